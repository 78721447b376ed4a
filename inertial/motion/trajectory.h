// SPDX-License-Identifier: GPL-3.0-or-later
// One face over every source of motion: closed forms, flight plans, smoothed telemetry, and these moved over
// the pole or along a lever arm. A trajectory is a pure function of time; IMU, GNSS truth and gravimetry all
// ask the same one.
#ifndef ORR_INERTIAL_MOTION_TRAJECTORY_H
#define ORR_INERTIAL_MOTION_TRAJECTORY_H

#include "core/time.h"
#include "inertial/motion/motion.h"

typedef struct orr_trajectory {
    orr_time t0;           // of all seconds below; the inertial frame coincides with ecef at t0
    double begin_s, end_s; // it may be evaluated in [begin_s, end_s]
    double knot_origin_s;  // its higher derivatives jump at knot_origin_s + k knot_step_s and nowhere else;
    double knot_step_s; // 0: nowhere. Quadratures must not straddle a knot, nor a navigator's groups those of
                        // cubics
    int knot_degree;    // 3: acceleration and rate bend there; 5: they do so in their second derivative only
    void (*evaluate)(const void *self, double t_s, orr_motion *out);
    void (*destroy)(void *self); // may be NULL
    void *self;
} orr_trajectory;

// The motion t_s seconds after t0. Outside [begin_s, end_s] (by more than a microsecond) ORR_E_RANGE with a
// sentence.
orr_status orr_trajectory_evaluate(const orr_trajectory *tr, double t_s, orr_motion *out, orr_diag *diag);
// Frees what the trajectory owns; an empty one is allowed.
void orr_trajectory_free(orr_trajectory *tr);

// Samples of one half (position or attitude) of a trajectory and the spline to lay through them.
typedef struct orr_spline_plan {
    int degree; // 3 or 5
    double knot_step_s;
    double roughness; // of orr_uspline_fit
} orr_spline_plan;

typedef struct orr_spline_residuals {
    double position_rms_m, position_max_m;
    double attitude_rms_rad, attitude_max_rad;
} orr_spline_residuals;

// Positions (ecef) and attitudes, each at ascending times of its own, in seconds after t0.
typedef struct orr_spline_samples {
    size_t n_r;
    const double *r_t_s;
    const orr_vec3 *r_m;
    size_t n_q;
    const double *q_t_s;
    const orr_quat *q_be;
} orr_spline_samples;

// Splines through positions (ecef, relative to a local origin) and attitudes (sign-continuous quaternions),
// so that the poles, the date line and the wraps of heading and roll are nothing special.
//   Given:    t0              instant of second 0
//             begin_s, end_s  time that the trajectory may be evaluated in
//             samples         positions and attitudes; the signs of quaternions need not be continuous. They
//                             may lie beyond begin_s and end_s, which makes the ends as good as the middle
//             position        degree and knots of the positions' spline, and
//             attitude        of the attitudes'; one knot step is a whole multiple of the other
//   Returned: out             the trajectory, knots of both halves at begin_s; free with orr_trajectory_free
//             residuals       what the samples differ by from the splines; may be NULL
//   Notes:    ORR_E_ARG, ORR_E_NUMERIC (samples that determine no spline), ORR_E_MEMORY, ORR_E_LIMIT.
orr_status orr_trajectory_from_samples(orr_time t0, double begin_s, double end_s,
                                       const orr_spline_samples *samples, orr_spline_plan position,
                                       orr_spline_plan attitude, orr_trajectory *out,
                                       orr_spline_residuals *residuals, orr_diag *diag);

// A quintic spline through samples of another trajectory, which need not outlive it.
//   Given:    in            the trajectory
//             step_s        step of the samples and of the knots, s
//             change        called for each sample at t_s, with `user`; may alter r_m and q_be; NULL: no change
//             user          for `change`
//   Returned: out           the spline over the same time; free with orr_trajectory_free
//   Notes:    ORR_E_ARG (step or span), ORR_E_NUMERIC, ORR_E_MEMORY.
orr_status orr_trajectory_resample(const orr_trajectory *in, double step_s,
                                   void (*change)(void *user, double t_s, orr_motion *m), void *user,
                                   orr_trajectory *out, orr_diag *diag);

#endif
