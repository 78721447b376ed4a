// SPDX-License-Identifier: MIT
// The inner loop: samples of one code on one carrier, added to a sum. Integers throughout but for the phasors, which are
// sums and products of doubles in a fixed order: plain C, AVX2 and NEON give the same bits.
#ifndef ORR_GENERATOR_KERNEL_MIX_H
#define ORR_GENERATOR_KERNEL_MIX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "src/generator/kernel/oscillator.h"

// Samples that share one phasor, times a table of rotations; and groups of them in a piece.
#define ORR_GEN_GROUP 32
#define ORR_GEN_GROUPS (ORR_GEN_PIECE / ORR_GEN_GROUP)
// Sub-chips that must be readable behind the last of a period.
#define ORR_GEN_CHIPS_BEYOND 40
// Sub-chips in a sample: at most 7/8, so that eight samples see no more than eight.
#define ORR_GEN_CHIPS_IN_SAMPLE 0.875

// The largest amplitude of a carrier.
#define ORR_GEN_AMPLITUDE 8191

// A carrier of constant rate over a piece. Phasors are held four times as large as they are played, so that of their rounding little
// is left beside that of the product.
typedef struct orr_gen_carrier {
    int16_t re[ORR_GEN_GROUP], im[ORR_GEN_GROUP]; // rotations within a group, 8192 for 1
    uint32_t group_re[ORR_GEN_GROUPS],
        group_im[ORR_GEN_GROUPS]; // phasors, twice in a word as vectors take them
} orr_gen_carrier;

// What the chips of a run are.
typedef enum orr_gen_chips {
    ORR_GEN_SIGNS,   // -1, 1
    ORR_GEN_TERNARY, // -1, 0, 1
    ORR_GEN_LEVELS,  // -127 to 127, in 1/128 of the amplitude
} orr_gen_chips;

// Groups of a piece within one period of the code.
typedef struct orr_gen_run {
    const orr_gen_carrier *carrier; // of the piece
    size_t group, n;                // the first group, and how many
    int sign;                       // 1 or -1, of all chips
    const int8_t *chips;            // sub-chips of the period, ORR_GEN_CHIPS_BEYOND more behind them readable
    uint64_t code, code_step; // of the first sample since the period's begin, 2^ORR_GEN_CODE_BITS a sub-chip
    orr_gen_chips kind;       // of the chips
} orr_gen_run;

// Adds the run's samples to those of the piece, re and im, whole groups of them. Sums must stay within 16 bits: the caller keeps the
// sum of amplitudes below 32767 less one a channel.
typedef void orr_gen_mixer(const orr_gen_run *run, int16_t *re, int16_t *im);

// A carrier.
//
// Given:
//    phase      of the first sample, 2^64 a cycle
//    step       from sample to sample, likewise
//    amplitude  at a chip of 1, at most ORR_GEN_AMPLITUDE
//    groups     how many of its groups are wanted, at most ORR_GEN_GROUPS
// Returned:
//    c          the carrier
typedef void orr_gen_carrier_maker(uint64_t phase, uint64_t step, double amplitude, size_t groups,
                                   orr_gen_carrier *c);

// Adds n sums of a group of channels to those of all groups, or puts those of the first there.
typedef void orr_gen_adder(bool first, const int16_t *group, size_t n, int32_t *sum);

orr_gen_mixer orr_gen_mix_plain, orr_gen_mix_avx2, orr_gen_mix_neon;
orr_gen_carrier_maker orr_gen_carrier_plain, orr_gen_carrier_avx2;
orr_gen_adder orr_gen_add_plain, orr_gen_add_avx2;

#endif
