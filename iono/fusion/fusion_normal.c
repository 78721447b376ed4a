// SPDX-License-Identifier: GPL-3.0-or-later
// Normal equations of the joint method. Every arc's bias is eliminated on the spot, so that the unknowns are the
// correction's knots and the receiver's biases: [knots x terms | receiver biases], dense (some hundreds). What one arc
// contributes can be taken out again, which is how arcs are left out.
//
// Along an arc, phase minus field, over the mapping, is correction + bias / mapping + structure, the structure a
// stationary process whose correlation falls exponentially with time. Such a process is whitened exactly by
// differences of neighbours, (r[i] - rho r[i-1]) / sqrt(1 - rho^2).
#include "iono/fusion/fusion_private.h"

#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "core/nan.h"

#define MOST_UNKNOWNS 3000
// A receiver's bias can be anything; a sigma of 1000 TECU only keeps one that nothing speaks of from being singular.
#define FREE_BIAS_WEIGHT 1e-6
// Receivers' biases move by this and more within a day (Ciraolo et al. 2007), so a published one, which is the day's, is
// that of a session to no better.
#define RECEIVER_MOVES_TECU 0.5

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

double fusion_residual(const orr_phase_tec *p, const orr_fusion *f, const orr_fused_arc *a, size_t i)
{
    const orr_phase_sat *sat = &p->sat[a->sat_index];
    double vtec = f->model_vtec[a->sat_index][i], map = f->mapping[a->sat_index][i];
    double correction = orr_correction_at(&f->correction, sat->t[i], sat->pierce[i].unit, vtec, map);
    return sat->gf_tecu[i] - a->bias_tecu - map * (vtec + correction);
}

orr_status fusion_normal_init(const orr_fusion *f, fusion_normal *out, orr_diag *diag)
{
    *out = (fusion_normal){.groups = f->correction.n * ORR_CORRECTION_TERMS};
    out->n = out->groups + f->n_groups;
    if (out->n > MOST_UNKNOWNS)
        return orr_diag_set(diag, ORR_E_LIMIT, "%zu hours are too many for one fit; fuse shorter stretches",
                            f->correction.n);
    out->matrix = calloc(out->n * out->n, sizeof *out->matrix);
    out->rhs = calloc(out->n, sizeof *out->rhs);
    out->part = calloc(out->n, sizeof *out->part);
    if (out->matrix == NULL || out->rhs == NULL || out->part == NULL) {
        fusion_normal_free(out);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the fit");
    }
    return ORR_OK;
}

void fusion_normal_free(fusion_normal *s)
{
    free(s->matrix);
    free(s->rhs);
    free(s->part);
    *s = (fusion_normal){0};
}

void fusion_normal_clear(fusion_normal *s)
{
    memset(s->matrix, 0, s->n * s->n * sizeof *s->matrix);
    memset(s->rhs, 0, s->n * sizeof *s->rhs);
    s->square = s->log_variances = 0;
}

// A row of the design matrix over the columns [from, to), and with it the bias and the value.
typedef struct line {
    size_t from, to;
    double column[3 * ORR_CORRECTION_TERMS], bias, value;
} line;

static line line_of(const orr_fusion *f, const orr_fused_arc *arc, const orr_phase_sat *sat, size_t i)
{
    line x = {.bias = 1 / f->mapping[arc->sat_index][i]};
    double term[ORR_CORRECTION_TERMS], w;
    size_t k;
    x.value = sat->gf_tecu[i] * x.bias - f->model_vtec[arc->sat_index][i];
    correction_terms(&f->correction, sat->pierce[i].unit, f->model_vtec[arc->sat_index][i],
                     f->mapping[arc->sat_index][i], term);
    correction_knots(&f->correction, sat->t[i], &k, &w);
    x.from = k * ORR_CORRECTION_TERMS;
    x.to = x.from + (f->correction.n > 1 ? 2U : 1U) * ORR_CORRECTION_TERMS;
    for (size_t j = 0; j < ORR_CORRECTION_TERMS; j++) {
        x.column[j] = (1 - w) * term[j];
        if (f->correction.n > 1) x.column[ORR_CORRECTION_TERMS + j] = w * term[j];
    }
    return x;
}

