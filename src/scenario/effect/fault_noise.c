// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Markov processes, exact at nodes of a lattice of time, a twentieth of the correlation time apart or less.
#include <math.h>

#include "core/rng.h"
#include "src/scenario/effect/fault_private.h"

// Step between nodes of a process with this correlation time: each a multiple of the blocks' lengths up to itself.
static int64_t step_ns(double time_s)
{
    static const double STEPS_S[] = {10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05};
    size_t k = 0;
    while (k + 1 < sizeof STEPS_S / sizeof *STEPS_S && STEPS_S[k] > time_s / 20) k++;
    return (int64_t)(STEPS_S[k] * 1e9);
}

static orr_status make_series(double sigma_m, double time_s, orr_time from, orr_time to, uint64_t seed,
                              uint64_t stream, size_t *spare, orr_series *out)
{
    const orr_status s = orr_series_open(from, to, step_ns(time_s), spare, out);
    if (s != ORR_OK) return s;
    const double keep = exp(-(double)out->step_ns / 1e9 / time_s), fresh = sqrt(1 - keep * keep);
    double x = sigma_m * orr_rng_normal(seed, stream, 0);
    for (size_t k = 0; k < out->n; k++) {
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
