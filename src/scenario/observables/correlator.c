// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/observables/correlator.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "core/constants.h"

// BOC with so many half periods in a chip: (-1)^k (1 - k/halves) at k/halves chips, linear between; 1 half is BPSK.
static double subcarrier(int halves, double chips)
{
    const double x = fabs(chips) * halves;
    if (x >= halves) return 0;
    const double k = floor(x), a = 1 - k / halves, b = 1 - (k + 1) / halves;
    const double sign = fmod(k, 2) > 0.5 ? -1 : 1;
    return sign * (a - (x - k) * (a + b));
}

double orr_correlation(const orr_signal *s, double chips)
{
    if (strstr(s->modulation, "BOC") == NULL) return fmax(1 - fabs(chips), 0);
    return 10.0 / 11 * subcarrier(2, chips) + 1.0 / 11 * subcarrier(12, chips);
}

typedef struct problem {
    const orr_signal *s;
    double spacing, chip_m;
    const orr_correlator_ray *ray;
    size_t n;
} problem;

static double complex sum_at(const problem *p, double chips)
{
    double complex sum = 0;
    for (size_t k = 0; k < p->n; k++) {
        const orr_correlator_ray *r = &p->ray[k];
        const double behind = (r->delay_m - p->ray[0].delay_m) / p->chip_m,
                     turn = -2 * ORR_PI * (r->phase_cycles - p->ray[0].phase_cycles);
        sum += r->amplitude * orr_correlation(p->s, chips - behind) *
               (cos(turn) + sin(turn) * (double complex)I);
    }
    return sum;
}

// Positive where the replica is late.
static double discriminator(const problem *p, double chips)
{
    const double early = cabs(sum_at(p, chips - p->spacing / 2)),
                 late = cabs(sum_at(p, chips + p->spacing / 2));
    return early * early - late * late;
}

static double bisect(const problem *p, double low, double high)
{
    for (int k = 0; k < 60; k++) {
        const double middle = (low + high) / 2;
        if (discriminator(p, middle) > 0)
            high = middle;
        else
            low = middle;
    }
    return (low + high) / 2;
}

// The rising zero nearest to 0; 0 where there is none within a chip.
static double lock(const problem *p)
{
    const double step = fmin(p->spacing, 0.1) / 4;
    for (double out = 0; out < 1.5; out += step) {
        const bool after = discriminator(p, out) <= 0 && discriminator(p, out + step) > 0;
        const bool before = discriminator(p, -out - step) <= 0 && discriminator(p, -out) > 0;
        if (after) return bisect(p, out, out + step);
        if (before) return bisect(p, -out - step, -out);
    }
    return 0;
}

void orr_correlator(const orr_signal *s, double spacing, const orr_correlator_ray *ray, size_t n,
                    double *code_m, double *phase_cycles, double *gain)
{
    const problem p = {s, spacing, ORR_LIGHT_MPS / s->chips_per_s, ray, n};
    *code_m = *phase_cycles = 0;
    *gain = 1;
    if (n < 2) return;
    const double chips = lock(&p);
    const double complex prompt = sum_at(&p, chips);
    *code_m = chips * p.chip_m;
    *phase_cycles = -carg(prompt) / (2 * ORR_PI);
    *gain = cabs(prompt) / ray[0].amplitude;
}
