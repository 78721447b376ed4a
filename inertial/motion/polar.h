// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a whole trajectory to another part of the Earth, over a pole above all: places and attitudes turn
// with one constant rotation of the terrestrial frame and the heights are put right (Bogdanov 2015,
// section 2.6).
#ifndef ORR_INERTIAL_MOTION_POLAR_H
#define ORR_INERTIAL_MOTION_POLAR_H

#include "inertial/motion/trajectory.h"

// C of eq. (19), (20) that takes the (geocentric) direction of `from_m` to that of `to_m`: east and north
// there become east and north here, then turned clockwise by azimuth_rad. On a pole, "north" is the direction
// of longitude 180 deg from it.
orr_mat3 orr_polar_rotation(orr_vec3 from_m, orr_vec3 to_m, double azimuth_rad);

// Mean direction of a trajectory (a look a second), for from_m of the above: a point at about the Earth's
// radius.
orr_vec3 orr_trajectory_middle(const orr_trajectory *tr);

// Where a place comes to: turned by C^T (19), then moved along its vertical to the ellipsoidal height that it had.
orr_vec3 orr_polar_place(const orr_mat3 *C, orr_vec3 r_m);
// The inverse: the place that comes to r_m.
orr_vec3 orr_polar_home(const orr_mat3 *C, orr_vec3 r_m);

// What becomes of attitudes.
typedef enum orr_polar_attitude {
    ORR_POLAR_LEVEL, // re-projected to the ellipsoid's vertical: roll and pitch against it stay as they were
    ORR_POLAR_LITERAL, // (20) as it stands: they stay against the geocentric vertical, whose angle to the ellipsoid's
                       // changes by up to 0.19 deg
} orr_polar_attitude;

// Carries a trajectory by a rotation.
//   Given:    in            the trajectory
//             C             of orr_polar_rotation
//             attitude      what its attitudes refer to
//             step_s        knots of the result; 0: the knots of `in`, or 0.2 s
//   Returned: out           the moved trajectory, a quintic spline; free with orr_trajectory_free
//   Notes:    eta_P = C^T eta (19), B_P = B C (20), each place then moved along its vertical to the ellipsoidal
//             height it had, since the Earth is no sphere. Level attitudes are turned on by the smallest rotation
//             that brings the carried vertical onto that of the ellipsoid. Lengths over the ground change by the
//             ratio of the radii (at most 0.7 %). ORR_E_ARG, ORR_E_MEMORY.
//   Reference: Bogdanov 2015, eq. (19), (20).
orr_status orr_polar_transfer(const orr_trajectory *in, const orr_mat3 *C, orr_polar_attitude attitude,
                              double step_s, orr_trajectory *out, orr_diag *diag);

#endif
