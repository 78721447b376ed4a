// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest plane paths of bounded curvature between two poses (Dubins 1957): how an aircraft gets from the
// end of one survey line to the begin of the next, whatever their spacing.
#ifndef ORR_INERTIAL_MOTION_DUBINS_H
#define ORR_INERTIAL_MOTION_DUBINS_H

#include <stdbool.h>

typedef struct orr_pose {
    double east_m, north_m, course_rad; // course clockwise from North
} orr_pose;

// A piece of constant curvature; turn is +1 right (clockwise), -1 left, 0 straight.
typedef struct orr_path_piece {
    orr_pose from;
    double length_m, radius_m;
    int turn;
} orr_path_piece;

// Pose along_m behind the begin of a piece; beyond its ends the curve of the piece goes on.
orr_pose orr_path_at(const orr_path_piece *p, double along_m);
// Three pieces (some may have length 0) of the shortest path with turns of radius_m; returns its length.
double orr_dubins(orr_pose from, orr_pose to, double radius_m, orr_path_piece piece[3]);

#endif
