// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/sense/sensors.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "inertial/nav/one_step.h"

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
    orr_motion_sense(&m, orr_gravity_gravitation(g, m.r_m), gyro_radps, accel_mps2);
}

// Where gravitation comes from in a quadrature: from the field, or (field NULL, track set) from a parabola in
// time through three of its values a step apart. That errs by 1e-13 m/s^2 at 100 Hz and halves
// the work.
typedef struct pull {
    const orr_gravity *field;
    const orr_vec3 *track; // values at from_s + (k - 1) step_s, k = 0..2; NULL: ask the field
    double from_s, step_s;
} pull;

static orr_vec3 pull_at(const pull *p, double t_s, orr_vec3 r_m)
{
    if (p->track == NULL) return orr_gravity_gravitation(p->field, r_m);
    double x = (t_s - p->from_s) / p->step_s, a = 0.5 * x * (x - 1.0), b = (1.0 - x) * (1.0 + x),
           c = 0.5 * x * (x + 1.0);
    orr_vec3 g = orr_vec3_scale(a, p->track[0]);
    return orr_vec3_axpy(c, p->track[2], orr_vec3_axpy(b, p->track[1], g));
}

static void add_instant(const orr_trajectory *tr, const pull *p, double t_s, double w, orr_vec3 *dtheta,
                        orr_vec3 *dv)
{
    orr_motion m;
    orr_vec3 gyro, accel;
    tr->evaluate(tr->self, t_s, &m);
    orr_motion_sense(&m, pull_at(p, t_s, m.r_m), &gyro, &accel);
    *dtheta = orr_vec3_axpy(w, gyro, *dtheta);
    *dv = orr_vec3_axpy(w, accel, *dv);
}

static void add_gauss(const orr_trajectory *tr, const pull *g, int order, double a, double b,
                      orr_vec3 *dtheta, orr_vec3 *dv)
{
    double mid = 0.5 * (a + b), half = 0.5 * (b - a);
    for (int k = 0; k < (order + 1) / 2; k++) {
        double x = half * node[order - 1][k], w = half * weight[order - 1][k];
        add_instant(tr, g, mid - x, w, dtheta, dv);
        if (x > 0.0) add_instant(tr, g, mid + x, w, dtheta, dv);
    }
}

// The knots inside an interval cut it. One within a billionth of the interval from its end is the end.
static double slack_of(const orr_sensors_sum *s) { return 1e-9 * (s->to_s - s->from_s); }

orr_sensors_sum orr_sensors_sum_begin(const orr_trajectory *tr, double from_s, double to_s)
{
    orr_sensors_sum s = {.from_s = from_s, .to_s = to_s, .at_s = from_s};
    if (tr->knot_step_s > 0.0)
        s.knot = floor((from_s + slack_of(&s) - tr->knot_origin_s) / tr->knot_step_s) + 1.0;
    return s;
}

static bool add_some(const orr_trajectory *tr, const pull *g, orr_quadrature quadrature, int order,
                     orr_sensors_sum *s, long pieces)
{
    if (quadrature == ORR_QUADRATURE_RIEMANN) {
        double step = (s->to_s - s->from_s) / (double)order;
        for (; s->rectangle < order && pieces > 0; s->rectangle++, pieces--)
            add_instant(tr, g, s->from_s + ((double)s->rectangle + 0.5) * step, step, &s->dtheta_rad,
                        &s->dv_mps);
        return s->rectangle == order;
    }
    bool last = false;
    for (; !last && pieces > 0; pieces--, s->knot += 1.0) {
        double knot = tr->knot_origin_s + s->knot * tr->knot_step_s;
        last = !(tr->knot_step_s > 0.0 && knot < s->to_s - slack_of(s));
        double end = last ? s->to_s : knot;
        add_gauss(tr, g, order, s->at_s, end, &s->dtheta_rad, &s->dv_mps);
        s->at_s = end;
    }
    return last;
}

bool orr_sensors_sum_add(const orr_trajectory *tr, const orr_gravity *g, orr_quadrature quadrature, int order,
                         orr_sensors_sum *s, long pieces)
{
    pull p = {.field = g, .track = NULL};
    return add_some(tr, &p, quadrature, order, s, pieces);
}

static void increment(const orr_trajectory *tr, const pull *g, orr_quadrature quadrature, int order,
                      double from_s, double to_s, orr_vec3 *dtheta_rad, orr_vec3 *dv_mps)
{
    orr_sensors_sum s = orr_sensors_sum_begin(tr, from_s, to_s);
    add_some(tr, g, quadrature, order, &s, LONG_MAX);
    *dtheta_rad = s.dtheta_rad;
    *dv_mps = s.dv_mps;
}

// All increments of a run. Steps of up to 20 m in plain normal gravity, of up to 5 m in one with a
// profile or map (whose cells are a hundred times that), take the parabola through their edges.
static void fill_increments(const orr_trajectory *tr, const orr_gravity *g, orr_imu *imu)
{
    orr_vec3 track[3];
    bool even = orr_gravity_parts_view(g).n_masses == 0; // a mass may be so near that a parabola is none
    pull p = {.field = g, .track = NULL, .step_s = 1.0 / imu->rate_hz};
    for (size_t j = 0; j < imu->n; j++) {
        p.from_s = orr_imu_edge_s(imu, j);
        // The middle value is that of the step's begin; at the first step the parabola is one place late.
        bool smooth =
            even && imu->n >= 2 && orr_vec3_norm(imu->v_mps[j]) * p.step_s < (g == NULL ? 20.0 : 5.0);
        if (smooth && p.track == NULL) {
            size_t from = j == 0 ? 0 : j - 1;
            for (size_t k = 0; k < 3; k++) track[k] = orr_gravity_gravitation(g, imu->r_m[from + k]);
        } else if (smooth && j >= 2) {
            track[0] = track[1];
            track[1] = track[2];
            track[2] = orr_gravity_gravitation(g, imu->r_m[j + 1]);
        }
        if (j == 0) p.from_s += p.step_s;
        p.track = smooth ? track : NULL;
        increment(tr, &p, imu->mode.quadrature, imu->mode.order, orr_imu_edge_s(imu, j),
                  orr_imu_edge_s(imu, j + 1), &imu->dtheta_rad[j], &imu->dv_mps[j]);
    }
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
    s = orr_imu_allocate(out, n, 1, request->instantaneous, closed, diag);
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
        fill_increments(tr, request->gravity, out);
        orr_mat3 A;
        orr_imu_true_state(out, 0, &out->start_r_m, &out->start_v_mps, &A);
        out->start_q_bi = orr_quat_from_mat3(&A);
    } else {
        s = orr_one_step_generate(out, request->gravity, diag);
    }
    if (s != ORR_OK) orr_imu_free(out);
    return s;
}
