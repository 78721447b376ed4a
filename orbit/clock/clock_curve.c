// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_curve.h"

#include <math.h>

#include "core/constants.h"
#include "core/linalg.h"
#include "core/time.h"
#include "orbit/clock/clock_noise.h"

enum { MAX = ORR_CLOCK_TERMS };
static const double turn_per_day = 2 * ORR_PI * ORR_S_PER_DAY / ORR_CLOCK_HARMONIC_S;

static void terms_at(const orr_clock_curve *c, double days, double row[MAX])
{
    int k = 0;
    row[k++] = 1;
    row[k++] = days;
    if (c->degree == 2) row[k++] = days * days;
    if (!c->harmonic) return;
    row[k++] = cos(turn_per_day * days);
    row[k++] = sin(turn_per_day * days);
}

orr_status orr_clock_curve_fit(int degree, bool harmonic, const double *days, const double *clock_s,
                               const double *weight, size_t n, orr_clock_curve *out)
{
    *out =
        (orr_clock_curve){.degree = degree, .harmonic = harmonic, .n_terms = degree + 1 + (harmonic ? 2 : 0)};
    double *normal = out->inverse, right[MAX] = {0}, row[MAX];
    const size_t m = (size_t)out->n_terms;
    for (size_t i = 0; i < n; i++) {
        terms_at(out, days[i], row);
        const double w = weight[i] * weight[i];
        for (size_t k = 0; k < m; k++) {
            right[k] += w * row[k] * clock_s[i];
            for (size_t j = 0; j < m; j++) normal[k * m + j] += w * row[k] * row[j];
        }
    }
    orr_status s = orr_cholesky_factor(normal, m, 1e-13);
    if (s == ORR_OK) s = orr_cholesky_invert(normal, m);
    for (size_t k = 0; k < m && s == ORR_OK; k++)
        for (size_t j = 0; j < m; j++) out->x[k] += normal[k * m + j] * right[j];
    return s;
}

double orr_clock_curve_at(const orr_clock_curve *c, double days)
{
    double row[MAX], sum = 0;
    terms_at(c, days, row);
    for (int k = 0; k < c->n_terms; k++) sum += c->x[k] * row[k];
    return sum;
}

double orr_clock_curve_rate_per_day(const orr_clock_curve *c, double days)
{
    double rate = c->x[1];
    int k = 2;
    if (c->degree == 2) rate += 2 * c->x[k++] * days;
    if (c->harmonic)
        rate += turn_per_day * (c->x[k + 1] * cos(turn_per_day * days) - c->x[k] * sin(turn_per_day * days));
    return rate;
}

double orr_clock_curve_gain(const orr_clock_curve *c, double at_days, double days, double weight)
{
    double at[MAX], row[MAX], sum = 0;
    terms_at(c, at_days, at);
    terms_at(c, days, row);
    for (int k = 0; k < c->n_terms; k++)
        for (int j = 0; j < c->n_terms; j++) sum += at[k] * c->inverse[k * c->n_terms + j] * row[j];
    return sum * weight * weight;
}
