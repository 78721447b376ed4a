// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/make/truth.h"

#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "core/rng.h"
#include "samples/make/force.h"

#define STEP_S 60
#define STEPS_PER_DAY (ORR_S_PER_DAY / STEP_S)
#define CLOCK_SEED 20250320
#define CLOCK_STREAM 2

typedef struct node {
    orr_vec3 r, v, a; // GCRS
} node;

struct orr_sample_truth {
    size_t n_sats, n_nodes;
    orr_sample_sat sat[ORR_SAMPLE_MAX_SATS];
    orr_sample_gravity gravity;
    node *node;      // [step * n_sats + k]
    double *clock;   // the same
    orr_vec3 *burnt; // velocity just before the node, where a burn is there; [n_sats]
    size_t *burn_at; // node of the burn, 0: none; [n_sats]
};

// ---- motion of all satellites as one system, so that the sky is worked out once an instant ----

static int derivative(double s, const double y[], double dy[], void *user)
{
    const orr_sample_truth *t = user;
    orr_sample_sky sky;
    orr_sample_sky_at(orr_time_add_s(orr_sample_start(), s), &sky);
    for (size_t k = 0; k < t->n_sats; k++) {
        const double *p = y + 6 * k;
        double *d = dy + 6 * k;
        orr_vec3 r = {p[0], p[1], p[2]}, v = {p[3], p[4], p[5]};
        orr_vec3 a = orr_sample_acceleration(&t->gravity, &sky, &t->sat[k].body, r, v);
        d[0] = v.x;
        d[1] = v.y;
        d[2] = v.z;
        d[3] = a.x;
        d[4] = a.y;
        d[5] = a.z;
    }
    return GSL_SUCCESS;
}

// Position and velocity of Keplerian elements (Montenbruck and Gill 2000, 2.2).
static void from_elements(const orr_sample_sat *s, double y[6])
{
    double anomaly = s->m_rad;
    for (int i = 0; i < 50; i++) // Kepler's equation by Newton; e <= 0.17
        anomaly -= (anomaly - s->e * sin(anomaly) - s->m_rad) / (1 - s->e * cos(anomaly));
    double b = sqrt(1 - s->e * s->e), c = cos(anomaly), n = sqrt(ORR_EGM96_GM / pow(s->a_m, 3));
    double rate = n / (1 - s->e * c);
    orr_vec3 r = {s->a_m * (c - s->e), s->a_m * b * sin(anomaly), 0};
    orr_vec3 v = {-s->a_m * sin(anomaly) * rate, s->a_m * b * c * rate, 0};
    orr_mat3 turn = orr_mat3_rot3(-s->raan_rad), tilt = orr_mat3_rot1(-s->i_rad),
             perigee = orr_mat3_rot3(-s->argp_rad);
    orr_mat3 a = orr_mat3_mul(&tilt, &perigee);
    a = orr_mat3_mul(&turn, &a);
    r = orr_mat3_apply(&a, r);
    v = orr_mat3_apply(&a, v);
    const double out[6] = {r.x, r.y, r.z, v.x, v.y, v.z};
    for (int i = 0; i < 6; i++) y[i] = out[i];
}

static void keep(orr_sample_truth *t, size_t step, const double *y, const double *dy)
{
    for (size_t k = 0; k < t->n_sats; k++) {
        const double *p = y + 6 * k, *d = dy + 6 * k;
        t->node[step * t->n_sats + k] = (node){{p[0], p[1], p[2]}, {p[3], p[4], p[5]}, {d[3], d[4], d[5]}};
    }
}

static size_t step_of(orr_time at) { return (size_t)((at - orr_sample_start()) / (STEP_S * ORR_NS_PER_S)); }

static void burn(orr_sample_truth *t, size_t step, double *y)
{
    orr_sample_event event[ORR_SAMPLE_MAX_EVENTS];
    size_t n = orr_sample_events(event);
    for (size_t i = 0; i < n; i++) {
        if (event[i].kind != ORR_SAMPLE_BURN || step_of(event[i].from) != step) continue;
        for (size_t k = 0; k < t->n_sats; k++) {
            if (t->sat[k].sat != event[i].sat) continue;
            double *v = y + 6 * k + 3, speed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            t->burnt[k] = (orr_vec3){v[0], v[1], v[2]};
            t->burn_at[k] = step;
            for (int j = 0; j < 3; j++) v[j] *= 1 + event[i].value / speed;
        }
    }
}

