// SPDX-License-Identifier: GPL-3.0-or-later
// The unknowns of a calibration as they truly are, in the axes that the accelerometers fix, and how far a solution is from them.
#include <math.h>
#include <stdlib.h>

#include "core/linalg.h"
#include "inertial/study/calibration_private.h"

double orr_calibration_along(const orr_stand_cycle *cycle, const orr_calibration_truth *truth)
{
    orr_vec3 r = orr_vec3_add(cycle->outer_m, truth->inner_m[0]);
    return *orr_component(&r, orr_calibration_nearest(cycle));
}

void orr_calibration_true_values(const orr_calibration_plan *plan, const orr_calibration_truth *truth,
                                 double *value)
{
    for (int i = 0; i < 3; i++) {
        value[ACCEL_BIAS + i] = truth->accel_bias_mps2[i];
        value[GYRO_BIAS + i] = truth->gyro_bias_radps[i];
        value[ACCEL_SCALE + i] = truth->accel.m[i][i] - 1;
        value[ACCEL_CROSS + i] = truth->accel.m[cross_row[i]][cross_column[i]];
        for (int k = 0; k < 3; k++) value[GYRO_MATRIX + 3 * i + k] = truth->gyro.m[i][k] - (i == k ? 1 : 0);
    }
    const orr_vec3 origin = plan->offsets_known ? (orr_vec3){0, 0, 0} : truth->inner_m[0];
    for (int axis = plan->offsets_known ? 0 : 1; plan->arms && axis < 3; axis++) {
        const orr_vec3 r = orr_vec3_sub(truth->inner_m[axis], origin);
        double *v = value + ARMS + 3 * (axis - (plan->offsets_known ? 0 : 1));
        v[0] = r.x;
        v[1] = r.y;
        v[2] = r.z;
    }
    for (size_t c = 0; c < plan->n_cycles; c++) {
        const orr_stand_cycle *q = &plan->cycle[c];
        double *v = value + orr_calibration_parameters(plan) + c * orr_calibration_per_cycle(plan);
        // The same attitude by a mounting error without a part along the axis: it is R = C1(alpha) I R2(chi) I' of the
        // body's axes; the turn about the nearest axis goes to the start angle, by iteration.
        const int a = orr_calibration_nearest(q), i = (a + 1) % 3, j = (a + 2) % 3;
        const orr_mat3 alpha = orr_mat3_from_rotvec(q->mounting_rad), chi = orr_mat3_rot2(q->start_rad),
                       nominal = orr_mat3_mul(&q->order, &chi), C = orr_mat3_mul(&alpha, &nominal);
        double start = q->start_rad;
        orr_vec3 tilt = {0, 0, 0};
        const double sign = q->order.m[a][1] > 0 ? 1 : -1;
        for (int k = 0; k < 60; k++) {
            const orr_mat3 back = orr_mat3_rot2(start), there = orr_mat3_mul(&q->order, &back),
                           turned = orr_mat3_transpose(&there), left = orr_mat3_mul(&C, &turned);
            tilt = orr_rotvec_from_mat3(&left);
            start += sign * *orr_component(&tilt, a);
        }
        v[TILT_1] = *orr_component(&tilt, i);
        v[TILT_2] = *orr_component(&tilt, j);
        v[START] = start;
        if (plan->offsets_known) continue;
        orr_vec3 r = orr_vec3_add(q->outer_m, origin);
        v[OFFSET_1] = *orr_component(&r, i);
        v[OFFSET_2] = *orr_component(&r, j);
    }
}

orr_status orr_calibration_own_axes(orr_calibration_truth *truth, orr_mat3 *turned, orr_diag *diag)
{
    // Rows of the accelerometers' matrix, made orthogonal from the first on (Gram and Schmidt), are the axes.
    orr_vec3 row[3], axis[3];
    for (int i = 0; i < 3; i++)
        row[i] = (orr_vec3){truth->accel.m[i][0], truth->accel.m[i][1], truth->accel.m[i][2]};
    for (int i = 0; i < 3; i++) {
        axis[i] = row[i];
        for (int k = 0; k < i; k++)
            axis[i] = orr_vec3_axpy(-orr_vec3_dot(axis[i], axis[k]), axis[k], axis[i]);
        if (!(orr_vec3_norm(axis[i]) > 1e-3 * orr_vec3_norm(row[i])))
            return orr_diag_set(diag, ORR_E_NUMERIC, "two accelerometers look the same way");
        axis[i] = orr_vec3_unit(axis[i]);
    }
    for (int i = 0; i < 3; i++) {
        turned->m[i][0] = axis[i].x;
        turned->m[i][1] = axis[i].y;
        turned->m[i][2] = axis[i].z;
    }
    const orr_mat3 Rt = orr_mat3_transpose(turned);
    truth->accel = orr_mat3_mul(&truth->accel, &Rt);
    truth->gyro = orr_mat3_mul(&truth->gyro, &Rt);
    for (int i = 0; i < 3; i++) truth->inner_m[i] = orr_mat3_apply(turned, truth->inner_m[i]);
    return ORR_OK;
}

orr_status orr_calibration_nees(const orr_calibration_result *r, const double *value, const double *truth,
                                size_t k, double *nees, orr_diag *diag)
{
    double *P = malloc(k * k * sizeof *P), *e = malloc(k * sizeof *e);
    orr_status s =
        P != NULL && e != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "no memory for a covariance");
    if (s == ORR_OK) {
        // In units of sigma, which are of very different size.
        for (size_t i = 0; i < k; i++) {
            e[i] = (value[i] - truth[i]) / r->sigma[i];
            for (size_t j = 0; j < k; j++)
                P[i * k + j] = r->covariance[i * r->n + j] / (r->sigma[i] * r->sigma[j]);
        }
        if (orr_cholesky_factor(P, k, 1e-14) != ORR_OK || orr_cholesky_solve_lower(P, k, e) != ORR_OK)
            s = orr_diag_set(diag, ORR_E_NUMERIC, "the covariance of a calibration is not positive");
    }
    *nees = 0;
    for (size_t i = 0; s == ORR_OK && i < k; i++) *nees += e[i] * e[i];
    free(P);
    free(e);
    return s;
}
