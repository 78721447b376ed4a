// SPDX-License-Identifier: GPL-3.0-or-later
// Least, greatest, last and percentiles of a time that is counted again and again: a histogram of 8 bins an octave, both signs.
#ifndef ORR_SERVICE_LIVE_SPREAD_H
#define ORR_SERVICE_LIVE_SPREAD_H

#include "proto/gen/messages.h"

enum { ORR_SPREAD_SIDE = 8 * 40 }; // bins of one sign: 8 an octave from 1 us up to 2^40 us

// Zero-initialise.
typedef struct orr_spread {
    uint64_t n, bin[2 * ORR_SPREAD_SIDE + 1]; // negative ones, what is below 1 us, positive ones
    int64_t min_ns, max_ns, last_ns;
} orr_spread;

// Counts one.
void orr_spread_add(orr_spread *s, int64_t ns);
// What the counts tell.
orr_msg_motion_spread orr_spread_told(const orr_spread *s);

#endif
