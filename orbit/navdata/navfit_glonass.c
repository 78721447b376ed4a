// SPDX-License-Identifier: GPL-3.0-or-later
// GLONASS' state at tb: Gauss-Newton on the message's own model of motion, then the nearest point of the
// lattice, whose steps of half a metre are what decides.
#include <math.h>
#include <string.h>

#include "core/astro.h"
#include "core/linalg.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/force.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/navfit_private.h"

#define ITERATIONS 10
#define CONVERGED_M 1e-5
#define DERIVED_WITHIN_M 100
#define SEARCH_NODES 3000
#define DIFFERENCE 100 // LSBs
#define N 9

#define POS_LSB (1e3 * P2(11))
#define VEL_LSB (1e3 * P2(20))
#define ACC_LSB (1e3 * P2(30))

// The acceleration is that of Sun and Moon unless the orbit says otherwise: a deviation by one LSB costs as
// much as PULL_M in one coordinate. (What the model lacks, C22 first of all, is as large as an LSB, and a
// receiver adds whatever is sent.)
#define PULL_M 0.1

// GLONASS ICD 5.1, table 4.5: 27, 24 and 5 bits.
static const orr_navfit_field table[N] = {
    ORR_MAGNITUDE("x", POS_LSB, 27),  ORR_MAGNITUDE("y", POS_LSB, 27),  ORR_MAGNITUDE("z", POS_LSB, 27),
    ORR_MAGNITUDE("vx", VEL_LSB, 24), ORR_MAGNITUDE("vy", VEL_LSB, 24), ORR_MAGNITUDE("vz", VEL_LSB, 24),
    ORR_MAGNITUDE("ax", ACC_LSB, 5),  ORR_MAGNITUDE("ay", ACC_LSB, 5),  ORR_MAGNITUDE("az", ACC_LSB, 5),
};

static void to_array(const orr_nav_glonass *g, double p[N])
{
    const double all[N] = {g->pos_m.x,   g->pos_m.y,    g->pos_m.z,    g->vel_mps.x, g->vel_mps.y,
                           g->vel_mps.z, g->acc_mps2.x, g->acc_mps2.y, g->acc_mps2.z};
    memcpy(p, all, sizeof all);
}

static void from_array(const double p[N], orr_nav_glonass *g)
{
    g->pos_m = orr_vec3_make(p[0], p[1], p[2]);
    g->vel_mps = orr_vec3_make(p[3], p[4], p[5]);
    g->acc_mps2 = orr_vec3_make(p[6], p[7], p[8]);
}

typedef struct problem {
    const orr_navfit_window *w;
    double tk[ORR_NAVFIT_POSITIONS];
    double start[3]; // the lunisolar acceleration
    size_t rows;
    double J[ORR_NAVFIT_ROWS * N], A[ORR_NAVFIT_ROWS * N], b[ORR_NAVFIT_ROWS]; // A: J, decomposed
} problem;

// Jacobian in units of the LSBs by differences. Steps of a hundred LSBs: 49 m, 0.1 m/s, 1e-4 m/s^2, over which the motion is linear to
// 1e-5; for the same reason one Jacobian serves until the solution moves by more than that.
static orr_status derive(problem *q, const orr_nav_glonass *g)
{
    const size_t n = q->w->n;
    orr_vec3 here[ORR_NAVFIT_POSITIONS], there[ORR_NAVFIT_POSITIONS];
    double p[N];
    to_array(g, p);
    orr_status s = orr_broadcast_glonass_track(g, q->tk, n, here);
    for (size_t j = 0; j < N && s == ORR_OK; j++) {
        orr_nav_glonass moved;
        double at[N];
        memcpy(at, p, sizeof at);
        at[j] += DIFFERENCE * table[j].lsb;
        from_array(at, &moved);
        s = orr_broadcast_glonass_track(&moved, q->tk, n, there);
        for (size_t i = 0; i < n && s == ORR_OK; i++) {
            const orr_vec3 d = orr_vec3_scale(1.0 / DIFFERENCE, orr_vec3_sub(there[i], here[i]));
            double *column = &q->J[3 * i * N + j];
            column[0] = d.x, column[N] = d.y, column[2 * N] = d.z;
        }
    }
    if (s != ORR_OK) return s;
    q->rows = 3 * n;
    for (size_t j = 6; j < N; j++) {
        double *row = &q->J[q->rows++ * N];
        memset(row, 0, N * sizeof *row);
        row[j] = PULL_M;
    }
    return ORR_OK;
}

