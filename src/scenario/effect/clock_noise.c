// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/clock_noise.h"

#include <math.h>

#include "core/constants.h"
#include "core/rng.h"

enum { PROCESSES = 48 };

// A Gauss-Markov process over a second: what it keeps, and what its integral has of the value before and of two normal numbers, of
// which the first is the process' own.
typedef struct markov {
    double state, keep, fresh;
    double of_state, of_first, of_second;
} markov;

// Processes of one variance, whose sum has a spectrum h/f.
typedef struct flicker {
    size_t n;
    markov process[PROCESSES];
} flicker;

// Moments of the integral of a process of correlation time T (Gillespie 1996, Phys. Rev. E 54:2084).
static markov markov_of(double T, double sigma)
{
    const double u = 1 / T, keep = exp(-u), fresh = sigma * sqrt(-expm1(-2 * u));
    const double lost = -expm1(-u),
                 shared = sigma * sigma * T * lost * lost; // covariance of integral and value
    markov m = {.keep = keep, .fresh = fresh, .of_state = T * lost, .of_first = shared / fresh};
    // Of slow ones the rest is below a fiftieth of a per cent of the sum's variance at 1 s, and lost in the difference.
    if (T > 64) return m;
    const double variance = sigma * sigma * T * T * (2 * u - 2 * lost - lost * lost);
    m.of_second = sqrt(fmax(variance - m.of_first * m.of_first, 0));
    return m;
}

// Sum over octaves of 4 s^2 T/(1 + (2 pi f T)^2) is s^2/(f ln 2), from the shortest correlation time to 15 times the span.
static flicker flicker_begin(double h, double shortest_s, double span_s, uint64_t seed, uint64_t stream)
{
    flicker f = {.n = 0};
    const double sigma = sqrt(h * log(2));
    for (double T = shortest_s; f.n < PROCESSES && T < 15 * fmax(span_s, 100); T *= 2) {
        f.process[f.n] = markov_of(T, sigma);
        f.process[f.n].state = sigma * orr_rng_normal(seed, stream, f.n);
        f.n++;
    }
    return f;
}

static double flicker_value(const flicker *f)
{
    double sum = 0;
    for (size_t j = 0; j < f->n; j++) sum += f->process[j].state;
    return sum;
}

// Goes on by a second; returns the integral over it.
static double flicker_step(flicker *f, uint64_t seed, uint64_t stream, uint64_t k)
{
    double integral = 0;
    for (size_t j = 0; j < f->n; j++) {
        markov *m = &f->process[j];
        const uint64_t at = ((k + 1) * PROCESSES + j) * 2;
        const double first = orr_rng_normal(seed, stream, at);
        integral += m->of_state * m->state + m->of_first * first;
        if (m->of_second > 0) integral += m->of_second * orr_rng_normal(seed, stream, at + 1);
        m->state = m->keep * m->state + m->fresh * first;
    }
    return integral;
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
    // Sampled each second, octaves from sqrt(2)/pi s on have the variance that a bandwidth of 0.5 Hz has: both are
    // h1/(4 pi^2) (1.038 + 3 ln(pi tau))/tau^2 beyond a second. A frequency's are integrated, and go as far down as a second sees.
    flicker phase = flicker_begin(h1 / (4 * pi2), sqrt(2) / ORR_PI, span_s, seed, base),
            frequency = flicker_begin(flicker_h, 1 / 128.0, span_s, seed, base + 1);
    const double walk = law->random_walk_frequency * sqrt(3);
    double walked_s = 0, drift = 0; // time error by frequency, and the frequency's walk
    for (size_t k = 0; k < out->n; k++) {
        double x = walked_s;
        if (law->white_phase > 0) x += law->white_phase / sqrt(3) * orr_rng_normal(seed, base + 2, k);
        if (law->flicker_phase > 0) {
            x += flicker_value(&phase);
            (void)flicker_step(&phase, seed, base, k);
        }
        out->node[k] = x;
        double y = drift;
        if (law->white_frequency > 0) y += law->white_frequency * orr_rng_normal(seed, base + 3, k);
        if (law->flicker_frequency > 0) y += flicker_step(&frequency, seed, base + 1, k);
        if (walk > 0) { // the walk within the second, too: its mean has half of where it goes, and a bridge
            const double step = walk * orr_rng_normal(seed, base + 4, k);
            y += step / 2 + walk / sqrt(12) * orr_rng_normal(seed, base + 5, k);
            drift += step;
        }
        walked_s += y;
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
