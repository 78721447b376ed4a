// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/readings/imu.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *orr_nav_frame_name(orr_nav_frame f)
{
    return f == ORR_FRAME_INERTIAL ? "inertial" : f == ORR_FRAME_GEOGRAPHIC ? "geographic" : "body";
}

const char *orr_imu_axes_name(orr_imu_axes a)
{
    return a == ORR_AXES_FRD ? "forward right down" : "right forward up";
}

void orr_axes_swap(orr_vec3 *v, size_t n)
{
    for (size_t k = 0; v != NULL && k < n; k++) v[k] = orr_axes_swapped(v[k]);
}

// Half a turn about the line between right and forward.
orr_quat orr_axes_swapped_quat(orr_quat q)
{
    const double half = sqrt(0.5);
    return orr_quat_mul(q, (orr_quat){0.0, half, half, 0.0});
}

void orr_imu_free(orr_imu *m)
{
    free(m->dtheta_rad);
    free(m->dv_mps);
    free(m->measured_dtheta_rad);
    free(m->measured_dv_mps);
    free(m->gyro_radps);
    free(m->accel_mps2);
    free(m->r_m);
    free(m->v_mps);
    free(m->q_be);
    free(m->carried_r_m);
    memset(m, 0, sizeof *m);
}

#define MAX_SAMPLES 50000000u

void orr_imu_swap_measured(orr_imu *m)
{
    orr_vec3 *g = m->dtheta_rad, *a = m->dv_mps;
    m->dtheta_rad = m->measured_dtheta_rad;
    m->dv_mps = m->measured_dv_mps;
    m->measured_dtheta_rad = g;
    m->measured_dv_mps = a;
}

orr_status orr_imu_allocate(orr_imu *m, size_t n, size_t truth_every, bool instantaneous, bool carried,
                            orr_diag *diag)
{
    if (n == 0 || n > MAX_SAMPLES)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%zu inertial samples; a run has 1 to %u of them: change its length or rate", n,
                            MAX_SAMPLES);
    if (truth_every == 0) return orr_diag_set(diag, ORR_E_ARG, "truth at every 0th sample");
    size_t truths = n / truth_every + 1;
    m->n = n;
    m->truth_every = truth_every;
    m->dtheta_rad = malloc(n * sizeof *m->dtheta_rad);
    m->dv_mps = malloc(n * sizeof *m->dv_mps);
    m->r_m = malloc(truths * sizeof *m->r_m);
    m->v_mps = malloc(truths * sizeof *m->v_mps);
    m->q_be = malloc(truths * sizeof *m->q_be);
    m->gyro_radps = instantaneous ? malloc((n + 1) * sizeof *m->gyro_radps) : NULL;
    m->accel_mps2 = instantaneous ? malloc((n + 1) * sizeof *m->accel_mps2) : NULL;
    m->carried_r_m = carried ? malloc((n + 1) * sizeof *m->carried_r_m) : NULL;
    if (m->dtheta_rad == NULL || m->dv_mps == NULL || m->r_m == NULL || m->v_mps == NULL || m->q_be == NULL ||
        (instantaneous && (m->gyro_radps == NULL || m->accel_mps2 == NULL)) ||
        (carried && m->carried_r_m == NULL)) {
        orr_imu_free(m);
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
    }
    return ORR_OK;
}

orr_mat3 orr_inertial_from_ecef(double t_s) { return orr_mat3_rot3(-ORR_EARTH_RATE_RADPS * t_s); }

void orr_imu_true_state(const orr_imu *m, size_t edge, orr_vec3 *r_m, orr_vec3 *v_mps,
                        orr_mat3 *body_from_inertial)
{
    size_t j = edge / m->truth_every;
    orr_mat3 R = orr_inertial_from_ecef(orr_imu_edge_s(m, edge)), Rt = orr_mat3_transpose(&R);
    orr_mat3 B = orr_mat3_from_quat(m->q_be[j]);
    double u = ORR_EARTH_RATE_RADPS;
    orr_vec3 v =
        orr_vec3_make(m->v_mps[j].x - u * m->r_m[j].y, m->v_mps[j].y + u * m->r_m[j].x, m->v_mps[j].z);
    *r_m = orr_mat3_apply(&R, m->r_m[j]);
    *v_mps = orr_mat3_apply(&R, v);
    *body_from_inertial = orr_mat3_mul(&B, &Rt);
}

char *orr_imu_mode_text(const orr_imu_mode *mode, char *buf, size_t n)
{
    if (mode->approach == 2)
        snprintf(buf, n, "approach 2, %s of %d %s a step (physical)",
                 mode->quadrature == ORR_QUADRATURE_GAUSS ? "Gauss-Legendre" : "Riemann sum", mode->order,
                 mode->quadrature == ORR_QUADRATURE_GAUSS ? "nodes" : "rectangles");
    else
        snprintf(buf, n, "approach 1, %s frame, projection at %s, %s loop (navigator-matched)",
                 orr_nav_frame_name(mode->frame), mode->project_mid ? "mid-step" : "t_j",
                 mode->closed_loop ? "closed" : "open");
    return buf;
}
