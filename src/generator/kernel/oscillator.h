// SPDX-License-Identifier: MIT
// From the cubics of a block to integer oscillators. A piece of at most ORR_GEN_PIECE samples is played by a code and a
// carrier of constant rate, the chords of the cubics between its ends; both are 64-bit words, so that a sample's phase is
// word + k * step, exact and the same on every machine. docs/generator.md derives each formula.
#ifndef ORR_GENERATOR_KERNEL_OSCILLATOR_H
#define ORR_GENERATOR_KERNEL_OSCILLATOR_H

#include <stdint.h>

// Samples of one piece. Pieces begin at multiples of this many samples since 1980-01-06T00:00:00 of the scale of the wire
// and where a block begins, wherever a run began: a stream that is taken up again has the same bytes.
#define ORR_GEN_PIECE 4096

// Fractional bits of a sub-chip in the words of codes: a second of 12.276 million sub-chips stays below 2^63.
#define ORR_GEN_CODE_BITS 39

// What the wire says of a channel over a block (CHANNELS, sat_channel).
typedef struct orr_gen_cubics {
    int64_t block_ns;         // the block's begin
    double code_m[4];         // pseudorange: sum of code_m[k] s^k, s in seconds since block_ns
    double carrier_cycles[4]; // phase range less the whole cycles, likewise
    int64_t transmit_ns;      // reading of the satellite's clock when the code at block_ns was sent
    double transmit_rest_ns;  // and what is beyond whole nanoseconds, 0 to 1
    double carrier_hz;
} orr_gen_cubics;

// Where a signal is in the stream. The intermediate frequency is the nominal carrier less the stream's centre.
typedef struct orr_gen_tuning {
    uint32_t rate_hz;     // samples a second
    int64_t offset_hz;    // intermediate frequency
    uint32_t chips_per_s; // sub-chips: the ranging code's chips times the sub-carrier's changes in one
} orr_gen_tuning;

typedef struct orr_gen_oscillator {
    uint64_t carrier, carrier_step; // 2^64 a cycle
    int64_t code_s;                 // whole second of the satellite's time at the piece's first sample
    uint64_t code, code_step;       // sub-chips since that second, 2^ORR_GEN_CODE_BITS each
} orr_gen_oscillator;

// The first sample at or after an instant, counted from 1980-01-06T00:00:00.
int64_t orr_gen_first_sample(int64_t t_ns, uint32_t rate_hz);

// The oscillators of the samples first .. first + n - 1.
//
// Given:
//    cubics    the channel's block; the samples lie in it, or at most one piece beyond it
//    tuning    the signal in the stream
//    first     number of the first sample since 1980-01-06T00:00:00
//    n         how many samples, 1 to ORR_GEN_PIECE
// Returned:
//    o         their oscillators
// Notes:
//    Against the cubics the chord errs by at most (n / rate)^2 / 8 times the second derivative, in the middle of the piece;
//    rounding of words adds 2^-53 of what the cubics hold.
void orr_gen_oscillators(const orr_gen_cubics *cubics, const orr_gen_tuning *tuning, int64_t first,
                         uint32_t n, orr_gen_oscillator *o);

#endif