// (x - rho before) * scale over the columns of both, which are the same knots or the next ones. False where they are
// further apart: then nothing is known of the correlation that a line could hold, and it is left to start anew.
static bool whitened(const line *x, const line *before, double rho, double scale, line *out)
{
    if (x->from > before->to || x->to - before->from > 3 * ORR_CORRECTION_TERMS) return false;
    *out = (line){.from = before->from, .to = x->to};
    for (size_t c = x->from; c < x->to; c++) out->column[c - out->from] = scale * x->column[c - x->from];
    for (size_t c = before->from; c < before->to; c++)
        out->column[c - out->from] -= scale * rho * before->column[c - before->from];
    out->bias = scale * (x->bias - rho * before->bias);
    out->value = scale * (x->value - rho * before->value);
    return true;
}

// The sums over an arc that its bias takes part in.
typedef struct with_bias {
    size_t from, to; // columns touched, without the receiver's
    double weight, value;
} with_bias;

static void add_line(fusion_normal *s, const line *x, double sign, with_bias *b)
{
    for (size_t r = x->from; r < x->to; r++) {
        double v = x->column[r - x->from];
        for (size_t c = x->from; c <= r; c++) s->matrix[r * s->n + c] += sign * v * x->column[c - x->from];
        s->rhs[r] += sign * v * x->value;
        s->part[r] += v * x->bias;
    }
    if (x->from < b->from) b->from = x->from;
    if (x->to > b->to) b->to = x->to;
    b->weight += x->bias * x->bias;
    b->value += x->bias * x->value;
    s->square += sign * x->value * x->value;
}

// Sums of an arc, its bias still in them: s->part[] holds the products with the bias's column.
static with_bias sum_arc(fusion_normal *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                         const orr_fusion *f, const orr_fused_arc *arc, double sign)
{
    const orr_phase_sat *sat = &phase->sat[arc->sat_index];
    const orr_fusion_model *m = &f->model;
    with_bias b = {.from = s->groups};
    line before = {0};
    orr_time last = 0;
    bool started = false;
    for (size_t i = SIZE_MAX;
         fusion_next_sample(sat, (int)arc->arc, o->thin_s, f->model_vtec[arc->sat_index], &i);) {
        line x = line_of(f, arc, sat, i), white;
        double rho = started ? exp(-orr_time_diff_s(sat->t[i], last) / m->residual_s) : 0;
        double sigma = m->residual_tecu * sqrt(1 - rho * rho);
        if (!started || !whitened(&x, &before, rho, 1 / sigma, &white)) {
            sigma = m->residual_tecu;
            white = x;
            for (size_t c = 0; c < x.to - x.from; c++) white.column[c] /= sigma;
            white.bias /= sigma;
            white.value /= sigma;
        }
        add_line(s, &white, sign, &b);
        s->log_variances += sign * 2 * log(sigma);
        before = x;
        last = sat->t[i];
        started = true;
    }
    if (arc->code_used) { // bias - receiver = code_bias
        double w = 1 / (o->code_tecu * o->code_tecu);
        size_t g = s->groups + arc->group;
        s->matrix[g * s->n + g] += sign * w;
        s->rhs[g] -= sign * w * arc->code_bias_tecu;
        s->part[g] = -w;
        b.weight += w;
        b.value += w * arc->code_bias_tecu;
        s->square += sign * w * arc->code_bias_tecu * arc->code_bias_tecu;
        s->log_variances += sign * 2 * log(o->code_tecu);
    }
    return b;
}

static void clear_part(fusion_normal *s, const orr_fused_arc *arc, const with_bias *b)
{
    for (size_t c = b->from; c < b->to; c++) s->part[c] = 0;
    if (arc->code_used) s->part[s->groups + arc->group] = 0;
}

