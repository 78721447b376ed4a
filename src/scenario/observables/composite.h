// SPDX-License-Identifier: GPL-3.0-or-later
// A channel and its echoes as one observation.
#ifndef ORR_SCENARIO_OBSERVABLES_COMPOSITE_H
#define ORR_SCENARIO_OBSERVABLES_COMPOSITE_H

#include "src/scenario/channel/channel.h"

typedef struct orr_composite {
    double code_m, phase_cycles, power_db; // what echoes add to the channel; 0 without any
} orr_composite;

// What the echoes of channel[k] make of it, as a correlator sees them.
// Given:
//   c        channels that they are of
//   channel  [n] of one instant, echoes behind their signal
//   n        how many
//   k        the signal's place; not an echo
// Returned:
//   out      what they add
// Returns the place of the next signal.
size_t orr_composite_of(const orr_channels *c, const orr_channel *channel, size_t n, size_t k,
                        orr_composite *out);

#endif
