// SPDX-License-Identifier: GPL-3.0-or-later
// The plan as pieces of lines and arcs over the local map, each with a constant acceleration along it: between
// flight_plan.c, which makes a motion of it, and flight_path.c.
#ifndef ORR_INERTIAL_MOTION_FLIGHT_PATH_H
#define ORR_INERTIAL_MOTION_FLIGHT_PATH_H

#include "inertial/motion/dubins.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/motion/local_map.h"

typedef struct orr_flight_piece {
    orr_path_piece path;       // of length 0: at rest
    double from_s, to_s;       // since the begin of the flight
    double from_mps, to_mps;   // speeds at both ends
    double from_up_m, to_up_m; // above the origin's height
    bool airborne;
} orr_flight_piece;

typedef struct orr_flight_path {
    orr_local_map map;
    size_t n;
    orr_flight_piece *piece;
    double duration_s, length_m, radius_m;
    size_t lines;    // of surveys
    bool has_ground; // some pieces are on the ground
    bool level_off;  // behind the end the height stays; else it goes on as in the last piece
} orr_flight_path;

// Lines and arcs of a plan, over a map about its middle (waypoints) or its start. Free with orr_flight_path_free.
// Errors: ORR_E_ARG with a sentence on what cannot be flown, ORR_E_MEMORY.
orr_status orr_flight_path_make(const orr_flight_plan *plan, orr_flight_path *out, orr_diag *diag);
// Frees the pieces; an empty path is allowed.
void orr_flight_path_free(orr_flight_path *p);
// Place over the map at t_s; before the begin and after the end the first and last piece go straight on.
// *hint is the piece of the last call (start with 0), and then of this one.
orr_vec3 orr_flight_path_at(const orr_flight_path *p, double t_s, size_t *hint);
// Course of piece k of the path at t_s, over the map.
double orr_flight_path_course(const orr_flight_path *p, double t_s, size_t k);

#endif