// Residuals of g and the linear least-squares step from there, in LSBs; x may be NULL.
static orr_status solve(problem *q, const orr_nav_glonass *g, double *x)
{
    orr_vec3 at[ORR_NAVFIT_POSITIONS];
    orr_status s = orr_broadcast_glonass_track(g, q->tk, q->w->n, at);
    if (s != ORR_OK) return s;
    for (size_t i = 0; i < q->w->n; i++) {
        orr_vec3 r = orr_vec3_sub(q->w->pos[i], at[i]);
        q->b[3 * i] = r.x, q->b[3 * i + 1] = r.y, q->b[3 * i + 2] = r.z;
    }
    double p[N];
    to_array(g, p);
    for (size_t j = 6; j < N; j++) q->b[q->rows + j - N] = PULL_M / ACC_LSB * (q->start[j - 6] - p[j]);
    memcpy(q->A, q->J, q->rows * N * sizeof *q->A);
    double tau[N];
    return orr_least_squares(q->A, q->rows, N, q->b, tau, x);
}

// Tide of Sun and Moon at r, ecef axes: what the message calls the lunisolar acceleration. The secular pole and UT1 by the leap
// seconds (3e-5 rad), and the Sun to 2e-4 rad, are enough: 5e-6 m/s^2 turned by that are 1e-9 m/s^2, and the message's last bit is
// 9e-7 m/s^2.
static orr_vec3 lunisolar(orr_time t, orr_vec3 r)
{
    orr_mat3 R;
    orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
    orr_vec3 body[2] = {orr_navfit_rough_sun(t), orr_mat3_apply(&R, orr_astro_moon(t))}, a = {0, 0, 0};
    const double gm[2] = {ORR_SUN_GM, ORR_MOON_GM};
    for (int k = 0; k < 2; k++) {
        orr_vec3 d = orr_vec3_sub(body[k], r);
        a = orr_vec3_axpy(gm[k] / pow(orr_vec3_norm(d), 3), d, a);
        a = orr_vec3_axpy(-gm[k] / pow(orr_vec3_norm(body[k]), 3), body[k], a);
    }
    return a;
}

// State at tb: that of the window's middle, carried to tb by the message's own model.
static orr_status first_guess(orr_nav_eph *e, const orr_navfit_window *w)
{
    orr_nav_eph there = *e;
    size_t mid = orr_navfit_middle(w, w->t[0], 0, &there.glonass.pos_m, &there.glonass.vel_mps);
    there.toe = w->t[mid];
    there.glonass.acc_mps2 = (orr_vec3){0, 0, 0};
    orr_broadcast_state at_tb;
    orr_status s = orr_broadcast_eval(&there, e->toe, &at_tb);
    if (s != ORR_OK) return s;
    e->glonass.pos_m = at_tb.pos_m;
    e->glonass.vel_mps = at_tb.vel_mps;
    e->glonass.acc_mps2 = lunisolar(e->toe, at_tb.pos_m);
    return ORR_OK;
}

static orr_status gauss_newton(problem *q, orr_nav_glonass *g)
{
    double moved = HUGE_VAL;
    for (int it = 0; it < ITERATIONS && moved > CONVERGED_M; it++) {
        double x[N], p[N], sum = 0;
        orr_status s = moved > DERIVED_WITHIN_M ? derive(q, g) : ORR_OK;
        if (s == ORR_OK) s = solve(q, g, x);
        if (s != ORR_OK) return s;
        to_array(g, p);
        for (size_t j = 0; j < N; j++) {
            p[j] += x[j] * table[j].lsb;
            sum += q->b[j] * q->b[j];
        }
        from_array(p, g);
        moved = sqrt(sum / (double)q->w->n);
    }
    return moved <= 1e-3 ? ORR_OK : ORR_E_NUMERIC;
}

// How far the model is from the window, integrated through it in one go.
static orr_status rms_of(const problem *q, const orr_nav_glonass *g, double *rms_m)
{
    orr_vec3 at[ORR_NAVFIT_POSITIONS];
    double sum = 0;
    const orr_status s = orr_broadcast_glonass_track(g, q->tk, q->w->n, at);
    for (size_t i = 0; i < q->w->n && s == ORR_OK; i++) {
        const orr_vec3 d = orr_vec3_sub(q->w->pos[i], at[i]);
        sum += orr_vec3_dot(d, d);
    }
    *rms_m = sqrt(sum / (double)q->w->n);
    return s;
}

