// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/make/error_series.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/sense/sensors.h"

static orr_status sum_up(const orr_imu *imu, orr_error_series *out, orr_diag *diag)
{
    out->begin_s = imu->begin_s;
    out->rate_hz = imu->rate_hz;
    out->n = imu->n;
    out->dtheta_rad = malloc((imu->n + 1) * sizeof *out->dtheta_rad);
    out->dv_mps = malloc((imu->n + 1) * sizeof *out->dv_mps);
    if (out->dtheta_rad == NULL || out->dv_mps == NULL)
        return orr_diag_set(diag, ORR_E_MEMORY, "no memory for the errors of %zu readings", imu->n);
    out->dtheta_rad[0] = out->dv_mps[0] = orr_vec3_make(0, 0, 0);
    for (size_t j = 0; j < imu->n; j++) {
        out->dtheta_rad[j + 1] =
            orr_vec3_add(out->dtheta_rad[j], orr_vec3_sub(imu->measured_dtheta_rad[j], imu->dtheta_rad[j]));
        out->dv_mps[j + 1] =
            orr_vec3_add(out->dv_mps[j], orr_vec3_sub(imu->measured_dv_mps[j], imu->dv_mps[j]));
    }
    return ORR_OK;
}

orr_status orr_error_series_make(const orr_moving *moving, size_t unit, const orr_imu_errors *errors,
                                 orr_error_series *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    const orr_trajectory *tr = orr_moving_unit(moving, unit);
    const orr_imu_request q = {.begin_s = tr->begin_s,
                               .duration_s = tr->end_s - tr->begin_s,
                               .rate_hz = moving->rate_hz,
                               .mode = moving->mode,
                               .gravity = moving->gravity};
    orr_imu_errors of_unit = *errors;
    of_unit.seed += unit;
    orr_imu imu = {0};
    orr_status s = orr_imu_generate(tr, &q, &imu, diag);
    if (s != ORR_OK) return s;
    s = orr_imu_add_errors(&of_unit, &imu, NULL, diag);
    if (s == ORR_OK) s = sum_up(&imu, out, diag);
    orr_imu_free(&imu);
    if (s != ORR_OK) orr_error_series_free(out);
    return s;
}

static orr_vec3 up_to(const orr_error_series *s, const orr_vec3 *sum, double t_s)
{
    const double at = fmin(fmax((t_s - s->begin_s) * s->rate_hz, 0.0), (double)s->n),
                 whole = floor(at + 1e-6);
    const size_t k = (size_t)whole;
    const double part = fmax(at - whole, 0.0);
    if (k >= s->n || part < 1e-6) return sum[k];
    return orr_vec3_axpy(part, orr_vec3_sub(sum[k + 1], sum[k]), sum[k]);
}

void orr_error_series_add(const orr_error_series *s, double from_s, double to_s, orr_vec3 *dtheta_rad,
                          orr_vec3 *dv_mps)
{
    *dtheta_rad = orr_vec3_add(*dtheta_rad,
                               orr_vec3_sub(up_to(s, s->dtheta_rad, to_s), up_to(s, s->dtheta_rad, from_s)));
    *dv_mps = orr_vec3_add(*dv_mps, orr_vec3_sub(up_to(s, s->dv_mps, to_s), up_to(s, s->dv_mps, from_s)));
}

void orr_error_series_free(orr_error_series *s)
{
    free(s->dtheta_rad);
    free(s->dv_mps);
    memset(s, 0, sizeof *s);
}
