// SPDX-License-Identifier: GPL-3.0-or-later
// Four satellites whose truth is known, and the smoother run on files of them.
#ifndef UNIT_ORBIT_SMOOTHER_MADE_H
#define UNIT_ORBIT_SMOOTHER_MADE_H

#include "orbit/smooth/smoother.h"
#include "unit/orbit/made_sp3.h"

#define DAY 288 // epochs of 300 s
#define PUSH_S (11 * 3600.0 + 37 * 60 + 30)

// Of one test program, from make_truth to drop_truth, which cmocka calls before and after the tests.
extern made_sky sky;
extern made_truth gps, eccentric, glonass, pushed; // pushed: 0.10 m/s along track at 11:37:30
extern const made_truth *const all[3];             // those that nobody pushed
int make_truth(void **state);
int drop_truth(void **state);

// Files of these satellites smoothed together, under names of their own.
// Given:
//   files, n  the files
//   o         the options
// Returned:
//   s         the solution, to be freed
//   report    NULL, or the smoother's report
//   w, d      NULL, or warnings and the sentence of a failure
orr_status run(const orr_sp3 *files, size_t n, const orr_smoother_options *o, orr_orbit_solution *s,
               orr_smoother_report *report, orr_warnings *w, orr_diag *d);
// Events of a kind in a satellite's arc, and the last of them (unless `last` is NULL).
size_t count_events(const orr_orbit_solution *s, orr_sat sat, orr_event_kind kind,
                    const orr_orbit_event **last);

#endif
