// SPDX-License-Identifier: GPL-3.0-or-later
// Between telemetry_fit.c and telemetry_faults.c: which rows of a log are worth using.
#ifndef ORR_INERTIAL_MOTION_TELEMETRY_FAULTS_H
#define ORR_INERTIAL_MOTION_TELEMETRY_FAULTS_H

#include "inertial/motion/telemetry_fit.h"

// One half of a log: values of `dim` numbers a row (positions as ecef about a local origin, attitudes as
// sign-continuous quaternions), and the fault of each row so far (ORR_FAULTS: none).
typedef struct telemetry_series {
    bool attitude;
    size_t n;
    int dim;
    const double *t_s;
    double *value;    // [n][dim]
    orr_fault *fault; // [n]
    size_t *order;    // the good rows, ascending in time
    size_t n_good;
    double interval_s; // usual, between good rows
} telemetry_series;

// The rows whose times ascend: the longest such sequence, so that neither a clock that leaps ahead nor one
// that is set back costs more than the rows concerned.
orr_status telemetry_mark_clock(telemetry_series *s, orr_diag *diag);
// Values that stand still for a second or more and then leap on to where the motion had gone meanwhile.
void telemetry_mark_frozen(telemetry_series *s);
// Keeps the longest part (in time) without gaps over max_gap_s.
orr_status telemetry_part(telemetry_series *s, double max_gap_s, orr_fit_report *report, orr_diag *diag);
// Rows far off a smooth curve through the others.
orr_status telemetry_mark_jumps(telemetry_series *s, double floor, orr_diag *diag);

#endif
