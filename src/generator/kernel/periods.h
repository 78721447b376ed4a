// SPDX-License-Identifier: MIT
// A code over a piece: which of its periods is played where, and the group of samples in which one gives way to the next.
#ifndef ORR_GENERATOR_KERNEL_PERIODS_H
#define ORR_GENERATOR_KERNEL_PERIODS_H

#include "src/generator/kernel/mix.h"

// The chips of one period, and the sign that they are played with.
typedef struct orr_gen_period {
    const int8_t *chips; // ORR_GEN_CHIPS_BEYOND more behind them readable
    int sign;            // 1 or -1
} orr_gen_period;

// What a period is made of. Its chips must stay until the next but one is asked for.
//
// Given:
//    user      as in orr_gen_code
//    number    of the period
//    from, to  sub-chips of it that will be played, all below orr_gen_code.chips
typedef orr_gen_period orr_gen_period_maker(void *user, int64_t number, size_t from, size_t to);

// A code at a piece's first sample.
typedef struct orr_gen_code_at {
    int64_t number; // of the period
    size_t chips;   // sub-chips of a period
    uint64_t code,
        code_step;      // since the period's begin and from sample to sample, 2^ORR_GEN_CODE_BITS a sub-chip
    orr_gen_chips kind; // of the chips
    orr_gen_period_maker *period;
    void *user; // of it
} orr_gen_code_at;

// Adds a code on its carrier to the groups of a piece. A period must be longer than a group.
//
// Given:
//    mix      the mixer
//    carrier  of the piece
//    code     at its first sample
//    groups   how many groups of samples
// Returned:
//    re, im   sums of the piece, to which is added
void orr_gen_periods_mix(orr_gen_mixer *mix, const orr_gen_carrier *carrier, const orr_gen_code_at *code,
                         size_t groups, int16_t *re, int16_t *im);

#endif
