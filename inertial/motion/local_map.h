// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth map from metres East, North and Up of an origin to the Earth, by the ellipsoid's normal vector:
// nothing special happens at poles and the date line. Distances are exact in the middle and within 0.5 % a
// thousand kilometres away.
#ifndef ORR_INERTIAL_MOTION_LOCAL_MAP_H
#define ORR_INERTIAL_MOTION_LOCAL_MAP_H

#include "core/earth.h"

#define ORR_LOCAL_MAP_REACH_M 2.0e6 // plans that go farther from their origin are refused

typedef struct orr_local_map {
    orr_mat3 A0;            // enu from ecef at the origin
    double east_m, north_m; // radii of curvature plus height there
    double height_m;
} orr_local_map;

// The map about an origin; its height 0 is that of the origin.
orr_local_map orr_local_map_make(orr_geodetic origin);
// Place of local coordinates (metres); height is the origin's plus z.
orr_vec3 orr_local_map_to_ecef(const orr_local_map *m, orr_vec3 enu_m);
// Inverse for any place less than half a turn away: East, North and height above the origin's.
orr_vec3 orr_local_map_from_ecef(const orr_local_map *m, orr_vec3 r_m);

// The series that the map is made of, smooth through s = 0 where a square root is not.
//   Given:    s             squared angle from the origin, 0 to 10
//   Returned: C             cos(sqrt(s)); its derivative is -S / 2
//             S             sin(sqrt(s)) / sqrt(s)
//             S1, S2        first and second derivative of S by s
void orr_local_map_series(double s, double *C, double *S, double *S1, double *S2);

#endif
