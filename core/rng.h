// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random numbers, the same on every machine: counter-based, so that the k-th number of a stream is a
// pure function of (seed, stream, k) and can be asked in any order.
#ifndef ORR_CORE_RNG_H
#define ORR_CORE_RNG_H

#include <stdint.h>

uint64_t orr_rng_u64(uint64_t seed, uint64_t stream, uint64_t k);
double orr_rng_uniform(uint64_t seed, uint64_t stream, uint64_t k); // [0, 1), 53 bits
double orr_rng_normal(uint64_t seed, uint64_t stream, uint64_t k);  // mean 0, variance 1

#endif
