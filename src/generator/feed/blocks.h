// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of an antenna's channels, one after the other as time goes on.
#ifndef ORR_GENERATOR_FEED_BLOCKS_H
#define ORR_GENERATOR_FEED_BLOCKS_H

#include "src/generator/feed/link.h"
#include "src/generator/kernel/oscillator.h"

typedef struct orr_gen_channel {
    char system;
    uint8_t number;
    uint8_t signal;             // its place in orr_gen_service.signal
    bool echo;                  // or a spoofer's
    double power_dbw, strength; // strength: 10^(power_dbw / 20)
    double share;               // of an echo its strength against its signal's; else 1
    orr_gen_cubics cubics;
} orr_gen_channel;

typedef struct orr_gen_block {
    int64_t begin_ns, length_ns;
    double error_m; // as CHANNELS says it
    size_t n, capacity;
    orr_gen_channel *channel;
} orr_gen_block;

typedef struct orr_gen_blocks orr_gen_blocks;

// Makes ready to ask for blocks.
//
// Given:
//    link       the connection
//    service    what CAPS says; must stay
//    antenna    which antenna
//    signal     places in service->signal of the signals that are wanted
//    n_signals  how many
// Returned:
//    blocks     to be closed
//    fault      why it failed
bool orr_gen_blocks_open(orr_gen_link *link, const orr_gen_service *service, uint16_t antenna,
                         const uint8_t *signal, size_t n_signals, orr_gen_blocks **blocks,
                         orr_gen_fault *fault);
// Frees it; NULL may be closed.
void orr_gen_blocks_close(orr_gen_blocks *blocks);

// Consecutive blocks.
//
// Given:
//    blocks  of which antenna and signals
//    t_ns    an instant that the first of them holds
// Returned:
//    block   block[0 .. n), kept until the next call
//    n       how many
//    fault   why it failed: outside the span that is served
bool orr_gen_blocks_from(orr_gen_blocks *blocks, int64_t t_ns, const orr_gen_block **block, size_t *n,
                         orr_gen_fault *fault);

#endif
