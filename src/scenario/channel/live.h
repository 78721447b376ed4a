// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of antennas that ride on a body whose motion comes from outside. Slow terms are computed along straight lines, taken up
// anew where the body has left them by 30 m; what follows the motion itself is exact.
#ifndef ORR_SCENARIO_CHANNEL_LIVE_H
#define ORR_SCENARIO_CHANNEL_LIVE_H

#include "src/scenario/channel/block.h"

typedef struct orr_live_channels orr_live_channels;

// Prepares the antennas of channels for live motion; for one thread. Errors: ORR_E_MEMORY. Free with orr_live_channels_close.
orr_status orr_live_channels_open(const orr_channels *c, orr_live_channels **out, orr_diag *diag);
void orr_live_channels_close(orr_live_channels *l); // NULL is allowed
// Whether an antenna rides on the body: it does not stand by itself.
bool orr_live_channels_rides(const orr_live_channels *l, size_t antenna);

// Motion at both ends of a block.
typedef struct orr_live_motion {
    orr_time t0, t1;
    orr_motion begin, end;
    bool arm;    // of the body: antennas are at their lever arms
    bool breaks; // the begin is not where the block before ended
} orr_live_motion;

// The blocks of an antenna along live motion.
// Given:
//   l         the live channels
//   antenna   which, one that rides
//   m         the motion
//   signals   those that are wanted
// Returned:
//   at        the antenna at the begin
//   block, n  as orr_blocks_at
// Answers: ORR_ANSWER_OK or ORR_ANSWER_OUTSIDE_SPAN.
orr_answer orr_live_blocks(orr_live_channels *l, size_t antenna, const orr_live_motion *m, uint64_t signals,
                           orr_antenna_state *at, orr_block *block, size_t *n);

#endif
