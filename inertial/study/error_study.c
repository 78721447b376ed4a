// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/error_study.h"

#include <math.h>
#include <stdlib.h>

#define TENTH 0.1
// What rounding and the navigator's own steps leave of no errors at all: below it nothing is compared.
#define FLOOR_M 1e-5
#define FLOOR_MPS 1e-7
#define FLOOR_RAD 1e-11

size_t orr_error_comparisons(const orr_error_flight *f) { return f->imu->n / f->every + 1; }

// --- The linear equations ---

static orr_error_state axpy(double k, const orr_error_state *d, const orr_error_state *x)
{
    return (orr_error_state){orr_vec3_axpy(k, d->position, x->position),
                             orr_vec3_axpy(k, d->velocity, x->velocity),
                             orr_vec3_axpy(k, d->attitude, x->attitude)};
}

// One step over [t, t + h]: the true motion at its begin, middle and end, and steady errors of the sensors.
typedef struct interval {
    orr_error_point at[3];
    orr_vec3 gyro, accel;
} interval;

static orr_error_state step_over(orr_error_model m, orr_error_method method, const interval *i, double h,
                                 const orr_error_state *x)
{
    const orr_error_state a = orr_error_rate(m, &i->at[0], x, i->gyro, i->accel);
    if (method == ORR_ERROR_EULER) return axpy(h, &a, x);
    orr_error_state y = axpy(0.5 * h, &a, x);
    const orr_error_state b = orr_error_rate(m, &i->at[1], &y, i->gyro, i->accel);
    if (method == ORR_ERROR_MIDPOINT) return axpy(h, &b, x);
    y = axpy(0.5 * h, &b, x);
    const orr_error_state c = orr_error_rate(m, &i->at[1], &y, i->gyro, i->accel);
    y = axpy(h, &c, x);
    const orr_error_state d = orr_error_rate(m, &i->at[2], &y, i->gyro, i->accel);
    y = axpy(h / 6.0, &a, x);
    y = axpy(h / 3.0, &b, &y);
    y = axpy(h / 3.0, &c, &y);
    return axpy(h / 6.0, &d, &y);
}

static orr_vec3 mean_error(const orr_vec3 *measured, const orr_vec3 *ideal, size_t from, size_t to, double h)
{
    orr_vec3 sum = {0, 0, 0};
    for (size_t j = from; j < to; j++) sum = orr_vec3_add(sum, orr_vec3_sub(measured[j], ideal[j]));
    return orr_vec3_scale(1.0 / h, sum);
}

static orr_status point_at(const orr_error_flight *f, double t_s, orr_error_point *p, orr_diag *diag)
{
    orr_error_point_at(f->tr, f->gravity, fmin(fmax(t_s, f->tr->begin_s), f->tr->end_s), f->round, p);
    if (cos(p->lat_rad) * p->normal_m >= 1000.0) return ORR_OK;
    return orr_diag_set(
        diag, ORR_E_UNSUPPORTED,
        "%.0f s after the begin the track is within 1 km of a pole, where geographic axes turn about at "
        "once",
        t_s);
}

// Errors at the start, as phi has them.
static orr_error_state start_of(const orr_error_flight *f, const orr_error_point *p)
{
    const double N = p->normal_m + p->height_m, M = p->meridian_m + p->height_m;
    orr_error_state x = {
        orr_vec3_make(f->position_m.x / (N * cos(p->lat_rad)), f->position_m.y / M, f->position_m.z),
        f->velocity_mps, f->attitude_rad};
    return x;
}

