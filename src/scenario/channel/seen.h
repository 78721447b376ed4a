// SPDX-License-Identifier: GPL-3.0-or-later
// Section `mask`: which satellites an antenna sees.
#ifndef ORR_SCENARIO_CHANNEL_SEEN_H
#define ORR_SCENARIO_CHANNEL_SEEN_H

#include "src/scenario/channel/channels_private.h"

// Where a satellite stands for an antenna, by its place at reception: what STATES and DELAYS speak of.
typedef struct seen_direction {
    double az_rad, el_rad;
    bool seen;
} seen_direction;

// Direction of a satellite.
// Given:
//   c, antenna  channels, and which antenna
//   at          the antenna at an instant
//   sat_m       the satellite then, ecef
seen_direction seen_at(const orr_channels *c, size_t antenna, const orr_antenna_state *at, orr_vec3 sat_m);

// Satellites that may come above the mask in the lattice's cell of t, into the antenna's workspace: all others need no
// second look.
// Given:
//   c, antenna  channels, and which antenna
//   work        workspace
//   t           instant of reception
//   at          the antenna then
void seen_candidates(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                     const orr_antenna_state *at);

#endif
