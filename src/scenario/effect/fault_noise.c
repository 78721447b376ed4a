// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Markov processes: exact at nodes of a lattice of time, a twentieth of the correlation time apart or less, and between
// them cubics through nodes and their central differences, so that value and rate are continuous.
#include <math.h>
#include <stdlib.h>

#include "core/rng.h"
#include "src/scenario/effect/fault_private.h"

int64_t fault_noise_step_ns(double time_s)
{
    // Each a multiple of the blocks' lengths up to itself.
    static const double STEPS_S[] = {10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05};
    size_t k = 0;
    while (k + 1 < sizeof STEPS_S / sizeof *STEPS_S && STEPS_S[k] > time_s / 20) k++;
    return (int64_t)(STEPS_S[k] * 1e9);
}

static orr_status make_series(double sigma_m, double time_s, orr_time from, orr_time to, uint64_t seed,
                              uint64_t stream, size_t *spare, fault_series *out)
{
    const int64_t step = fault_noise_step_ns(time_s);
    const size_t n = (size_t)((to - from) / step) + 5; // a node before and two after the first and last
    if (n > *spare) return ORR_E_LIMIT;
    *spare -= n;
    out->node = malloc(n * sizeof *out->node);
    if (out->node == NULL) return ORR_E_MEMORY;
    out->n = n;
    out->step_ns = step;
    out->from = from - orr_floor_mod(from, step);
    const double keep = exp(-(double)step / 1e9 / time_s), fresh = sqrt(1 - keep * keep);
    double x = sigma_m * orr_rng_normal(seed, stream, 0);
    for (size_t k = 0; k < n; k++) {
        out->node[k] = x;
        x = keep * x + sigma_m * fresh * orr_rng_normal(seed, stream, k + 1);
    }
    return ORR_OK;
}

orr_status fault_noise_make(const fault_item *item, int64_t seed, orr_sat sat, size_t *spare, fault_use *use)
{
    orr_status s = ORR_OK;
    for (size_t k = 0; s == ORR_OK && k < item->noise->sigma_m.n; k++) {
        const uint64_t stream = ((uint64_t)item->index << 32) | ((uint64_t)sat << 8) | k;
        s = make_series(item->noise->sigma_m.item[k], item->noise->time_s.item[k], item->from, item->to,
                        (uint64_t)seed, stream, spare, &use->series[k]);
        if (s == ORR_OK) use->n_series = k + 1;
    }
    return s;
}

double fault_noise_at(const fault_series *x, orr_time t, double *rate_mps)
{
    // A block along live motion may reach beyond the end of the fault.
    const size_t last = x->n - 4, found = (size_t)((t - x->from) / x->step_ns),
                 k = (found < last ? found : last) + 1;
    const double T = (double)x->step_ns / 1e9,
                 s = (double)(t - x->from - (int64_t)(k - 1) * x->step_ns) / 1e9 / T;
    const double *p = &x->node[k - 1];
    const double a = p[1], b = (p[2] - p[0]) / 2, e = (p[3] - p[1]) / 2, rise = p[2] - p[1];
    const double c2 = 3 * rise - 2 * b - e, c3 = b + e - 2 * rise;
    *rate_mps = (b + s * (2 * c2 + s * 3 * c3)) / T;
    return a + s * (b + s * (c2 + s * c3));
}
