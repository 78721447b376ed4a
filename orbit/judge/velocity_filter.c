// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/judge/velocity_filter.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "core/astro.h"
#include "core/chebyshev.h"

enum { MIN_HALF = 8 };
#define WINDOW_S 3600.0

#define MAX_STEP_S 900.0

// What two bodies leave is mainly J2's: 5e-5 m/s^2 at twice the satellite's rate, which is up to 1.5 times
// that of a 12-h orbit at the perigee of e = 0.2. The first odd term that a series of odd degree leaves out
// must not matter.
static int degree_for(double half_width_s)
{
    double half_phase = 0.5 * 2 * 1.5 * 2 * ORR_PI / 43000.0 * half_width_s,
           term = 0.5 * 5e-5 * half_width_s * half_width_s;
    for (int k = 1;; k++) {
        term *= half_phase / k; // J_k(z) is (z/2)^k / k! for small z
        if (k % 2 == 1 && k >= 3 && (term * k / half_width_s < 2e-7 || k >= 21)) return k - 2;
    }
}

// weight[at][k] = sum_j T'_j(x_at) C[j][k] / h, where column k of C is the least-squares series of a unit at
// epoch k.
static orr_status make_weights(orr_velocity_filter *f, int degree, orr_diag *diag)
{
    size_t terms = (size_t)degree + 1, n = f->n;
    double h = (double)f->half * f->step_s, t[ORR_CHEB_MAX_DEGREE + 1], d[ORR_CHEB_MAX_DEGREE + 1];
    gsl_matrix *a = gsl_matrix_calloc(n, terms);
    gsl_vector *tau = gsl_vector_calloc(terms), *unit = gsl_vector_calloc(n), *x = gsl_vector_calloc(terms),
               *residual = gsl_vector_calloc(n);
    orr_status s = ORR_OK;
    if (a == NULL || tau == NULL || unit == NULL || x == NULL || residual == NULL) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a velocity filter of %zu epochs", n);
    } else {
        for (size_t k = 0; k < n; k++) {
            orr_cheb_basis(degree, (double)k / (double)f->half - 1.0, t, NULL, NULL);
            for (size_t j = 0; j < terms; j++) gsl_matrix_set(a, k, j, t[j]);
        }
        if (gsl_linalg_QR_decomp(a, tau) != 0) s = ORR_E_NUMERIC;
        for (size_t k = 0; k < n && s == ORR_OK; k++) {
            gsl_vector_set_basis(unit, k);
            if (gsl_linalg_QR_lssolve(a, tau, unit, x, residual) != 0) s = ORR_E_NUMERIC;
            for (size_t at = 0; at < n; at++) {
                orr_cheb_basis(degree, (double)at / (double)f->half - 1.0, t, d, NULL);
                double sum = 0;
                for (size_t j = 0; j < terms; j++) sum += d[j] * gsl_vector_get(x, j);
                f->weight[at * n + k] = sum / h;
            }
        }
        if (s != ORR_OK)
            orr_diag_set(diag, s, "a velocity filter of %zu epochs and degree %d is singular", n, degree);
    }
    gsl_matrix_free(a);
    gsl_vector_free(tau);
    gsl_vector_free(unit);
    gsl_vector_free(x);
    gsl_vector_free(residual);
    return s;
}

orr_status orr_velocity_filter_init(double step_s, orr_velocity_filter *f, orr_diag *diag)
{
    *f = (orr_velocity_filter){.step_s = step_s};
    if (!(step_s >= 1 && step_s <= 1800))
        return orr_diag_set(diag, ORR_E_ARG,
                            "no velocities are derived from positions %.15g s apart (1 to 1800 s)", step_s);
    size_t half = (size_t)ceil(WINDOW_S / step_s - 1e-9);
    f->half = half < MIN_HALF ? MIN_HALF : half;
    if (f->half > 120) f->half = 120; // ten minutes of 5 s: enough against any rounding
    f->n = 2 * f->half + 1;
    int degree = degree_for((double)f->half * step_s);
    if ((size_t)degree > f->n - 1) degree = (int)f->n - 1;
    f->weight = calloc(f->n * f->n, sizeof *f->weight);
    f->c = calloc(f->n, sizeof *f->c);
    f->s = calloc(f->n, sizeof *f->s);
    orr_status s = ORR_OK;
    if (f->weight == NULL || f->c == NULL || f->s == NULL)
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a velocity filter of %zu epochs", f->n);
    else
        s = make_weights(f, degree, diag);
    if (s != ORR_OK) {
        orr_velocity_filter_free(f);
        return s;
    }
    for (size_t k = 0; k < f->n; k++) {
        f->c[k] = cos(ORR_EARTH_RATE_RADPS * step_s * (double)k);
        f->s[k] = sin(ORR_EARTH_RATE_RADPS * step_s * (double)k);
    }
    return ORR_OK;
}

