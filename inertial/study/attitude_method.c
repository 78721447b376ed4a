// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/attitude_method.h"

#include <stdio.h>
#include <string.h>

#include "inertial/study/attitude_method_private.h"

enum { MOST = ORR_METHOD_MAX_SAMPLES, NODES = ORR_METHOD_NODES };

// --- Chebyshev's extrema on (0, 1), node k at (1 - cos(k pi / (NODES - 1))) / 2 ---

static long double node_angle(int k) { return ORR_PI_X * (1 - (long double)k / (long double)(NODES - 1)); }
static long double node_at(int k) { return (1 + cosl(node_angle(k))) / 2; }

// Of Chebyshev's T_m, at cos(angle): (T_{m+1} / (m+1) - T_{m-1} / (m-1)) / 2.
static long double antiderivative(int m, long double angle)
{
    if (m == 0) return cosl(angle);
    const long double up = cosl((long double)(m + 1) * angle) / (long double)(m + 1);
    return m == 1 ? up / 2 : (up - cosl((long double)(m - 1) * angle) / (long double)(m - 1)) / 2;
}

// Integral up to node k of the polynomial that is 1 at node i and 0 at the others, as a sum of Chebyshev polynomials:
// c_m = (2 / last) T_m(y_i), halved at the ends of i and of m.
static long double integral_to(int k, int i)
{
    const int last = NODES - 1;
    long double sum = 0;
    for (int m = 0; m <= last; m++) {
        long double c = 2 / (long double)last * cosl((long double)m * node_angle(i));
        if (i == 0 || i == last) c /= 2;
        if (m == 0 || m == last) c /= 2;
        sum += c * (antiderivative(m, node_angle(k)) - antiderivative(m, ORR_PI_X));
    }
    return sum / 2; // of x = (1 + y) / 2
}

// --- The polynomial through increments ---

// The sum of n increments of which the i-th (from 0) is 1 and the others 0, as the polynomial of degree n through 0 at
// x = 0..i and 1 at i+1..n, and its derivative, by Newton's divided differences; x in [0, n].
static void cumulative(int n, int i, long double x, long double *value, long double *rate)
{
    long double d[MOST + 1];
    for (int k = 0; k <= n; k++) d[k] = k > i ? 1.0L : 0.0L;
    for (int order = 1; order <= n; order++)
        for (int k = n; k >= order; k--) d[k] = (d[k] - d[k - 1]) / (long double)order;
    *value = *rate = 0;
    for (int k = n; k >= 0; k--) {
        *rate = *rate * (x - (long double)k) + *value;
        *value = *value * (x - (long double)k) + d[k];
    }
}

// pair_ij = 1/2 integral of (P_i P_j' - P_j P_i') with P of cumulative(): the second order of Bortz's equation.
static void polynomial_pairs(orr_attitude_method *m)
{
    const int n = m->samples;
    for (int k = 0; k < NODES; k++) {
        long double p[MOST], rate[MOST];
        for (int i = 0; i < n; i++) cumulative(n, i, (long double)n * node_at(k), &p[i], &rate[i]);
        const long double weight = (long double)n * integral_to(NODES - 1, k) / 2;
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++) m->pair[i][j] += weight * (p[i] * rate[j] - p[j] * rate[i]);
    }
}

// --- Methods by name ---

static const struct {
    const char *name;
    orr_method_kind kind;
    int samples;
    long double last[MOST - 1]; // (k_1 d_1 + ..) x d_N; none: of the polynomial
} builtin[] = {
    {"1-step", ORR_METHOD_ROTATION_VECTOR, 1, {0}},
    {"2-step", ORR_METHOD_ROTATION_VECTOR, 2, {2.0L / 3}},
    {"3-step", ORR_METHOD_ROTATION_VECTOR, 3, {9.0L / 20, 27.0L / 20}},
    {"4-step", ORR_METHOD_ROTATION_VECTOR, 4, {54.0L / 105, 92.0L / 105, 214.0L / 105}},
    {"5-step", ORR_METHOD_ROTATION_VECTOR, 5, {250.0L / 504, 525.0L / 504, 650.0L / 504, 1375.0L / 504}},
    {"polynomial-3", ORR_METHOD_ROTATION_VECTOR, 3, {0}},
    {"polynomial-4", ORR_METHOD_ROTATION_VECTOR, 4, {0}},
    {"polynomial-5", ORR_METHOD_ROTATION_VECTOR, 5, {0}},
    {"iteration-4", ORR_METHOD_ITERATION, 4, {0}},
    {"iteration-8", ORR_METHOD_ITERATION, 8, {0}},
};
enum { BUILTIN = sizeof builtin / sizeof builtin[0] };

