// SPDX-License-Identifier: MIT
// Phasors of a run and their rotations, in doubles and a fixed order, compiled into each mixer so that each vectorises it as it
// can: no operation is fused (-ffp-contract=off), so that all give the same bits.
#ifndef ORR_GENERATOR_KERNEL_PHASOR_PRIVATE_H
#define ORR_GENERATOR_KERNEL_PHASOR_PRIVATE_H

#include <stdbool.h>

#include "src/generator/kernel/mix.h"
#include "src/generator/kernel/oscillator.h"

#define GROUPS (ORR_GEN_PIECE / ORR_GEN_GROUP + 1)

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
    switch (quarter >> 62) {
    case 0:
        *re = c, *im = s;
        break;
    case 1:
        *re = -s, *im = c;
        break;
    case 2:
        *re = -c, *im = -s;
        break;
    default:
        *re = s, *im = -c;
        break;
    }
}

// One doubling of `powers`: z[m + k] = z[k] w for k below n, at most m, and w becomes its square.
static inline __attribute__((always_inline)) void double_up(double *restrict re, double *restrict im,
                                                            size_t m, size_t n, double *w_re, double *w_im)
{
    const double a = *w_re, b = *w_im;
    for (size_t k = 0; k < n; k++) {
        re[m + k] = re[k] * a - im[k] * b;
        im[m + k] = re[k] * b + im[k] * a;
    }
    *w_re = a * a - b * b;
    *w_im = 2.0 * (a * b);
}

// z[k] = z[0] w^k for k below n, by doubling. Arrays hold n, 32 at least. Doublings of constant length
// are there for the compiler, which makes vectors of them.
static inline void powers(double *restrict re, double *restrict im, double w_re, double w_im, size_t n)
{
    double_up(re, im, 1, 1, &w_re, &w_im);
    double_up(re, im, 2, 2, &w_re, &w_im);
    double_up(re, im, 4, 4, &w_re, &w_im);
    double_up(re, im, 8, 8, &w_re, &w_im);
    double_up(re, im, 16, 16, &w_re, &w_im);
    for (size_t m = 32; m < n; m *= 2) double_up(re, im, m, m < n - m ? m : n - m, &w_re, &w_im);
}

// The nearest integer, halves to even, of |x| < 2^31: added to 1.5 * 2^52 it stands in the lowest bits.
static inline int16_t nearest(double x) { return (int16_t)(int32_t)(x + 0x1.8p52 - 0x1.8p52); }

// A phasor a group of the run, four times its amplitude; twice in a word, as vectors take it.
static inline size_t run_phasors(const orr_gen_run *run, uint32_t *restrict re, uint32_t *restrict im)
{
    double z_re[GROUPS], z_im[GROUPS];
    const size_t n = (run->n + ORR_GEN_GROUP - 1) / ORR_GEN_GROUP;
    unit_phasor(run->carrier, &z_re[0], &z_im[0]);
    z_re[0] *= 4.0 * run->amplitude;
    z_im[0] *= 4.0 * run->amplitude;
    powers(z_re, z_im, run->rotation->group_re, run->rotation->group_im, n);
    for (size_t k = 0; k < n; k++) re[k] = (uint16_t)nearest(z_re[k]) * 0x10001u;
    for (size_t k = 0; k < n; k++) im[k] = (uint16_t)nearest(z_im[k]) * 0x10001u;
    return n;
}

static inline void rotation_of(uint64_t carrier_step, orr_gen_rotation *r)
{
    double re[ORR_GEN_GROUP], im[ORR_GEN_GROUP], w_re, w_im;
    re[0] = 1.0, im[0] = 0.0;
    unit_phasor(carrier_step, &w_re, &w_im);
    powers(re, im, w_re, w_im, ORR_GEN_GROUP);
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) r->re[k] = nearest(8192.0 * re[k]);
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) r->im[k] = nearest(8192.0 * im[k]);
    unit_phasor(carrier_step * ORR_GEN_GROUP, &r->group_re, &r->group_im);
    r->step = carrier_step;
}

// Phases of eight samples of one load of chips, less that of the first: 1/8192 sub-chip, rounded.
static inline void steps_of_eight(uint64_t code_step, uint16_t steps[8])
{
    for (unsigned i = 0; i < 8; i++)
        steps[i] = (uint16_t)((i * code_step + ((uint64_t)1 << (ORR_GEN_CODE_BITS - 14))) >>
                              (ORR_GEN_CODE_BITS - 13));
}

static inline void add_all(bool first, const int16_t *restrict group, size_t n, int32_t *restrict sum)
{
    if (first)
        for (size_t k = 0; k < n; k++) sum[k] = group[k];
    else
        for (size_t k = 0; k < n; k++) sum[k] += group[k];
}

#endif
