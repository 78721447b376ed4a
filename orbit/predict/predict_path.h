// SPDX-License-Identifier: GPL-3.0-or-later
// One satellite carried on: the state at its last node by a stiff filter about the fitted orbit, and the path
// from there, which leaves the filter's state for the fitted orbit within hours. Room-internal.
#ifndef ORR_ORBIT_PREDICT_PREDICT_PATH_H
#define ORR_ORBIT_PREDICT_PREDICT_PATH_H

#include "orbit/dynamics/reference_fit.h"
#include "orbit/smooth/kalman.h"
#include "orbit/smooth/solution.h"

// What a thread has for itself.
typedef struct orr_predict_room {
    const orr_sky *sky;
    orr_force force;
    orr_integrator *integrator;
} orr_predict_room;

// Makes a thread's room; sky and the field are borrowed. ORR_E_MEMORY. Free with orr_predict_room_free.
orr_status orr_predict_room_init(const orr_sky *sky, const orr_gravity_field *earth, orr_predict_room *room,
                                 orr_diag *diag);
// Frees what the room holds.
void orr_predict_room_free(orr_predict_room *room);

// Where a path begins: the fitted orbit at the last node, and how the filter's state departs from it.
typedef struct orr_predict_start {
    double t_s;
    orr_vec3 r_m, v_mps; // integration axes
    double x[ORR_NX];    // of orbit/smooth/kalman.h
    double joint_m;      // how far the last change of files moved the orbit; NAN: there is none
} orr_predict_start;

// Filters the nodes of a fitted arc. source[i] is the file of node i: where it changes the orbit may step. Errors:
// ORR_E_NUMERIC where the orbit leaves sense.
orr_status orr_predict_filter(orr_predict_room *room, const orr_reference_arc *fit, const uint16_t *source,
                              orr_predict_start *out);

// Appends samples to the last arc of a satellite, on its own grid, until they reach to_s; their sigma is that of
// the arc's end.
// Given:
//   room    the thread's
//   fit     the fitted arc, for its coefficients of ECOM
//   start   where the path begins
//   to_s    until when, s since the sky's origin
//   arc     smoothed samples; the last is at the node that start belongs to
// Returned:
//   arc     longer
// Errors: ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_predict_extend(orr_predict_room *room, const orr_reference_arc *fit,
                              const orr_predict_start *start, double to_s, orr_orbit_arc *arc);

#endif
