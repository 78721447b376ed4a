// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/analytic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "inertial/motion/local_map.h"

#define POLE_CIRCLE_M 100.0

// A value with two time derivatives; the rules below are those of differentiation.
typedef struct jet {
    double v, d, dd;
} jet;

static jet jet_add(jet a, jet b) { return (jet){a.v + b.v, a.d + b.d, a.dd + b.dd}; }
static jet jet_sub(jet a, jet b) { return (jet){a.v - b.v, a.d - b.d, a.dd - b.dd}; }
static jet jet_scale(double k, jet a) { return (jet){k * a.v, k * a.d, k * a.dd}; }
static jet jet_mul(jet a, jet b)
{
    return (jet){a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2.0 * a.d * b.d + a.v * b.dd};
}
// f(a) from f, f', f'' at a.v
static jet jet_chain(double f, double f1, double f2, jet a)
{
    return (jet){f, f1 * a.d, f2 * a.d * a.d + f1 * a.dd};
}
static jet jet_sin(jet a) { return jet_chain(sin(a.v), cos(a.v), -sin(a.v), a); }
static jet jet_cos(jet a) { return jet_chain(cos(a.v), -sin(a.v), -cos(a.v), a); }
static jet jet_atan2(jet y, jet x)
{
    double r2 = x.v * x.v + y.v * y.v, r2_half_dot = x.v * x.d + y.v * y.d;
    double d = (x.v * y.d - y.v * x.d) / r2;
    return (jet){atan2(y.v, x.v), d, (x.v * y.dd - y.v * x.dd) / r2 - 2.0 * d * r2_half_dot / r2};
}

typedef struct jet_quat {
    jet w, x, y, z;
} jet_quat;

static jet_quat jet_quat_mul(jet_quat a, jet_quat b)
{
    return (jet_quat){
        jet_sub(jet_sub(jet_mul(a.w, b.w), jet_mul(a.x, b.x)), jet_add(jet_mul(a.y, b.y), jet_mul(a.z, b.z))),
        jet_add(jet_add(jet_mul(a.w, b.x), jet_mul(a.x, b.w)), jet_sub(jet_mul(a.y, b.z), jet_mul(a.z, b.y))),
        jet_add(jet_sub(jet_mul(a.w, b.y), jet_mul(a.x, b.z)), jet_add(jet_mul(a.y, b.w), jet_mul(a.z, b.x))),
        jet_add(jet_add(jet_mul(a.w, b.z), jet_mul(a.x, b.y)),
                jet_sub(jet_mul(a.z, b.w), jet_mul(a.y, b.x)))};
}

// Quaternion of the passive rotation about axis 1, 2 or 3.
static jet_quat jet_turn(int axis, jet angle)
{
    jet half = jet_scale(0.5, angle), c = jet_cos(half), s = jet_sin(half), o = {0, 0, 0};
    return (jet_quat){c, axis == 1 ? s : o, axis == 2 ? s : o, axis == 3 ? s : o};
}

typedef struct analytic_motion {
    orr_analytic_plan plan;
    orr_local_map map;
} analytic_motion;

// Value and three derivatives of amplitude sin(rate t + phase), added.
static void add_sine(double sum[4], double amplitude, double rate, double phase, double t_s)
{
    double s = amplitude * sin(rate * t_s + phase), c = amplitude * cos(rate * t_s + phase);
    sum[0] += s;
    sum[1] += rate * c;
    sum[2] -= rate * rate * s;
    sum[3] -= rate * rate * rate * c;
}

typedef struct sums {
    double e[4], n[4], u[4], heading[4], pitch[4], roll[4];
} sums;

