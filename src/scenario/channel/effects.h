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

// Adds what a recorded day has of a signal: its terms and its power.
// Given:
//   c      channels
//   sent   the signal
//   t      instant of reception
//   as_of  instant whose arc it is (orr_replay_at)
//   out    channel with the terms of its models
// Returned:
//   start  integer of its carrier
//   out    with them
// Returns false where it was not observed then; without a recorded day nothing is added.
bool effects_replay(const orr_channels *c, const channel_sent *sent, orr_time t, orr_time as_of,
                    int64_t *start, orr_channel *out);

// Adds scintillation to a signal: its term and its power.
// Given:
//   c          channels that have it
//   antenna    whose
//   t          instant
//   s4         of its satellite's ray, and
//   sigma_rad  of its phase, at 1575.42 MHz
//   fading     processes of the satellite at the antenna
// Returned:
//   fading     likewise
//   out        with it
void effects_scintillation(const orr_channels *c, size_t antenna, orr_time t, double s4, double sigma_rad,
                           orr_scintillation_cell *fading, orr_channel *out);
// Adds what a road in view or in shadow does to a signal: its term and its power. Given and Returned: as effects_fault.
void effects_land_mobile(const orr_channels *c, size_t place, orr_time t, orr_time as_of, orr_channel *out);
// Turbulence of the troposphere along a ray, which all signals share.
// Given:
//   c      channels that have it
//   t      instant
//   at     the antenna then
//   l      the satellite's light
// Returned:
//   delay_m, delay_mps  its term and its rate
void effects_turbulence(const orr_channels *c, orr_time t, const orr_antenna_state *at, const orr_light *l,
                        double *delay_m, double *delay_mps);
// Makes a channel that of an echo of it: its terms, power and number; sums are the caller's.
void effects_echo(const orr_echo *echo, orr_channel *out);
// Whether effects change in after < t <= until, so that a block that ends at t is not the begin of the next.
bool effects_change(const orr_channels *c, orr_time after, orr_time until);
// Whether blocks of this length, on multiples of it, follow the effects of an antenna in the block's cell (orr_faults_allow).
bool effects_allow(const orr_channels *c, size_t antenna, orr_time cell, int64_t length_ns);

#endif
