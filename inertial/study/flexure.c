// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/flexure.h"

#include <math.h>
#include <stdlib.h>

#include "core/rng.h"

#define STEPS_A_TIME 20.0 // of 1 / beta

typedef struct bending {
    const orr_mounting *mounting;
    double begin_s, step_s;
    size_t n;
    orr_vec3 *angle; // [n] at begin_s + k step_s
} bending;

// x'' + 2 b x' + b^2 x = w exactly from step to step: the state (x, x') decays by exp(-b t) [1 + b t, t; -b^2 t, 1 - b t], and what the noise
// adds has the covariance of the stationary state less what is left of it.
static void fill_axis(const orr_flexure *f, int axis, double h, size_t n, double *x)
{
    const double b = f->beta_radps, s2 = f->sigma_rad * f->sigma_rad, e = exp(-b * h), bh = b * h;
    const double a[2][2] = {{e * (1.0 + bh), e * h}, {-e * b * bh, e * (1.0 - bh)}}, p[2] = {s2, s2 * b * b};
    double q[2][2];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            q[i][k] = (i == k ? p[i] : 0.0) - a[i][0] * p[0] * a[k][0] - a[i][1] * p[1] * a[k][1];
    const double l11 = sqrt(q[0][0]), l21 = q[1][0] / l11, l22 = sqrt(fmax(0.0, q[1][1] - l21 * l21));
    const uint64_t stream = 5000u + (uint64_t)axis;
    double v[2] = {f->sigma_rad * orr_rng_normal(f->seed, stream, 0),
                   f->sigma_rad * b * orr_rng_normal(f->seed, stream, 1)};
    for (size_t k = 0; k < n; k++) {
        x[k] = v[0];
        const double g = orr_rng_normal(f->seed, stream, 2 * k + 2),
                     d = orr_rng_normal(f->seed, stream, 2 * k + 3);
        const double next = a[0][0] * v[0] + a[0][1] * v[1] + l11 * g;
        v[1] = a[1][0] * v[0] + a[1][1] * v[1] + l21 * g + l22 * d;
        v[0] = next;
    }
}

static orr_status bend(const orr_flexure *f, const orr_trajectory *tr, bending *b, orr_diag *diag)
{
    b->begin_s = tr->begin_s;
    b->step_s = 1.0 / (STEPS_A_TIME * f->beta_radps);
    b->n = (size_t)((tr->end_s - tr->begin_s) / b->step_s) + 3;
    b->angle = malloc(b->n * sizeof *b->angle);
    double *x = malloc(3 * b->n * sizeof *x);
    if (b->angle == NULL || x == NULL) {
        free(x);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu angles of bending", b->n);
    }
    for (int axis = 0; axis < 3; axis++) fill_axis(f, axis, b->step_s, b->n, x + (size_t)axis * b->n);
    for (size_t k = 0; k < b->n; k++) b->angle[k] = orr_vec3_make(x[k], x[b->n + k], x[2 * b->n + k]);
    free(x);
    return ORR_OK;
}

// The first unit's motion becomes that of the end of the bent arm.
static void apply(void *user, double t_s, orr_motion *m)
{
    const bending *b = user;
    const double at = fmin(fmax((t_s - b->begin_s) / b->step_s, 0.0), (double)(b->n - 2));
    const size_t k = (size_t)at;
    const orr_vec3 angle =
        orr_vec3_axpy(at - (double)k, orr_vec3_sub(b->angle[k + 1], b->angle[k]), b->angle[k]);
    const orr_mat3 A = orr_mat3_from_quat(m->q_be), bent = orr_mat3_from_rotvec(angle);
    const orr_vec3 arm = orr_mat3_apply_t(&bent, b->mounting->arm_m);
    m->r_m = orr_vec3_add(m->r_m, orr_mat3_apply_t(&A, arm));
    m->q_be = orr_quat_mul(orr_quat_mul(m->q_be, orr_quat_from_rotvec(angle)),
                           orr_quat_from_mat3(&b->mounting->C_21));
}

orr_status orr_trajectory_flexed(const orr_trajectory *first, const orr_mounting *mounting,
                                 const orr_flexure *flexure, orr_trajectory *out, orr_diag *diag)
{
    if (!(flexure->sigma_rad > 0.0 && flexure->beta_radps > 0.0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "an arm bends by more than nothing, and not for ever one way: sigma %g rad, rate "
                            "%g rad/s",
                            flexure->sigma_rad, flexure->beta_radps);
    bending b = {.mounting = mounting};
    orr_status s = bend(flexure, first, &b, diag);
    if (s == ORR_OK) s = orr_trajectory_resample(first, b.step_s, apply, &b, out, diag);
    free(b.angle);
    return s;
}

orr_vec3 orr_flexure_velocity_mps(const orr_flexure *f, orr_vec3 arm)
{
    const double rate = f->sigma_rad * f->beta_radps;
    return orr_vec3_make(rate * hypot(arm.y, arm.z), rate * hypot(arm.x, arm.z), rate * hypot(arm.x, arm.y));
}
