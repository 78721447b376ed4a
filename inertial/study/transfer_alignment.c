// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/transfer_alignment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"
#include "core/rng.h"
#include "inertial/nav/navigator.h"
#include "inertial/study/error_equations.h"

// States: psi and velocity in geographic axes; constant and walking biases of gyros and accelerometers, second unit's axes.
enum { N = ORR_TRANSFER_STATES, PSI = 0, VEL = 3, GYRO = 6, ACCEL = 9, GYRO_WALK = 12, ACCEL_WALK = 15 };
enum { STREAM_MOUNTING = 6000, STREAM_VELOCITY, STREAM_MEASURED, STREAM_FIRST };
#define SUBSTEP_S 0.2 // over which force is taken as steady

typedef struct filter {
    double p[N][N];
    orr_vec3 gyro, accel, gyro_walk, accel_walk; // biases as they are known
} filter;

orr_transfer_noise orr_transfer_noise_of(const orr_triad_errors *a, const orr_triad_errors *b)
{
    const double wa = a->n_processes > 0 ? a->process[0].sigma : 0.0,
                 wb = b->n_processes > 0 ? b->process[0].sigma : 0.0;
    return (orr_transfer_noise){.white = hypot(a->white[0], b->white[0]),
                                .bias = hypot(a->bias_sigma, b->bias_sigma),
                                .walking = hypot(wa, wb),
                                .correlation_s = b->n_processes > 0   ? b->process[0].correlation_s
                                                 : a->n_processes > 0 ? a->process[0].correlation_s
                                                                      : 1.0};
}

static double component(orr_vec3 v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
static orr_vec3 normals(uint64_t seed, uint64_t stream, uint64_t k)
{
    return orr_vec3_make(orr_rng_normal(seed, stream, 3 * k), orr_rng_normal(seed, stream, 3 * k + 1),
                         orr_rng_normal(seed, stream, 3 * k + 2));
}
static orr_vec3 by_axis(orr_vec3 a, orr_vec3 b) { return orr_vec3_make(a.x * b.x, a.y * b.y, a.z * b.z); }

// --- Covariance ---

static void set_block(double m[N][N], int row, int col, const orr_mat3 *b, double k)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) m[row + i][col + j] += k * b->m[i][j];
}

// x' = f x of psi's equations, by the navigated attitude and force.
static void derivative(const orr_transfer_plan *plan, const orr_mat3 *C, orr_vec3 force, orr_vec3 both,
                       orr_vec3 coriolis, double f[N][N])
{
    memset(f, 0, sizeof(double) * N * N);
    const orr_mat3 turn = orr_mat3_hat(both), twice = orr_mat3_hat(coriolis), tilt = orr_mat3_hat(force);
    set_block(f, PSI, PSI, &turn, 1.0);
    set_block(f, VEL, VEL, &twice, 1.0);
    set_block(f, VEL, PSI, &tilt, 1.0); // psi x f = -f x psi
    set_block(f, PSI, GYRO, C, 1.0);
    set_block(f, PSI, GYRO_WALK, C, 1.0);
    set_block(f, VEL, ACCEL, C, 1.0);
    set_block(f, VEL, ACCEL_WALK, C, 1.0);
    for (int i = 0; i < 3; i++) {
        f[GYRO_WALK + i][GYRO_WALK + i] = -1.0 / plan->gyro.correlation_s;
        f[ACCEL_WALK + i][ACCEL_WALK + i] = -1.0 / plan->accel.correlation_s;
    }
}

static void multiply(double out[N][N], double a[N][N], double b[N][N], bool transposed)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            double sum = 0.0;
            for (int k = 0; k < N; k++) sum += a[i][k] * (transposed ? b[j][k] : b[k][j]);
            out[i][j] = sum;
        }
}

// P over a step: the transition to second order, the noise half before and half after it.
static void propagate(const orr_transfer_plan *plan, filter *q, double f[N][N], double h)
{
    double phi[N][N], ff[N][N], tmp[N][N];
    multiply(ff, f, f, false);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) phi[i][j] = (i == j) + h * f[i][j] + 0.5 * h * h * ff[i][j];
    const orr_transfer_noise *g = &plan->gyro, *a = &plan->accel;
    const double noise[4] = {g->white * g->white, a->white * a->white,
                             2.0 * g->walking * g->walking / g->correlation_s,
                             2.0 * a->walking * a->walking / a->correlation_s};
    static const int at[4] = {PSI, VEL, GYRO_WALK, ACCEL_WALK};
    for (int half = 0; half < 2; half++) {
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < 3; i++) q->p[at[k] + i][at[k] + i] += 0.5 * h * noise[k];
        if (half == 1) break;
        multiply(tmp, phi, q->p, false);
        multiply(q->p, tmp, phi, true);
    }
}

