// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/nav/null_test.h"

#include <math.h>
#include <string.h>

typedef struct comparison {
    const orr_imu *imu;
    orr_null_report *report;
    orr_status (*point)(void *user, const orr_null_point *p);
    void *user;
} comparison;

static orr_status compare(void *user, const orr_nav_state *state)
{
    comparison *c = user;
    orr_null_report *r = c->report;
    if (r->replayed && memcmp(&state->r_m, &c->imu->carried_r_m[state->edge], sizeof state->r_m) != 0)
        r->bit_identical = false;
    if (state->edge % c->imu->truth_every != 0) return ORR_OK;
    r->compared++;
    orr_vec3 true_r, true_v;
    orr_mat3 true_A;
    orr_imu_true_state(c->imu, state->edge, &true_r, &true_v, &true_A);
    orr_null_point p = {.t_s = state->t_s,
                        .dr_m = orr_vec3_sub(state->r_m, true_r),
                        .dv_mps = orr_vec3_sub(state->v_mps, true_v)};
    // The ellipsoid's normal at height zero serves as the vertical: it is off by less than 1e-5 rad at any
    // flight's height.
    orr_vec3 up = orr_vec3_unit(orr_vec3_make(true_r.x, true_r.y, true_r.z / (1.0 - ORR_WGS84_E2)));
    p.vertical_m = orr_vec3_dot(p.dr_m, up);
    p.horizontal_m = orr_vec3_norm(orr_vec3_axpy(-p.vertical_m, up, p.dr_m));
    orr_mat3 t = orr_mat3_transpose(&true_A), d = orr_mat3_mul(&state->A_bi, &t);
    p.attitude_rad = orr_vec3_norm(orr_rotvec_from_mat3(&d));
    r->final_3d_m = orr_vec3_norm(p.dr_m);
    r->max_3d_m = fmax(r->max_3d_m, r->final_3d_m);
    r->max_horizontal_m = fmax(r->max_horizontal_m, p.horizontal_m);
    r->max_vertical_m = fmax(r->max_vertical_m, fabs(p.vertical_m));
    r->max_xi1_m = fmax(r->max_xi1_m, fabs(p.dr_m.x));
    r->max_attitude_rad = fmax(r->max_attitude_rad, p.attitude_rad);
    // In approach 1 the velocity at the start is that of the first step, not the true one: it is compared
    // from there on.
    if (c->imu->mode.approach == 2 || state->edge > 0)
        r->max_velocity_mps = fmax(r->max_velocity_mps, orr_vec3_norm(p.dv_mps));
    r->duration_s = state->t_s - c->imu->begin_s;
    return c->point != NULL ? c->point(c->user, &p) : ORR_OK;
}

orr_status orr_null_test(const orr_imu *imu, const orr_navigator *nav,
                         orr_status (*point)(void *user, const orr_null_point *p), void *user,
                         orr_null_report *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    out->replayed = out->bit_identical = imu->carried_r_m != NULL && nav->kind == ORR_NAVIGATOR_ONE_STEP &&
                                         nav->frame == imu->mode.frame &&
                                         nav->project_mid == imu->mode.project_mid && !nav->hold_vertical;
    comparison c = {imu, out, point, user};
    return orr_navigate(imu, nav, compare, &c, diag);
}
