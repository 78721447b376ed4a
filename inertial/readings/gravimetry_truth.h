// SPDX-License-Identifier: GPL-3.0-or-later
// What a scenario knows of gravity along its track: the truth that airborne gravimetry is compared with.
#ifndef ORR_INERTIAL_READINGS_GRAVIMETRY_TRUTH_H
#define ORR_INERTIAL_READINGS_GRAVIMETRY_TRUTH_H

#include "inertial/gravity/gravity.h"
#include "inertial/readings/imu.h"

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

#endif
