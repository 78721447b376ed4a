// SPDX-License-Identifier: MIT
// Phasors of a carrier and their rotations, in doubles and a fixed order, compiled into each kernel so that each vectorises it as it
// can: no operation is fused (-ffp-contract=off), so that all give the same bits.
#ifndef ORR_GENERATOR_KERNEL_PHASOR_PRIVATE_H
#define ORR_GENERATOR_KERNEL_PHASOR_PRIVATE_H

#include <stdbool.h>

#include "src/generator/kernel/mix.h"
#include "src/generator/kernel/oscillator.h"

// cos and sin of a phase. Taylor's series on an eighth of a turn each side: 1e-16.
static inline void unit_phasor(uint64_t phase, double *re, double *im)
{
    const uint64_t quarter = phase + ((uint64_t)1 << 61); // rounded to the nearest quarter
    const double x =
        (double)(int64_t)(phase - (quarter & ((uint64_t)3 << 62))) * (6.283185307179586477 * 0x1p-64);
    const double y = x * x;
    const double c =
        1.0 - y * (1.0 / 2 -
                   y * (1.0 / 24 -
                        y * (1.0 / 720 -
                             y * (1.0 / 40320 -
                                  y * (1.0 / 3628800 - y * (1.0 / 479001600 - y * (1.0 / 87178291200.0)))))));
    const double s =
        x *
        (1.0 -
         y * (1.0 / 6 -
              y * (1.0 / 120 -
                   y * (1.0 / 5040 - y * (1.0 / 362880 - y * (1.0 / 39916800 - y * (1.0 / 6227020800.0)))))));
    // By quarters: (c, s), (-s, c), (-c, -s), (s, -c). No branches: each is as likely as the others.
    static const double sign[2][4] = {{1, -1, -1, 1}, {1, 1, -1, -1}};
    const double part[2] = {c, s};
    const size_t q = (size_t)(quarter >> 62);
    *re = sign[0][q] * part[q % 2];
    *im = sign[1][q] * part[1 - q % 2];
}

// One doubling of `powers`: z[m + k] = z[k] w for k below m, and w becomes its square.
static inline __attribute__((always_inline)) void double_up(double *restrict re, double *restrict im,
                                                            size_t m, double *w_re, double *w_im)
{
    const double a = *w_re, b = *w_im;
    for (size_t k = 0; k < m; k++) {
        re[m + k] = re[k] * a - im[k] * b;
        im[m + k] = re[k] * b + im[k] * a;
    }
    *w_re = a * a - b * b;
    *w_im = 2.0 * (a * b);
}

// z[k] = z[0] w^k for k below n, by doubling; arrays hold n rounded up to a power of two, 32 at least. Doublings of constant length
// are there for the compiler, which makes vectors of them.
static inline void powers(double *restrict re, double *restrict im, double w_re, double w_im, size_t n)
{
    double_up(re, im, 1, &w_re, &w_im);
    double_up(re, im, 2, &w_re, &w_im);
    double_up(re, im, 4, &w_re, &w_im);
    double_up(re, im, 8, &w_re, &w_im);
    double_up(re, im, 16, &w_re, &w_im);
    if (n > 32) double_up(re, im, 32, &w_re, &w_im);
    if (n > 64) double_up(re, im, 64, &w_re, &w_im);
}

// The nearest integer, halves to even, of |x| < 2^31: added to 1.5 * 2^52 it stands in the lowest bits.
static inline int16_t nearest(double x) { return (int16_t)(int32_t)(x + 0x1.8p52 - 0x1.8p52); }

// As orr_gen_carrier_maker says it.
static inline void make_carrier(uint64_t phase, uint64_t step, double amplitude, size_t groups,
                                orr_gen_carrier *c)
{
    double re[ORR_GEN_GROUPS], im[ORR_GEN_GROUPS], turn_re[ORR_GEN_GROUP], turn_im[ORR_GEN_GROUP];
    double sample_re, sample_im, group_re, group_im;
    unit_phasor(step, &sample_re, &sample_im);
    unit_phasor(step * ORR_GEN_GROUP, &group_re, &group_im);
    unit_phasor(phase, &re[0], &im[0]);
    turn_re[0] = 8192.0, turn_im[0] = 0.0;
    re[0] *= 4.0 * amplitude;
    im[0] *= 4.0 * amplitude;
    powers(turn_re, turn_im, sample_re, sample_im, ORR_GEN_GROUP);
    powers(re, im, group_re, group_im, groups);
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) c->re[k] = nearest(turn_re[k]);
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) c->im[k] = nearest(turn_im[k]);
    for (size_t at = 0; at < groups; at += 32) {
        for (size_t k = at; k < at + 32; k++) c->group_re[k] = (uint16_t)nearest(re[k]) * 0x10001u;
        for (size_t k = at; k < at + 32; k++) c->group_im[k] = (uint16_t)nearest(im[k]) * 0x10001u;
    }
}

// Phases of eight samples of one load of chips, less that of the first: 1/8192 sub-chip, rounded. Returns by how much a run's code word is
// to be ahead of its phase. That the phase of the first is truncated moves no edge, as a step is a whole number of the units that
// are left; but what steps are rounded by is the same in all groups, up to 3e-5 sub-chip in the mean. Where it is more than half a unit of
// one sample early, the step that was rounded up furthest is rounded down; where it is late, all of the code is made as
// much earlier. What remains is 7.7e-6 sub-chip at most, and no edge is off by more than 1e-4.
static inline uint64_t steps_of_eight(uint64_t code_step, uint16_t steps[8])
{
    enum { LOW = ORR_GEN_CODE_BITS - 13 };
    const int64_t unit = (int64_t)1 << LOW;
    int64_t early[8], sum = 0;
    for (unsigned i = 0; i < 8; i++) {
        const uint64_t exact = i * code_step;
        steps[i] = (uint16_t)((exact + ((uint64_t)1 << (LOW - 1))) >> LOW);
        early[i] = (int64_t)(((uint64_t)steps[i] << LOW) - exact);
        sum += early[i];
    }
    while (sum > unit / 2) {
        unsigned most = 1;
        for (unsigned i = 2; i < 8; i++)
            if (early[i] > early[most]) most = i;
        steps[most]--;
        early[most] -= unit;
        sum -= unit;
    }
    return sum < 0 ? (uint64_t)(-sum / 8) : 0;
}

static inline void add_all(bool first, const int16_t *restrict group, size_t n, int32_t *restrict sum)
{
    if (first)
        for (size_t k = 0; k < n; k++) sum[k] = group[k];
    else
        for (size_t k = 0; k < n; k++) sum[k] += group[k];
}

#endif
