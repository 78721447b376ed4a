// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/series.h"

#include <stdlib.h>

#include "core/hermite.h"

orr_status orr_series_open(orr_time from, orr_time to, int64_t step_ns, size_t *spare, orr_series *out)
{
    const size_t n = (size_t)((to - from) / step_ns) + 5; // a node before and two after the first and last
    *out = (orr_series){.n = 0};
    if (n > *spare) return ORR_E_LIMIT;
    out->node = malloc(n * sizeof *out->node);
    if (out->node == NULL) return ORR_E_MEMORY;
    *spare -= n;
    out->n = n;
    out->step_ns = step_ns;
    out->from = from - orr_floor_mod(from, step_ns);
    return ORR_OK;
}

void orr_series_free(orr_series *s)
{
    free(s->node);
    *s = (orr_series){.n = 0};
}

double orr_series_at(const orr_series *x, orr_time t, double *rate_ps)
{
    const size_t last = x->n - 4, found = t < x->from ? 0 : (size_t)((t - x->from) / x->step_ns),
                 k = (found < last ? found : last) + 1;
    const double T = (double)x->step_ns / 1e9,
                 s = (double)(t - x->from - (int64_t)(k - 1) * x->step_ns) / 1e9 / T;
    const double *p = &x->node[k - 1];
    double c[4]; // over one step
    orr_hermite_cubic(p[1], p[2] - p[1], (p[2] - p[0]) / 2, (p[3] - p[1]) / 2, 1, c);
    *rate_ps = orr_cubic_rate(c, s) / T;
    return orr_cubic_at(c, s);
}
