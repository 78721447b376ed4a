// SPDX-License-Identifier: GPL-3.0-or-later
// What a scenario knows of gravity along its track: the truth that airborne gravimetry is compared with.
#ifndef ORR_INERTIAL_READINGS_GRAVIMETRY_TRUTH_H
#define ORR_INERTIAL_READINGS_GRAVIMETRY_TRUTH_H

#include "inertial/gravity/gravity.h"
#include "inertial/readings/imu.h"

// Gravity terms of one instant.
//   Given:    g                 the field; NULL: normal gravity
//             m                 motion at that instant
//   Returned: disturbance_mgal  gravity over normal gravity, downward, mGal
//             eotvos_mgal       Eotvos term, upward, mGal
//             vertical_mps2     rate of the vertical velocity over the ellipsoid, m/s^2
void orr_gravity_terms(const orr_gravity *g, const orr_motion *m, double *disturbance_mgal,
                       double *eotvos_mgal, double *vertical_mps2);

// Truth at every `every`-th sample edge of a run.
typedef struct orr_gravimetry {
    size_t n, every;
    double *disturbance_mgal; // what gravity has over normal gravity, downward positive
    double *eotvos_mgal;      // what motion takes off the weight
    double *vertical_mps2;    // rate of the vertical velocity over the ellipsoid
} orr_gravimetry;

// Truth on the edges of a run.
//   Given:    tr            trajectory that the run was made on
//             g             its gravity; NULL: normal gravity
//             imu           the run; rate, length and truth_every are used
//             every         samples from one instant to the next; 0: about ten instants a second. Taken up to
//                           the next multiple of imu->truth_every
//   Returned: out           the truth; free with orr_gravimetry_free
//   Notes:    ORR_E_MEMORY.
orr_status orr_gravimetry_truth(const orr_trajectory *tr, const orr_gravity *g, const orr_imu *imu,
                                size_t every, orr_gravimetry *out, orr_diag *diag);
// Frees the series; an empty truth is allowed.
void orr_gravimetry_free(orr_gravimetry *g);

#endif
