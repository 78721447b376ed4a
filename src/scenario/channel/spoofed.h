// SPDX-License-Identifier: GPL-3.0-or-later
// False sets of channels: what a receiver elsewhere would receive, sent from a transmitter that the antennas hear.
#ifndef ORR_SCENARIO_CHANNEL_SPOOFED_H
#define ORR_SCENARIO_CHANNEL_SPOOFED_H

#include "src/scenario/channel/channels_private.h"
#include "src/scenario/effect/mover.h"

// One of them.
typedef struct spoofer {
    bool has_sats;
    orr_sat_set sats;
    orr_interval sends;
    orr_mover transmitter;
    double delay_m, power_db;
} spoofer;

// The false sky of a scenario: channels of the places that spoofers tell of, without any effect of the surroundings, and the
// spoofers.
struct spoofed {
    orr_channels sky; // borrows from the scenario's channels; its antennas are the places told, one a spoofer
    spoofer item[ORR_MAX_SPOOFERS];
};

// Prepares the section `spoofers` of prepared channels, and makes room for theirs in c->max_channels; c->spoofed stays NULL without it.
// Given:
//   s       scenario
//   c       channels, prepared but for this
//   cancel  ends it; may be NULL
// Returned:
//   c       with its false sky
//   diag    why it failed
// Errors: those of the turns' count, ORR_E_MEMORY.
orr_status spoofed_open(const orr_scenario *s, orr_channels *c, const volatile int *cancel, orr_diag *diag);
void spoofed_close(struct spoofed *x); // NULL is allowed

// Whether any spoofer begins or ends in after < t <= until.
bool spoofed_change(const orr_channels *c, orr_time after, orr_time until);
// Whether those that do so in [from, to) do it on multiples of length_ns.
bool spoofed_allow(const orr_channels *c, orr_time from, orr_time to, int64_t length_ns);

#endif