static orr_status to_lattice(problem *q, orr_nav_glonass *g, orr_diag *diag)
{
    double p[N], whole[N], R[N * N], z[N];
    to_array(g, p);
    for (size_t j = 0; j < N; j++) {
        whole[j] = round(p[j] / table[j].lsb);
        p[j] = whole[j] * table[j].lsb;
    }
    from_array(p, g);
    orr_status s = solve(q, g, NULL);
    if (s != ORR_OK) return s;
    memcpy(R, q->A, sizeof R);
    s = orr_lattice_closest(N, R, q->b, SEARCH_NODES, z);
    for (size_t j = 0; j < N && s == ORR_OK; j++)
        s = orr_navfit_to_field(&table[j], whole[j] + z[j], &p[j], diag);
    if (s == ORR_OK) from_array(p, g);
    return s;
}

orr_status orr_navfit_glonass(orr_sat sat, orr_time tb, orr_time from, orr_time to, orr_navfit_source source,
                              void *user, orr_nav_eph *eph, orr_navfit_report *report, orr_diag *diag)
{
    if (orr_sat_system(sat) != 'R')
        return orr_diag_set(diag, ORR_E_ARG, "a state at tb is sent by GLONASS satellites");
    orr_status s = orr_navfit_check_window(tb, from, to, 600, 7200, diag);
    if (s != ORR_OK) return s;
    orr_navfit_window w;
    s = orr_navfit_gather(from, to, 300, source, user, &w, diag);
    if (s != ORR_OK) return s;
    orr_nav_eph e = {.sat = sat,
                     .kind = ORR_NAV_GLONASS,
                     .message = ORR_NAV_FDMA,
                     .toe = tb,
                     .toc = tb,
                     .transmission = ORR_TIME_NONE,
                     .week = -1,
                     .fit_interval_h = (double)NAN,
                     .iode = ORR_NAV_NO_IOD,
                     .iodc = ORR_NAV_NO_IOD};
    e.glonass.frame_time_s = e.glonass.delta_tau_s = e.glonass.ura = (double)NAN;
    problem q;
    q.w = &w;
    for (size_t i = 0; i < w.n; i++) q.tk[i] = orr_time_diff_s(w.t[i], tb);
    s = first_guess(&e, &w);
    q.start[0] = e.glonass.acc_mps2.x, q.start[1] = e.glonass.acc_mps2.y, q.start[2] = e.glonass.acc_mps2.z;
    if (s == ORR_OK) s = gauss_newton(&q, &e.glonass);
    if (s == ORR_OK) s = rms_of(&q, &e.glonass, &report->fit_rms_m);
    if (s == ORR_OK) s = to_lattice(&q, &e.glonass, diag);
    if (s == ORR_E_RANGE) return s;
    if (s == ORR_OK) s = orr_navfit_judge(&e, &w, &report->rms_m, &report->max_m);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the orbit over the window cannot be fitted by a GLONASS state");
    report->n = w.n;
    *eph = e;
    return ORR_OK;
}

void orr_navfit_glonass_displace(orr_nav_eph *eph, orr_vec3 displaced_m)
{
    const orr_vec3 earth_radps = {0, 0, ORR_EARTH_RATE_RADPS}, r = eph->glonass.pos_m,
                   v = orr_velocity_inertial(r, eph->glonass.vel_mps);
    const orr_mat3 axes = orr_orbit_axes(r, v);
    const orr_vec3 d = orr_mat3_apply(&axes, displaced_m),
                   orbit_radps = orr_vec3_scale(1 / orr_vec3_dot(r, r), orr_vec3_cross(r, v));
    eph->glonass.pos_m = orr_vec3_add(r, d);
    eph->glonass.vel_mps =
        orr_vec3_add(eph->glonass.vel_mps, orr_vec3_cross(orr_vec3_sub(orbit_radps, earth_radps), d));
    double p[N];
    to_array(&eph->glonass, p);
    for (int j = 0; j < N; j++) p[j] = table[j].lsb * nearbyint(p[j] / table[j].lsb);
    from_array(p, &eph->glonass);
}
