// SPDX-License-Identifier: GPL-3.0-or-later
// Between flight_plan.c and flight_path.c: the plan as pieces of lines and arcs over the local map, each with
// a speed.
#ifndef ORR_INERTIAL_MOTION_FLIGHT_PATH_H
#define ORR_INERTIAL_MOTION_FLIGHT_PATH_H

#include "inertial/motion/dubins.h"
#include "inertial/motion/flight_plan.h"
#include "inertial/motion/local_map.h"

typedef struct orr_flight_piece {
    orr_path_piece path;
    double from_s, to_s; // since the begin of the flight
    double speed_mps;
    double from_up_m, to_up_m; // above the origin's height
} orr_flight_piece;

typedef struct orr_flight_path {
    orr_local_map map;
    size_t n;
    orr_flight_piece *piece;
    double duration_s, length_m, radius_m;
} orr_flight_path;

// Lines and arcs of a plan, over a map about its middle (waypoints) or its start (survey). Free with
// orr_flight_path_free. Errors: ORR_E_ARG with a sentence on what cannot be flown, ORR_E_MEMORY.
orr_status orr_flight_path_make(const orr_flight_plan *plan, orr_flight_path *out, orr_diag *diag);
// Frees the pieces; an empty path is allowed.
void orr_flight_path_free(orr_flight_path *p);
// Place over the map at t_s; before the begin and after the end the first and last piece go straight on.
// *hint is the piece of the last call (start with 0).
orr_vec3 orr_flight_path_at(const orr_flight_path *p, double t_s, size_t *hint);

#endif
