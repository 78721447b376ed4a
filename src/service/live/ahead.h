// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of channels for a thread that asks for one after the other. The block that was asked for last is kept, for shorter steps than it
// is long; and a thread of its own, with workspaces of its own, makes the block across the end of each cell of 10 s (docs/channels.md) while
// the cell before is still in use, so that preparing what the next cell needs (some ten milliseconds) makes no block late. Answers are those
// of orr_blocks_at to the bit.
#ifndef ORR_SERVICE_LIVE_AHEAD_H
#define ORR_SERVICE_LIVE_AHEAD_H

#include "core/status.h"
#include "src/scenario/channel/block.h"

typedef struct orr_ahead orr_ahead;

// Starts the thread. The channels must outlive it. Errors: ORR_E_MEMORY. Free with orr_ahead_close.
orr_status orr_ahead_open(const orr_channels *c, orr_ahead **out, orr_diag *diag);
void orr_ahead_close(orr_ahead *a); // NULL is allowed

// As orr_blocks_at; one thread at a time may ask.
// Given:
//   a        of orr_ahead_open
//   antenna  which, from 0
//   t        instant
//   signals  those that are wanted
// Returned:
//   out      begin, length, error
//   block    [n] blocks, borrowed until the next call
//   n        how many
orr_answer orr_ahead_blocks(orr_ahead *a, size_t antenna, orr_time t, uint64_t signals, orr_blocks *out,
                            const orr_block **block, size_t *n);
// Somebody will ask for the block that holds t: it is made meanwhile. Any thread may say so.
void orr_ahead_expect(orr_ahead *a, size_t antenna, orr_time t, uint64_t signals);

#endif
