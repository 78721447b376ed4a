// SPDX-License-Identifier: GPL-3.0-or-later
// Normal equations of the joint method: [knots x 6 | arc biases | receiver biases], dense (some hundreds of
// unknowns).
#include <stdlib.h>

#include "core/linalg.h"
#include "core/nan.h"
#include "iono/fusion/fusion_private.h"

// The six terms of the correction at a pierce point (faded beyond its reach), and the knots at either side of
// t with their weights.
static void terms_at(const orr_correction *c, orr_vec3 unit, double term[ORR_CORRECTION_TERMS])
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
    double all[ORR_CORRECTION_TERMS] = {1, x, y, x * x, x * y, y * y};
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++) term[j] = fade * all[j];
}

static void knots_at(const orr_correction *c, orr_time t, size_t *knot, double *weight_of_next)
{
    double at = orr_time_diff_s(t, c->t0) / c->knot_s, last = (double)(c->n - 1);
    if (at < 0) at = 0;
    if (at > last) at = last;
    size_t k = (size_t)at;
    if (c->n > 1 && k > c->n - 2) k = c->n - 2;
    *knot = k;
    *weight_of_next = at - (double)k;
}

double orr_correction_at(const orr_correction *c, orr_time t, orr_vec3 unit)
{
    if (c->n == 0) return 0;
    double term[ORR_CORRECTION_TERMS], w, v = 0;
    size_t k;
    terms_at(c, unit, term);
    knots_at(c, t, &k, &w);
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++)
        v += term[j] * (c->n > 1 ? (1 - w) * c->term[k][j] + w * c->term[k + 1][j] : c->term[k][j]);
    return v;
}

bool fusion_next_sample(const orr_phase_sat *s, int arc, double thin_s, const double *vtec, size_t *i)
{
    size_t first = s->arcs.arc[arc].first, last = s->arcs.arc[arc].last, k = *i == SIZE_MAX ? first : *i + 1;
    for (; k <= last; k++) {
        if (s->arcs.arc_of[k] != arc || isnan(vtec[k])) continue;
        if (*i != SIZE_MAX && orr_time_diff_s(s->t[k], s->t[*i]) < thin_s - 0.01) continue;
        *i = k;
        return true;
    }
    return false;
}

typedef struct system_of {
    size_t n, arcs, groups; // unknowns; where biases start
    double *normal, *rhs;   // lower triangle
} system_of;

static void add(system_of *s, const size_t *at, const double *row, size_t n, double y, double weight)
{
    for (size_t i = 0; i < n; i++) {
        s->rhs[at[i]] += weight * row[i] * y;
        for (size_t j = 0; j < n; j++)
            if (at[j] <= at[i]) s->normal[at[i] * s->n + at[j]] += weight * row[i] * row[j];
    }
}

static void add_walk(system_of *s, const orr_correction *c, const orr_fusion_options *o)
{
    static const int kind[ORR_CORRECTION_TERMS] = {0, 1, 1, 2, 2, 2};
    double hours = c->knot_s / 3600;
    for (size_t j = 0; j < ORR_CORRECTION_TERMS; j++) {
        double start = o->start_tecu[kind[j]], walk = o->walk_tecu[kind[j]];
        size_t one[1] = {j};
        double unit[1] = {1};
        add(s, one, unit, 1, 0, 1 / (start * start));
        for (size_t k = 0; k + 1 < c->n; k++) {
            size_t two[2] = {k * ORR_CORRECTION_TERMS + j, (k + 1) * ORR_CORRECTION_TERMS + j};
            double step[2] = {-1, 1};
            add(s, two, step, 2, 0, 1 / (walk * walk * hours));
        }
    }
}

static void add_phases(system_of *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                       const orr_fusion *f)
{
    const orr_correction *c = &f->correction;
    size_t at[2 * ORR_CORRECTION_TERMS + 1];
    double row[2 * ORR_CORRECTION_TERMS + 1], term[ORR_CORRECTION_TERMS], w;
    for (size_t a = 0; a < f->n_arcs; a++) {
        const orr_fused_arc *arc = &f->arc[a];
        if (isnan(arc->bias_tecu)) continue; // withheld
        const orr_phase_sat *sat = &phase->sat[arc->sat_index];
        const double *vtec = f->model_vtec[arc->sat_index], *map = f->mapping[arc->sat_index];
        for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)arc->arc, o->thin_s, vtec, &i);) {
            size_t k, n = 0;
            terms_at(c, sat->pierce[i].unit, term);
            knots_at(c, sat->t[i], &k, &w);
            for (size_t j = 0; j < ORR_CORRECTION_TERMS; j++) {
                at[n] = k * ORR_CORRECTION_TERMS + j;
                row[n++] = map[i] * (1 - w) * term[j];
                if (w == 0) continue;
                at[n] = (k + 1) * ORR_CORRECTION_TERMS + j;
                row[n++] = map[i] * w * term[j];
            }
            at[n] = s->arcs + a;
            row[n++] = 1;
            double sigma = o->sample_tecu * map[i];
            add(s, at, row, n, sat->gf_tecu[i] - map[i] * vtec[i], 1 / (sigma * sigma));
        }
    }
}

