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

#endif
