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
static void renew(const orr_track_context *c, const orr_verdict *verdict, const orr_instant *at, orr_gauss *g)
{
    const bool rich = c->noise.nx == ORR_NX;
    const double *ecom = orr_ecom_sigma_nmps2(at->r_m, at->v_mps);
    for (int i = 0; i < ORR_ECOM_TERMS && at->renew && rich; i++)
        g->P[ORR_PARTIAL_ECOM + i][ORR_PARTIAL_ECOM + i] += ecom[i] * ecom[i];
    if (at->pulse && rich) admit(g, 0, ORR_NOON_STEP_MPS, 0);
    if (at->step && rich) admit(g, ORR_FILE_STEP_R_M, ORR_FILE_STEP_V_MPS, 0);
    if (at->n > 0 && verdict[at->first].begins_anew)
        admit(g, ORR_ANEW_R_M, ORR_ANEW_V_MPS, c->noise.f0_sigma_mps2);
}

// From the filtered state of an instant to what it predicts for the next one.
static void go_on(const orr_track_context *c, const orr_verdict *verdict, const orr_instant *at,
                  const orr_transition *step, const orr_gauss *filtered, orr_gauss *predicted)
{
    const orr_noise_factor factor = {c->noise.factor.q, at->shadow};
    orr_kalman_predict(filtered, step, c->noise.nx, factor, at[1].shift, predicted);
    renew(c, verdict, at + 1, predicted);
}

static void take_nodes(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                       orr_instant *at, orr_gauss *g)
{
    at->d2 = at->log_det = 0;
    at->count = 0;
    for (size_t i = at->first; i < at->first + at->n; i++) {
        const orr_node *node = &list[i];
        if (node->superseded || verdict[i].rejected) continue;
        const orr_vec3 z = orr_track_measured(c, at, node);
        if (!node->bridge) {
            double log_det = 0;
            at->d2 += 3 * orr_kalman_innovation2(g, z, node->sigma_m, NULL, &log_det);
            at->log_det += log_det;
            at->count++;
        }
        orr_kalman_update(g, c->noise.nx, z, node->sigma_m);
    }
}

static void filter(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict, orr_track *t,
                   size_t first, size_t last, bool keep)
{
    const orr_filter_noise *n = &c->noise;
    orr_gauss now, predicted;
    orr_transition step;
    orr_kalman_start(n->start_r_m, n->start_v_mps, n->f0_sigma_mps2,
                     orr_ecom_sigma_nmps2(t->at[first].r_m, t->at[first].v_mps), &now);
    predicted = now;
    for (size_t k = first; k <= last; k++) {
        if (k > first) {
            orr_transition_recall(&t->at[k - 1].next, &step);
            go_on(c, verdict, &t->at[k - 1], &step, &now, &predicted);
            now = predicted;
        }
        take_nodes(c, list, verdict, &t->at[k], &now);
        if (keep) orr_gauss_keep(&now, n->nx, &t->at[k].state);
    }
}

void orr_filter_range(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t, size_t first, size_t last)
{
    filter(c, list, verdict, t, first, last, true);
}

void orr_filter_sums(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                     orr_track *t, size_t first, size_t last)
{
    filter(c, list, verdict, t, first, last, false);
}

orr_status orr_smooth_range(const orr_track_context *c, const orr_verdict *verdict, orr_track *t,
                            size_t first, size_t last, orr_fresh_start *fresh)
{
    const int nx = c->noise.nx;
    orr_gauss filtered, predicted, smoothed, next;
    orr_transition step;
    orr_gauss_recall(&t->at[last].state, nx, &next); // filtered is smoothed there
    for (size_t k = last; k-- > first;) {
        orr_instant *at = &t->at[k];
        orr_gauss_recall(&at->state, nx, &filtered);
        orr_transition_recall(&at->next, &step);
        go_on(c, verdict, at, &step, &filtered, &predicted);
        const orr_status s = orr_kalman_smooth(&filtered, &step, nx, &predicted, &next, &smoothed, at[1].u);
        if (s != ORR_OK) return s;
        if (fresh != NULL) fresh[k + 1] = orr_fresh_start_at(&predicted, &next, at[1].u, nx);
        next = smoothed;
        orr_gauss_keep(&smoothed, nx, &at->state);
    }
    return ORR_OK;
}
