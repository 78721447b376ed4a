// SPDX-License-Identifier: GPL-3.0-or-later
// Philox 2x64-10: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC'11. The
// counter is (k, stream), the key the seed.
#include "core/rng.h"

#include <math.h>
#include <stddef.h>

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
double orr_rng_normal(uint64_t seed, uint64_t stream, uint64_t k)
{
    uint64_t r[2];
    philox(seed, stream, k, r);
    double u = (double)((r[0] >> 11) + 1) * 0x1p-53; // (0, 1]: its logarithm exists
    double v = (double)(r[1] >> 11) * 0x1p-53;
    return sqrt(-2.0 * log(u)) * cos(2.0 * ORR_PI * v);
}

// sin and cos of 2 pi v, 0 <= v < 1, to 1e-12: Taylor's series about the nearest quarter turn.
static void turn(double v, double *sine, double *cosine)
{
    const double quarter = floor(4.0 * v + 0.5), a = 0.5 * ORR_PI * (4.0 * v - quarter), b = a * a;
    const double s =
        a * (1.0 +
             b * (-1.0 / 6.0 +
                  b * (1.0 / 120.0 + b * (-1.0 / 5040.0 + b * (1.0 / 362880.0 + b * (-1.0 / 39916800.0))))));
    const double c =
        1.0 + b * (-0.5 + b * (1.0 / 24.0 +
                               b * (-1.0 / 720.0 +
                                    b * (1.0 / 40320.0 + b * (-1.0 / 3628800.0 + b * (1.0 / 479001600.0))))));
    const int q = (int)quarter & 3;
    *sine = q == 0 ? s : q == 1 ? c : q == 2 ? -s : -c;
    *cosine = q == 0 ? c : q == 1 ? -s : q == 2 ? -c : s;
}

// Philox 4x32-10, of the same paper: half the work for as many bits, where 32 of them are enough for a number.
static void philox32(uint64_t seed, const uint32_t counter[4], uint32_t out[4])
{
    const uint64_t m0 = UINT64_C(0xD2511F53), m1 = UINT64_C(0xCD9E8D57);
    uint32_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3];
    uint32_t k0 = (uint32_t)seed, k1 = (uint32_t)(seed >> 32);
    for (int round = 0; round < ROUNDS; round++) {
        const uint64_t a = m0 * c0, b = m1 * c2;
        c0 = (uint32_t)(b >> 32) ^ c1 ^ k0;
        c2 = (uint32_t)(a >> 32) ^ c3 ^ k1;
        c1 = (uint32_t)b;
        c3 = (uint32_t)a;
        k0 += UINT32_C(0x9E3779B9);
        k1 += UINT32_C(0xBB67AE85);
    }
    out[0] = c0;
    out[1] = c1;
    out[2] = c2;
    out[3] = c3;
}

void orr_rng_u32(uint64_t seed, uint64_t stream, uint64_t k, uint32_t out[4])
{
    const uint32_t counter[4] = {(uint32_t)k, (uint32_t)(k >> 32), (uint32_t)stream,
                                 (uint32_t)(stream >> 32)};
    philox32(seed, counter, out);
}

// A word a radius, a word an angle, whose cosine and sine are both of use.
void orr_rng_normals(uint64_t seed, uint64_t stream, uint64_t k, double out[ORR_RNG_BLOCK])
{
    uint32_t word[ORR_RNG_BLOCK];
    for (size_t i = 0; i < ORR_RNG_BLOCK / 4; i++)
        orr_rng_u32(seed, stream, k * (ORR_RNG_BLOCK / 4) + i, &word[4 * i]);
    for (size_t i = 0; i < ORR_RNG_BLOCK; i += 2) {
        const double radius = sqrt(-2.0 * log(((double)word[i] + 1.0) * 0x1p-32));
        double s, c;
        turn((double)word[i + 1] * 0x1p-32, &s, &c);
        out[i] = radius * c;
        out[i + 1] = radius * s;
    }
}
