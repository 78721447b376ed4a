// SPDX-License-Identifier: MIT
// The inner loop: samples of one code on one carrier, added to a sum. Integers throughout but for the phasors, which are
// sums and products of doubles in a fixed order: plain C, AVX2 and NEON give the same bits.
#ifndef ORR_GENERATOR_KERNEL_MIX_H
#define ORR_GENERATOR_KERNEL_MIX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Samples that share one phasor, times a table of rotations.
#define ORR_GEN_GROUP 32
// Sub-chips that must be readable behind the last one played: those of the rest of a group, and of a load of eight.
#define ORR_GEN_CHIPS_BEYOND 40
// Sub-chips in a sample: at most 7/8, so that eight samples see no more than eight.
#define ORR_GEN_CHIPS_IN_SAMPLE 0.875

// The largest amplitude of a run.
#define ORR_GEN_AMPLITUDE 8191

// The rotations of a carrier of constant rate, 8192 for 1: one table for all runs of a piece. Phasors are held four times as
// large as they are played, so that of their rounding little is left beside that of the product.
typedef struct orr_gen_rotation {
    uint64_t step; // cycles in a sample, 2^64 each
    int16_t re[ORR_GEN_GROUP], im[ORR_GEN_GROUP];
    double group_re, group_im; // of ORR_GEN_GROUP samples
} orr_gen_rotation;

// What the chips of a run are.
typedef enum orr_gen_chips {
    ORR_GEN_SIGNS,   // -1, 1
    ORR_GEN_TERNARY, // -1, 0, 1
    ORR_GEN_LEVELS,  // -127 to 127, in 1/128 of the amplitude
} orr_gen_chips;

// A run of samples within one period of the code and one piece.
typedef struct orr_gen_run {
    const orr_gen_rotation *rotation;
    uint64_t carrier; // phase of the first sample, 2^64 a cycle
    double
        amplitude; // of the carrier at a chip of 1; negative turns all chips. |amplitude| <= ORR_GEN_AMPLITUDE
    const int8_t *chips;      // sub-chips of the period, ORR_GEN_CHIPS_BEYOND more behind them readable
    uint64_t code, code_step; // of the first sample since the period's begin, 2^ORR_GEN_CODE_BITS a sub-chip
    orr_gen_chips kind;       // of the chips
    size_t n;                 // samples, at most ORR_GEN_PIECE
} orr_gen_run;

// Adds the run's samples to re[0..n) and im[0..n). Sums must stay within 16 bits: the caller keeps the sum of amplitudes
// below 32767 less one a channel.
typedef void orr_gen_mixer(const orr_gen_run *run, int16_t *re, int16_t *im);
// Fills r for a carrier of carrier_step a sample.
typedef void orr_gen_rotator(uint64_t carrier_step, orr_gen_rotation *r);
// Adds n sums of a group of channels to those of all groups, or puts those of the first there.
typedef void orr_gen_adder(bool first, const int16_t *group, size_t n, int32_t *sum);

orr_gen_mixer orr_gen_mix_plain, orr_gen_mix_avx2, orr_gen_mix_neon;
orr_gen_rotator orr_gen_rotate_plain, orr_gen_rotate_avx2;
orr_gen_adder orr_gen_add_plain, orr_gen_add_avx2;

#endif
