// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/clock_noise.h"

#include <math.h>

#include "core/constants.h"
#include "core/rng.h"

enum { PROCESSES = 40 };

// Gauss-Markov processes of one variance, whose sum has a spectrum h/f.
typedef struct flicker {
    size_t n;
    double sigma, keep[PROCESSES], state[PROCESSES];
} flicker;

// Sum over octaves of 4 s^2 T/(1 + (2 pi f T)^2) is s^2/(f ln 2).
static flicker flicker_begin(double h, double span_s, uint64_t seed, uint64_t stream)
{
    flicker f = {.sigma = sqrt(h * log(2))};
    for (double T = 0.2; f.n < PROCESSES && T < 15 * fmax(span_s, 100); T *= 2) {
        f.keep[f.n] = exp(-1 / T);
        f.state[f.n] = f.sigma * orr_rng_normal(seed, stream, f.n);
        f.n++;
    }
    return f;
}

static double flicker_step(flicker *f, uint64_t seed, uint64_t stream, uint64_t k)
{
    double sum = 0;
    for (size_t j = 0; j < f->n; j++) {
        sum += f->state[j];
        f->state[j] = f->keep[j] * f->state[j] + f->sigma * sqrt(1 - f->keep[j] * f->keep[j]) *
                                                     orr_rng_normal(seed, stream, (k + 1) * PROCESSES + j);
    }
    return sum;
}

static double square(double x) { return x * x; }

orr_status orr_clock_noise_make(const orr_scenario_clock *law, uint64_t stream, orr_time from, orr_time to,
                                size_t *spare, orr_series *out)
{
    const orr_status s = orr_series_open(from, to, ORR_NS_PER_S, spare, out);
    if (s != ORR_OK) return s;
    const uint64_t seed = (uint64_t)law->seed, base = stream * 8;
    const double span_s = orr_time_diff_s(to, from), pi2 = ORR_PI * ORR_PI;
    const double h1 = 4 * pi2 * square(law->flicker_phase) / (1.038 + 3 * log(ORR_PI)),
                 flicker_h = square(law->flicker_frequency) / (2 * log(2));
    flicker phase = flicker_begin(h1 / (4 * pi2), span_s, seed, base),
            frequency = flicker_begin(flicker_h, span_s, seed, base + 1);
    double walked_s = 0, drift = 0; // time error by frequency, and the frequency's walk
    for (size_t k = 0; k < out->n; k++) {
        double x = walked_s;
        if (law->white_phase > 0) x += law->white_phase / sqrt(3) * orr_rng_normal(seed, base + 2, k);
        if (law->flicker_phase > 0) x += flicker_step(&phase, seed, base, k);
        out->node[k] = x;
        double y = drift;
        if (law->white_frequency > 0) y += law->white_frequency * orr_rng_normal(seed, base + 3, k);
        if (law->flicker_frequency > 0) y += flicker_step(&frequency, seed, base + 1, k);
        walked_s += y;
        if (law->random_walk_frequency > 0)
            drift += law->random_walk_frequency * sqrt(3) * orr_rng_normal(seed, base + 4, k);
    }
    return ORR_OK;
}

void orr_clock_noise_pin(orr_series *s, const orr_time *node, size_t n)
{
    if (n == 0) return;
    double rate, left = orr_series_at(s, node[0], &rate), right = left;
    orr_time from = node[0], to = node[0];
    size_t next = 0;
    for (size_t k = 0; k < s->n; k++) {
        const orr_time t = s->from + ((int64_t)k - 1) * s->step_ns;
        while (next < n && t >= to) {
            from = to;
            left = right;
            if (++next == n) break;
            to = node[next];
            right = orr_series_at(s, to, &rate); // nodes there are not changed yet
        }
        const double part = to > from && t > from ? fmin((double)(t - from) / (double)(to - from), 1) : 0;
        s->node[k] -= left + part * (right - left);
    }
}
