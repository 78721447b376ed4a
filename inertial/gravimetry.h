// SPDX-License-Identifier: GPL-3.0-or-later
// Airborne gravimetry: what the scenario knows of gravity along the track, and its recovery from readings and
// trajectory.
#ifndef ORR_INERTIAL_GRAVIMETRY_H
#define ORR_INERTIAL_GRAVIMETRY_H

#include "inertial/navigator.h"

// Gravity terms of one instant, in the units of the struct below.
void orr_gravity_terms(const orr_gravity *g, const orr_motion *m, double *disturbance_mgal,
                       double *eotvos_mgal, double *vertical_mps2);

// Truth at every `every`-th sample edge of a run.
typedef struct orr_gravimetry {
    size_t n, every;
    double *disturbance_mgal; // what gravity has over normal gravity, downward positive
    double *eotvos_mgal;      // what motion takes off the weight
    double *vertical_mps2;    // rate of the vertical velocity over the ellipsoid
} orr_gravimetry;

// Truth on the edges of `imu` from its trajectory; every = 0: about ten times a second. Free with
// orr_gravimetry_free.
orr_status orr_gravimetry_truth(const orr_trajectory *tr, const orr_gravity *g, const orr_imu *imu,
                                size_t every, orr_gravimetry *out, orr_diag *diag);
void orr_gravimetry_free(orr_gravimetry *g);

// Recovery: from each truth edge to the next the readings are integrated on normal gravity alone, starting on
// the true motion; the vertical velocity that is then missing is the mean disturbance of that time. Filtered
// series are both run through a Gaussian of standard deviation sigma_s, cut at 4 sigma; the r.m.s. of the
// filtered difference leaves 3 sigma at both ends out.
typedef struct orr_gravimetry_result {
    size_t n;
    double *t_s, *recovered_mgal, *true_mgal, *recovered_filtered_mgal, *true_filtered_mgal;
    double raw_rms_mgal, filtered_rms_mgal, filtered_max_mgal;
} orr_gravimetry_result;
// Errors: ORR_E_ARG (sigma, run shorter than 8 sigma), ORR_E_UNSUPPORTED (readings of approach 1 are no
// physical force), ORR_E_MEMORY.
orr_status orr_gravimetry_recover(const orr_imu *imu, const orr_gravimetry *truth, double sigma_s,
                                  orr_gravimetry_result *out, orr_diag *diag);
void orr_gravimetry_result_free(orr_gravimetry_result *r);

// out[n]: Gaussian of sigma_samples over x[n], renormalised where it reaches past the ends. Not in place.
void orr_gaussian_filter(const double *x, size_t n, double sigma_samples, double *out);

#endif
