// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/study/vibration.h"

#include <stdlib.h>

#include "inertial/study/attitude_method_private.h"

// --- Exact increments ---

// Integral from time a to b of the matrix body-from-rest of (28): cos beta E + (1 - cos beta) e e' + sin beta hat(e) with
// e = (cos wt, sin wt, 0).
static void integrate_attitude(long double beta, long double w, long double a, long double b,
                               long double V[3][3])
{
    const long double h = b - a, s = sinl(w * h / 2), s2 = sinl(w * h), mid = w * (a + b) / 2;
    const long double c1 = 2 / w * s * cosl(mid), s1 = 2 / w * s * sinl(mid); // of cos wt, sin wt
    const long double cc = h / 2 + s2 * cosl(2 * mid) / (2 * w), ss = h - cc,
                      cs = s2 * sinl(2 * mid) / (2 * w);
    const long double sh = sinl(beta / 2), k = 2 * sh * sh, f = sinl(beta), d = (1 - k) * h;
    const long double out[3][3] = {
        {d + k * cc, k * cs, -f * s1}, {k * cs, d + k * ss, f * c1}, {f * s1, -f * c1, d}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) V[i][j] = out[i][j];
}

static orr_xvec apply(long double V[3][3], orr_xvec v)
{
    return (orr_xvec){V[0][0] * v.x + V[0][1] * v.y + V[0][2] * v.z,
                      V[1][0] * v.x + V[1][1] * v.y + V[1][2] * v.z,
                      V[2][0] * v.x + V[2][1] * v.y + V[2][2] * v.z};
}

// Of (29) from a to b; differences of sines as products, which lose no digits.
static orr_xvec coning_increment(long double beta, long double w, long double a, long double b)
{
    const long double s = 2 * sinl(beta) * sinl(w * (b - a) / 2), mid = w * (a + b) / 2, sh = sinl(beta / 2);
    return (orr_xvec){-s * sinl(mid), s * cosl(mid), -2 * w * sh * sh * (b - a)};
}

static orr_xquat cone(long double beta, long double phase)
{
    return orr_xquat_from_rotvec((orr_xvec){beta * cosl(phase), beta * sinl(phase), 0});
}

// --- A run ---

typedef struct run {
    orr_method_plan plan;
    long double w, beta, step_s;
    size_t groups;
} run;

static orr_status begin(const orr_vibration_study *study, const orr_attitude_method *method, double ratio,
                        run *r, orr_diag *diag)
{
    const double f = ratio * study->readings_hz;
    if (!(ratio > 0) || !(study->readings_hz > 0) || !(study->product_hz > 0))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "the frequencies of readings and vibration and f_v beta^2 are positive, not %g Hz, "
            "%g Hz and %g 1/s",
            study->readings_hz, f, study->product_hz);
    if (!(study->product_hz / f < ORR_PI * ORR_PI))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "f_v beta^2 = %g 1/s at %g Hz is an amplitude of %g rad, more than half a turn: the "
            "lowest frequency is %g Hz",
            study->product_hz, f, sqrt(study->product_hz / f), study->product_hz / (ORR_PI * ORR_PI));
    const double groups = floor(study->duration_s * study->readings_hz / method->samples * (1 + 1e-12));
    if (!(groups >= 1) || !(groups < 1e8))
        return orr_diag_set(
            diag, ORR_E_ARG,
            "a run of %g s at %g Hz is no group of %d samples, or more than a hundred million",
            study->duration_s, study->readings_hz, method->samples);
    orr_method_prepare(method, &r->plan);
    r->w = 2 * ORR_PI_X * (long double)ratio * (long double)study->readings_hz;
    r->beta = sqrtl((long double)study->product_hz / (long double)f);
    r->step_s = 1 / (long double)study->readings_hz;
    r->groups = (size_t)groups;
    return ORR_OK;
}

