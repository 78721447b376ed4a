// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sensors.h"

#include <math.h>
#include <string.h>

#include "inertial/one_step.h"

// Gauss-Legendre nodes on [-1, 1], the positive half from the middle out, and their weights (Abramowitz and
// Stegun 25.4.30).
static const double node[ORR_IMU_MAX_ORDER][3] = {{0.0},
                                                  {0.57735026918962576451},
                                                  {0.0, 0.77459666924148337704},
                                                  {0.33998104358485626480, 0.86113631159405257522},
                                                  {0.0, 0.53846931010568309104, 0.90617984593866399280}};
static const double weight[ORR_IMU_MAX_ORDER][3] = {
    {2.0},
    {1.0},
    {0.88888888888888888889, 0.55555555555555555556},
    {0.65214515486254614263, 0.34785484513745385737},
    {0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751}};

void orr_sensors_instant(const orr_trajectory *tr, const orr_gravity *g, double t_s, orr_vec3 *gyro_radps,
                         orr_vec3 *accel_mps2)
{
    orr_motion m;
    tr->evaluate(tr->self, t_s, &m);
    orr_mat3 B = orr_mat3_from_quat(m.q_be);
    double u = ORR_INERTIAL_EARTH_RATE_RADPS;
    *gyro_radps =
        orr_vec3_make(m.w_radps.x + u * B.m[0][2], m.w_radps.y + u * B.m[1][2], m.w_radps.z + u * B.m[2][2]);
    orr_vec3 f = orr_vec3_sub(orr_motion_absolute_acceleration(&m), orr_gravity_gravitation(g, m.r_m));
    *accel_mps2 = orr_mat3_apply(&B, f);
}

static void add_instant(const orr_trajectory *tr, const orr_gravity *g, double t_s, double w,
                        orr_vec3 *dtheta, orr_vec3 *dv)
{
    orr_vec3 gyro, accel;
    orr_sensors_instant(tr, g, t_s, &gyro, &accel);
    *dtheta = orr_vec3_axpy(w, gyro, *dtheta);
    *dv = orr_vec3_axpy(w, accel, *dv);
}

static void add_gauss(const orr_trajectory *tr, const orr_gravity *g, int order, double a, double b,
                      orr_vec3 *dtheta, orr_vec3 *dv)
{
    double mid = 0.5 * (a + b), half = 0.5 * (b - a);
    for (int k = 0; k < (order + 1) / 2; k++) {
        double x = half * node[order - 1][k], w = half * weight[order - 1][k];
        add_instant(tr, g, mid - x, w, dtheta, dv);
        if (x > 0.0) add_instant(tr, g, mid + x, w, dtheta, dv);
    }
}

void orr_sensors_increment(const orr_trajectory *tr, const orr_gravity *g, orr_quadrature quadrature,
                           int order, double from_s, double to_s, orr_vec3 *dtheta_rad, orr_vec3 *dv_mps)
{
    *dtheta_rad = *dv_mps = orr_vec3_make(0, 0, 0);
    if (quadrature == ORR_QUADRATURE_RIEMANN) {
        double step = (to_s - from_s) / (double)order;
        for (int k = 0; k < order; k++)
            add_instant(tr, g, from_s + ((double)k + 0.5) * step, step, dtheta_rad, dv_mps);
        return;
    }
    double a = from_s;
    if (tr->knot_step_s > 0.0) {
        // A knot within a billionth of the interval from its end is the end.
        double slack = 1e-9 * (to_s - from_s);
        double k = floor((from_s + slack - tr->knot_origin_s) / tr->knot_step_s) + 1.0;
        for (double knot; (knot = tr->knot_origin_s + k * tr->knot_step_s) < to_s - slack; k += 1.0) {
            add_gauss(tr, g, order, a, knot, dtheta_rad, dv_mps);
            a = knot;
        }
    }
    add_gauss(tr, g, order, a, to_s, dtheta_rad, dv_mps);
}

static orr_status check_request(const orr_trajectory *tr, const orr_imu_request *q, orr_diag *diag)
{
    if (!(q->rate_hz >= 0.01 && q->rate_hz <= 100000.0))
        return orr_diag_set(diag, ORR_E_ARG, "a rate of %g Hz is outside 0.01 to 100000 Hz", q->rate_hz);
    if (q->mode.approach != 1 && q->mode.approach != 2)
        return orr_diag_set(diag, ORR_E_ARG, "approach %d is neither 1 nor 2", q->mode.approach);
    int limit = q->mode.quadrature == ORR_QUADRATURE_GAUSS ? ORR_IMU_MAX_ORDER : ORR_IMU_MAX_RECTANGLES;
    if (q->mode.approach == 2 && (q->mode.order < 1 || q->mode.order > limit))
        return orr_diag_set(diag, ORR_E_ARG, "an order of %d is outside 1 to %d for this quadrature",
                            q->mode.order, limit);
    if (!(q->duration_s * q->rate_hz >= 1.0 - 1e-9))
        return orr_diag_set(diag, ORR_E_ARG, "%g s at %g Hz hold no sample", q->duration_s, q->rate_hz);
    if (q->begin_s < tr->begin_s - 1e-6 || q->begin_s + q->duration_s > tr->end_s + 1e-6)
        return orr_diag_set(diag, ORR_E_RANGE,
                            "readings from %.3f s to %.3f s are wanted, the trajectory has %.3f s to %.3f s",
                            q->begin_s, q->begin_s + q->duration_s, tr->begin_s, tr->end_s);
    return ORR_OK;
}

orr_status orr_imu_generate(const orr_trajectory *tr, const orr_imu_request *request, orr_imu *out,
                            orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = check_request(tr, request, diag);
    if (s != ORR_OK) return s;
    double samples = floor(request->duration_s * request->rate_hz + 1e-6);
    size_t n = samples < 1e12 ? (size_t)samples : (size_t)1e12;
    bool closed = request->mode.approach == 1 && request->mode.closed_loop;
    s = orr_imu_allocate(out, n, request->instantaneous, closed, diag);
    if (s != ORR_OK) return s;
    out->t0 = tr->t0;
    out->begin_s = request->begin_s;
    out->rate_hz = request->rate_hz;
    out->mode = request->mode;
    out->knot_origin_s = tr->knot_origin_s;
    out->knot_step_s = tr->knot_step_s;
    out->knot_degree = tr->knot_degree;
    for (size_t j = 0; j <= n; j++) {
        orr_motion m;
        tr->evaluate(tr->self, orr_imu_edge_s(out, j), &m);
        out->r_m[j] = m.r_m;
        out->v_mps[j] = m.v_mps;
        out->q_be[j] = m.q_be;
    }
    if (request->instantaneous)
        for (size_t j = 0; j <= n; j++)
            orr_sensors_instant(tr, request->gravity, orr_imu_edge_s(out, j), &out->gyro_radps[j],
                                &out->accel_mps2[j]);
    if (request->mode.approach == 2) {
        for (size_t j = 0; j < n; j++)
            orr_sensors_increment(tr, request->gravity, request->mode.quadrature, request->mode.order,
                                  orr_imu_edge_s(out, j), orr_imu_edge_s(out, j + 1), &out->dtheta_rad[j],
                                  &out->dv_mps[j]);
        orr_mat3 A;
        orr_imu_true_state(out, 0, &out->start_r_m, &out->start_v_mps, &A);
        out->start_q_bi = orr_quat_from_mat3(&A);
    } else {
        s = orr_one_step_generate(out, request->gravity, diag);
    }
    if (s != ORR_OK) orr_imu_free(out);
    return s;
}