void orr_velocity_filter_free(orr_velocity_filter *f)
{
    free(f->weight);
    free(f->c);
    free(f->s);
    *f = (orr_velocity_filter){0};
}

// First epoch of the best whole window: of those that hold `at` and have no missing epoch, the one nearest to
// centred.
static bool find_window(const orr_velocity_filter *f, const orr_vec3 *pos, size_t n, size_t at, size_t *first)
{
    // The unbroken run of positions about `at`, no wider than any window needs.
    if (isnan(pos[at].x)) return false;
    size_t low = at, high = at;
    while (low > 0 && at - low < f->n - 1 && !isnan(pos[low - 1].x)) low--;
    while (high + 1 < n && high - at < f->n - 1 && !isnan(pos[high + 1].x)) high++;
    if (high - low + 1 < f->n) return false;
    size_t want = at >= f->half ? at - f->half : 0, last = high + 1 - f->n;
    *first = want < low ? low : want > last ? last : want;
    return true;
}

// Position of two bodies dt after (r, v), by Kepler's equation for the difference of eccentric anomalies
// (Battin 1999, An Introduction to the Mathematics and Methods of Astrodynamics, 4.3). False where the orbit
// is no ellipse.
static bool two_body(orr_vec3 r, orr_vec3 v, double dt, orr_vec3 *out)
{
    double r0 = orr_vec3_norm(r), a = 1.0 / (2.0 / r0 - orr_vec3_dot(v, v) / ORR_WGS84_GM);
    if (!(a > 0)) return false;
    double n = sqrt(ORR_WGS84_GM / (a * a * a)), ecos = 1.0 - r0 / a,
           esin = orr_vec3_dot(r, v) / sqrt(ORR_WGS84_GM * a);
    double dm = n * dt, x = dm;
    for (int i = 0; i < 20; i++) {
        double step = (x - ecos * sin(x) + esin * (1 - cos(x)) - dm) / (1 - ecos * cos(x) + esin * sin(x));
        x -= step;
        if (fabs(step) < 1e-14) break;
    }
    double f = 1 - a / r0 * (1 - cos(x)), g = dt - (x - sin(x)) / n;
    *out = orr_vec3_axpy(g, v, orr_vec3_scale(f, r));
    return true;
}

// Position k of a window in the axes of its epoch `middle`: back by the angle u (t_k - t_middle).
static orr_vec3 turned(const orr_velocity_filter *f, const orr_vec3 *r, size_t k, size_t middle)
{
    double c = k >= middle ? f->c[k - middle] : f->c[middle - k];
    double s = k >= middle ? f->s[k - middle] : -f->s[middle - k];
    return (orr_vec3){c * r->x - s * r->y, s * r->x + c * r->y, r->z};
}

bool orr_velocity_filter_at(const orr_velocity_filter *f, const orr_vec3 *pos_m, size_t n, size_t at,
                            orr_vec3 *vel_mps, double *gain_ps)
{
    size_t first;
    if (!find_window(f, pos_m, n, at, &first)) return false;
    size_t middle = at - first;
    const double *w = &f->weight[middle * f->n];
    orr_vec3 v = {0, 0, 0}, correction = {0, 0, 0};
    for (size_t k = 0; k < f->n; k++) v = orr_vec3_axpy(w[k], turned(f, &pos_m[first + k], k, middle), v);
    // The derivative of the positions themselves is good to some cm/s; that of what they have beyond two
    // bodies tells how much is missing.
    for (size_t k = 0; k < f->n; k++) {
        orr_vec3 kepler;
        if (!two_body(pos_m[at], v, ((double)k - (double)middle) * f->step_s, &kepler)) return false;
        correction =
            orr_vec3_axpy(w[k], orr_vec3_sub(turned(f, &pos_m[first + k], k, middle), kepler), correction);
    }
    v = orr_vec3_add(v, correction);
    double squares = 0;
    for (size_t k = 0; k < f->n; k++) squares += w[k] * w[k];
    if (gain_ps != NULL) *gain_ps = sqrt(squares);
    const orr_vec3 *r = &pos_m[at];
    *vel_mps = (orr_vec3){v.x + ORR_EARTH_RATE_RADPS * r->y, v.y - ORR_EARTH_RATE_RADPS * r->x, v.z};
    return true;
}
