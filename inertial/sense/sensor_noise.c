// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <string.h>

#include "inertial/sense/measured_private.h"

enum { STREAM_BEGIN = 0, STREAM_STEPS = 1 };

orr_sensor_noise orr_sensor_noise_begin(const orr_triad_errors *e, int axis, double dt_s, uint64_t seed,
                                        uint64_t stream)
{
    orr_sensor_noise s;
    memset(&s, 0, sizeof s);
    // The integral of the walk about its chord has the variance K^2 dt^3 / 12, and is independent of its end.
    s.white = sqrt(e->white[axis] * e->white[axis] * dt_s +
                   e->walk[axis] * e->walk[axis] * dt_s * dt_s * dt_s / 12.0);
    s.walk = e->walk[axis] * sqrt(dt_s);
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

static double normal(orr_sensor_noise *s)
{
    const uint64_t at = s->drawn++ % ORR_RNG_BLOCK;
    if (at == 0) orr_rng_normals(s->seed, s->stream + STREAM_STEPS, s->drawn / ORR_RNG_BLOCK, s->draw);
    return s->draw[at];
}

double orr_sensor_noise_step(orr_sensor_noise *s, size_t j)
{
    const double dt = s->dt_s;
    double sum = s->ramp * ((double)j + 0.5) * dt * dt;
    if (s->white > 0.0) sum += s->white * normal(s);
    for (size_t p = 0; p < s->n_processes; p++) {
        const double end = s->keep[p] * s->process[p] + s->drive[p] * normal(s);
        sum += 0.5 * dt * (s->process[p] + end);
        s->process[p] = end;
    }
    if (s->walk > 0.0) {
        const double step = s->walk * normal(s);
        sum += (s->walked + 0.5 * step) * dt;
        s->walked += step;
    }
    return sum;
}