// The velocity along a direction; x is corrected, *residual in standard deviations.
static void update(filter *q, orr_vec3 along, double z, double variance, double x[N], double *residual)
{
    const double h[3] = {along.x, along.y, along.z};
    double gain[N], ph[N], s = variance, known = 0.0;
    for (int i = 0; i < N; i++) {
        ph[i] = 0.0;
        for (int k = 0; k < 3; k++) ph[i] += q->p[i][VEL + k] * h[k];
    }
    for (int k = 0; k < 3; k++) {
        s += h[k] * ph[VEL + k];
        known += h[k] * x[VEL + k];
    }
    *residual = (z - known) / sqrt(s);
    for (int i = 0; i < N; i++) {
        gain[i] = ph[i] / s;
        x[i] += gain[i] * (z - known);
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) q->p[i][j] -= gain[i] * ph[j];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < i; j++) q->p[i][j] = q->p[j][i] = 0.5 * (q->p[i][j] + q->p[j][i]);
}

// --- The two units ---

typedef struct pair {
    const orr_transfer_plan *plan;
    filter q;
    orr_imu work; // second unit's readings less its biases as they are known
    orr_nav_state second;
    orr_nav_state *first; // [n + 1] the first unit's, at each measurement
    size_t n;
} pair;

static orr_status keep(void *user, const orr_nav_state *s)
{
    pair *w = user;
    if (s->edge % w->plan->interval == 0 && s->edge / w->plan->interval <= w->n)
        w->first[s->edge / w->plan->interval] = *s;
    return ORR_OK;
}

// Navigated geographic axes, attitude and relative velocity.
typedef struct view {
    orr_mat3 D, C, R; // geographic from ecef, from body; inertial from ecef
    orr_vec3 earth, transport;
} view;

static view view_of(const orr_nav_state *s)
{
    view v = {.R = orr_inertial_from_ecef(s->t_s)};
    const orr_vec3 r = orr_mat3_apply_t(&v.R, s->r_m), u = {0, 0, ORR_EARTH_RATE_RADPS};
    const orr_vec3 velocity = orr_vec3_sub(orr_mat3_apply_t(&v.R, s->v_mps), orr_vec3_cross(u, r));
    const orr_geodetic at = orr_earth_from_ecef(r);
    v.D = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad);
    const orr_mat3 B = orr_mat3_mul(&s->A_bi, &v.R), Bt = orr_mat3_transpose(&B);
    v.C = orr_mat3_mul(&v.D, &Bt);
    const orr_vec3 enu = orr_mat3_apply(&v.D, velocity);
    double M, N_;
    orr_earth_radii(at.lat_rad, &M, &N_);
    v.earth = orr_mat3_apply(&v.D, u);
    v.transport = orr_vec3_make(-enu.y / (M + at.height_m), enu.x / (N_ + at.height_m),
                                enu.x / (N_ + at.height_m) * tan(at.lat_rad));
    return v;
}

static orr_mat3 attitude_of(const view *v, const orr_mat3 *C)
{
    const orr_mat3 Ct = orr_mat3_transpose(C), Rt = orr_mat3_transpose(&v->R);
    const orr_mat3 a = orr_mat3_mul(&v->D, &Rt);
    return orr_mat3_mul(&Ct, &a);
}

// C turned by a: v becomes v + a x v.
static orr_mat3 turned(orr_vec3 a, const orr_mat3 *C)
{
    const orr_mat3 t = orr_mat3_from_rotvec(orr_vec3_scale(-1.0, a));
    return orr_mat3_mul(&t, C);
}

// The second unit's readings from edge `from` to `to` without its biases.
static void correct_readings(pair *w, size_t from, size_t to)
{
    const double dt = 1.0 / w->work.rate_hz;
    const orr_vec3 g = orr_vec3_scale(dt, orr_vec3_add(w->q.gyro, w->q.gyro_walk)),
                   a = orr_vec3_scale(dt, orr_vec3_add(w->q.accel, w->q.accel_walk));
    for (size_t j = from; j < to; j++) {
        w->work.dtheta_rad[j] = orr_vec3_sub(w->plan->second->measured_dtheta_rad[j], g);
        w->work.dv_mps[j] = orr_vec3_sub(w->plan->second->measured_dv_mps[j], a);
    }
}