void fusion_normal_add_arc(fusion_normal *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                           const orr_fusion *f, const orr_fused_arc *arc, double sign)
{
    with_bias b = sum_arc(s, phase, o, f, arc, sign);
    size_t g = s->groups + arc->group;
    for (size_t r = b.from; r < b.to; r++) {
        double v = sign * s->part[r] / b.weight;
        for (size_t c = b.from; c <= r; c++) s->matrix[r * s->n + c] -= v * s->part[c];
        s->rhs[r] -= v * b.value;
        if (arc->code_used) s->matrix[g * s->n + r] -= v * s->part[g];
    }
    if (arc->code_used) {
        s->matrix[g * s->n + g] -= sign * s->part[g] * s->part[g] / b.weight;
        s->rhs[g] -= sign * s->part[g] * b.value / b.weight;
    }
    s->square -= sign * b.value * b.value / b.weight;
    s->log_variances += sign * log(b.weight);
    clear_part(s, arc, &b);
}

void fusion_normal_add_prior(fusion_normal *s, const orr_fusion *f)
{
    const orr_correction *c = &f->correction;
    for (int j = 0; j < ORR_CORRECTION_TERMS; j++) {
        double sigma, time_s;
        correction_prior(&f->model, j, &sigma, &time_s);
        double rho = exp(-c->knot_s / time_s);
        double q = sigma * sigma * (1 - rho * rho), w = 1 / (sigma * sigma);
        s->matrix[(size_t)j * (s->n + 1)] += w;
        s->log_variances += 2 * log(sigma) + (double)(c->n - 1) * log(q);
        for (size_t k = 0; k + 1 < c->n; k++) { // value[k + 1] = rho value[k] + noise of variance q
            size_t a = k * ORR_CORRECTION_TERMS + (size_t)j, b = a + ORR_CORRECTION_TERMS;
            s->matrix[a * (s->n + 1)] += rho * rho / q;
            s->matrix[b * (s->n + 1)] += 1 / q;
            s->matrix[b * s->n + a] -= rho / q;
        }
    }
    for (size_t g = 0; g < f->n_groups; g++) {
        size_t i = s->groups + g;
        double known = f->group[g].published_tecu,
               sigma = hypot(f->group[g].published_sigma_tecu, RECEIVER_MOVES_TECU);
        double w = isnan(known) ? FREE_BIAS_WEIGHT : 1 / (sigma * sigma);
        s->matrix[i * (s->n + 1)] += w;
        s->log_variances -= log(w);
        if (isnan(known)) continue;
        s->rhs[i] += w * known;
        s->square += w * known * known;
    }
}

void fusion_normal_build(fusion_normal *s, const orr_phase_tec *phase, const orr_fusion_options *o,
                         const orr_fusion *f)
{
    fusion_normal_clear(s);
    fusion_normal_add_prior(s, f);
    for (size_t a = 0; a < f->n_arcs; a++) fusion_normal_add_arc(s, phase, o, f, &f->arc[a], 1);
}

orr_status fusion_normal_factor(fusion_normal *s, double *minus_two_log_likelihood)
{
    orr_status status = orr_cholesky_factor(s->matrix, s->n, 0);
    if (status == ORR_OK) status = orr_cholesky_solve_lower(s->matrix, s->n, s->rhs);
    if (status != ORR_OK) return status;
    double sum = s->log_variances + s->square;
    for (size_t i = 0; i < s->n; i++) sum += 2 * log(s->matrix[i * (s->n + 1)]) - s->rhs[i] * s->rhs[i];
    *minus_two_log_likelihood = sum;
    // L' x = L^-1 b, from the last unknown up.
    for (size_t i = s->n; i-- > 0;) {
        s->rhs[i] /= s->matrix[i * (s->n + 1)];
        for (size_t j = 0; j < i; j++) s->rhs[j] -= s->matrix[i * s->n + j] * s->rhs[i];
    }
    return ORR_OK;
}

