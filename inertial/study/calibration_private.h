// SPDX-License-Identifier: GPL-3.0-or-later
// The linear problem of a calibration, decomposed.
#ifndef ORR_INERTIAL_STUDY_CALIBRATION_PRIVATE_H
#define ORR_INERTIAL_STUDY_CALIBRATION_PRIVATE_H

#include "inertial/study/calibration.h"

// Singular values of the factor; from them the solution, the covariance and what is not seen.
//   Given:    r             n, and the factor R [n][n] of the weighted problem
//             size          [n] how large each unknown usually is
//             y             [n] Q' y
//   Returned: r             covariance, sigma, condition, unseen, seen, partner, correlation
//             x             [n] the solution, nothing along what is not seen
//             diag          why it failed (ORR_E_NUMERIC, ORR_E_MEMORY)
orr_status orr_calibration_decompose(orr_calibration_result *r, const double *size, const double *y,
                                     double *x, orr_diag *diag);

// Where each unknown stands; matrices and arms by rows.
enum { ACCEL_BIAS = 0, ACCEL_SCALE = 3, ACCEL_CROSS = 6, GYRO_BIAS = 9, GYRO_MATRIX = 12, ARMS = 21 };
enum { TILT_1, TILT_2, START, OFFSET_1, OFFSET_2 }; // of a cycle
// Below the diagonal of the accelerometers' matrix: (1,0), (2,0), (2,1).
static const int cross_row[3] = {1, 2, 2}, cross_column[3] = {0, 0, 1};
// Unknowns of a cycle: 5, or 3 where offsets are known.
static inline size_t orr_calibration_per_cycle(const orr_calibration_plan *p)
{
    return p->offsets_known ? 3 : 5;
}
// Component 0, 1 or 2.
static inline double *orr_component(orr_vec3 *v, int i) { return i == 0 ? &v->x : i == 1 ? &v->y : &v->z; }
// The body's axis that is meant to lie nearest to the stand's.
static inline int orr_calibration_nearest(const orr_stand_cycle *c)
{
    int best = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(c->order.m[i][1]) > fabs(c->order.m[best][1])) best = i;
    return best;
}

#endif
