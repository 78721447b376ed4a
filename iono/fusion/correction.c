// SPDX-License-Identifier: GPL-3.0-or-later
// The correction of vertical TEC over a station as a function of place and time.
#include "iono/fusion/fusion_private.h"

#define PLASMASPHERE_RADIUS ((ORR_EARTH_MEAN_RADIUS_M + 2000e3) / 1e6)

// What a TECU up there adds to the vertical content in the shell: the quotient of the mappings, less 1. The zenith
// distance at the shell follows from the mapping itself, sin^2 z' = 1 - 1 / m^2.
static double above(const orr_correction *c, double mapping)
{
    double down = c->scale / PLASMASPHERE_RADIUS, sine2 = (1 - 1 / (mapping * mapping)) * down * down;
    return 1 / (mapping * sqrt(1 - sine2)) - 1;
}

void correction_terms(const orr_correction *c, orr_vec3 unit, double vtec_tecu, double mapping,
                      double term[ORR_CORRECTION_TERMS])
{
    double x = c->scale * orr_vec3_dot(unit, c->east), y = c->scale * orr_vec3_dot(unit, c->north), fade = 1;
    double r = orr_vec3_dot(unit, c->up) > 0 ? sqrt(x * x + y * y) : 1e9;
    if (r > c->reach) {
        double over = (r - c->reach) / (2 * c->reach);
        fade = over < 1 ? 0.5 * (1 + cos(ORR_PI * over)) : 0;
        if (r < 1e9) {
            x *= c->reach / r;
            y *= c->reach / r;
        }
    }
    double all[ORR_CORRECTION_TERMS] = {1,
                                        x,
                                        y,
                                        x * x,
                                        x * y,
                                        y * y,
                                        x * x * x,
                                        x * x * y,
                                        x * y * y,
                                        y * y * y,
                                        -0.1 / c->scale * vtec_tecu * (mapping * mapping - 1),
                                        above(c, mapping)};
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++) term[j] = fade * all[j];
}

void correction_prior(const orr_fusion_model *m, int term, double *sigma, double *time_s)
{
    if (term >= ORR_CORRECTION_PLACE_TERMS) {
        const bool height = term == ORR_CORRECTION_PLACE_TERMS;
        *sigma = height ? m->height_km / 100 : m->plasmasphere_tecu;
        *time_s = height ? m->height_s : m->plasmasphere_s;
        return;
    }
    const int degree = term == 0 ? 0 : term < 3 ? 1 : term < 6 ? 2 : 3;
    *sigma = m->level_tecu * pow(m->per_degree, degree);
    if (degree == 0) *sigma = hypot(*sigma, m->rms_tecu);
    *time_s = m->level_s * pow(m->time_per_degree, degree);
}

void correction_knots(const orr_correction *c, orr_time t, size_t *knot, double *weight_of_next)
{
    double at = orr_time_diff_s(t, c->t0) / c->knot_s, last = (double)(c->n - 1);
    if (at < 0) at = 0;
    if (at > last) at = last;
    size_t k = (size_t)at;
    if (c->n > 1 && k > c->n - 2) k = c->n - 2;
    *knot = k;
    *weight_of_next = at - (double)k;
}

double orr_correction_at(const orr_correction *c, orr_time t, orr_vec3 unit, double vtec_tecu, double mapping)
{
    if (c->n == 0) return 0;
    double term[ORR_CORRECTION_TERMS], w, v = 0;
    size_t k;
    correction_terms(c, unit, vtec_tecu, mapping, term);
    correction_knots(c, t, &k, &w);
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++)
        v += term[j] * (c->n > 1 ? (1 - w) * c->term[k][j] + w * c->term[k + 1][j] : c->term[k][j]);
    return v;
}