void fusion_normal_take_correction(const fusion_normal *s, orr_fusion *f)
{
    for (size_t k = 0; k < f->correction.n; k++)
        for (size_t j = 0; j < ORR_CORRECTION_TERMS; j++)
            f->correction.term[k][j] = s->rhs[k * ORR_CORRECTION_TERMS + j];
}

// Biases of the arcs and of the receiver with their sigmas, given the factor and solution in `s`; `sums` is a second
// system of the same size, as workspace.
static orr_status take_biases(const fusion_normal *s, fusion_normal *sums, const orr_phase_tec *phase,
                              const orr_fusion_options *o, orr_fusion *f)
{
    orr_status status = ORR_OK;
    for (size_t a = 0; status == ORR_OK && a < f->n_arcs; a++) {
        orr_fused_arc *arc = &f->arc[a];
        with_bias b = sum_arc(sums, phase, o, f, arc, 1);
        double value = b.value, variance = 0;
        memcpy(sums->rhs, sums->part, s->n * sizeof *sums->rhs);
        for (size_t i = 0; i < s->n; i++) value -= sums->part[i] * s->rhs[i];
        status = orr_cholesky_solve_lower(s->matrix, s->n, sums->rhs);
        for (size_t i = 0; i < s->n; i++) variance += sums->rhs[i] * sums->rhs[i];
        arc->bias_tecu = value / b.weight;
        arc->sigma_tecu = sqrt(1 / b.weight + variance / (b.weight * b.weight));
        clear_part(sums, arc, &b);
    }
    for (size_t g = 0; status == ORR_OK && g < f->n_groups; g++) {
        bool used = false;
        for (size_t a = 0; a < f->n_arcs; a++) used |= f->arc[a].code_used && f->arc[a].group == g;
        double variance = 0;
        memset(sums->rhs, 0, s->n * sizeof *sums->rhs);
        sums->rhs[s->groups + g] = 1;
        status = orr_cholesky_solve_lower(s->matrix, s->n, sums->rhs);
        for (size_t i = 0; i < s->n; i++) variance += sums->rhs[i] * sums->rhs[i];
        f->group[g].receiver_tecu = used ? s->rhs[s->groups + g] : ORR_NAN;
        f->group[g].sigma_tecu = used ? sqrt(variance + RECEIVER_MOVES_TECU * RECEIVER_MOVES_TECU) : ORR_NAN;
    }
    return status;
}

// Sigma of the correction over the station in the middle of the session.
static orr_status take_level(const fusion_normal *s, fusion_normal *sums, orr_fusion *f)
{
    memset(sums->rhs, 0, s->n * sizeof *sums->rhs);
    sums->rhs[f->correction.n / 2 * ORR_CORRECTION_TERMS] = 1;
    orr_status status = orr_cholesky_solve_lower(s->matrix, s->n, sums->rhs);
    double variance = 0;
    for (size_t i = 0; i < s->n; i++) variance += sums->rhs[i] * sums->rhs[i];
    f->level_sigma_tecu = sqrt(variance);
    return status;
}

orr_status fusion_solve(const orr_phase_tec *phase, const orr_fusion_options *o, orr_fusion *out,
                        orr_diag *diag)
{
    fusion_normal s, sums = {0};
    double likelihood;
    orr_status status = fusion_normal_init(out, &s, diag);
    if (status == ORR_OK) status = fusion_normal_init(out, &sums, diag);
    if (status == ORR_OK) {
        fusion_normal_build(&s, phase, o, out);
        status = fusion_normal_factor(&s, &likelihood);
        if (status == ORR_OK) {
            fusion_normal_take_correction(&s, out);
            status = take_biases(&s, &sums, phase, o, out);
        }
        if (status == ORR_OK) status = take_level(&s, &sums, out);
        if (status != ORR_OK)
            status = orr_diag_set(diag, ORR_E_NUMERIC,
                                  "the fit of arc biases and correction has no unique answer");
    }
    fusion_normal_free(&s);
    fusion_normal_free(&sums);
    return status;
}