const char *orr_attitude_method_name(size_t k) { return k < BUILTIN ? builtin[k].name : NULL; }

orr_status orr_attitude_method_builtin(const char *name, orr_attitude_method *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    for (size_t k = 0; k < BUILTIN; k++) {
        if (strcmp(name, builtin[k].name) != 0) continue;
        snprintf(out->name, sizeof out->name, "%s", name);
        out->kind = builtin[k].kind;
        const int n = out->samples = builtin[k].samples;
        if (n > 1 && !(builtin[k].last[0] > 0)) polynomial_pairs(out);
        for (int i = 0; i + 1 < n && builtin[k].last[0] > 0; i++) out->pair[i][n - 1] = builtin[k].last[i];
        return ORR_OK;
    }
    char names[256] = "";
    size_t used = 0;
    for (size_t k = 0; k < BUILTIN && used < sizeof names; k++)
        used +=
            (size_t)snprintf(names + used, sizeof names - used, "%s%s", k == 0 ? "" : ", ", builtin[k].name);
    return orr_diag_set(diag, ORR_E_ARG,
                        "there is no method \"%s\" (built in are %s; others need samples and coefficients)",
                        name, names);
}

orr_status orr_attitude_method_make(const char *name, int samples, const double *coefficient, size_t n,
                                    orr_attitude_method *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if (samples < 1 || samples > MOST)
        return orr_diag_set(diag, ORR_E_ARG, "method \"%s\" has %d samples in a group; 1 to %d can be", name,
                            samples, (int)MOST);
    const size_t last = (size_t)samples - 1, pairs = (size_t)samples * last / 2;
    if (n != last && n != pairs)
        return orr_diag_set(diag, ORR_E_ARG,
                            "method \"%s\" has %zu coefficients; %d samples need %zu (each earlier increment "
                            "with the last) or %zu (all pairs)",
                            name, n, samples, last, pairs);
    for (size_t k = 0; k < n; k++)
        if (!isfinite(coefficient[k]))
            return orr_diag_set(diag, ORR_E_ARG, "coefficient %zu of method \"%s\" is no number", k + 1,
                                name);
    snprintf(out->name, sizeof out->name, "%s", name);
    out->samples = samples;
    if (n == last) {
        for (size_t i = 0; i < last; i++) out->pair[i][last] = (long double)coefficient[i];
        return ORR_OK;
    }
    size_t k = 0;
    for (int i = 0; i < samples; i++)
        for (int j = i + 1; j < samples; j++) out->pair[i][j] = (long double)coefficient[k++];
    return ORR_OK;
}

double orr_attitude_method_consistency(const orr_attitude_method *m)
{
    double sum = 0;
    for (int i = 0; i < m->samples; i++)
        for (int j = i + 1; j < m->samples; j++) sum += (double)m->pair[i][j] * (j - i);
    return 12.0 * sum / pow(m->samples, 3);
}

double orr_attitude_method_response(const orr_attitude_method *m, double ratio)
{
    if (!(ratio > 0)) return 0.0;
    // 1 - sin(x)/x and the pairs' terms cancel to what is left: in extended precision.
    const long double wh = 2.0L * ORR_PI_X * (long double)ratio, wH = wh * (long double)m->samples;
    const long double s = sinl(wh / 2);
    long double sum = 0;
    for (int i = 0; i < m->samples; i++)
        for (int j = i + 1; j < m->samples; j++) sum += m->pair[i][j] * sinl((long double)(j - i) * wh);
    const long double x2 = wH * wH;
    const long double one = x2 < 1e-3L
                                ? x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * (1 - x2 / 110))))
                                : 1 - sinl(wH) / wH;
    return (double)(one - 8 / wH * s * s * sum);
}

// --- A step ---

void orr_method_prepare(const orr_attitude_method *method, orr_method_plan *plan)
{
    memset(plan, 0, sizeof *plan);
    plan->method = method;
    if (method->kind != ORR_METHOD_ITERATION) return;
    const int n = method->samples;
    for (int k = 0; k < NODES; k++) {
        for (int i = 0; i < n; i++) {
            long double value, rate;
            cumulative(n, i, (long double)n * node_at(k), &value, &rate);
            plan->rate[k][i] = rate * (long double)n;
        }
        for (int i = 0; i < NODES; i++) plan->sum[k][i] = integral_to(k, i);
    }
}

