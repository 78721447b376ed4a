// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling that is late and not quite regular: increments between other instants than the edges, by cubics through the sums of
// the increments about each.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/sense/measured_private.h"

typedef struct series {
    const orr_vec3 *increment;
    size_t n;
} series;

// The increment of step k; before the run and after it, the nearest.
static orr_vec3 of(const series *s, int64_t k)
{
    return s->increment[k < 0 ? 0 : k >= (int64_t)s->n ? (int64_t)s->n - 1 : k];
}

// The sum from edge k to k + x, 0 <= x < 1: Lagrange's cubic through the sums at k - 1, k, k + 1, k + 2.
static orr_vec3 part(const series *s, int64_t k, double x)
{
    const orr_vec3 a = of(s, k - 1), b = of(s, k), c = of(s, k + 1);
    const double before = x * (x - 1.0) * (x - 2.0) / 6.0; // weight of -(sum at k - 1)
    const double one = -0.5 * (x + 1.0) * x * (x - 2.0), two = (x + 1.0) * x * (x - 1.0) / 6.0;
    orr_vec3 p = orr_vec3_scale(before, a);
    p = orr_vec3_axpy(one + two, b, p);
    return orr_vec3_axpy(two, c, p);
}

// An instant of sampling: so many steps and a part of one after the run's begin.
typedef struct instant {
    int64_t step;
    double part;
} instant;

static instant instant_of(size_t edge, double late_steps)
{
    const double whole = floor(-late_steps);
    return (instant){(int64_t)edge + (int64_t)whole, -late_steps - whole};
}

static orr_vec3 between(const series *s, instant from, instant to)
{
    orr_vec3 sum = orr_vec3_sub(part(s, to.step, to.part), part(s, from.step, from.part));
    for (int64_t i = from.step; i < to.step; i++) sum = orr_vec3_add(sum, of(s, i));
    for (int64_t i = to.step; i < from.step; i++) sum = orr_vec3_sub(sum, of(s, i));
    return sum;
}

orr_status orr_sampling_shift(const orr_imu_errors *e, uint64_t stream, orr_imu *imu, orr_diag *diag)
{
    if (e->delay_s == 0.0 && e->jitter_s == 0.0) return ORR_OK;
    const size_t n = imu->n;
    orr_vec3 *dtheta = malloc(n * sizeof *dtheta), *dv = malloc(n * sizeof *dv);
    if (dtheta == NULL || dv == NULL) {
        free(dtheta);
        free(dv);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
    }
    const series turned = {imu->measured_dtheta_rad, n}, pushed = {imu->measured_dv_mps, n};
    instant last = {0, 0.0};
    double draw[ORR_RNG_BLOCK] = {0};
    for (size_t j = 0; j <= n; j++) {
        if (e->jitter_s > 0.0 && j % ORR_RNG_BLOCK == 0)
            orr_rng_normals(e->seed, stream, j / ORR_RNG_BLOCK, draw);
        const instant now =
            instant_of(j, (e->delay_s + e->jitter_s * draw[j % ORR_RNG_BLOCK]) * imu->rate_hz);
        if (j > 0) {
            dtheta[j - 1] = between(&turned, last, now);
            dv[j - 1] = between(&pushed, last, now);
        }
        last = now;
    }
    memcpy(imu->measured_dtheta_rad, dtheta, n * sizeof *dtheta);
    memcpy(imu->measured_dv_mps, dv, n * sizeof *dv);
    free(dtheta);
    free(dv);
    return ORR_OK;
}
