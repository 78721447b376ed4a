// SPDX-License-Identifier: GPL-3.0-or-later
// Philox 2x64-10: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC'11. The
// counter is (k, stream), the key the seed.
#include "core/rng.h"

#include <math.h>

#include "core/constants.h"

#define MULTIPLIER UINT64_C(0xD2B74407B1CE6E93)
#define WEYL UINT64_C(0x9E3779B97F4A7C15) // golden ratio
#define ROUNDS 10

// Both halves of a 128-bit product, in standard C.
static uint64_t multiply(uint64_t a, uint64_t b, uint64_t *high)
{
    uint64_t a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
    uint64_t low = a0 * b0, m1 = a1 * b0, m2 = a0 * b1;
    uint64_t carry = ((low >> 32) + (m1 & 0xffffffff) + (m2 & 0xffffffff)) >> 32;
    *high = a1 * b1 + (m1 >> 32) + (m2 >> 32) + carry;
    return a * b;
}

static void philox(uint64_t seed, uint64_t stream, uint64_t k, uint64_t out[2])
{
    uint64_t x = k, y = stream;
    for (int round = 0; round < ROUNDS; round++) {
        uint64_t high, low = multiply(MULTIPLIER, x, &high);
        x = high ^ seed ^ y;
        y = low;
        seed += WEYL;
    }
    out[0] = x;
    out[1] = y;
}

uint64_t orr_rng_u64(uint64_t seed, uint64_t stream, uint64_t k)
{
    uint64_t r[2];
    philox(seed, stream, k, r);
    return r[0];
}

double orr_rng_uniform(uint64_t seed, uint64_t stream, uint64_t k)
{
    return (double)(orr_rng_u64(seed, stream, k) >> 11) * 0x1p-53;
}

// Box and Muller 1958; the counter's two words give the radius and the angle.
static double radius(uint64_t word)
{
    return sqrt(-2.0 * log((double)((word >> 11) + 1) * 0x1p-53)); // of (0, 1]: the logarithm exists
}
static double angle(uint64_t word) { return 2.0 * ORR_PI * ((double)(word >> 11) * 0x1p-53); }

double orr_rng_normal(uint64_t seed, uint64_t stream, uint64_t k)
{
    uint64_t r[2];
    philox(seed, stream, k, r);
    return radius(r[0]) * cos(angle(r[1]));
}

void orr_rng_normal_pair(uint64_t seed, uint64_t stream, uint64_t k, double out[2])
{
    uint64_t r[2];
    philox(seed, stream, k, r);
    const double a = radius(r[0]), b = angle(r[1]);
    out[0] = a * cos(b);
    out[1] = a * sin(b);
}