static orr_xvec at_node(const orr_method_plan *plan, int k, const orr_xvec *d)
{
    orr_xvec w = {0, 0, 0};
    for (int i = 0; i < plan->method->samples; i++) w = orr_xvec_axpy(plan->rate[k][i], d[i], w);
    return w;
}

static void iterate(const orr_method_plan *plan, const orr_xvec *d, const orr_xvec *dv, orr_xquat *q,
                    orr_xvec *dv_out)
{
    // The turn within the group, from none; its difference from none is what is iterated, to lose no digits.
    orr_xquat p[NODES], rate[NODES];
    orr_xvec w[NODES];
    for (int k = 0; k < NODES; k++) {
        p[k] = (orr_xquat){0, 0, 0, 0};
        w[k] = at_node(plan, k, d);
    }
    for (int round = 0; round < 40; round++) {
        for (int k = 0; k < NODES; k++)
            rate[k] = orr_xquat_mul((orr_xquat){1 + p[k].w, p[k].x, p[k].y, p[k].z},
                                    (orr_xquat){0, w[k].x / 2, w[k].y / 2, w[k].z / 2});
        long double moved = 0;
        for (int k = 0; k < NODES; k++) {
            orr_xquat s = {0, 0, 0, 0};
            for (int i = 0; i < NODES; i++) {
                const long double c = plan->sum[k][i];
                s = (orr_xquat){s.w + c * rate[i].w, s.x + c * rate[i].x, s.y + c * rate[i].y,
                                s.z + c * rate[i].z};
            }
            moved = fmaxl(moved, fmaxl(fmaxl(fabsl(s.w - p[k].w), fabsl(s.x - p[k].x)),
                                       fmaxl(fabsl(s.y - p[k].y), fabsl(s.z - p[k].z))));
            p[k] = s;
        }
        if (moved < 1e-20L) break;
    }
    if (dv != NULL) {
        orr_xvec u = {0, 0, 0};
        for (int k = 0; k < NODES; k++)
            u = orr_xvec_axpy(
                plan->sum[NODES - 1][k],
                orr_xquat_back((orr_xquat){1 + p[k].w, p[k].x, p[k].y, p[k].z}, at_node(plan, k, dv)), u);
        *dv_out = orr_xquat_back(*q, u);
    }
    const orr_xquat *end = &p[NODES - 1];
    *q = orr_xquat_unit(orr_xquat_mul(*q, (orr_xquat){1 + end->w, end->x, end->y, end->z}));
}

void orr_method_step(const orr_method_plan *plan, const orr_xvec *d, const orr_xvec *dv, orr_xquat *q,
                     orr_xvec *dv_out)
{
    const orr_attitude_method *m = plan->method;
    if (m->kind == ORR_METHOD_ITERATION) {
        iterate(plan, d, dv, q, dv_out);
        return;
    }
    orr_xvec angle = {0, 0, 0}, coning = {0, 0, 0}, speed = {0, 0, 0}, sculling = {0, 0, 0};
    for (int i = 0; i < m->samples; i++) {
        angle = orr_xvec_add(angle, d[i]);
        if (dv != NULL) speed = orr_xvec_add(speed, dv[i]);
        for (int j = i + 1; j < m->samples; j++) {
            const long double c = m->pair[i][j];
            if (c == 0) continue;
            coning = orr_xvec_axpy(c, orr_xvec_cross(d[i], d[j]), coning);
            if (dv == NULL) continue;
            sculling = orr_xvec_axpy(c, orr_xvec_cross(d[i], dv[j]), sculling);
            sculling = orr_xvec_axpy(c, orr_xvec_cross(dv[i], d[j]), sculling);
        }
    }
    if (dv != NULL) { // Savage 1998: rotation of the velocity to third order, and sculling
        const orr_xvec turned = orr_xvec_cross(angle, speed);
        orr_xvec u = orr_xvec_add(orr_xvec_axpy(0.5L, turned, speed), sculling);
        u = orr_xvec_axpy(1.0L / 6, orr_xvec_cross(angle, turned), u);
        *dv_out = orr_xquat_back(*q, u);
    }
    *q = orr_xquat_unit(orr_xquat_mul(*q, orr_xquat_from_rotvec(orr_xvec_add(angle, coning))));
}
