// SPDX-License-Identifier: GPL-3.0-or-later
// A body that bends between two units: the second one's place and axes wander about where it is mounted.
#ifndef ORR_INERTIAL_STUDY_FLEXURE_H
#define ORR_INERTIAL_STUDY_FLEXURE_H

#include "inertial/motion/dual_unit.h"

// Angles of bending about the body's three axes, each a critically damped process of second order driven by white noise: correlation
// (1 + b t) exp(-b t). The arm turns with them, and so do the axes at its end.
//   Reference: Kain and Cloutier 1989, AIAA 89-3558.
typedef struct orr_flexure {
    double sigma_rad; // standard deviation of each angle
    double beta_radps;
    uint64_t seed;
} orr_flexure;

// A second unit on a bending arm.
//   Given:    first         the trajectory of the first unit
//             mounting      of the second at rest
//             flexure       how the arm bends; sigma_rad and beta_radps above 0
//   Returned: out           the trajectory of the second, a quintic spline whose knots lie a twentieth of 1 / beta apart; free with
//                           orr_trajectory_free
//   Notes:    `first` need not outlive it. Errors as of orr_trajectory_mounted and orr_trajectory_resample.
orr_status orr_trajectory_flexed(const orr_trajectory *first, const orr_mounting *mounting,
                                 const orr_flexure *flexure, orr_trajectory *out, orr_diag *diag);

// Standard deviations of the velocity that bending gives the end of an arm, body axes, m/s.
orr_vec3 orr_flexure_velocity_mps(const orr_flexure *flexure, orr_vec3 arm_m);

#endif
