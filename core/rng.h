// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random numbers, the same on every machine: counter-based, so that the k-th number of a stream is a
// pure function of (seed, stream, k) and can be asked in any order.
#ifndef ORR_CORE_RNG_H
#define ORR_CORE_RNG_H

#include <stdint.h>

// The k-th number of a stream, all 64 bits random.
uint64_t orr_rng_u64(uint64_t seed, uint64_t stream, uint64_t k);
// Uniform in [0, 1), with 53 bits.
double orr_rng_uniform(uint64_t seed, uint64_t stream, uint64_t k);
// Normal with mean 0 and variance 1 (Box and Muller 1958).
double orr_rng_normal(uint64_t seed, uint64_t stream, uint64_t k);
// The k-th four numbers of a stream, 32 random bits each; others than orr_rng_u64's.
void orr_rng_u32(uint64_t seed, uint64_t stream, uint64_t k, uint32_t out[4]);
#define ORR_RNG_BLOCK 16
// A block of them, independent, for long series: each has 32 bits, so that none is beyond 6.7.
//   Given:    seed, stream, k   which block
//   Returned: out               [ORR_RNG_BLOCK] the numbers; others than orr_rng_normal's
void orr_rng_normals(uint64_t seed, uint64_t stream, uint64_t k, double out[ORR_RNG_BLOCK]);

#endif
