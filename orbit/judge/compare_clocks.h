// SPDX-License-Identifier: GPL-3.0-or-later
// A product's clocks against clocks that it was not made from: how far apart once what all satellites of a system
// share at an epoch is taken away, and whether the sigma said so.
#ifndef ORR_ORBIT_JUDGE_COMPARE_CLOCKS_H
#define ORR_ORBIT_JUDGE_COMPARE_CLOCKS_H

#include "ingest/sp3/sp3.h"
#include "orbit/ephemeris/ephemeris.h"

// Of one system (sat ORR_SAT_NONE) or one satellite; numbers are NAN where n is 0.
typedef struct orr_clock_stats {
    char system;
    orr_sat sat;
    size_t n, satellites;
    double rms_s, p95_s, max_s; // of the difference less the epoch's median over the system
    double sigma_rms_s;         // what the product claimed; NAN where it claims nothing
    double ratio;               // RMS of difference over sigma, of those samples that have a sigma
} orr_clock_stats;

typedef struct orr_clock_comparison {
    size_t n_systems, n_sats;
    orr_clock_stats system[ORR_N_SYSTEMS]; // those with samples, in the order of ORR_SYSTEMS
    orr_clock_stats *sat;                  // descending rms
    size_t inputs;   // truth's clocks at nodes of the product's clocks: left out, or not with_inputs
    size_t no_clock; // left out because the product has no clock there
    size_t few;      // left out because fewer than four satellites of the system have both there
} orr_clock_comparison;

// Compares a product's clocks with those of SP3 files.
// Given:
//   e            product
//   truth        [n_truths] files
//   n_truths     how many
//   sats         satellites; NULL: all
//   with_inputs  also at nodes of the product's clocks
// Returned:
//   out          by system and satellite; free with orr_clock_comparison_free. All counts may be 0: no error
//   diag         why it failed; may be NULL
// Errors: ORR_E_MEMORY.
orr_status orr_compare_clocks(const orr_ephemeris *e, const orr_sp3 *truth, size_t n_truths,
                              const orr_sat_set *sats, bool with_inputs, orr_clock_comparison *out,
                              orr_diag *diag);
// Frees what orr_compare_clocks allocated; c is empty afterwards.
void orr_clock_comparison_free(orr_clock_comparison *c);

#endif
