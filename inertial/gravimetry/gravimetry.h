// SPDX-License-Identifier: GPL-3.0-or-later
// Airborne gravimetry: the gravity disturbance along a track, recovered from readings and trajectory.
#ifndef ORR_INERTIAL_GRAVIMETRY_GRAVIMETRY_H
#define ORR_INERTIAL_GRAVIMETRY_GRAVIMETRY_H

#include "inertial/nav/navigator.h"
#include "inertial/readings/gravimetry_truth.h"

// Recovery: from each truth edge to the next the readings are integrated on normal gravity alone, starting on
// the true motion; the vertical velocity that is then missing is the mean disturbance of that time. Filtered
// series are both run through a Gaussian of standard deviation sigma_s, cut at 4 sigma; the r.m.s. of the
// filtered difference leaves 3 sigma at both ends out.
typedef struct orr_gravimetry_result {
    size_t n;
    double *t_s, *recovered_mgal, *true_mgal, *recovered_filtered_mgal, *true_filtered_mgal;
    double raw_rms_mgal, filtered_rms_mgal, filtered_max_mgal;
} orr_gravimetry_result;

// Recovers the disturbance of a run.
//   Given:    imu           physical readings (approach 2) with truth at every instant that `truth` has
//             truth         true disturbance on the edges of imu, every truth->every samples
//             sigma_s       standard deviation of the Gaussian, s; the run is at least 8 of them long
//   Returned: out           truth->n - 1 values, one a span between two instants of the truth, at its middle
//   Notes:    ORR_E_ARG (sigma, run shorter than 8 sigma, truth of gravity where the motion has none),
//             ORR_E_UNSUPPORTED (readings of approach 1 are no physical force), ORR_E_MEMORY.
orr_status orr_gravimetry_recover(const orr_imu *imu, const orr_gravimetry *truth, double sigma_s,
                                  orr_gravimetry_result *out, orr_diag *diag);
// Frees the series; an empty result is allowed.
void orr_gravimetry_result_free(orr_gravimetry_result *r);

#endif
