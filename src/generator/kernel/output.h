// SPDX-License-Identifier: MIT
// From sums to what is written: gain, seeded Gaussian noise, rounding and packing.
#ifndef ORR_GENERATOR_KERNEL_OUTPUT_H
#define ORR_GENERATOR_KERNEL_OUTPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum orr_gen_format {
    ORR_GEN_I8,  // I, Q, bytes
    ORR_GEN_I16, // little-endian
    ORR_GEN_I2, // a byte a sample until it is packed: I sign, I magnitude, Q sign, Q magnitude from the lowest bit
    ORR_GEN_F32, // little-endian
} orr_gen_format;

// A table of the normal distribution: value k is that of probability (k + 1/2) / 65536, 7000 for one standard deviation.
typedef struct orr_gen_noise {
    int16_t value[65536];
} orr_gen_noise;

// Fills the table.
void orr_gen_noise_init(orr_gen_noise *noise);

typedef struct orr_gen_output {
    orr_gen_format format;
    double gain; // output units in a unit of the sum; of I2, standard deviations of its magnitude's threshold
    double sigma;               // standard deviation of the noise of I and of Q, in output units; 0: none
    const orr_gen_noise *noise; // may be NULL where sigma is 0
    uint64_t seed;              // of the noise: another stream, another seed
} orr_gen_output;

// Bytes that n samples take, before packing.
size_t orr_gen_output_size(orr_gen_format format, size_t n);

// What is to be written: sums of groups of channels, each of 16 bits.
typedef struct orr_gen_sums {
    const int16_t *re, *im;           // of the last group
    const int32_t *rest_re, *rest_im; // of all groups before it; NULL where there are none
    double most;                      // no sum of all is larger
} orr_gen_sums;

// Writes n samples. The noise of a sample depends on the seed and its number alone.
//
// Given:
//    out      what to make of the sums
//    sums     of n samples
//    first    number of the first sample
//    n        how many
// Returned:
//    bytes    orr_gen_output_size(out->format, n) of them
// The function returns how many samples were beyond what the format holds and have its largest value.
typedef size_t orr_gen_output_writer(const orr_gen_output *out, const orr_gen_sums *sums, int64_t first,
                                     size_t n, uint8_t *bytes);
orr_gen_output_writer orr_gen_output_write, orr_gen_output_write_avx2; // in plain C; for AVX2

// Packs samples of I2, two a byte, the first in the low half: n bytes in place, of which (n + 1) / 2 are left. Of an odd last
// one the high half is 0.
size_t orr_gen_output_pack(uint8_t *bytes, size_t n);

#endif