// Navigates and propagates to the next measurement.
static void advance(pair *w, size_t to)
{
    const orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5, .gravity = w->plan->gravity};
    const double hz = w->work.rate_hz;
    size_t each = (size_t)fmax(1.0, nearbyint(SUBSTEP_S * hz));
    correct_readings(w, w->second.edge, to);
    while (w->second.edge < to) {
        const size_t from = w->second.edge, end = from + each < to ? from + each : to;
        const view before = view_of(&w->second);
        orr_navigate_from(&w->work, &nav, &w->second, end);
        const view after = view_of(&w->second);
        const double h = (double)(end - from) / hz;
        orr_vec3 push = {0, 0, 0};
        for (size_t j = from; j < end; j++) push = orr_vec3_add(push, w->work.dv_mps[j]);
        orr_mat3 middle = orr_mat3_add(&before.C, &after.C);
        middle = orr_mat3_scale(0.5, &middle);
        const orr_vec3 both = orr_vec3_add(before.earth, before.transport);
        double f[N][N];
        derivative(w->plan, &middle, orr_mat3_apply(&middle, orr_vec3_scale(1.0 / h, push)), both,
                   orr_vec3_add(before.earth, both), f);
        propagate(w->plan, &w->q, f, h);
        w->q.gyro_walk = orr_vec3_scale(exp(-h / w->plan->gyro.correlation_s), w->q.gyro_walk);
        w->q.accel_walk = orr_vec3_scale(exp(-h / w->plan->accel.correlation_s), w->q.accel_walk);
    }
}

// The first unit's place and velocity carried to the second by the arm, by its own gyros: the mean rate of the two readings about the edge.
static void carry(const orr_transfer_plan *plan, const orr_nav_state *s, orr_vec3 *r, orr_vec3 *v)
{
    const orr_imu *m = plan->first;
    const size_t before = s->edge > 0 ? s->edge - 1 : 0, after = s->edge < m->n ? s->edge : m->n - 1;
    const orr_vec3 rate = orr_vec3_scale(
        0.5 * m->rate_hz, orr_vec3_add(m->measured_dtheta_rad[before], m->measured_dtheta_rad[after]));
    *r = orr_vec3_add(s->r_m, orr_mat3_apply_t(&s->A_bi, plan->mounting.arm_m));
    *v = orr_vec3_add(s->v_mps, orr_mat3_apply_t(&s->A_bi, orr_vec3_cross(rate, plan->mounting.arm_m)));
}

// The k-th measurement, and what it corrects.
static void measure(pair *w, size_t k, orr_vec3 *residual)
{
    const orr_transfer_plan *plan = w->plan;
    const view v = view_of(&w->second);
    orr_vec3 r, velocity;
    carry(plan, &w->first[k], &r, &velocity);
    const orr_mat3 Rt = orr_mat3_transpose(&v.R), A = orr_mat3_mul(&v.D, &Rt);
    orr_vec3 z = orr_mat3_apply(&A, orr_vec3_sub(w->second.v_mps, velocity));
    z = orr_vec3_axpy(plan->velocity_noise_mps, normals(plan->seed, STREAM_MEASURED, k), z);
    // Along the axes of the first unit, in which bending is known.
    const view first = view_of(&w->first[k]);
    const orr_mat3 axes = orr_mat3_transpose(&first.C);
    double x[N] = {0}, out[3];
    for (int i = 0; i < 3; i++) {
        const orr_vec3 along = orr_vec3_make(axes.m[i][0], axes.m[i][1], axes.m[i][2]);
        const double bent = component(plan->flexure_mps, i);
        update(&w->q, along, orr_vec3_dot(along, z),
               plan->velocity_noise_mps * plan->velocity_noise_mps + bent * bent, x, &out[i]);
    }
    *residual = orr_vec3_make(out[0], out[1], out[2]);
    const orr_vec3 psi = {x[PSI], x[PSI + 1], x[PSI + 2]}, dv = {x[VEL], x[VEL + 1], x[VEL + 2]};
    const orr_mat3 C = turned(orr_vec3_scale(-1.0, psi), &v.C);
    w->second.A_bi = attitude_of(&v, &C);
    w->second.v_mps = orr_vec3_sub(w->second.v_mps, orr_mat3_apply_t(&A, dv));
    w->second.r_m = r;
    orr_vec3 *const bias[4] = {&w->q.gyro, &w->q.accel, &w->q.gyro_walk, &w->q.accel_walk};
    for (int b = 0; b < 4; b++)
        *bias[b] =
            orr_vec3_add(*bias[b], orr_vec3_make(x[GYRO + 3 * b], x[GYRO + 3 * b + 1], x[GYRO + 3 * b + 2]));
}

