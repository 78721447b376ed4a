// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/nav/navigator.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "inertial/nav/one_step.h"

enum { MAX = ORR_NAVIGATOR_MAX_SAMPLES };

void orr_increment_polynomial(int n, double coefficient[MAX][MAX])
{
    // The integral of the rate passes through the sums of the increments at the n + 1 edges of the parts: it is
    // Lagrange's polynomial, in y = n x at the whole numbers, whose factors are whole numbers and exact.
    for (int d = 0; d < n; d++)
        for (int i = 0; i < n; i++) coefficient[d][i] = 0.0;
    for (int k = 1; k <= n; k++) { // edge k has increments 0 .. k - 1 behind it
        double power[MAX + 1] = {1.0}, divisor = 1.0;
        int degree = 0;
        for (int m = 0; m <= n; m++) {
            if (m == k) continue;
            degree++;
            for (int d = degree; d > 0; d--) power[d] = power[d - 1] - m * power[d];
            power[0] *= -m;
            divisor *= k - m;
        }
        for (int d = 0; d < n; d++) {
            const double share = (d + 1) * power[d + 1] * pow(n, d + 1) / divisor;
            for (int i = 0; i < k; i++) coefficient[d][i] += share;
        }
    }
}

size_t orr_navigator_group(const orr_imu *imu, size_t j, int wanted)
{
    size_t w = (size_t)wanted, left = imu->n - j;
    if (imu->knot_step_s > 0.0 && imu->knot_degree < 5) {
        // Sample edges nearest to the knots on both sides of the sample's middle.
        double k =
            floor((orr_imu_edge_s(imu, j) + 0.5 / imu->rate_hz - imu->knot_origin_s) / imu->knot_step_s);
        double from = (imu->knot_origin_s + k * imu->knot_step_s - imu->begin_s) * imu->rate_hz;
        double to = from + imu->knot_step_s * imu->rate_hz;
        double a = fmax(nearbyint(from), 0.0), b = nearbyint(to);
        if (b > (double)j && a <= (double)j) {
            size_t begin = (size_t)a, end = b < (double)imu->n ? (size_t)b : imu->n, whole = end - begin;
            size_t groups = (whole + w - 1) / w;
            for (size_t g = 0; g < groups; g++) {
                size_t next = begin + (g + 1) * whole / groups;
                if (next > j) return next - j;
            }
        }
    }
    return left < w ? left : w;
}

static orr_vec3 gravitation_inertial(const orr_gravity *g, orr_vec3 r_m, double t_s)
{
    double a = ORR_EARTH_RATE_RADPS * t_s, c = cos(a), s = sin(a);
    orr_vec3 e =
        orr_gravity_gravitation(g, orr_vec3_make(c * r_m.x + s * r_m.y, c * r_m.y - s * r_m.x, r_m.z));
    return orr_vec3_make(c * e.x - s * e.y, s * e.x + c * e.y, e.z);
}

// Kahan's sum: *x += d, what is lost kept in *low.
static void add(double *x, double *low, double d)
{
    double y = d - *low, t = *x + y;
    *low = (t - *x) - y;
    *x = t;
}
static void add3(orr_vec3 *x, orr_vec3 *low, orr_vec3 d)
{
    add(&x->x, &low->x, d.x);
    add(&x->y, &low->y, d.y);
    add(&x->z, &low->z, d.z);
}

// The state of the integrators in inertial axes, with what rounding took from it.
typedef struct body {
    orr_vec3 r, v, r_low, v_low;
    orr_quat q, q_low;
} body;

static orr_quat quat_axpy(double k, orr_quat a, orr_quat b)
{
    return (orr_quat){k * a.w + b.w, k * a.x + b.x, k * a.y + b.y, k * a.z + b.z};
}

// q' = q w / 2 and v' = C f + G, where C turns body components into inertial ones.
static void derivative(const orr_gravity *g, double t_s, orr_vec3 r, orr_quat q, orr_vec3 w, orr_vec3 f,
                       orr_quat *q_dot, orr_vec3 *a)
{
    *q_dot = orr_quat_mul(q, (orr_quat){0.0, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z});
    orr_mat3 A = orr_mat3_from_quat(q);
    orr_vec3 G = gravitation_inertial(g, r, t_s);
    *a = orr_vec3_axpy(1.0 / orr_quat_dot(q, q), orr_mat3_apply_t(&A, f), G);
}