static void add_term(const orr_analytic_term *k, double t_s, sums *s)
{
    double w = k->kind == ORR_ANALYTIC_STRAIGHT ? 0.0 : 2.0 * ORR_PI / k->period_s;
    double ca = cos(k->azimuth_rad), sa = sin(k->azimuth_rad);
    switch (k->kind) {
    case ORR_ANALYTIC_STRAIGHT:
        s->e[0] += k->velocity_mps.x * t_s;
        s->n[0] += k->velocity_mps.y * t_s;
        s->u[0] += k->velocity_mps.z * t_s;
        s->e[1] += k->velocity_mps.x;
        s->n[1] += k->velocity_mps.y;
        s->u[1] += k->velocity_mps.z;
        break;
    case ORR_ANALYTIC_CIRCLE:
        if (k->counter_clockwise) w = -w;
        add_sine(s->e, k->radius_m, w, k->azimuth_rad, t_s);
        add_sine(s->n, k->radius_m, w, k->azimuth_rad + 0.5 * ORR_PI, t_s);
        break;
    case ORR_ANALYTIC_EIGHT:
        add_sine(s->e, k->along_m * sa, w, k->phase_rad, t_s);
        add_sine(s->n, k->along_m * ca, w, k->phase_rad, t_s);
        add_sine(s->e, k->across_m * ca, 2.0 * w, 2.0 * k->phase_rad, t_s);
        add_sine(s->n, -k->across_m * sa, 2.0 * w, 2.0 * k->phase_rad, t_s);
        break;
    case ORR_ANALYTIC_SINE:
        add_sine(s->e, k->amplitude_m.x, w, k->phase_rad, t_s);
        add_sine(s->n, k->amplitude_m.y, w, k->phase_rad, t_s);
        add_sine(s->u, k->amplitude_m.z, w, k->phase_rad, t_s);
        add_sine(s->heading, k->amplitude.heading_rad, w, k->phase_rad, t_s);
        add_sine(s->pitch, k->amplitude.pitch_rad, w, k->phase_rad, t_s);
        add_sine(s->roll, k->amplitude.roll_rad, w, k->phase_rad, t_s);
        break;
    }
}

static jet first_three(const double a[4]) { return (jet){a[0], a[1], a[2]}; }

static void evaluate_analytic(const void *self, double t_s, orr_motion *out)
{
    const analytic_motion *a = self;
    sums s;
    memset(&s, 0, sizeof s);
    for (size_t k = 0; k < a->plan.n_terms; k++) add_term(&a->plan.term[k], t_s, &s);

    // Place: the normal vector, then (N + h) n with the third component's N (1 - e^2) + h.
    jet x = jet_scale(1.0 / a->map.east_m, first_three(s.e)),
        y = jet_scale(1.0 / a->map.north_m, first_three(s.n));
    jet q = jet_add(jet_mul(x, x), jet_mul(y, y));
    double C, S, S1, S2;
    orr_local_map_series(q.v, &C, &S, &S1, &S2);
    jet cosine = jet_chain(C, -0.5 * S, -0.5 * S1, q), sine = jet_chain(S, S1, S2, q);
    jet local[3] = {jet_mul(sine, x), jet_mul(sine, y), cosine}, n[3];
    for (int i = 0; i < 3; i++) {
        n[i] = (jet){0, 0, 0};
        for (int k = 0; k < 3; k++) n[i] = jet_add(n[i], jet_scale(a->map.A0.m[k][i], local[k]));
    }
    jet w2 = jet_scale(-ORR_WGS84_E2, jet_mul(n[2], n[2])); // W^2 = 1 - e^2 sin^2(lat); N = a / W
    w2.v += 1.0;
    double root = 1.0 / sqrt(w2.v);
    jet N = jet_scale(ORR_WGS84_A_M, jet_chain(root, -0.5 * root / w2.v, 0.75 * root / (w2.v * w2.v), w2));
    jet h = first_three(s.u);
    h.v += a->map.height_m;
    jet Nh = jet_add(N, h), Nz = jet_add(jet_scale(1.0 - ORR_WGS84_E2, N), h);
    jet r[3] = {jet_mul(Nh, n[0]), jet_mul(Nh, n[1]), jet_mul(Nz, n[2])};
    out->r_m = orr_vec3_make(r[0].v, r[1].v, r[2].v);
    out->v_mps = orr_vec3_make(r[0].d, r[1].d, r[2].d);
    out->a_mps2 = orr_vec3_make(r[0].dd, r[1].dd, r[2].dd);

    // Attitude: body from enu from ecef, as one product of turns.
    jet level2 = jet_add(jet_mul(n[0], n[0]), jet_mul(n[1], n[1]));
    double level = sqrt(level2.v);
    jet across = jet_chain(level, 0.5 / level, -0.25 / (level * level2.v), level2);
    jet lat = jet_atan2(n[2], across), lon = jet_atan2(n[1], n[0]);
    jet heading = first_three(s.heading), pitch = first_three(s.pitch), roll = first_three(s.roll);
    if (a->plan.follow_course) {
        jet ve = {s.e[1], s.e[2], s.e[3]}, vn = {s.n[1], s.n[2], s.n[3]};
        heading = jet_add(heading, jet_atan2(ve, vn));
    }
    heading.v += a->plan.attitude.heading_rad;
    pitch.v += a->plan.attitude.pitch_rad;
    roll.v += a->plan.attitude.roll_rad;
    lon.v += 0.5 * ORR_PI;
    jet colat = jet_scale(-1.0, lat);
    colat.v += 0.5 * ORR_PI;
    jet_quat Q = jet_quat_mul(jet_turn(3, lon), jet_turn(1, colat)); // enu = R1(pi/2 - lat) R3(pi/2 + lon)
    Q = jet_quat_mul(Q, jet_turn(3, jet_scale(-1.0, heading)));
    Q = jet_quat_mul(Q, jet_turn(1, pitch));
    Q = jet_quat_mul(Q, jet_turn(2, roll));
    double p[4] = {Q.w.v, Q.x.v, Q.y.v, Q.z.v}, d1[4] = {Q.w.d, Q.x.d, Q.y.d, Q.z.d},
           d2[4] = {Q.w.dd, Q.x.dd, Q.y.dd, Q.z.dd};
    orr_rates_from_quat(p, d1, d2, &out->q_be, &out->w_radps, &out->wdot_radps2);
}