static orr_status integrate(orr_sample_truth *t, orr_diag *diag)
{
    size_t dim = 6 * t->n_sats;
    double *y = malloc(4 * dim * sizeof *y);
    gsl_odeiv2_step *stepper = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, dim);
    gsl_odeiv2_system system = {derivative, NULL, dim, t};
    orr_status status = ORR_OK;
    if (y == NULL || stepper == NULL) {
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory to integrate %zu satellites", t->n_sats);
    } else {
        double *error = y + dim, *dy = y + 2 * dim;
        for (size_t k = 0; k < t->n_sats; k++) from_elements(&t->sat[k], y + 6 * k);
        for (size_t i = 0; status == ORR_OK && i < t->n_nodes; i++) {
            burn(t, i, y);
            (void)derivative((double)i * STEP_S, y, dy, t);
            keep(t, i, y, dy);
            if (gsl_odeiv2_step_apply(stepper, (double)i * STEP_S, STEP_S, y, error, dy, NULL, &system) !=
                GSL_SUCCESS)
                status = orr_diag_set(diag, ORR_E_NUMERIC, "the integration of the samples failed");
        }
    }
    gsl_odeiv2_step_free(stepper);
    free(y);
    return status;
}

// ---- clocks: white frequency noise, that is a random walk of phase ----

static void run_clocks(orr_sample_truth *t)
{
    orr_sample_event event[ORR_SAMPLE_MAX_EVENTS];
    size_t n = orr_sample_events(event);
    for (size_t k = 0; k < t->n_sats; k++) {
        const orr_sample_sat *s = &t->sat[k];
        double walk = s->clock_s;
        for (size_t i = 0; i < t->n_nodes; i++) {
            for (size_t j = 0; j < n; j++)
                if (event[j].kind == ORR_SAMPLE_RESET && event[j].sat == s->sat &&
                    step_of(event[j].from) == i)
                    walk += event[j].value;
            t->clock[i * t->n_sats + k] = walk;
            walk += STEP_S * s->drift_sps +
                    s->white_fm * sqrt((double)STEP_S) *
                        orr_rng_normal(CLOCK_SEED, CLOCK_STREAM, (uint64_t)s->sat << 32 | i);
        }
    }
}

orr_status orr_sample_truth_new(const orr_sat_set *only, int days, orr_sample_truth **out, orr_diag *diag)
{
    *out = NULL;
    if (days < 1 || days > ORR_SAMPLE_DAYS)
        return orr_diag_set(diag, ORR_E_ARG, "the samples have %d days, not %d", ORR_SAMPLE_DAYS, days);
    orr_sample_truth *t = calloc(1, sizeof *t);
    if (t == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the samples");
    orr_sample_sat all[ORR_SAMPLE_MAX_SATS];
    size_t n = orr_sample_constellation(all);
    for (size_t k = 0; k < n; k++)
        if (only == NULL || orr_sat_set_has(only, all[k].sat)) t->sat[t->n_sats++] = all[k];
    t->n_nodes = (size_t)days * STEPS_PER_DAY + 1;
    orr_sample_gravity_init(&t->gravity, ORR_SAMPLE_DEGREE);
    t->node = calloc(t->n_nodes * (t->n_sats + 1), sizeof *t->node);
    t->clock = calloc(t->n_nodes * (t->n_sats + 1), sizeof *t->clock);
    t->burnt = calloc(t->n_sats + 1, sizeof *t->burnt);
    t->burn_at = calloc(t->n_sats + 1, sizeof *t->burn_at);
    orr_status status = ORR_OK;
    if (t->node == NULL || t->clock == NULL || t->burnt == NULL || t->burn_at == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %d days of %zu satellites", days, t->n_sats);
    else if (t->n_sats == 0)
        status = orr_diag_set(diag, ORR_E_ARG, "none of the satellites asked for is in the samples");
    if (status == ORR_OK) status = integrate(t, diag);
    if (status != ORR_OK) {
        orr_sample_truth_free(t);
        return status;
    }
    run_clocks(t);
    *out = t;
    return ORR_OK;
}

void orr_sample_truth_free(orr_sample_truth *t)
{
    if (t == NULL) return;
    free(t->node);
    free(t->clock);
    free(t->burnt);
    free(t->burn_at);
    free(t);
}

size_t orr_sample_truth_count(const orr_sample_truth *t) { return t->n_sats; }
const orr_sample_sat *orr_sample_truth_sat(const orr_sample_truth *t, size_t k) { return &t->sat[k]; }

// The quintic through position, velocity and acceleration at both ends; u in [0, 1].
static void quintic(double u, double p0, double v0, double a0, double p1, double v1, double a1, double *p,
                    double *v)
{
    const double h = STEP_S;
    double d = p1 - p0 - h * v0 - 0.5 * h * h * a0, e = h * (v1 - v0) - h * h * a0, f = h * h * (a1 - a0);
    double c3 = 10 * d - 4 * e + 0.5 * f, c4 = -15 * d + 7 * e - f, c5 = 6 * d - 3 * e + 0.5 * f;
    *p = p0 + u * (h * v0 + u * (0.5 * h * h * a0 + u * (c3 + u * (c4 + u * c5))));
    *v = v0 + u * (h * a0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)) / h);
}