static orr_vec3 polynomial(const orr_vec3 *c, size_t n, double x)
{
    orr_vec3 p = c[n - 1];
    for (size_t k = n - 1; k-- > 0;) p = orr_vec3_axpy(x, p, c[k]);
    return p;
}

static void runge_kutta(const orr_gravity *g, double t_s, double h, const orr_vec3 w[3], const orr_vec3 f[3],
                        body *b)
{
    orr_quat q1, q2, q3, q4;
    orr_vec3 a1, a2, a3, a4, r = b->r, v = b->v;
    derivative(g, t_s, r, b->q, w[0], f[0], &q1, &a1);
    derivative(g, t_s + 0.5 * h, orr_vec3_axpy(0.5 * h, v, r), quat_axpy(0.5 * h, q1, b->q), w[1], f[1], &q2,
               &a2);
    derivative(g, t_s + 0.5 * h, orr_vec3_axpy(0.25 * h * h, a1, orr_vec3_axpy(0.5 * h, v, r)),
               quat_axpy(0.5 * h, q2, b->q), w[1], f[1], &q3, &a3);
    derivative(g, t_s + h, orr_vec3_axpy(0.5 * h * h, a2, orr_vec3_axpy(h, v, r)), quat_axpy(h, q3, b->q),
               w[2], f[2], &q4, &a4);
    // The velocity's low part belongs to the motion too: it moves the position by h times itself.
    orr_vec3 move = orr_vec3_scale(h, orr_vec3_sub(v, b->v_low));
    move = orr_vec3_axpy(h * h / 6.0, orr_vec3_add(a1, orr_vec3_add(a2, a3)), move);
    add3(&b->r, &b->r_low, move);
    orr_vec3 gain = orr_vec3_add(orr_vec3_add(a1, a4), orr_vec3_scale(2.0, orr_vec3_add(a2, a3)));
    add3(&b->v, &b->v_low, orr_vec3_scale(h / 6.0, gain));
    orr_quat d = quat_axpy(2.0, q2, q1);
    d = quat_axpy(2.0, q3, d);
    d = quat_axpy(1.0, q4, d);
    d = (orr_quat){d.w * h / 6.0, d.x * h / 6.0, d.y * h / 6.0, d.z * h / 6.0};
    orr_quat next = quat_axpy(1.0, d, b->q);
    d = quat_axpy(-0.5 * (orr_quat_dot(next, next) - 1.0), b->q, d); // back to unit length, to first order
    add(&b->q.w, &b->q_low.w, d.w);
    add(&b->q.x, &b->q_low.x, d.x);
    add(&b->q.y, &b->q_low.y, d.y);
    add(&b->q.z, &b->q_low.z, d.z);
}

// Runge-Kutta steps for a group of n samples: at most 11 ms and turns of at most 4 mrad each (its error of a
// steady turn is then below 1e-15 rad), and so many that span c / (120 steps^4), Simpson's error of a term c
// x^4 over the group, stays below 1e-11 rad and 1e-9 m/s for all terms c x^d from the second on: products of
// the lower ones err alike.
static int steps_for(const orr_imu *imu, size_t j, size_t n, double span_s, const orr_vec3 *w,
                     const orr_vec3 *f)
{
    double turn = 0.0;
    for (size_t i = 0; i < n; i++) turn = fmax(turn, orr_vec3_norm(imu->dtheta_rad[j + i]));
    double k = fmax(ceil(1.0 / (imu->rate_hz * 0.011)), ceil(turn / 0.004)) * (double)n;
    double bend = 0.0;
    for (size_t d = 2; d < n; d++) bend += orr_vec3_norm(w[d]) / 1e-11 + orr_vec3_norm(f[d]) / 1e-9;
    k = fmax(k, ceil(pow(span_s * bend / 120.0, 0.25)));
    return k < 1.0 ? 1 : k > 1000.0 * (double)n ? 1000 * (int)n : (int)k;
}

