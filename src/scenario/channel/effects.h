// SPDX-License-Identifier: GPL-3.0-or-later
// What effects (src/scenario/effect) add to a channel's terms.
#ifndef ORR_SCENARIO_CHANNEL_EFFECTS_H
#define ORR_SCENARIO_CHANNEL_EFFECTS_H

#include "src/scenario/channel/channels_private.h"
#include "src/scenario/channel/light.h"

// Adds the faults of a signal: its terms, its power, its flags.
// Given:
//   c      channels
//   place  satellite
//   l      its light
//   t      instant of reception
//   as_of  instant whose faults there are (orr_faults_at)
//   out    channel, whose terms of faults are not set yet
// Returned:
//   out    with them
void effects_fault(const orr_channels *c, size_t place, const orr_light *l, orr_time t, orr_time as_of,
                   orr_channel *out);

#endif
