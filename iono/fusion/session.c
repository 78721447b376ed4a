// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a session of a fusion, and learns what small-scale structure it has.
#include "iono/fusion/session.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "iono/fusion/fusion_private.h"

void orr_session_free(orr_session *s)
{
    orr_tec_field_free(s->field);
    free(s->correction.term);
    free(s->arc);
    free(s->sample);
    *s = (orr_session){0};
}

// Lag at which a decaying correlation, given at equal steps from lag 0 on, crosses 1/e; the last lag if it
// does not.
static double fall(const double *rho, size_t n, double step)
{
    for (size_t i = 1; i < n; i++)
        if (rho[i] < exp(-1)) {
            double w = (rho[i - 1] - exp(-1)) / (rho[i - 1] - rho[i]);
            return step * ((double)(i - 1) + w);
        }
    return step * (double)(n - 1);
}

static void learn_time(orr_session *s)
{
    enum { LAGS = 121 };
    double product[LAGS] = {0}, count[LAGS] = {0}, rho[LAGS];
    size_t stride = s->interval_s > 0 && s->interval_s < 60 ? (size_t)(60 / s->interval_s + 0.5) : 1;
    for (size_t a = 0; a < s->n_arcs; a++) {
        const orr_session_sample *x = s->sample + s->arc[a].first;
        for (size_t lag = 0; lag < LAGS; lag++)
            for (size_t i = 0; i + lag * stride < s->arc[a].n; i += stride) {
                product[lag] += x[i].residual_tecu * x[i + lag * stride].residual_tecu;
                count[lag]++;
            }
    }
    size_t n = 0;
    while (n < LAGS && count[n] > 50) {
        rho[n] = product[0] > 0 ? product[n] / count[n] / (product[0] / count[0]) : 0;
        n++;
    }
    s->small.sigma_tecu = count[0] > 0 ? sqrt(product[0] / count[0]) : 0;
    s->small.time_s = n > 1 ? fall(rho, n, (double)stride * s->interval_s) : 600;
    if (!(s->small.time_s >= 60)) s->small.time_s = 60;
}

#define LEAST_SHARED 0.3 // of the variance: fewer pairs than it takes to say less

// Pairs of satellites at one epoch (of every tenth minute), by distance of their pierce points.
static orr_status learn_length(orr_session *s, orr_diag *diag)
{
    enum { BINS = 31 };
    const double width = 50e3;
    double product[BINS] = {0}, count[BINS] = {0}, radius = orr_tec_field_shell_radius_m(s->field);
    const orr_session_sample **now = malloc((s->n_arcs + 1) * sizeof(const orr_session_sample *));
    size_t *at = calloc(s->n_arcs + 1, sizeof *at);
    if (now == NULL || at == NULL) {
        free(now);
        free(at);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the small-scale structure");
    }
    double step = fmax(600, s->interval_s);
    for (orr_time t = s->from; t <= s->to; t = orr_time_add_s(t, step)) {
        size_t n = 0;
        for (size_t a = 0; a < s->n_arcs; a++) {
            const orr_session_sample *x = s->sample + s->arc[a].first;
            while (at[a] < s->arc[a].n && x[at[a]].t < t) at[a]++;
            if (at[a] < s->arc[a].n && orr_time_diff_s(x[at[a]].t, t) < fmax(s->interval_s, 1))
                now[n++] = &x[at[a]];
        }
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < i; j++) {
                double d = radius * orr_vec3_norm(orr_vec3_sub(now[i]->pierce, now[j]->pierce));
                size_t b = (size_t)(d / width) + 1; // bin b is around (b - 1/2) width; bin 0 is distance 0
                if (b >= BINS) continue;
                product[b] += now[i]->residual_tecu * now[j]->residual_tecu;
                count[b]++;
            }
    }
    free(now);
    free(at);
    // Fit of a exp(-d / L), weighted by counts: a by least squares for each L of a ladder. What a lacks of the variance
    // is not shared by neighbours.
    double variance = s->small.sigma_tecu * s->small.sigma_tecu, best = (double)INFINITY, shared = variance;
    s->small.length_m = 300e3;
    for (double l = 20e3; l < 3000e3; l *= 1.1) {
        double up = 0, down = 0, square = 0;
        for (size_t b = 1; b < BINS; b++) {
            if (count[b] < 20) continue;
            double e = exp(-((double)b - 0.5) * width / l), mean = product[b] / count[b];
            up += count[b] * e * mean;
            down += count[b] * e * e;
            square += count[b] * mean * mean;
        }
        if (!(down > 0)) continue;
        double a = fmin(fmax(up / down, LEAST_SHARED * variance), variance),
               sum = square - 2 * a * up + a * a * down;
        if (sum < best) {
            best = sum;
            shared = a;
            s->small.length_m = l;
        }
    }
    s->small.own_tecu = sqrt(variance - shared);
    return ORR_OK;
}

