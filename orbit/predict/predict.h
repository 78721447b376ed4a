// SPDX-License-Identifier: GPL-3.0-or-later
// Orbits and clocks beyond the last position that a file has: a dynamic orbit fitted to the last two days, all
// satellites together with the Earth's rotation, and carried on; clocks by the curve that suits their kind.
#ifndef ORR_ORBIT_PREDICT_PREDICT_H
#define ORR_ORBIT_PREDICT_PREDICT_H

#include "core/log.h"
#include "orbit/smooth/smoother.h"

typedef struct orr_predict_options {
    orr_time to;                // how far
    const orr_eop_series *eop;  // a rotation that is to be kept, where it covers all; NULL: the orbits' own
    const orr_leap_table *leap; // by which UT1 begins without one; NULL: built-in
    int jobs;
    const orr_sat_set *sats; // NULL: all
} orr_predict_options;

typedef struct orr_predict_report {
    orr_time from;      // the last position that was used
    size_t orbits;      // satellites predicted
    size_t clocks;      // of these with a clock
    size_t left_out;    // satellites that end before, do not fit, or fly too low
    bool eop_estimated; // the rotation is the orbits' own
    bool eop_known;     // or the caller's
    double xp_rad, yp_rad, lod_s, pole_sigma_rad, lod_sigma_s; // at `from`
} orr_predict_report;

// The longest prediction: beyond, nothing here was measured.
#define ORR_PREDICT_LONGEST_S (7 * 86400.0)

// Extends a solution: arcs and clocks of satellites whose last arc ends where the files do, flagged as predicted,
// with sigmas that grow; and its rotation.
// Given:
//   s         a solution, smoothed; nodes that their file flags as predicted are not gone by
//   input     [n_inputs] files that it was made from
//   n_inputs  how many
//   o         options; o->to is after the last position and no more than ORR_PREDICT_LONGEST_S
//   log       may be NULL
//   cancel    may be NULL; non-zero stops with ORR_E_INTERRUPTED
// Returned:
//   s         extended; o->to becomes the end of its span
//   report    what was done
//   warnings  satellites that are left out
//   diag      ORR_E_ARG (o->to), ORR_E_NODATA (no satellite can be predicted), ORR_E_MEMORY, ORR_E_INTERRUPTED
// Reference: Beutler et al. 1994 (ECOM); docs/orbit.md tells what each part gains.
orr_status orr_predict(orr_orbit_solution *s, const orr_smoother_input *input, size_t n_inputs,
                       const orr_predict_options *o, const orr_log *log, const volatile int *cancel,
                       orr_predict_report *report, orr_warnings *warnings, orr_diag *diag);

#endif
