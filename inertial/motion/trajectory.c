// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/trajectory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/uniform_spline.h"

orr_status orr_trajectory_evaluate(const orr_trajectory *tr, double t_s, orr_motion *out, orr_diag *diag)
{
    if (!(t_s >= tr->begin_s - 1e-6 && t_s <= tr->end_s + 1e-6))
        return orr_diag_set(
            diag, ORR_E_RANGE,
            "the trajectory knows the %.3f s from %.3f s to %.3f s after its start time, not %.3f s",
            tr->end_s - tr->begin_s, tr->begin_s, tr->end_s, t_s);
    tr->evaluate(tr->self, t_s, out);
    return ORR_OK;
}

void orr_trajectory_free(orr_trajectory *tr)
{
    if (tr->destroy != NULL) tr->destroy(tr->self);
    memset(tr, 0, sizeof *tr);
}

typedef struct spline_motion {
    orr_vec3 origin_m;
    orr_uspline r, q;
} spline_motion;

static void evaluate_spline(const void *self, double t_s, orr_motion *out)
{
    const spline_motion *s = self;
    double r[3], v[3], a[3], p[4], d1[4], d2[4];
    orr_uspline_eval(&s->r, t_s, r, v, a);
    orr_uspline_eval(&s->q, t_s, p, d1, d2);
    out->r_m = orr_vec3_make(s->origin_m.x + r[0], s->origin_m.y + r[1], s->origin_m.z + r[2]);
    out->v_mps = orr_vec3_make(v[0], v[1], v[2]);
    out->a_mps2 = orr_vec3_make(a[0], a[1], a[2]);
    orr_rates_from_quat(p, d1, d2, &out->q_be, &out->w_radps, &out->wdot_radps2);
}

static void destroy_spline(void *self)
{
    spline_motion *s = self;
    orr_uspline_free(&s->r);
    orr_uspline_free(&s->q);
    free(s);
}

// Knot intervals of step that cover [first, last] when knots pass through begin: *origin moves back by whole
// steps.
static size_t cover(double begin_s, double step_s, double first_s, double last_s, double *origin_s)
{
    double before = ceil((begin_s - first_s) / step_s - 1e-6);
    if (before < 0.0) before = 0.0;
    *origin_s = begin_s - before * step_s;
    double n = ceil((last_s - *origin_s) / step_s - 1e-6);
    return n < 1.0 ? 1 : n > 4e9 ? (size_t)4000000000u : (size_t)n;
}

static bool commensurate(double a, double b)
{
    double k = a > b ? a / b : b / a;
    return fabs(k - nearbyint(k)) < 1e-6 * k;
}