static int by_sat_and_time(const void *a, const void *b)
{
    const orr_fused_arc *x = a, *y = b;
    if (x->sat != y->sat) return x->sat < y->sat ? -1 : 1;
    return x->from < y->from ? -1 : x->from > y->from;
}

orr_status orr_session_make(const orr_phase_tec *phase, const orr_fusion *fusion, orr_tec_field *field,
                            double max_gap_s, orr_session *out, orr_diag *diag)
{
    *out = (orr_session){.site = phase->site,
                         .interval_s = phase->interval_s,
                         .max_gap_s = max_gap_s,
                         .from = phase->from,
                         .to = phase->to,
                         .field = field,
                         .correction = fusion->correction};
    snprintf(out->station, sizeof out->station, "%s", phase->marker);
    snprintf(out->method, sizeof out->method, "%s", orr_fusion_method_name(fusion->method));
    out->correction.term = malloc((fusion->correction.n + 1) * sizeof *out->correction.term);
    out->arc = calloc(fusion->n_arcs + 1, sizeof *out->arc);
    out->sample = malloc((fusion->n_samples + 1) * sizeof *out->sample);
    orr_fused_arc *order = malloc((fusion->n_arcs + 1) * sizeof *order);
    if (out->correction.term == NULL || out->arc == NULL || out->sample == NULL || order == NULL) {
        free(order);
        orr_session_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a session");
    }
    if (fusion->correction.n > 0)
        memcpy(out->correction.term, fusion->correction.term,
               fusion->correction.n * sizeof *out->correction.term);
    memcpy(order, fusion->arc, fusion->n_arcs * sizeof *order);
    qsort(order, fusion->n_arcs, sizeof *order, by_sat_and_time);
    for (size_t k = 0; k < fusion->n_arcs; k++) {
        const orr_fused_arc *a = &order[k];
        const orr_phase_sat *sat = &phase->sat[a->sat_index];
        const double *vtec = fusion->model_vtec[a->sat_index], *map = fusion->mapping[a->sat_index];
        orr_session_arc *arc = &out->arc[out->n_arcs++];
        *arc = (orr_session_arc){a->sat, out->n_samples, 0, a->bias_tecu, a->sigma_tecu, sat->freq_hz[0]};
        for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)a->arc, 0, vtec, &i);) {
            orr_session_sample *x = &out->sample[out->n_samples++];
            const orr_pierce *p = &sat->pierce[i];
            x->t = sat->t[i];
            x->stec_tecu = sat->gf_tecu[i] - a->bias_tecu;
            x->model_stec_tecu = map[i] * vtec[i];
            x->mapping = map[i];
            x->residual_tecu = x->stec_tecu / map[i] - vtec[i] -
                               orr_correction_at(&out->correction, x->t, p->unit, vtec[i], map[i]);
            x->pierce = p->unit;
            x->az_rad = p->az_rad;
            x->el_rad = p->el_rad;
            arc->n++;
        }
    }
    free(order);
    learn_time(out);
    orr_status s = learn_length(out, diag);
    if (s != ORR_OK) orr_session_free(out);
    return s;
}
