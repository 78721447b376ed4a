// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/dual_unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct mounted_motion {
    const orr_trajectory *first;
    orr_mounting mounting;
    orr_quat q_21;
} mounted_motion;

static void evaluate_mounted(const void *self, double t_s, orr_motion *out)
{
    const mounted_motion *u = self;
    orr_motion m;
    u->first->evaluate(u->first->self, t_s, &m);
    orr_mat3 B = orr_mat3_from_quat(m.q_be);
    orr_vec3 l = u->mounting.arm_m, v = orr_vec3_cross(m.w_radps, l);
    orr_vec3 a = orr_vec3_add(orr_vec3_cross(m.w_radps, v), orr_vec3_cross(m.wdot_radps2, l));
    out->r_m = orr_vec3_add(m.r_m, orr_mat3_apply_t(&B, l));
    out->v_mps = orr_vec3_add(m.v_mps, orr_mat3_apply_t(&B, v));
    out->a_mps2 = orr_vec3_add(m.a_mps2, orr_mat3_apply_t(&B, a));
    out->q_be = orr_quat_mul(m.q_be, u->q_21);
    out->w_radps = orr_mat3_apply(&u->mounting.C_21, m.w_radps);
    out->wdot_radps2 = orr_mat3_apply(&u->mounting.C_21, m.wdot_radps2);
}

orr_status orr_trajectory_mounted(const orr_trajectory *first, const orr_mounting *mounting,
                                  orr_trajectory *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    const orr_mat3 *C = &mounting->C_21;
    orr_mat3 T = orr_mat3_transpose(C), P = orr_mat3_mul(C, &T);
    double off = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) off = fmax(off, fabs(P.m[i][j] - (i == j ? 1.0 : 0.0)));
    if (!(off < 1e-9))
        return orr_diag_set(diag, ORR_E_ARG, "the mutual orientation of two units is no rotation");
    if (!(orr_vec3_norm(mounting->arm_m) <= 1000.0))
        return orr_diag_set(diag, ORR_E_ARG, "a lever arm of %g m; the limit is 1 km",
                            orr_vec3_norm(mounting->arm_m));
    mounted_motion *u = malloc(sizeof *u);
    if (u == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a second unit");
    *u = (mounted_motion){first, *mounting, orr_quat_from_mat3(C)};
    *out = *first;
    out->evaluate = evaluate_mounted;
    out->destroy = free;
    out->self = u;
    return ORR_OK;
}
