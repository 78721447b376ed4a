// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers that keep their clock within a millisecond by stepping it: ranges of all satellites jump by a whole number
// of milliseconds while carrier phases run on (or the other way about). No cycle has slipped, but the Melbourne-Wuebben
// combination jumps by 3e5 cycles. The step is common to all satellites of an epoch, and is taken out of the ranges.
#ifndef ORR_IONO_PHASE_CLOCK_STEPS_H
#define ORR_IONO_PHASE_CLOCK_STEPS_H

#include "core/status.h"
#include "core/time.h"

// One satellite, n samples in time order.
typedef struct orr_clock_series {
    size_t n;
    const orr_time *t;
    double (*value)[4]; // phases 1, 2 in cycles, ranges 1, 2 in metres (NAN: none)
    double wave_m;      // of phase 1
} orr_clock_series;

// Finds steps of the receiver's clock and takes them out of the ranges.
// Given:
//   sat, n_sats  series of all satellites
//   epoch, n     epochs of the file, ascending
// Returned:
//   sat          ranges of value[], from each step on, less c times the steps so far
//   steps        how many epochs had one
//   diag         why it failed; may be NULL
// Errors: ORR_E_MEMORY.
// Notes: at an epoch, range minus phase may have moved by k milliseconds, k not 0, within 100 m (noise, and what the
// ionosphere does in one interval); that is a step of the clock where most satellites say so with the same k.
orr_status orr_clock_steps_undo(const orr_clock_series *sat, size_t n_sats, const orr_time *epoch, size_t n,
                                size_t *steps, orr_diag *diag);

#endif