orr_status orr_error_solve(const orr_error_flight *f, orr_error_model model, orr_error_method method,
                           size_t step, orr_error_state *out, orr_diag *diag)
{
    const orr_imu *imu = f->imu;
    if (step == 0 || f->every % step != 0)
        return orr_diag_set(diag, ORR_E_ARG,
                            "a step of %zu readings does not divide the %zu between comparisons", step,
                            f->every);
    const double h = (double)step / imu->rate_hz;
    interval i;
    orr_status s = point_at(f, imu->begin_s, &i.at[0], diag);
    if (s != ORR_OK) return s;
    orr_error_state x = start_of(f, &i.at[0]);
    x = orr_error_convert(ORR_ERROR_PHI, model, &i.at[0], &x);
    if (f->hold_vertical) x = orr_error_hold_vertical(model, &i.at[0], &x);
    out[0] = x;
    for (size_t j = 0; j + step <= imu->n; j += step) {
        const double t = orr_imu_edge_s(imu, j);
        if (method != ORR_ERROR_EULER) s = point_at(f, t + 0.5 * h, &i.at[1], diag);
        if (s == ORR_OK) s = point_at(f, t + h, &i.at[2], diag);
        if (s != ORR_OK) return s;
        i.gyro = mean_error(imu->measured_dtheta_rad, imu->dtheta_rad, j, j + step, h);
        i.accel = mean_error(imu->measured_dv_mps, imu->dv_mps, j, j + step, h);
        x = step_over(model, method, &i, h, &x);
        if (f->hold_vertical) x = orr_error_hold_vertical(model, &i.at[2], &x);
        i.at[0] = i.at[2];
        if ((j + step) % f->every == 0) out[(j + step) / f->every] = x;
    }
    return ORR_OK;
}

// --- The navigator ---

typedef struct difference {
    const orr_error_flight *f;
    orr_error_state *const *out;
    size_t found;
    orr_diag *diag;
} difference;

static orr_status take(void *user, const orr_nav_state *state)
{
    difference *d = user;
    if (state->edge % d->f->every != 0) return ORR_OK;
    orr_error_point p;
    const orr_status s = point_at(d->f, state->t_s, &p, d->diag);
    if (s != ORR_OK) return s;
    for (int m = 0; m < ORR_ERROR_MODELS; m++)
        d->out[m][state->edge / d->f->every] =
            orr_error_direct((orr_error_model)m, &p, state->r_m, state->v_mps, &state->A_bi);
    d->found++;
    return ORR_OK;
}

// The start of a navigator whose errors at it are exactly those of phi's quantities.
static void disturb_start(const orr_error_flight *f, const orr_error_point *p, double size, orr_imu *imu)
{
    const orr_error_state x = start_of(f, p);
    orr_geodetic at = orr_earth_from_ecef(orr_mat3_apply_t(&p->D, p->r));
    at.lon_rad += size * x.position.x;
    at.lat_rad += size * x.position.y;
    at.height_m += f->hold_vertical ? 0.0 : size * x.position.z;
    orr_vec3 change = orr_vec3_scale(size, x.velocity);
    if (f->hold_vertical) change.z = 0.0;
    const orr_mat3 D = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad), R = orr_inertial_from_ecef(p->t_s),
                   Rt = orr_mat3_transpose(&R),
                   turn = orr_mat3_from_rotvec(orr_vec3_scale(-size, x.attitude)),
                   C = orr_mat3_mul(&turn, &p->C), Ct = orr_mat3_transpose(&C);
    const orr_vec3 r = orr_earth_to_ecef(at), u = {0, 0, ORR_EARTH_RATE_RADPS};
    const orr_vec3 v = orr_mat3_apply_t(&D, orr_vec3_add(p->v, change));
    imu->start_r_m = orr_mat3_apply(&R, r);
    imu->start_v_mps = orr_mat3_apply(&R, orr_vec3_add(v, orr_vec3_cross(u, r)));
    orr_mat3 A = orr_mat3_mul(&D, &Rt);
    A = orr_mat3_mul(&Ct, &A);
    imu->start_q_bi = orr_quat_from_mat3(&A);
}

// The truth at the ends of whole groups alone, so that a navigator that holds its vertical channel there need not take readings
// one by one.
static bool thin_truth(const orr_imu *from, orr_imu *to)
{
    const size_t every = ORR_NAVIGATOR_MAX_SAMPLES, n = from->n / every + 1;
    to->truth_every = every;
    to->r_m = malloc(n * sizeof *to->r_m);
    to->v_mps = malloc(n * sizeof *to->v_mps);
    to->q_be = malloc(n * sizeof *to->q_be);
    if (to->r_m == NULL || to->v_mps == NULL || to->q_be == NULL) return false;
    for (size_t k = 0; k < n; k++) {
        to->r_m[k] = from->r_m[k * every];
        to->v_mps[k] = from->v_mps[k * every];
        to->q_be[k] = from->q_be[k * every];
    }
    return true;
}

