// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectories in closed form, exact to rounding with every derivative: rest, straight and level flight,
// circles, figures of eight, oscillations, and sums of them. They are what everything else is tested with.
#ifndef ORR_INERTIAL_MOTION_ANALYTIC_H
#define ORR_INERTIAL_MOTION_ANALYTIC_H

#include "inertial/motion/trajectory.h"

typedef enum orr_analytic_kind {
    ORR_ANALYTIC_STRAIGHT, // constant velocity over the local map
    ORR_ANALYTIC_CIRCLE,   // about the origin
    ORR_ANALYTIC_EIGHT,    // along a sin wt, across b sin 2wt
    ORR_ANALYTIC_SINE,     // of position and attitude
} orr_analytic_kind;

typedef struct orr_analytic_term {
    orr_analytic_kind kind;
    orr_vec3 velocity_mps;    // straight: East, North, Up
    double radius_m;          // circle
    double period_s;          // circle, eight, sine; not 0
    double azimuth_rad;       // circle: of the place at t = 0 from the centre; eight: of its long axis
    bool counter_clockwise;   // circle, seen from above
    double along_m, across_m; // eight: amplitudes
    orr_vec3 amplitude_m;     // sine: East, North, Up
    orr_angles amplitude;     // sine: of heading, pitch, roll
    double phase_rad;         // eight, sine
} orr_analytic_term;

#define ORR_ANALYTIC_MAX_TERMS 16

typedef struct orr_analytic_plan {
    orr_geodetic origin;
    orr_angles attitude; // mean; with follow_course its heading is added to that of the motion over the map
    bool follow_course;
    size_t n_terms; // 0: rest
    orr_analytic_term term[ORR_ANALYTIC_MAX_TERMS];
} orr_analytic_plan;

// A trajectory in closed form.
//   Given:    t0              instant of its second 0
//             begin_s, end_s  time it may be evaluated in, s after t0; terms are functions of the same seconds
//             plan            origin, mean attitude and the terms that are summed; copied
//   Returned: out             the trajectory, without knots; free with orr_trajectory_free
//   Notes:    The motion may not come within 100 m of a pole, where headings turn about at once
//             (orr_polar_transfer carries a trajectory there). ORR_E_ARG, ORR_E_MEMORY.
orr_status orr_trajectory_analytic(orr_time t0, double begin_s, double end_s, const orr_analytic_plan *plan,
                                   orr_trajectory *out, orr_diag *diag);

#endif