orr_status orr_sample_truth_at(const orr_sample_truth *t, size_t k, orr_time at, orr_vec3 *r_m,
                               orr_vec3 *v_mps, double *clock_s)
{
    orr_time end = orr_sample_start() + (orr_time)(t->n_nodes - 1) * STEP_S * ORR_NS_PER_S;
    if (k >= t->n_sats) return ORR_E_ARG;
    if (at < orr_sample_start() || at > end) return ORR_E_RANGE;
    size_t i = step_of(at);
    if (i == t->n_nodes - 1) i--; // the last instant is the end of the last step
    double u = orr_time_diff_s(at, orr_sample_start() + (orr_time)i * STEP_S * ORR_NS_PER_S) / STEP_S;
    const node *a = &t->node[i * t->n_sats + k], *b = a + t->n_sats;
    orr_vec3 vb = t->burn_at[k] != 0 && t->burn_at[k] == i + 1 ? t->burnt[k] : b->v, r, v;
    quintic(u, a->r.x, a->v.x, a->a.x, b->r.x, vb.x, b->a.x, &r.x, &v.x);
    quintic(u, a->r.y, a->v.y, a->a.y, b->r.y, vb.y, b->a.y, &r.y, &v.y);
    quintic(u, a->r.z, a->v.z, a->a.z, b->r.z, vb.z, b->a.z, &r.z, &v.z);
    orr_mat3 R, dR;
    orr_eop eop = orr_eop_at(NULL, at, NULL, NULL);
    orr_astro_gcrs_to_itrs(at, &eop, NULL, &R, v_mps != NULL ? &dR : NULL);
    *r_m = orr_mat3_apply(&R, r);
    if (v_mps != NULL) *v_mps = orr_vec3_add(orr_mat3_apply(&R, v), orr_mat3_apply(&dR, r));
    if (clock_s != NULL) {
        const double *c = &t->clock[i * t->n_sats + k];
        *clock_s = c[0] + u * (c[t->n_sats] - c[0]);
    }
    return ORR_OK;
}

static bool hidden(orr_sample_event_kind kind, orr_sat sat, orr_time at)
{
    orr_sample_event event[ORR_SAMPLE_MAX_EVENTS];
    size_t n = orr_sample_events(event);
    for (size_t i = 0; i < n; i++)
        if (event[i].kind == kind && event[i].sat == sat && at >= event[i].from && at <= event[i].to)
            return true;
    return false;
}

bool orr_sample_has_position(orr_sat sat, orr_time at) { return !hidden(ORR_SAMPLE_GAP, sat, at); }
bool orr_sample_has_clock(orr_sat sat, orr_time at) { return !hidden(ORR_SAMPLE_NOCLOCK, sat, at); }