static orr_error_state error_of(const orr_trajectory *tr, const orr_gravity *g, const orr_nav_state *s)
{
    orr_error_point p;
    orr_error_point_at(tr, g, fmin(s->t_s, tr->end_s), true, &p);
    return orr_error_direct(ORR_ERROR_PSI, &p, s->r_m, s->v_mps, &s->A_bi);
}

static orr_transfer_point tell(const pair *w, size_t k)
{
    const orr_transfer_plan *plan = w->plan;
    const orr_error_state a = error_of(plan->first_tr, plan->gravity, &w->first[k]),
                          b = error_of(plan->second_tr, plan->gravity, &w->second);
    double sigma[6];
    for (int i = 0; i < 6; i++) sigma[i] = sqrt(w->q.p[i][i]);
    return (orr_transfer_point){.t_s = w->second.t_s,
                                .attitude_rad = orr_vec3_sub(b.attitude, a.attitude),
                                .velocity_mps = orr_vec3_sub(b.velocity, a.velocity),
                                .attitude_sigma_rad = {sigma[0], sigma[1], sigma[2]},
                                .velocity_sigma_mps = {sigma[3], sigma[4], sigma[5]}};
}

static void square(double m[N][N], int at, orr_vec3 sigma)
{
    for (int i = 0; i < 3; i++) m[at + i][at + i] = component(sigma, i) * component(sigma, i);
}

// Both units at the start: the first with its alignment errors, the second from it by the mounting as it is known.
static void begin(pair *w, orr_imu *first)
{
    const orr_transfer_plan *plan = w->plan;
    orr_nav_state s = {.t_s = first->begin_s,
                       .r_m = first->start_r_m,
                       .v_mps = first->start_v_mps,
                       .A_bi = orr_mat3_from_quat(first->start_q_bi)};
    const view v = view_of(&s);
    const orr_mat3 C = turned(by_axis(plan->first_attitude_rad, normals(plan->seed, STREAM_FIRST, 0)), &v.C);
    s.A_bi = attitude_of(&v, &C);
    first->start_q_bi = orr_quat_from_mat3(&s.A_bi);
    w->second = s;
    carry(plan, &s, &w->second.r_m, &w->second.v_mps);
    w->second.A_bi = orr_mat3_mul(&plan->mounting.C_21, &s.A_bi);
    // Errors of the mounting are drawn in geographic axes, where the filter has them.
    const view v2 = view_of(&w->second);
    const orr_mat3 C2 =
        turned(by_axis(plan->mounting_sigma_rad, normals(plan->seed, STREAM_MOUNTING, 0)), &v2.C);
    w->second.A_bi = attitude_of(&v2, &C2);
    const orr_mat3 Rt = orr_mat3_transpose(&v2.R), A = orr_mat3_mul(&v2.D, &Rt);
    w->second.v_mps = orr_vec3_add(
        w->second.v_mps, orr_mat3_apply_t(&A, orr_vec3_scale(plan->start_velocity_mps,
                                                             normals(plan->seed, STREAM_VELOCITY, 0))));
    square(w->q.p, PSI, plan->mounting_sigma_rad);
    square(w->q.p, VEL,
           orr_vec3_make(plan->start_velocity_mps, plan->start_velocity_mps, plan->start_velocity_mps));
    const orr_mat3 body = view_of(&s).C;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int a = 0; a < 3; a++)
                w->q.p[VEL + i][VEL + k] += body.m[i][a] * body.m[k][a] * component(plan->flexure_mps, a) *
                                            component(plan->flexure_mps, a);
    square(w->q.p, GYRO, orr_vec3_make(plan->gyro.bias, plan->gyro.bias, plan->gyro.bias));
    square(w->q.p, ACCEL, orr_vec3_make(plan->accel.bias, plan->accel.bias, plan->accel.bias));
    square(w->q.p, GYRO_WALK, orr_vec3_make(plan->gyro.walking, plan->gyro.walking, plan->gyro.walking));
    square(w->q.p, ACCEL_WALK, orr_vec3_make(plan->accel.walking, plan->accel.walking, plan->accel.walking));
}

// e' P^-1 e of attitude and velocity.
static orr_status nees_of(const pair *w, const orr_transfer_point *p, double *out, orr_diag *diag)
{
    double a[6 * 6], x[6], e[6];
    for (int i = 0; i < 6; i++) {
        e[i] = x[i] = i < 3 ? component(p->attitude_rad, i) : component(p->velocity_mps, i - 3);
        for (int j = 0; j < 6; j++) a[6 * i + j] = w->q.p[i][j];
    }
    orr_status s = orr_cholesky_factor(a, 6, 0.0);
    if (s == ORR_OK) s = orr_cholesky_solve(a, 6, x);
    if (s != ORR_OK) return orr_diag_set(diag, s, "the filter's covariance is not positive definite");
    *out = 0.0;
    for (int i = 0; i < 6; i++) *out += e[i] * x[i];
    return ORR_OK;
}

