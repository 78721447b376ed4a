// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/rotation_knots.h"

#include "core/eop_tides.h"

#define SERIES_STEP_S 10800.0
#define MAS (ORR_RAD_PER_DEG / 3.6e6)
#define TURN_PER_MS (2 * ORR_PI * 1.00273781191135448 / 86400 * 1e-3)

size_t orr_knot_window(const orr_rotation_knots *k, double t_s)
{
    size_t w = 0;
    while (w + 2 < k->n && t_s >= k->t_s[w + 1]) w++;
    return w;
}

// Adds `times` the slope at knot i to the weights of its neighbours; weight[0] is that of knot `first`.
static void add_slope(const orr_rotation_knots *k, size_t i, double times, ptrdiff_t first, double *weight)
{
    const double *x = k->t_s;
    double *w = weight + ((ptrdiff_t)i - first);
    if (i == 0 || i + 1 == k->n) {
        const size_t lo = i == 0 ? 0 : i - 1;
        const double s = times / (x[lo + 1] - x[lo]);
        weight[(ptrdiff_t)lo - first] -= s;
        weight[(ptrdiff_t)lo + 1 - first] += s;
        return;
    }
    const double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i], s0 = times * h1 / (h0 + h1) / h0,
                 s1 = times * h0 / (h0 + h1) / h1;
    w[-1] -= s0;
    w[0] += s0 - s1;
    w[1] += s1;
}

void orr_knot_weights(const orr_rotation_knots *k, size_t window, double t_s, double weight[ORR_KNOT_REACH])
{
    const ptrdiff_t first = (ptrdiff_t)window - 1;
    if (k->polynomial) {
        const double d = (t_s - k->t_s[1]) / ORR_S_PER_DAY, term[3] = {1, d, d * d / 2};
        for (ptrdiff_t i = 0; i < ORR_KNOT_REACH; i++)
            weight[i] = first + i >= 0 && first + i < 3 ? term[first + i] : 0;
        return;
    }
    const double h = k->t_s[window + 1] - k->t_s[window], u = (t_s - k->t_s[window]) / h, u2 = u * u,
                 u3 = u2 * u;
    for (int i = 0; i < ORR_KNOT_REACH; i++) weight[i] = 0;
    weight[1] = 2 * u3 - 3 * u2 + 1;
    weight[2] = -2 * u3 + 3 * u2;
    add_slope(k, window, h * (u3 - 2 * u2 + u), first, weight);
    add_slope(k, window + 1, h * (u3 - u2), first, weight);
}

static void combine(const orr_rotation_knots *k, size_t window, const double *weight, double *value)
{
    for (int j = 0; j < ORR_KNOT_VALUES; j++) {
        value[j] = 0;
        for (size_t i = 0; i < ORR_KNOT_REACH; i++) {
            const size_t knot = window + i;
            if (knot >= 1 && knot - 1 < k->n) value[j] += weight[i] * k->value[knot - 1][j];
        }
    }
}

void orr_knot_value(const orr_rotation_knots *k, double t_s, double value[ORR_KNOT_VALUES],
                    double per_day[ORR_KNOT_VALUES])
{
    const size_t w = orr_knot_window(k, t_s);
    double weight[ORR_KNOT_REACH], before[ORR_KNOT_REACH], after[ORR_KNOT_REACH];
    orr_knot_weights(k, w, t_s, weight);
    combine(k, w, weight, value);
    if (per_day == NULL) return;
    const double step_s = 60; // of a cubic over a day: good to 1e-6 of its change
    orr_knot_weights(k, w, t_s - step_s, before);
    orr_knot_weights(k, w, t_s + step_s, after);
    for (int i = 0; i < ORR_KNOT_REACH; i++)
        weight[i] = (after[i] - before[i]) * (ORR_S_PER_DAY / (2 * step_s));
    combine(k, w, weight, per_day);
}

size_t orr_knot_series_length(const orr_rotation_knots *k)
{
    return (size_t)ceil(k->t_s[k->n - 1] / SERIES_STEP_S) + 3;
}

void orr_knot_series(const orr_rotation_knots *k, const orr_eop_series *start, const orr_leap_table *leap,
                     orr_eop_series *out)
{
    out->n = orr_knot_series_length(k);
    for (size_t i = 0; i < out->n; i++) {
        const double t_s = SERIES_STEP_S * ((double)i - 1);
        const orr_time t = orr_time_add_s(k->origin, t_s);
        int32_t day;
        double fraction, c[ORR_KNOT_VALUES];
        orr_time_mjd(t, ORR_SCALE_UTC, NULL, &day, &fraction);
        orr_eop e = orr_eop_node(start, t, leap);
        if (start == NULL) e.ut1_utc_s += orr_eop_tides_zonal_ut1(t);
        orr_knot_value(k, t_s, c, NULL);
        out->mjd_utc[i] = day + fraction;
        out->value[i] = (orr_eop){.xp_rad = e.xp_rad + c[0] * MAS,
                                  .yp_rad = e.yp_rad + c[1] * MAS,
                                  .ut1_utc_s = e.ut1_utc_s + c[2] * 1e-3};
    }
}

void orr_knot_partials(orr_vec3 p, orr_vec3 by[ORR_KNOT_VALUES])
{
    by[0] = (orr_vec3){-MAS * p.z, 0, MAS * p.x};
    by[1] = (orr_vec3){0, MAS * p.z, -MAS * p.y};
    by[2] = (orr_vec3){-TURN_PER_MS * p.y, TURN_PER_MS * p.x, 0};
}
