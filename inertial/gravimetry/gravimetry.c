// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/gravimetry/gravimetry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void orr_gravimetry_result_free(orr_gravimetry_result *r)
{
    free(r->t_s);
    free(r->recovered_mgal);
    free(r->true_mgal);
    free(r->recovered_filtered_mgal);
    free(r->true_filtered_mgal);
    memset(r, 0, sizeof *r);
}

// out[n]: Gaussian of sigma_samples over x[n], renormalised where it reaches past the ends. Not in place.
static void gaussian_filter(const double *x, size_t n, double sigma_samples, double *out)
{
    // Far tails weigh nothing, and there are as many weights as distances: e^(-d^2/2) by a two-term
    // recurrence.
    size_t half = (size_t)ceil(4.0 * sigma_samples);
    if (half >= n) half = n - 1;
    double step = exp(-0.5 / (sigma_samples * sigma_samples));
    for (size_t i = 0; i < n; i++) {
        double sum = x[i], weight = 1.0, w = 1.0, ratio = step;
        for (size_t d = 1; d <= half; d++) {
            w *= ratio; // w_d / w_d-1 = step^(2 d - 1)
            ratio *= step * step;
            if (d <= i) {
                sum += w * x[i - d];
                weight += w;
            }
            if (i + d < n) {
                sum += w * x[i + d];
                weight += w;
            }
        }
        out[i] = sum / weight;
    }
}

orr_status orr_gravimetry_recover(const orr_imu *imu, const orr_gravimetry *truth, double sigma_s,
                                  orr_gravimetry_result *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (imu->mode.approach != 2)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "these readings are matched to a navigator (approach 1) and are no physical "
                            "force; make them with "
                            "approach 2");
    if (truth->every % imu->truth_every != 0)
        return orr_diag_set(diag, ORR_E_ARG,
                            "gravity at every %zu-th sample needs motion there, which is at every %zu-th",
                            truth->every, imu->truth_every);
    double step_s = (double)truth->every / imu->rate_hz;
    size_t n = truth->n - 1;
    if (!(sigma_s > 0.0) || (double)n * step_s < 8.0 * sigma_s)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a filter of %g s needs a run of at least %g s; this one has %g s", sigma_s,
                            8.0 * sigma_s, (double)n * step_s);
    double **column[5] = {&out->t_s, &out->recovered_mgal, &out->true_mgal, &out->recovered_filtered_mgal,
                          &out->true_filtered_mgal};
    for (int k = 0; k < 5; k++)
        if ((*column[k] = malloc(n * sizeof(double))) == NULL) {
            orr_gravimetry_result_free(out);
            return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu values of gravity", n);
        }
    out->n = n;
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = ORR_NAVIGATOR_MAX_SAMPLES};
    double sum = 0.0;
    for (size_t k = 0; k < n; k++) {
        size_t from = k * truth->every, to = from + truth->every;
        orr_nav_state s = {.edge = from, .t_s = orr_imu_edge_s(imu, from)};
        orr_imu_true_state(imu, from, &s.r_m, &s.v_mps, &s.A_bi);
        orr_navigate_from(imu, &nav, &s, to);
        orr_vec3 r, v;
        orr_mat3 A;
        orr_imu_true_state(imu, to, &r, &v, &A);
        orr_geodetic at = orr_earth_from_ecef(r);
        orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
        orr_vec3 missing = orr_mat3_apply(&E, orr_vec3_sub(v, s.v_mps));
        out->t_s[k] = 0.5 * (orr_imu_edge_s(imu, from) + orr_imu_edge_s(imu, to));
        out->recovered_mgal[k] = -missing.z / step_s / ORR_MPS2_PER_MGAL;
        out->true_mgal[k] = 0.5 * (truth->disturbance_mgal[k] + truth->disturbance_mgal[k + 1]);
        double e = out->recovered_mgal[k] - out->true_mgal[k];
        sum += e * e;
    }
    out->raw_rms_mgal = sqrt(sum / (double)n);
    gaussian_filter(out->recovered_mgal, n, sigma_s / step_s, out->recovered_filtered_mgal);
    gaussian_filter(out->true_mgal, n, sigma_s / step_s, out->true_filtered_mgal);
    size_t margin = (size_t)(3.0 * sigma_s / step_s), used = 0;
    sum = 0.0;
    for (size_t k = margin; k + margin < n; k++, used++) {
        double e = out->recovered_filtered_mgal[k] - out->true_filtered_mgal[k];
        sum += e * e;
        out->filtered_max_mgal = fmax(out->filtered_max_mgal, fabs(e));
    }
    out->filtered_rms_mgal = sqrt(sum / (double)used);
    return ORR_OK;
}
