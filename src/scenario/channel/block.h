// SPDX-License-Identifier: GPL-3.0-or-later
// Channels as cubics over a block of time: what a generator plays. Neighbouring blocks share the evaluation at their joint, so
// that value and rate go on exactly.
#ifndef ORR_SCENARIO_CHANNEL_BLOCK_H
#define ORR_SCENARIO_CHANNEL_BLOCK_H

#include "src/scenario/channel/channel.h"

#define ORR_BLOCK_CELL_NS (10 * ORR_NS_PER_S) // all blocks of a cell have one length
// Begin of the cell that holds t.
static inline orr_time orr_block_cell(orr_time t) { return t - orr_floor_mod(t, ORR_BLOCK_CELL_NS); }

// One channel over [t0, t0 + length): with s the seconds since t0, its code is
//   code[0] + code[1] s + code[2] s^2 + code[3] s^3 metres,
// its carrier carrier_cycles + carrier[0] + carrier[1] s + ... cycles.
typedef struct orr_block {
    orr_channel at; // the channel at t0, with its terms
    double code[4], carrier[4];
    int64_t carrier_cycles; // whole cycles at t0; carrier[0] is the rest, [0, 1)
} orr_block;

// The blocks of an antenna that begin at one instant.
typedef struct orr_blocks {
    orr_time t0;
    int64_t length_ns;
    double
        error_m; // greatest error of the cubics against the antenna's motion that was found in the cell; above
                 // channel.error_m where even the shortest length does not hold it
} orr_blocks;

// The blocks that hold t.
// Given:
//   c         channels
//   antenna   which, from 0
//   work      workspace of these channels
//   t         instant of reception
//   signals   those that are wanted, as orr_channels_signals
// Returned:
//   out       begin, length and error
//   block     [at most orr_channels_max] those that the antenna sees at t0, by satellite, signal and echo
//   n         how many
// Answers: as orr_channels_at, at t0 and at the end of the block.
// Notes: a function of (scenario, t) alone. Blocks lie on multiples of their length. A satellite whose arc ends within the block
// has none. Where blocks are asked for one after the other, each is one evaluation: its begin is the end of the one before.
orr_answer orr_blocks_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                         uint64_t signals, orr_blocks *out, orr_block *block, size_t *n);

// Length of the blocks of a cell and the error found: by the antenna's motion alone, from the shortest length on, each tried at
// middles and by their rates, until one errs by more than channel.error_m / 1.25.
// Given:
//   c, antenna  channels and which antenna
//   cell        begin of the cell
// Returned:
//   length_ns, error_m  the length, and the greatest error of those tried that have it
// Notes: a middle alone is no honest test: a motion of 20 Hz has a node there at 100 ms.
void orr_block_length_of(const orr_channels *c, size_t antenna, orr_time cell, int64_t *length_ns,
                         double *error_m);

#endif
