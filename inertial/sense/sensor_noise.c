// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <string.h>

#include "core/rng.h"
#include "inertial/sense/measured_private.h"

enum { PAIRS = (3 + ORR_ERRORS_MAX_PROCESSES + 1) / 2, STREAM_BEGIN = 0, STREAM_STEPS = 1 };

orr_sensor_noise orr_sensor_noise_begin(const orr_triad_errors *e, int axis, double dt_s, uint64_t seed,
                                        uint64_t stream)
{
    orr_sensor_noise s;
    memset(&s, 0, sizeof s);
    s.white = e->white[axis] * sqrt(dt_s);
    s.walk = e->walk[axis];
    s.ramp = e->ramp[axis];
    s.n_processes = e->n_processes;
    s.dt_s = dt_s;
    s.seed = seed;
    s.stream = stream;
    for (size_t p = 0; p < e->n_processes; p++) {
        s.keep[p] = exp(-dt_s / e->process[p].correlation_s);
        s.drive[p] = e->process[p].sigma * sqrt(-expm1(-2.0 * dt_s / e->process[p].correlation_s));
        s.process[p] = e->process[p].sigma * orr_rng_normal(seed, stream + STREAM_BEGIN, (uint64_t)p);
    }
    return s;
}

double orr_sensor_noise_step(orr_sensor_noise *s, size_t j)
{
    const bool white = s->white > 0.0, walk = s->walk > 0.0;
    const size_t wanted = (size_t)white + 2 * (size_t)walk + s->n_processes;
    double draw[2 * PAIRS], dt = s->dt_s, sum = s->ramp * ((double)j + 0.5) * dt * dt;
    for (size_t k = 0; 2 * k < wanted; k++)
        orr_rng_normal_pair(s->seed, s->stream + STREAM_STEPS, (uint64_t)j * PAIRS + k, &draw[2 * k]);
    const double *next = draw;
    if (white) sum += s->white * *next++;
    for (size_t p = 0; p < s->n_processes; p++) {
        const double end = s->keep[p] * s->process[p] + s->drive[p] * *next++;
        sum += 0.5 * dt * (s->process[p] + end);
        s->process[p] = end;
    }
    if (walk) { // its end, and its integral about the chord: variance dt^3 / 12
        const double step = s->walk * sqrt(dt) * next[0];
        sum += (s->walked + 0.5 * step) * dt + s->walk * dt * sqrt(dt / 12.0) * next[1];
        s->walked += step;
    }
    return sum;
}
