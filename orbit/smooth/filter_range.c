// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/filter_range.h"

static void admit(orr_gauss *g, double r_m, double v_mps, double f_mps2)
{
    for (int i = 0; i < 3; i++) {
        g->P[i][i] += r_m * r_m;
        g->P[3 + i][3 + i] += v_mps * v_mps;
        g->P[6 + i][6 + i] += f_mps2 * f_mps2;
    }
}

// What is new where a window of the reference or a file begins, or the satellite was pushed.
static void renew(const orr_track_context *c, const orr_verdict *verdict, orr_instant *at)
{
    const bool rich = c->noise.nx == ORR_NX;
    for (int i = 0; i < ORR_ECOM_TERMS && at->renew && rich; i++)
        at->predicted.P[ORR_PARTIAL_ECOM + i][ORR_PARTIAL_ECOM + i] +=
            orr_ecom_sigma_nmps2[i] * orr_ecom_sigma_nmps2[i];
    if (at->pulse && rich) admit(&at->predicted, 0, ORR_NOON_STEP_MPS, 0);
    if (at->step && rich) admit(&at->predicted, ORR_FILE_STEP_R_M, ORR_FILE_STEP_V_MPS, 0);
    if (at->n > 0 && verdict[at->first].begins_anew)
        admit(&at->predicted, ORR_ANEW_R_M, ORR_ANEW_V_MPS, c->noise.f0_sigma_mps2);
}

static void take_nodes(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                       orr_instant *at)
{
    at->d2 = at->log_det = 0;
    at->count = 0;
    for (size_t i = at->first; i < at->first + at->n; i++) {
        const orr_node *node = &list[i];
        if (node->superseded || verdict[i].rejected) continue;
        const orr_vec3 z = orr_track_measured(c, at, node);
        if (!node->bridge) {
            double log_det = 0;
            at->d2 += 3 * orr_kalman_innovation2(&at->filtered, z, node->sigma_m, NULL, &log_det);
            at->log_det += log_det;
            at->count++;
        }
        orr_kalman_update(&at->filtered, c->noise.nx, z, node->sigma_m);
    }
}

void orr_filter_range(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t, size_t first, size_t last)
{
    const orr_filter_noise *n = &c->noise;
    orr_kalman_start(&t->at[first].predicted, n->start_r_m, n->start_v_mps, n->f0_sigma_mps2);
    for (size_t k = first; k <= last; k++) {
        orr_instant *at = &t->at[k];
        if (k > first) {
            const orr_instant *before = &t->at[k - 1];
            const orr_noise_factor factor = {n->factor.q, before->shadow};
            orr_kalman_predict(&before->filtered, &before->next, n->nx, factor, at->shift, &at->predicted);
            renew(c, verdict, at);
        }
        at->filtered = at->predicted;
        take_nodes(c, list, verdict, at);
    }
}

orr_status orr_smooth_range(const orr_track_context *c, orr_track *t, size_t first, size_t last)
{
    t->at[last].smoothed = t->at[last].filtered;
    for (size_t k = last; k-- > first;) {
        orr_instant *a = &t->at[k], *b = &t->at[k + 1];
        orr_status s = orr_kalman_smooth(&a->filtered, &a->next, c->noise.nx, &b->predicted, &b->smoothed,
                                         &a->smoothed, b->u);
        if (s != ORR_OK) return s;
    }
    return ORR_OK;
}
