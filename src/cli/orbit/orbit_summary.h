// SPDX-License-Identifier: GPL-3.0-or-later
// What `orrery orbit` tells of a run: a table on stderr, or JSON on stdout.
#ifndef ORR_CLI_ORBIT_ORBIT_SUMMARY_H
#define ORR_CLI_ORBIT_ORBIT_SUMMARY_H

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/predict/predict.h"
#include "src/cli/frame/cli.h"

typedef struct orbit_seconds { // wall clock, by stage
    double read, smooth, fit, write;
} orbit_seconds;

// Prints it.
// Given:
//   c           command
//   s           solution
//   report      of the smoother
//   e           product
//   prediction  NULL: none was asked for
//   seconds     how long it took
// Returned:
//   value       exit status
int orbit_summary_print(const orr_cli *c, const orr_orbit_solution *s, const orr_smoother_report *report,
                        const orr_ephemeris *e, const orr_predict_report *prediction,
                        const orbit_seconds *seconds);

#endif