static void reference_group(const orr_imu *imu, const orr_navigator *nav, double c[MAX + 1][MAX][MAX],
                            size_t j, size_t n, body *b)
{
    double span = (double)n / imu->rate_hz;
    orr_vec3 w[MAX], f[MAX];
    for (size_t d = 0; d < n; d++) {
        // Differences from the first increment leave a steady part (gravity) untouched by the coefficients'
        // rounding, which would otherwise be a bias of some 1e-13 g, tens of micrometres after an hour.
        w[d] = f[d] = orr_vec3_make(0, 0, 0);
        for (size_t i = 1; i < n; i++) {
            double k = c[n][d][i] / span;
            w[d] = orr_vec3_axpy(k, orr_vec3_sub(imu->dtheta_rad[j + i], imu->dtheta_rad[j]), w[d]);
            f[d] = orr_vec3_axpy(k, orr_vec3_sub(imu->dv_mps[j + i], imu->dv_mps[j]), f[d]);
        }
    }
    w[0] = orr_vec3_axpy(imu->rate_hz, imu->dtheta_rad[j], w[0]);
    f[0] = orr_vec3_axpy(imu->rate_hz, imu->dv_mps[j], f[0]);
    int steps = nav->substeps > 0 ? (int)n * nav->substeps : steps_for(imu, j, n, span, w, f);
    double h = span / steps;
    for (int s = 0; s < steps; s++) {
        orr_vec3 wn[3], fn[3];
        for (int k = 0; k < 3; k++) {
            double x = ((double)s + 0.5 * k) / steps;
            wn[k] = polynomial(w, n, x);
            fn[k] = polynomial(f, n, x);
        }
        runge_kutta(nav->gravity, orr_imu_edge_s(imu, j) + h * s, h, wn, fn, b);
    }
}

// double_integral[n][i][k]: integral over the group of (running integral of the part of the rate that
// increment i makes) times (that of increment k), so that the cross products of coning and sculling follow
// for any pair.
static void cross_weights(double c[MAX + 1][MAX][MAX], double s[MAX + 1][MAX][MAX])
{
    memset(s, 0, sizeof(double) * (MAX + 1) * MAX * MAX);
    for (int n = 1; n <= MAX; n++)
        for (int i = 0; i < n; i++)
            for (int k = 0; k < n; k++)
                for (int d = 0; d < n; d++)
                    for (int e = 0; e < n; e++)
                        s[n][i][k] += c[n][d][i] / (d + 1.0) * c[n][e][k] / (d + e + 2.0);
}

static void multi_sample_group(const orr_imu *imu, const orr_navigator *nav, double s[MAX + 1][MAX][MAX],
                               size_t j, size_t n, body *b)
{
    double h = (double)n / imu->rate_hz, t = orr_imu_edge_s(imu, j);
    const orr_vec3 *th = imu->dtheta_rad + j, *dv = imu->dv_mps + j;
    orr_vec3 turn = {0, 0, 0}, push = {0, 0, 0}, coning = {0, 0, 0}, sculling = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        turn = orr_vec3_add(turn, th[i]);
        push = orr_vec3_add(push, dv[i]);
        for (size_t k = 0; k < n; k++) {
            coning = orr_vec3_axpy(0.5 * s[n][i][k], orr_vec3_cross(th[i], th[k]), coning);
            sculling = orr_vec3_axpy(s[n][i][k], orr_vec3_cross(th[i], dv[k]), sculling);
        }
    }
    // Second order of the turn within the group, for a steady rate and force: theta x (theta x v) / 6.
    orr_vec3 second = orr_vec3_scale(1.0 / 6.0, orr_vec3_cross(turn, orr_vec3_cross(turn, push)));
    push = orr_vec3_add(push, orr_vec3_add(sculling, second));
    turn = orr_vec3_add(turn, coning);
    orr_mat3 A = orr_mat3_from_quat(b->q);
    orr_vec3 gain = orr_mat3_apply_t(&A, push), v0 = b->v;
    orr_vec3 middle = orr_vec3_axpy(0.5 * h, orr_vec3_axpy(0.25, gain, v0), b->r);
    gain = orr_vec3_axpy(h, gravitation_inertial(nav->gravity, middle, t + 0.5 * h), gain);
    add3(&b->v, &b->v_low, gain);
    add3(&b->r, &b->r_low, orr_vec3_scale(0.5 * h, orr_vec3_add(v0, b->v)));
    b->q = orr_quat_unit(orr_quat_mul(b->q, orr_quat_from_rotvec(turn)));
}

static orr_status near_earth(orr_vec3 r_m, double t_s, orr_diag *diag)
{
    double n = orr_vec3_norm(r_m);
    if (n > 1e6 && n < 1e8) return ORR_OK;
    return orr_diag_set(diag, ORR_E_NUMERIC,
                        "the navigation diverged: %.0f s after t0 it is %.3g km from the Earth's centre", t_s,
                        n / 1e3);
}