static orr_status fit_positions(const orr_spline_samples *in, orr_spline_plan plan, double begin_s,
                                double end_s, spline_motion *s, orr_spline_residuals *res, orr_diag *diag)
{
    const orr_vec3 *mid = &in->r_m[in->n_r / 2];
    s->origin_m = orr_vec3_make(nearbyint(mid->x), nearbyint(mid->y), nearbyint(mid->z));
    double *value = malloc(in->n_r * 3 * sizeof *value);
    if (value == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu positions", in->n_r);
    for (size_t k = 0; k < in->n_r; k++) {
        value[3 * k] = in->r_m[k].x - s->origin_m.x;
        value[3 * k + 1] = in->r_m[k].y - s->origin_m.y;
        value[3 * k + 2] = in->r_m[k].z - s->origin_m.z;
    }
    double origin_s, first = fmin(begin_s, in->r_t_s[0]), last = fmax(end_s, in->r_t_s[in->n_r - 1]);
    size_t n = cover(begin_s, plan.knot_step_s, first, last, &origin_s);
    orr_status status = orr_uspline_fit(plan.degree, 3, origin_s, plan.knot_step_s, n, in->n_r, in->r_t_s,
                                        value, NULL, plan.roughness, &s->r, diag);
    if (status == ORR_OK && res != NULL) {
        double sum = 0.0, max = 0.0;
        for (size_t k = 0; k < in->n_r; k++) {
            double p[3];
            orr_uspline_eval(&s->r, in->r_t_s[k], p, NULL, NULL);
            double e2 = 0.0;
            for (size_t c = 0; c < 3; c++) e2 += (p[c] - value[3 * k + c]) * (p[c] - value[3 * k + c]);
            sum += e2;
            if (e2 > max) max = e2;
        }
        res->position_rms_m = sqrt(sum / (double)in->n_r);
        res->position_max_m = sqrt(max);
    }
    free(value);
    return status;
}

static orr_status fit_attitudes(const orr_spline_samples *in, orr_spline_plan plan, double begin_s,
                                double end_s, spline_motion *s, orr_spline_residuals *res, orr_diag *diag)
{
    double *value = malloc(in->n_q * 4 * sizeof *value);
    if (value == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu attitudes", in->n_q);
    orr_quat last = in->q_be[0];
    for (size_t k = 0; k < in->n_q; k++) {
        orr_quat q = in->q_be[k];
        if (orr_quat_dot(q, last) < 0.0) q = orr_quat_neg(q);
        value[4 * k] = q.w;
        value[4 * k + 1] = q.x;
        value[4 * k + 2] = q.y;
        value[4 * k + 3] = q.z;
        last = q;
    }
    double origin_s, first = fmin(begin_s, in->q_t_s[0]), end = fmax(end_s, in->q_t_s[in->n_q - 1]);
    size_t n = cover(begin_s, plan.knot_step_s, first, end, &origin_s);
    orr_status status = orr_uspline_fit(plan.degree, 4, origin_s, plan.knot_step_s, n, in->n_q, in->q_t_s,
                                        value, NULL, plan.roughness, &s->q, diag);
    if (status == ORR_OK && res != NULL) {
        double sum = 0.0, max = 0.0;
        for (size_t k = 0; k < in->n_q; k++) {
            double p[4], dot = 0.0, n2 = 0.0;
            orr_uspline_eval(&s->q, in->q_t_s[k], p, NULL, NULL);
            for (size_t c = 0; c < 4; c++) {
                dot += p[c] * value[4 * k + c];
                n2 += p[c] * p[c];
            }
            double c = fabs(dot) / sqrt(n2), e = 2.0 * acos(c < 1.0 ? c : 1.0);
            sum += e * e;
            if (e > max) max = e;
        }
        res->attitude_rms_rad = sqrt(sum / (double)in->n_q);
        res->attitude_max_rad = max;
    }
    free(value);
    return status;
}

orr_status orr_trajectory_from_samples(orr_time t0, double begin_s, double end_s,
                                       const orr_spline_samples *samples, orr_spline_plan position,
                                       orr_spline_plan attitude, orr_trajectory *out,
                                       orr_spline_residuals *residuals, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (samples->n_r == 0 || samples->n_q == 0 || !(end_s > begin_s))
        return orr_diag_set(diag, ORR_E_ARG, "a trajectory needs positions, attitudes and a length of time");
    if (!(position.knot_step_s > 0.0) || !(attitude.knot_step_s > 0.0) ||
        !commensurate(position.knot_step_s, attitude.knot_step_s))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "knot steps of %g s (position) and %g s (attitude): one has to be a whole multiple of the other",
            position.knot_step_s, attitude.knot_step_s);
    spline_motion *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a trajectory");
    orr_status status = fit_positions(samples, position, begin_s, end_s, s, residuals, diag);
    if (status == ORR_OK) status = fit_attitudes(samples, attitude, begin_s, end_s, s, residuals, diag);
    if (status != ORR_OK) {
        destroy_spline(s);
        return status;
    }
    *out =
        (orr_trajectory){.t0 = t0,
                         .begin_s = begin_s,
                         .end_s = end_s,
                         .knot_origin_s = begin_s,
                         .knot_step_s = fmin(position.knot_step_s, attitude.knot_step_s),
                         .knot_degree = position.degree < attitude.degree ? position.degree : attitude.degree,
                         .evaluate = evaluate_spline,
                         .destroy = destroy_spline,
                         .self = s};
    return ORR_OK;
}

orr_status orr_trajectory_resample(const orr_trajectory *in, double step_s,
                                   void (*change)(void *user, double t_s, orr_motion *m), void *user,
                                   orr_trajectory *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    double span = in->end_s - in->begin_s;
    if (!(step_s > 0.0) || !(span > 0.0) || span / step_s > (double)ORR_USPLINE_MAX_INTERVALS)
        return orr_diag_set(diag, ORR_E_ARG, "cannot sample %g s of motion every %g s", span, step_s);
    // A spline through its knots alone is free at the ends; samples half-way between the outer knots bind it.
    size_t knots = (size_t)ceil(span / step_s - 1e-9) + 1, n = 0;
    const size_t outer = 6;
    double *t = malloc((knots + 2 * outer) * sizeof *t);
    orr_vec3 *r = malloc((knots + 2 * outer) * sizeof *r);
    orr_quat *q = malloc((knots + 2 * outer) * sizeof *q);
    orr_status status = ORR_OK;
    if (t == NULL || r == NULL || q == NULL) {
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu samples of a trajectory", knots);
    } else {
        for (size_t k = 0; k < knots; k++) {
            bool between = (k < outer || k + 1 + outer >= knots) && k + 1 < knots;
            for (int half = 0; half <= (between ? 1 : 0); half++, n++) {
                orr_motion m;
                t[n] = in->begin_s + step_s * ((double)k + 0.5 * half);
                in->evaluate(in->self, t[n],
                             &m); // the last sample may lie a fraction of a step behind the end
                if (change != NULL) change(user, t[n], &m);
                r[n] = m.r_m;
                q[n] = m.q_be;
            }
        }
        orr_spline_plan plan = {.degree = 5, .knot_step_s = step_s, .roughness = 1e-8};
        orr_spline_samples samples = {.n_r = n, .r_t_s = t, .r_m = r, .n_q = n, .q_t_s = t, .q_be = q};
        status = orr_trajectory_from_samples(in->t0, in->begin_s, in->end_s, &samples, plan, plan, out, NULL,
                                             diag);
    }
    free(t);
    free(r);
    free(q);
    return status;
}
