// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing published SP3 files and judging the samples by the epochs that were withheld. Samples fall on
// every multiple of 150 s, so 5-minute truth needs no interpolation.
#ifndef ORR_TESTS_REAL_ORBIT_H
#define ORR_TESTS_REAL_ORBIT_H

#include "orbit/smooth/smoother.h"

#define MAX_FILES 8

typedef struct real_files {
    size_t n;
    orr_sp3 sp3[MAX_FILES];
    orr_smoother_input input[MAX_FILES];
} real_files;

typedef struct real_stats {
    size_t n;
    double rms_m, max_m;
} real_stats;

typedef enum real_part { REAL_INNER, REAL_EDGE, REAL_GAP } real_part;

// false where one of the files is absent.
bool real_open(const char *const *names, size_t n, real_files *f);
void real_close(real_files *f);
// Takes the last epoch off the i-th file if it is the 24:00 one.
void real_drop_midnight(real_files *f, size_t i);

// The satellite's sample at an instant; NULL where none is.
const orr_orbit_sample *real_sample_at(const orr_orbit_sat *sat, orr_time t);

// Truth at epochs that were no nodes, one system, one part of the span (the same borders as `orrery
// compare`).
real_stats real_judge(const orr_orbit_solution *s, const real_files *truth, char system, real_part part);
// Largest distance between two solutions' samples at common instants of the inner part; *n counts them.
double real_distance(const orr_orbit_solution *a, const orr_orbit_solution *b, double margin_s, size_t *n);

#endif