// The Earth's rate in the axes of the body at rest.
static orr_xvec earth_at_rest(const orr_vibration_study *study)
{
    if (!study->earth) return (orr_xvec){0, 0, 0};
    const orr_mat3 L = orr_body_from_enu(study->attitude);
    const orr_vec3 u = orr_mat3_apply(&L, (orr_vec3){0.0, ORR_EARTH_RATE_RADPS * cos(study->lat_rad),
                                                     ORR_EARTH_RATE_RADPS * sin(study->lat_rad)});
    return (orr_xvec){(long double)u.x, (long double)u.y, (long double)u.z};
}

orr_status orr_vibration_error_of(const orr_vibration_study *study, const orr_attitude_method *method,
                                  double ratio, orr_vibration_error *out, orr_diag *diag)
{
    run r;
    const orr_status status = begin(study, method, ratio, &r, diag);
    if (status != ORR_OK) return status;
    const orr_xvec u = earth_at_rest(study);
    orr_xquat q = cone(r.beta, 0); // body from inertial axes that are those of rest at the start
    for (size_t g = 0; g < r.groups; g++) {
        orr_xvec d[ORR_METHOD_MAX_SAMPLES];
        for (int i = 0; i < method->samples; i++) {
            const long double j = (long double)(g * (size_t)method->samples + (size_t)i);
            const long double a = j * r.step_s, b = (j + 1) * r.step_s;
            d[i] = coning_increment(r.beta, r.w, a, b);
            if (!study->earth) continue;
            long double V[3][3];
            integrate_attitude(r.beta, r.w, a, b, V);
            d[i] = orr_xvec_add(d[i], apply(V, u));
        }
        orr_method_step(&r.plan, d, NULL, &q, NULL);
    }
    const long double T = (long double)r.groups * (long double)method->samples * r.step_s;
    const orr_xvec turned = {u.x * T, u.y * T, u.z * T};
    const orr_xquat truth = orr_xquat_mul(orr_xquat_from_rotvec(turned), cone(r.beta, r.w * T));
    // Their difference as a turn of the axes of rest. Counter-clockwise about the vertical is less heading.
    const orr_xquat rest = orr_xquat_from_rotvec(turned);
    const orr_xquat e =
        orr_xquat_mul(orr_xquat_mul(orr_xquat_conj(rest), orr_xquat_mul(q, orr_xquat_conj(truth))), rest);
    const long double twice = e.w < 0 ? -2 : 2;
    const orr_xvec turn = {twice * e.x, twice * e.y, twice * e.z};
    const orr_mat3 L = orr_body_from_enu(study->attitude);
    const orr_xvec up = {(long double)L.m[0][2], (long double)L.m[1][2], (long double)L.m[2][2]};
    const long double about_up = turn.x * up.x + turn.y * up.y + turn.z * up.z;
    const orr_xvec tilt = orr_xvec_axpy(-about_up, up, turn);
    const long double sh = sinl(r.beta / 2), drift = 2 * r.w * sh * sh;
    *out = (orr_vibration_error){
        .amplitude_rad = (double)r.beta,
        .duration_s = (double)T,
        .drift_radps = (double)drift,
        .heading_rad = (double)-about_up,
        .normalised = (double)(-turn.z / (drift * T)),
        .tilt_rad = (double)sqrtl(tilt.x * tilt.x + tilt.y * tilt.y + tilt.z * tilt.z),
    };
    return ORR_OK;
}

// --- Sculling ---

// J_1(x) for small x, with J_3 and J_5 the odd harmonics of sin(x sin a).
static long double bessel(int n, long double x)
{
    long double term = 1, sum = 0;
    for (int k = 1; k <= n; k++) term *= x / (2 * (long double)k);
    for (int k = 0; k < 30; k++) {
        sum += term;
        term *= -x * x / (4 * (long double)(k + 1) * (long double)(k + 1 + n));
    }
    return sum;
}

