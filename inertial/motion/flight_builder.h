// SPDX-License-Identifier: GPL-3.0-or-later
// Between flight_path.c and flight_phases.c: a path over the local map that grows at its end, piece by piece.
#ifndef ORR_INERTIAL_MOTION_FLIGHT_BUILDER_H
#define ORR_INERTIAL_MOTION_FLIGHT_BUILDER_H

#include "inertial/motion/flight_path.h"

// Where the path has come to.
typedef struct flight_builder {
    const orr_flight_plan *plan;
    orr_flight_path *path;
    orr_pose pose;
    double speed_mps, up_m; // above the origin's height
    bool airborne;
} flight_builder;

// A straight line or an arc, flown with constant acceleration.
//   Given:    length_m    0: nothing
//             radius_m    of a turn
//             turn        +1 right, -1 left, 0 straight
//             to_up_m     height at its end, reached evenly along the way
//             to_speed    speed at its end; not 0 together with that at its begin
//   Returned: b           at the end of the piece
//   Notes:    ORR_E_MEMORY.
orr_status flight_go(flight_builder *b, double length_m, double radius_m, int turn, double to_up_m,
                     double to_speed_mps, orr_diag *diag);
// Stands still for a time.
orr_status flight_rest(flight_builder *b, double duration_s, orr_diag *diag);
// Straight on until a speed is reached, by the plan's greatest acceleration; at most most_m may be needed.
orr_status flight_speed_up(flight_builder *b, double to_speed_mps, double most_m, orr_diag *diag);
// Length of way that a change of speed takes.
double flight_speed_up_m(const flight_builder *b, double to_speed_mps);
// Radius of turns at this speed. Errors: ORR_E_ARG where the plan's own is too tight.
orr_status flight_turn_radius(const orr_flight_plan *plan, double speed_mps, double *radius_m,
                              orr_diag *diag);
// The shortest way to a pose, in turns of that radius, at the height and speed that the path has.
orr_status flight_to(flight_builder *b, orr_pose to, double radius_m, orr_diag *diag);
// Pose over the map of a place and a course against true North there.
orr_pose flight_pose(const orr_local_map *map, orr_geodetic at, double azimuth_rad);
// The lines of a survey and their tie lines; `first` is the begin of the first line.
orr_status flight_lines(flight_builder *b, const orr_survey *v, orr_pose first, orr_diag *diag);

// The plan's phases, one after the other (flight_phases.c).
orr_status flight_phases(flight_builder *b, orr_diag *diag);

#endif