static void add_codes(system_of *s, const orr_fusion_options *o, const orr_fusion *f)
{
    for (size_t a = 0; a < f->n_arcs; a++) {
        if (!f->arc[a].code_used) continue;
        size_t at[2] = {s->arcs + a, s->groups + f->arc[a].group};
        double row[2] = {1, -1};
        add(s, at, row, 2, f->arc[a].code_bias_tecu, 1 / (o->code_tecu * o->code_tecu));
    }
}

// How many thinned samples say the same: 1 + 2 sum of autocorrelations of the residuals along arcs, while
// positive.
static double alike(const orr_phase_tec *phase, const orr_fusion_options *o, const orr_fusion *f,
                    double *unit_sigma)
{
    enum { LAGS = 120 };
    double product[LAGS] = {0}, count[LAGS] = {0}, *r = NULL;
    size_t room = 0;
    for (size_t a = 0; a < f->n_arcs; a++) {
        const orr_fused_arc *arc = &f->arc[a];
        if (isnan(arc->bias_tecu)) continue;
        const orr_phase_sat *sat = &phase->sat[arc->sat_index];
        const double *vtec = f->model_vtec[arc->sat_index], *map = f->mapping[arc->sat_index];
        if (sat->n > room) {
            double *more = realloc(r, sat->n * sizeof *r);
            if (more == NULL) break;
            r = more;
            room = sat->n;
        }
        size_t n = 0;
        for (size_t i = SIZE_MAX; fusion_next_sample(sat, (int)arc->arc, o->thin_s, vtec, &i);)
            r[n++] = (sat->gf_tecu[i] - arc->bias_tecu) / map[i] - vtec[i] -
                     orr_correction_at(&f->correction, sat->t[i], sat->pierce[i].unit);
        for (size_t lag = 0; lag < LAGS; lag++)
            for (size_t i = 0; i + lag < n; i++) {
                product[lag] += r[i] * r[i + lag];
                count[lag]++;
            }
    }
    free(r);
    *unit_sigma = count[0] > 0 ? sqrt(product[0] / count[0]) / o->sample_tecu : 1;
    double sum = 1;
    for (size_t lag = 1; lag < LAGS && count[lag] > 0 && product[lag] > 0 && product[0] > 0; lag++)
        sum += 2 * product[lag] / count[lag] / (product[0] / count[0]);
    return sum;
}

orr_status fusion_solve(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                        orr_diag *diag)
{
    orr_correction *c = &out->correction;
    system_of s = {.arcs = c->n * ORR_CORRECTION_TERMS};
    s.groups = s.arcs + out->n_arcs;
    s.n = s.groups + out->n_groups;
    if (s.n > 6000)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%zu arcs over %zu hours are too many for one fit; fuse shorter stretches",
                            out->n_arcs, c->n);
    s.normal = calloc(s.n * s.n, sizeof *s.normal);
    s.rhs = calloc(s.n, sizeof *s.rhs);
    if (s.normal == NULL || s.rhs == NULL) {
        free(s.normal);
        free(s.rhs);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the fit");
    }
    add_walk(&s, c, o);
    // Biases can be anything; a sigma of 1000 TECU only keeps a bias that nothing speaks of (withheld) from
    // being singular.
    for (size_t i = s.arcs; i < s.n; i++) s.normal[i * s.n + i] += 1e-6;
    add_phases(&s, phase, o, out);
    add_codes(&s, o, out);
    orr_status solved = orr_cholesky_factor(s.normal, s.n, 0);
    if (solved == ORR_OK) solved = orr_cholesky_solve(s.normal, s.n, s.rhs);
    if (solved == ORR_OK) solved = orr_cholesky_invert(s.normal, s.n);
    if (solved != ORR_OK) {
        free(s.normal);
        free(s.rhs);
        return orr_diag_set(diag, ORR_E_NUMERIC, "the fit of arc biases and correction has no unique answer");
    }
    for (size_t k = 0; k < c->n; k++)
        for (size_t j = 0; j < ORR_CORRECTION_TERMS; j++) c->term[k][j] = s.rhs[k * ORR_CORRECTION_TERMS + j];
    for (size_t a = 0; a < out->n_arcs; a++)
        if (!isnan(out->arc[a].bias_tecu)) out->arc[a].bias_tecu = s.rhs[s.arcs + a];
    out->inflation = alike(phase, o, out, &out->unit_sigma);
    double scale = out->unit_sigma * sqrt(out->inflation);
    for (size_t a = 0; a < out->n_arcs; a++) {
        size_t i = s.arcs + a;
        out->arc[a].sigma_tecu = isnan(out->arc[a].bias_tecu) ? ORR_NAN : scale * sqrt(s.normal[i * s.n + i]);
    }
    for (size_t g = 0; g < out->n_groups; g++) {
        size_t i = s.groups + g;
        bool used = false;
        for (size_t a = 0; a < out->n_arcs; a++) used |= out->arc[a].code_used && out->arc[a].group == g;
        out->group[g].receiver_tecu = used ? s.rhs[i] : ORR_NAN;
        out->group[g].sigma_tecu = used ? scale * sqrt(s.normal[i * s.n + i]) : ORR_NAN;
    }
    free(s.normal);
    free(s.rhs);
    return ORR_OK;
}
