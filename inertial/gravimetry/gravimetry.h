// SPDX-License-Identifier: GPL-3.0-or-later
// Airborne gravimetry: the gravity disturbance along a track, recovered from readings and trajectory.
#ifndef ORR_INERTIAL_GRAVIMETRY_GRAVIMETRY_H
#define ORR_INERTIAL_GRAVIMETRY_GRAVIMETRY_H

#include "inertial/gravimetry/gravity_filter.h"
#include "inertial/nav/navigator.h"
#include "inertial/readings/gravimetry_truth.h"

// Recovery: from each truth edge to the next the readings are integrated on normal gravity alone, starting on
// the true motion; the vertical velocity that is then missing is the mean disturbance of that time. Both
// series are run through the filter; the r.m.s. of the filtered difference leaves the filter's ends out, which have one of
// their own.
typedef struct orr_gravimetry_result {
    size_t n, first; // values, and the span of the truth that the first is of
    double *t_s, *recovered_mgal, *true_mgal, *recovered_filtered_mgal, *true_filtered_mgal;
    double raw_rms_mgal, filtered_rms_mgal, filtered_max_mgal;
    double edge_s, edge_rms_mgal; // of the filter's ends, that long each
} orr_gravimetry_result;

// A track that a satellite receiver has found: places of its antenna, which take the place of the true motion. Attitude then
// comes from the readings alone, from the run's start attitude on.
typedef struct orr_gravimetry_track {
    size_t n;
    const double *t_s;   // [n] ascending, seconds after imu->t0
    const orr_vec3 *r_m; // [n] places of the antenna, ecef
    orr_vec3 arm_m;      // antenna from the unit, body axes: right, forward, up
} orr_gravimetry_track;

// Recovers the disturbance of a run.
//   Given:    imu           physical readings (approach 2) with truth at every instant that `truth` has
//             truth         true disturbance on the edges of imu, every truth->every samples
//             track         motion by a receiver; NULL: the true motion
//             filter        of both series; the run is longer than its two ends
//   Returned: out           truth->n - 1 values, one a span between two instants of the truth, at its middle
//   Notes:    ORR_E_ARG (filter, a run shorter than it, truth of gravity where the motion has none, a track
//             that does not cover as much of the run),
//             ORR_E_UNSUPPORTED (readings of approach 1 are no physical force), ORR_E_MEMORY.
orr_status orr_gravimetry_recover(const orr_imu *imu, const orr_gravimetry *truth,
                                  const orr_gravimetry_track *track, const orr_gravity_filter *filter,
                                  orr_gravimetry_result *out, orr_diag *diag);
// Frees the series; an empty result is allowed.
void orr_gravimetry_result_free(orr_gravimetry_result *r);

#endif