static orr_status check(const orr_transfer_plan *p, orr_diag *diag)
{
    const orr_imu *a = p->first, *b = p->second;
    if (a->n != b->n || a->rate_hz != b->rate_hz || a->begin_s != b->begin_s || a->measured_dv_mps == NULL ||
        b->measured_dv_mps == NULL)
        return orr_diag_set(diag, ORR_E_ARG, "two units need readings with errors on the same edges");
    if (p->interval == 0 || p->interval % ORR_NAVIGATOR_MAX_SAMPLES != 0 || p->interval > a->n)
        return orr_diag_set(
            diag, ORR_E_ARG,
            "%zu readings from one measurement to the next; a multiple of %d is wanted, within the run",
            p->interval, ORR_NAVIGATOR_MAX_SAMPLES);
    const double v[] = {p->velocity_noise_mps, p->flexure_mps.x, p->flexure_mps.y, p->flexure_mps.z,
                        p->start_velocity_mps, p->gyro.white,    p->gyro.bias,     p->gyro.walking,
                        p->accel.white,        p->accel.bias,    p->accel.walking};
    for (size_t k = 0; k < sizeof v / sizeof v[0]; k++)
        if (!(v[k] >= 0.0))
            return orr_diag_set(diag, ORR_E_ARG, "a standard deviation of %g; it cannot be negative", v[k]);
    if (!(p->velocity_noise_mps > 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "the velocity that is handed over needs a noise above 0");
    if (!(p->gyro.correlation_s > 0.0 && p->accel.correlation_s > 0.0))
        return orr_diag_set(diag, ORR_E_ARG, "a correlation time has to be above 0");
    return ORR_OK;
}

static orr_status run(pair *w, void (*point)(void *, const orr_transfer_point *), void *user,
                      orr_transfer_result *out, orr_diag *diag)
{
    orr_vec3 last = {0, 0, 0};
    double product[3] = {0}, squares[3] = {0};
    out->first = out->last = tell(w, 0);
    if (point != NULL) point(user, &out->first);
    for (size_t k = 1; k <= w->n; k++) {
        orr_vec3 residual;
        advance(w, k * w->plan->interval);
        measure(w, k, &residual);
        out->last = tell(w, k);
        out->last.residual = residual;
        if (point != NULL) point(user, &out->last);
        for (int i = 0; i < 3; i++) {
            const double now = component(residual, i);
            squares[i] += now * now;
            if (k > 1) product[i] += now * component(last, i);
        }
        last = residual;
    }
    out->n = w->n;
    for (int i = 0; i < 3; i++) {
        out->whiteness[i] = product[i] / squares[i];
        out->residual_rms[i] = sqrt(squares[i] / (double)w->n);
    }
    return nees_of(w, &out->last, &out->nees, diag);
}

orr_status orr_transfer_align(const orr_transfer_plan *plan,
                              void (*point)(void *user, const orr_transfer_point *p), void *user,
                              orr_transfer_result *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    orr_status s = check(plan, diag);
    if (s != ORR_OK) return s;
    pair *w = calloc(1, sizeof *w);
    if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    w->plan = plan;
    w->n = plan->first->n / plan->interval;
    w->first = calloc(w->n + 1, sizeof *w->first);
    w->work = *plan->second;
    w->work.dtheta_rad = calloc(plan->second->n, sizeof *w->work.dtheta_rad);
    w->work.dv_mps = calloc(plan->second->n, sizeof *w->work.dv_mps);
    if (w->first == NULL || w->work.dtheta_rad == NULL || w->work.dv_mps == NULL) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu readings", plan->second->n);
    } else {
        orr_imu first = *plan->first; // navigates on its measured readings, from a start of its own
        first.dtheta_rad = plan->first->measured_dtheta_rad;
        first.dv_mps = plan->first->measured_dv_mps;
        begin(w, &first);
        const orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5, .gravity = plan->gravity};
        s = orr_navigate(&first, &nav, keep, w, diag);
    }
    if (s == ORR_OK) s = run(w, point, user, out, diag);
    free(w->first);
    free(w->work.dtheta_rad);
    free(w->work.dv_mps);
    free(w);
    return s;
}
