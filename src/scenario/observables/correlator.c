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
    const int k = (int)x;
    const double a = 1 - (double)k / halves, b = 1 - (double)(k + 1) / halves;
    const double sign = k % 2 != 0 ? -1 : 1;
    return sign * (a - (x - k) * (a + b));
}

static bool is_boc(const orr_signal *s) { return strstr(s->modulation, "BOC") != NULL; }

static double correlation(bool boc, double chips)
{
    if (!boc) return fmax(1 - fabs(chips), 0);
    return 10.0 / 11 * subcarrier(2, chips) + 1.0 / 11 * subcarrier(12, chips);
}

double orr_correlation(const orr_signal *s, double chips) { return correlation(is_boc(s), chips); }

// Rays against the first, as phasors and in chips.
typedef struct problem {
    bool boc;
    double spacing;
    size_t n;
    double behind[ORR_CORRELATOR_RAYS];
    double complex phasor[ORR_CORRELATOR_RAYS];
} problem;

static double complex sum_at(const problem *p, double chips)
{
    double complex sum = 0;
    for (size_t k = 0; k < p->n; k++) sum += correlation(p->boc, chips - p->behind[k]) * p->phasor[k];
    return sum;
}

static double power_at(const problem *p, double chips)
{
    const double complex sum = sum_at(p, chips);
    return creal(sum) * creal(sum) + cimag(sum) * cimag(sum);
}

// Positive where the replica is late.
static double discriminator(const problem *p, double chips)
{
    return power_at(p, chips - p->spacing / 2) - power_at(p, chips + p->spacing / 2);
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
    double later = discriminator(p, 0), earlier = later; // at the borders of what was searched
    for (double out = 0; out < 1.5; out += step) {
        const double above = discriminator(p, out + step), below = discriminator(p, -out - step);
        if (later <= 0 && above > 0) return bisect(p, out, out + step);
        if (below <= 0 && earlier > 0) return bisect(p, -out - step, -out);
        later = above;
        earlier = below;
    }
    return 0;
}

void orr_correlator(const orr_signal *s, double spacing, const orr_correlator_ray *ray, size_t n,
                    double *code_m, double *phase_cycles, double *gain)
{
    *code_m = *phase_cycles = 0;
    *gain = 1;
    if (n < 2) return;
    const double chip_m = ORR_LIGHT_MPS / s->chips_per_s;
    problem p = {.boc = is_boc(s), .spacing = spacing, .n = n};
    for (size_t k = 0; k < n; k++) {
        const double turn = -2 * ORR_PI * (ray[k].phase_cycles - ray[0].phase_cycles);
        p.behind[k] = (ray[k].delay_m - ray[0].delay_m) / chip_m;
        p.phasor[k] = ray[k].amplitude * (cos(turn) + sin(turn) * (double complex)I);
    }
    const double chips = lock(&p);
    const double complex prompt = sum_at(&p, chips);
    *code_m = chips * chip_m;
    *phase_cycles = -carg(prompt) / (2 * ORR_PI);
    *gain = cabs(prompt) / ray[0].amplitude;
}