orr_status orr_error_differ(const orr_error_flight *f, double size,
                            orr_error_state *const out[ORR_ERROR_MODELS], orr_diag *diag)
{
    const size_t n = f->imu->n;
    orr_imu imu = *f->imu; // what it borrows goes
    imu.measured_dtheta_rad = imu.measured_dv_mps = imu.gyro_radps = imu.accel_mps2 = imu.carried_r_m = NULL;
    imu.dtheta_rad = malloc(n * sizeof *imu.dtheta_rad);
    imu.dv_mps = malloc(n * sizeof *imu.dv_mps);
    const bool room = thin_truth(f->imu, &imu) && imu.dtheta_rad != NULL && imu.dv_mps != NULL;
    orr_error_point p;
    orr_status s = room ? point_at(f, imu.begin_s, &p, diag)
                        : orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu inertial samples", n);
    if (s == ORR_OK) {
        for (size_t j = 0; j < n; j++) {
            const orr_vec3 th = f->imu->dtheta_rad[j], dv = f->imu->dv_mps[j];
            imu.dtheta_rad[j] = orr_vec3_axpy(size, orr_vec3_sub(f->imu->measured_dtheta_rad[j], th), th);
            imu.dv_mps[j] = orr_vec3_axpy(size, orr_vec3_sub(f->imu->measured_dv_mps[j], dv), dv);
        }
        disturb_start(f, &p, size, &imu);
        const orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE,
                                   .samples = ORR_NAVIGATOR_MAX_SAMPLES,
                                   .hold_vertical = f->hold_vertical,
                                   .gravity = f->gravity};
        difference d = {f, out, 0, diag};
        s = orr_navigate(&imu, &nav, take, &d, diag);
        if (s == ORR_OK && d.found != orr_error_comparisons(f))
            s = orr_diag_set(
                diag, ORR_E_ARG,
                "comparisons every %zu readings are not where the navigator's groups of %d end: take a "
                "multiple of them",
                f->every, ORR_NAVIGATOR_MAX_SAMPLES);
    }
    orr_imu_free(&imu);
    return s;
}

// --- The comparison ---

typedef struct race {
    double floor;
    double most, worst, held_s; // greatest norm and deviation; when it was too much
    bool over;
} race;

static void judge(race *r, double t_s, orr_vec3 linear, orr_vec3 direct)
{
    const double deviation = orr_vec3_norm(orr_vec3_sub(linear, direct));
    r->most = fmax(r->most, orr_vec3_norm(direct));
    r->worst = fmax(r->worst, deviation);
    if (deviation > fmax(TENTH * r->most, r->floor)) r->over = true;
    if (!r->over) r->held_s = t_s;
}

void orr_error_compare(const orr_error_flight *f, orr_error_model model, const orr_error_state *linear,
                       double size, orr_error_model of, const orr_error_state *direct, orr_error_hold *out)
{
    race position = {.floor = FLOOR_M}, velocity = {.floor = FLOOR_MPS}, attitude = {.floor = FLOOR_RAD};
    for (size_t k = 0; k < orr_error_comparisons(f); k++) {
        const double t = (double)(k * f->every) / f->imu->rate_hz;
        orr_error_point p;
        orr_error_point_at(f->tr, f->gravity, fmin(f->imu->begin_s + t, f->tr->end_s), true, &p);
        judge(&position, t, orr_vec3_scale(size, orr_error_metres(model, &p, &linear[k])),
              orr_error_metres(of, &p, &direct[k]));
        judge(&velocity, t, orr_vec3_scale(size, linear[k].velocity), direct[k].velocity);
        judge(&attitude, t, orr_vec3_scale(size, linear[k].attitude), direct[k].attitude);
    }
    *out = (orr_error_hold){position.held_s,
                            velocity.held_s,
                            attitude.held_s,
                            position.worst / position.most,
                            velocity.worst / velocity.most,
                            attitude.worst / attitude.most};
}
