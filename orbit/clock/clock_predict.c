// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_predict.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "orbit/clock/clock_curve.h"

#define DAY_S 86400.0
#define FORGET_DAYS 1.0 // a node's weight falls to 1/e in a day
#define LEAST_SPAN_S (18 * 3600.0)
#define CAESIUM_WFM_S2PS (8e-18 / DAY_S) // 2.8 ns a day; rubidium has 0.2 to 1
#define OLD_RUBIDIUM_WHITE_S2 4e-21      // (0.063 ns)^2
// What the solutions of a centre add to the noise of a clock once the system's median is taken away. Not measured
// by itself: it is what makes sigma meet the errors of Galileo's clocks, the quietest, an hour ahead.
#define SOLUTION_S 8e-11

struct orr_clock_predictor {
    orr_clock_curve curve;
    orr_clock_noise noise;
    orr_time last;
    double anchor_s; // what the last node is off the curve, and that node's value
    double base_s;
    size_t n;
    double *days, *weight; // of the nodes
};

static bool begins(const char *text, const char *with) { return strncmp(text, with, strlen(with)) == 0; }

orr_clock_model orr_clock_model_choose(orr_sat sat, const char *block, const orr_clock_noise *noise)
{
    const orr_clock_model line = {1, false, DAY_S}, parabola = {2, false, 2 * DAY_S};
    if (orr_sat_system(sat) == 'C') return parabola;
    if (orr_sat_system(sat) != 'G') return line;
    const orr_clock_model caesium = {1, false, 2 * DAY_S}, old_rubidium = {1, true, DAY_S},
                          new_rubidium = {2, true, 2 * DAY_S};
    if (noise->wfm_s2ps > CAESIUM_WFM_S2PS) return caesium;
    if (block == NULL || !begins(block, "BLOCK"))
        return noise->white_s2 > OLD_RUBIDIUM_WHITE_S2 ? old_rubidium : new_rubidium;
    if (begins(block, "BLOCK III")) return parabola;
    return begins(block, "BLOCK IIF") ? new_rubidium : old_rubidium;
}

void orr_clock_predictor_free(orr_clock_predictor *p)
{
    if (p == NULL) return;
    free(p->days);
    free(p->weight);
    free(p);
}

static orr_status fit(orr_clock_predictor *p, const orr_clock_node *node, const size_t *index, size_t m,
                      const orr_clock_model *model)
{
    double *value = malloc(m * sizeof *value);
    p->days = malloc(m * sizeof *p->days);
    p->weight = malloc(m * sizeof *p->weight);
    if (value == NULL || p->days == NULL || p->weight == NULL) {
        free(value);
        return ORR_E_MEMORY;
    }
    p->n = m;
    p->last = node[index[m - 1]].t;
    p->base_s = node[index[m - 1]].clock_s;
    for (size_t i = 0; i < m; i++) {
        p->days[i] = orr_time_diff_s(node[index[i]].t, p->last) / DAY_S;
        p->weight[i] = exp(p->days[i] / FORGET_DAYS);
        value[i] = node[index[i]].clock_s - p->base_s;
    }
    const bool whole = -p->days[0] * DAY_S >= LEAST_SPAN_S;
    const orr_status s = orr_clock_curve_fit(whole ? model->degree : 1, whole && model->harmonic, p->days,
                                             value, p->weight, m, &p->curve);
    p->anchor_s = -orr_clock_curve_at(&p->curve, 0);
    free(value);
    return s;
}

orr_status orr_clock_predictor_init(const orr_clock_node *node, size_t n, const orr_clock_model *model,
                                    const orr_clock_noise *noise, orr_clock_predictor **out)
{
    *out = NULL;
    if (n < 2) return ORR_E_NODATA;
    orr_clock_predictor *p = calloc(1, sizeof *p);
    size_t *index = malloc(n * sizeof *index);
    orr_status s = p != NULL && index != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s == ORR_OK) {
        p->noise = *noise;
        const size_t m = orr_clock_lattice(node, n, model->window_s, index);
        s = m < 2 ? ORR_E_NODATA : fit(p, node, index, m, model);
    }
    free(index);
    if (s != ORR_OK) {
        orr_clock_predictor_free(p);
        return s;
    }
    *out = p;
    return ORR_OK;
}

// The error of the prediction at t is the clock there less a weighted sum of the nodes. Written by the
// increments of the clock from node to node (and of its frequency), which are independent, its variance is a
// sum over nodes: each increment counts with the sum of all weights after it.
static double variance_at(const orr_clock_predictor *p, double t_days)
{
    double white = 0, walk = 0, frequency = 0;
    double after = 1, after_dt = 0,
           later = t_days; // weights after the interval; those times its length, summed
    for (size_t i = p->n; i-- > 0;) {
        const double dt = (later - p->days[i]) * DAY_S;
        walk += after * after * dt;
        frequency += after * after * dt * dt * dt / 3 + after_dt * after_dt * dt + after * after_dt * dt * dt;
        after_dt += after * dt;
        double w = orr_clock_curve_gain(&p->curve, t_days, p->days[i], p->weight[i]) -
                   orr_clock_curve_gain(&p->curve, 0, p->days[i], p->weight[i]);
        if (i + 1 == p->n) w += 1;
        after -= w;
        white += w * w;
        later = p->days[i];
    }
    return p->noise.white_s2 * white + p->noise.wfm_s2ps * walk + p->noise.rwfm_s2ps3 * frequency;
}

orr_clock_prediction orr_clock_predictor_at(const orr_clock_predictor *p, orr_time t)
{
    const double days = orr_time_diff_s(t, p->last) / DAY_S;
    return (orr_clock_prediction){
        .clock_s = p->base_s + p->anchor_s + orr_clock_curve_at(&p->curve, days),
        .rate_sps = orr_clock_curve_rate_per_day(&p->curve, days) / DAY_S,
        .sigma_s = sqrt(SOLUTION_S * SOLUTION_S + variance_at(p, days > 0 ? days : 0)),
    };
}