// Headings are against North, which turns about at a pole. Between two looks the way is taken as straight.
static orr_status check_poles(const orr_trajectory *tr, orr_diag *diag)
{
    const double span_s = tr->end_s - tr->begin_s, n = fmin(ceil(span_s) + 1.0, 1e5), step_s = span_s / n;
    for (double k = 0; k < n; k++) {
        orr_motion m;
        double t_s = tr->begin_s + (k + 0.5) * step_s;
        evaluate_analytic(tr->self, t_s, &m);
        double v2 = m.v_mps.x * m.v_mps.x + m.v_mps.y * m.v_mps.y;
        double dt = v2 > 0.0 ? -(m.r_m.x * m.v_mps.x + m.r_m.y * m.v_mps.y) / v2 : 0.0;
        dt = fmin(fmax(dt, -0.5 * step_s), 0.5 * step_s);
        if (!(hypot(m.r_m.x + dt * m.v_mps.x, m.r_m.y + dt * m.v_mps.y) >= POLE_CIRCLE_M))
            return orr_diag_set(
                diag, ORR_E_ARG,
                "%.1f s after the start the motion comes within %g m of a pole, where a heading "
                "turns about at once (a transfer carries a trajectory there)",
                t_s + dt, POLE_CIRCLE_M);
    }
    return ORR_OK;
}

orr_status orr_trajectory_analytic(orr_time t0, double begin_s, double end_s, const orr_analytic_plan *plan,
                                   orr_trajectory *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (!(end_s > begin_s))
        return orr_diag_set(diag, ORR_E_ARG, "a trajectory needs a positive length of time");
    if (plan->n_terms > ORR_ANALYTIC_MAX_TERMS)
        return orr_diag_set(diag, ORR_E_ARG, "%zu motions are summed; the limit is %d", plan->n_terms,
                            ORR_ANALYTIC_MAX_TERMS);
    if (!(fabs(plan->origin.lat_rad) <= 0.5 * ORR_PI))
        return orr_diag_set(diag, ORR_E_ARG, "latitude %.6f deg is past a pole",
                            plan->origin.lat_rad * ORR_DEG_PER_RAD);
    bool moves = false;
    for (size_t k = 0; k < plan->n_terms; k++) {
        const orr_analytic_term *m = &plan->term[k];
        if (m->kind != ORR_ANALYTIC_STRAIGHT && !(fabs(m->period_s) >= 1e-3))
            return orr_diag_set(diag, ORR_E_ARG, "motion %zu has a period of %g s; it needs at least 1 ms",
                                k + 1, m->period_s);
        moves = moves || m->kind != ORR_ANALYTIC_SINE;
    }
    if (plan->follow_course && !moves)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a heading can follow the course only where the body goes somewhere");
    analytic_motion *a = calloc(1, sizeof *a);
    if (a == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a trajectory");
    a->plan = *plan;
    a->map = orr_local_map_make(plan->origin);
    *out = (orr_trajectory){.t0 = t0,
                            .begin_s = begin_s,
                            .end_s = end_s,
                            .evaluate = evaluate_analytic,
                            .destroy = free,
                            .self = a};
    orr_status s = check_poles(out, diag);
    if (s != ORR_OK) orr_trajectory_free(out);
    return s;
}
