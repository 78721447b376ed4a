// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling that is late and not quite regular: increments between other instants than the edges, by cubics through the sums of
// the increments about each.
#include <math.h>
#include <stdlib.h>

#include "core/rng.h"
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

orr_status orr_sampling_shift(const orr_imu_errors *e, uint64_t stream, double dt_s, orr_vec3 *increment,
                              size_t n, orr_diag *diag)
{
    if (e->delay_s == 0.0 && e->jitter_s == 0.0) return ORR_OK;
    orr_vec3 *out = malloc(n * sizeof *out);
    if (out == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
    const series s = {increment, n};
    int64_t at = 0;
    double frac = 0.0;
    for (size_t j = 0; j <= n; j++) {
        const double late =
            e->delay_s - (e->jitter_s > 0.0 ? e->jitter_s * orr_rng_normal(e->seed, stream, j) : 0.0);
        const double place = -late / dt_s, whole = floor(place);
        const int64_t k = (int64_t)j + (int64_t)whole;
        const double x = place - whole;
        if (j > 0) {
            orr_vec3 sum = orr_vec3_sub(part(&s, k, x), part(&s, at, frac));
            for (int64_t i = at; i < k; i++) sum = orr_vec3_add(sum, of(&s, i));
            for (int64_t i = k; i < at; i++) sum = orr_vec3_sub(sum, of(&s, i));
            out[j - 1] = sum;
        }
        at = k;
        frac = x;
    }
    for (size_t j = 0; j < n; j++) increment[j] = out[j];
    free(out);
    return ORR_OK;
}