static orr_status run_one_step(const orr_imu *imu, const orr_navigator *nav,
                               orr_status (*visit)(void *, const orr_nav_state *), void *user, orr_diag *diag)
{
    if (nav->hold_vertical && imu->truth_every != 1)
        return orr_diag_set(diag, ORR_E_UNSUPPORTED,
                            "holding the vertical channel needs the truth at every sample; make the readings "
                            "with the truth's "
                            "rate equal to theirs");
    orr_one_step s;
    orr_one_step_start(&s, nav->frame, nav->project_mid, 1.0 / imu->rate_hz, nav->gravity, imu->begin_s,
                       imu->start_r_m, imu->start_v_mps, imu->start_q_bi);
    for (size_t j = 0; j <= imu->n; j++) {
        if (j > 0) {
            orr_one_step_advance(&s, imu->dtheta_rad[j - 1], imu->dv_mps[j - 1]);
            if (nav->hold_vertical) {
                orr_vec3 r, v;
                orr_mat3 A;
                orr_imu_true_state(imu, j, &r, &v, &A);
                orr_one_step_hold_vertical(&s, r, v);
            }
        }
        orr_status status = near_earth(s.r_m, s.t_s, diag);
        if (status != ORR_OK) return status;
        orr_nav_state out = {j, orr_imu_edge_s(imu, j), s.r_m, orr_one_step_velocity(&s), s.A_zi};
        status = visit(user, &out);
        if (status != ORR_OK) return status;
    }
    return ORR_OK;
}

orr_status orr_navigate(const orr_imu *imu, const orr_navigator *nav,
                        orr_status (*visit)(void *user, const orr_nav_state *state), void *user,
                        orr_diag *diag)
{
    if (nav->kind == ORR_NAVIGATOR_ONE_STEP) return run_one_step(imu, nav, visit, user, diag);
    if (nav->samples < 1 || nav->samples > MAX)
        return orr_diag_set(diag, ORR_E_ARG, "a navigator takes 1 to %d samples at a time, not %d", MAX,
                            nav->samples);
    double c[MAX + 1][MAX][MAX] = {{{0}}}, s[MAX + 1][MAX][MAX];
    for (int n = 1; n <= MAX; n++) orr_increment_polynomial(n, c[n]);
    cross_weights(c, s);
    body b = {.r = imu->start_r_m, .v = imu->start_v_mps, .q = imu->start_q_bi};
    size_t j = 0;
    for (;;) {
        orr_status status = near_earth(b.r, orr_imu_edge_s(imu, j), diag);
        if (status != ORR_OK) return status;
        orr_nav_state out = {j, orr_imu_edge_s(imu, j), b.r, b.v, orr_mat3_from_quat(orr_quat_unit(b.q))};
        status = visit(user, &out);
        if (status != ORR_OK || j == imu->n) return status;
        size_t n = orr_navigator_group(imu, j, nav->samples),
               to_truth = imu->truth_every - j % imu->truth_every;
        if (nav->hold_vertical && n > to_truth) n = to_truth; // so that a group ends wherever there is truth
        if (nav->kind == ORR_NAVIGATOR_REFERENCE)
            reference_group(imu, nav, c, j, n, &b);
        else
            multi_sample_group(imu, nav, s, j, n, &b);
        j += n;
        if (nav->hold_vertical && j % imu->truth_every == 0) {
            orr_vec3 r, v;
            orr_mat3 A;
            orr_imu_true_state(imu, j, &r, &v, &A);
            orr_hold_vertical(r, v, &b.r, &b.v);
        }
    }
}

void orr_navigate_from(const orr_imu *imu, const orr_navigator *nav, orr_nav_state *state, size_t to)
{
    assert(nav->samples >= 1 && nav->samples <= MAX && to <= imu->n);
    double c[MAX + 1][MAX][MAX] = {{{0}}};
    for (int n = 1; n <= MAX; n++) orr_increment_polynomial(n, c[n]);
    body b = {.r = state->r_m, .v = state->v_mps, .q = orr_quat_from_mat3(&state->A_bi)};
    for (size_t j = state->edge; j < to;) {
        size_t n = orr_navigator_group(imu, j, nav->samples);
        if (n > to - j) n = to - j;
        reference_group(imu, nav, c, j, n, &b);
        j += n;
    }
    *state = (orr_nav_state){to, orr_imu_edge_s(imu, to), b.r, b.v, orr_mat3_from_quat(orr_quat_unit(b.q))};
}