// Integral of force sin a sin(beta sin a) over time 0..T with a = wt + phase, force 1: what axis 3 of the axes of rest
// gains.
static long double gained(long double beta, long double w, long double phase, long double T)
{
    long double sum = bessel(1, beta) * T; // sin a sin a = (1 - cos 2a) / 2, times 2 J_1
    for (int n = 1; n <= 7; n += 2) {      // 2 J_n sin(na) sin a = J_n (cos (n-1)a - cos (n+1)a)
        const long double J = bessel(n, beta), up = (long double)(n + 1), down = (long double)(n - 1);
        if (n > 1) sum += J * (sinl(down * (w * T + phase)) - sinl(down * phase)) / (down * w);
        sum -= J * (sinl(up * (w * T + phase)) - sinl(up * phase)) / (up * w);
    }
    return sum;
}

orr_status orr_sculling_error_of(const orr_vibration_study *study, const orr_attitude_method *method,
                                 double ratio, double *normalised, orr_diag *diag)
{
    run r;
    const orr_status status = begin(study, method, ratio, &r, diag);
    if (status != ORR_OK) return status;
    const long double T = (long double)r.groups * (long double)method->samples * r.step_s;
    long double error = 0;
    for (int quarter = 0; quarter < 2; quarter++) {
        const long double phase = (long double)quarter * ORR_PI_X / 2;
        orr_xquat q = orr_xquat_from_rotvec((orr_xvec){r.beta * sinl(phase), 0, 0});
        long double up = 0;
        for (size_t g = 0; g < r.groups; g++) {
            orr_xvec d[ORR_METHOD_MAX_SAMPLES], dv[ORR_METHOD_MAX_SAMPLES], u;
            for (int i = 0; i < method->samples; i++) {
                const long double j = (long double)(g * (size_t)method->samples + (size_t)i);
                const long double mid = r.w * (j + 0.5L) * r.step_s + phase, s = 2 * sinl(r.w * r.step_s / 2);
                d[i] = (orr_xvec){r.beta * s * cosl(mid), 0, 0};
                dv[i] = (orr_xvec){0, s * sinl(mid) / r.w, 0};
            }
            orr_method_step(&r.plan, d, dv, &q, &u);
            up += u.z;
        }
        error += (gained(r.beta, r.w, phase, T) - up) / (bessel(1, r.beta) * T) / 2;
    }
    *normalised = (double)error;
    return ORR_OK;
}

// --- Crossings ---

// Above 0 where the first has the larger error; 0 where they differ by rounding alone.
static double larger(const orr_attitude_method *a, const orr_attitude_method *b, double ratio)
{
    const double x = fabs(orr_attitude_method_response(a, ratio)),
                 y = fabs(orr_attitude_method_response(b, ratio));
    return fabs(x - y) > 1e-11 * x ? x - y : 0.0;
}

static int by_ratio(const void *a, const void *b)
{
    const orr_vibration_crossing *x = a, *y = b;
    return (x->ratio > y->ratio) - (x->ratio < y->ratio);
}

size_t orr_vibration_crossings(const orr_attitude_method *methods, size_t n, double low, double high,
                               orr_vibration_crossing *out, size_t most)
{
    size_t found = 0;
    const double step = 1e-3; // the response has no detail below 1/8 of f_m over the longest group
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n; j++) {
            double at = low, before = larger(&methods[i], &methods[j], at);
            for (double to = low + step; at < high && found < most; to += step) {
                if (to > high) to = high;
                const double now = larger(&methods[i], &methods[j], to);
                if (before * now < 0) {
                    double a = at, b = to;
                    for (int k = 0; k < 60; k++) {
                        const double m = 0.5 * (a + b);
                        if ((larger(&methods[i], &methods[j], m) < 0) == (before < 0))
                            a = m;
                        else
                            b = m;
                    }
                    out[found++] =
                        (orr_vibration_crossing){i, j, b, fabs(orr_attitude_method_response(&methods[i], b))};
                }
                at = to;
                if (now < 0 || now > 0) before = now;
            }
        }
    qsort(out, found, sizeof *out, by_ratio);
    return found;
}
