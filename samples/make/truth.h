// SPDX-License-Identifier: GPL-3.0-or-later
// The made truth as a function of time: any of the satellites, at any instant of the three days, beyond what
// SP3's rounding lets through. Tests link it; the files of samples/ are printed from it.
#ifndef ORR_SAMPLES_TRUTH_H
#define ORR_SAMPLES_TRUTH_H

#include "core/status.h"
#include "samples/make/constellation.h"

typedef struct orr_sample_truth orr_sample_truth;

// Integrates the satellites of `only` (NULL: all) from orr_sample_start() over `days` (1..ORR_SAMPLE_DAYS).
// Prince-Dormand 8(7) with a step of 60 s; between steps a quintic through position, velocity and
// acceleration (1e-9 m). Errors: ORR_E_ARG, ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_sample_truth_new(const orr_sat_set *only, int days, orr_sample_truth **out, orr_diag *diag);
void orr_sample_truth_free(orr_sample_truth *t);

size_t orr_sample_truth_count(const orr_sample_truth *t);
const orr_sample_sat *orr_sample_truth_sat(const orr_sample_truth *t, size_t k);

// Centre of mass and its velocity in ecef (ITRS), and the clock without relativity's periodic part, of the
// k-th satellite at an instant; v_mps and clock_s may be NULL. ORR_E_RANGE outside the days. Events that hide
// data do not hide the truth.
orr_status orr_sample_truth_at(const orr_sample_truth *t, size_t k, orr_time at, orr_vec3 *r_m,
                               orr_vec3 *v_mps, double *clock_s);
// What an SP3 file made from it says: whether there is a position, a clock; whether an event of the kind is
// within `half_s`.
bool orr_sample_has_position(orr_sat sat, orr_time at);
bool orr_sample_has_clock(orr_sat sat, orr_time at);

#endif
