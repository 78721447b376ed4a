// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/uniform_spline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/linalg.h"

// Values at tau of the degree + 1 standard basis functions that live on one interval (de Boor's recurrence on
// integer knots: N_{i,k} from N_{i,k-1} and N_{i+1,k-1}).
static void basis_values(int degree, double tau, double *b)
{
    b[0] = 1.0;
    for (int k = 1; k <= degree; k++) {
        double saved = 0.0;
        for (int r = 0; r < k; r++) {
            double right = (double)(r + 1) - tau, left = tau + (double)(k - 1 - r);
            double share = b[r] / (right + left);
            b[r] = saved + right * share;
            saved = left * share;
        }
        b[k] = saved;
    }
}

// power[k][r]: coefficient of tau^k in basis function r. The recurrence of above on polynomials.
static void basis_powers(int degree, double power[ORR_USPLINE_MAX_DEGREE + 1][ORR_USPLINE_MAX_DEGREE + 1])
{
    memset(power, 0, sizeof(double) * (ORR_USPLINE_MAX_DEGREE + 1) * (ORR_USPLINE_MAX_DEGREE + 1));
    power[0][0] = 1.0;
    for (int k = 1; k <= degree; k++) {
        double old[ORR_USPLINE_MAX_DEGREE + 1][ORR_USPLINE_MAX_DEGREE + 1];
        memcpy(old, power, sizeof old);
        memset(power, 0, sizeof old);
        for (int r = 0; r < k; r++)
            for (int e = 0; e < k; e++) {
                double share = old[e][r] / (double)k; // right + left = k
                power[e][r] += (double)(r + 1) * share;
                power[e + 1][r] -= share;
                power[e][r + 1] += (double)(k - 1 - r) * share;
                power[e + 1][r + 1] += share;
            }
    }
}

static size_t interval_of(const orr_uspline *s, double t_s, double *tau)
{
    double x = (t_s - s->origin_s) / s->step_s;
    size_t i = 0;
    if (x > 0.0) {
        i = x < (double)s->n ? (size_t)x : s->n - 1;
    }
    *tau = x - (double)i;
    return i;
}

orr_status orr_uspline_fit(int degree, int dim, double origin_s, double step_s, size_t n_intervals, size_t m,
                           const double *t_s, const double *value, const double *weight, double roughness,
                           orr_uspline *out, orr_diag *diag)
{
    memset(out, 0, sizeof *out);
    if ((degree != 3 && degree != 5) || dim < 1 || dim > ORR_USPLINE_MAX_DIM)
        return orr_diag_set(diag, ORR_E_ARG, "a spline has degree 3 or 5 and 1 to %d components",
                            ORR_USPLINE_MAX_DIM);
    if (!(step_s > 0.0) || n_intervals == 0 || m == 0)
        return orr_diag_set(diag, ORR_E_ARG, "a spline needs a positive knot step, an interval and a sample");
    if (n_intervals > ORR_USPLINE_MAX_INTERVALS)
        return orr_diag_set(diag, ORR_E_LIMIT,
                            "%zu knot intervals are more than the limit of %u; take a longer knot step",
                            n_intervals, ORR_USPLINE_MAX_INTERVALS);
    orr_uspline s = {
        .degree = degree, .dim = dim, .n = n_intervals, .origin_s = origin_s, .step_s = step_s, .poly = NULL};
    double slack = 1e-6 * step_s, end_s = origin_s + step_s * (double)n_intervals;
    for (size_t k = 0; k < m; k++)
        if (!(t_s[k] >= origin_s - slack && t_s[k] <= end_s + slack) || (k > 0 && t_s[k] < t_s[k - 1]))
            return orr_diag_set(diag, ORR_E_ARG,
                                "sample %zu of a spline (%.6f s) is out of order or outside its knots", k,
                                t_s[k]);

    size_t nc = n_intervals + (size_t)degree, w = (size_t)degree + 1, d = (size_t)dim;
    double *a = calloc(nc * w, sizeof *a), *x = calloc(nc * d, sizeof *x);
    s.poly = malloc(n_intervals * w * d * sizeof *s.poly);
    orr_status status = ORR_OK;
    if (a == NULL || x == NULL || s.poly == NULL) {
        status = orr_diag_set(diag, ORR_E_MEMORY, "no memory for a spline of %zu intervals", n_intervals);
        goto end;
    }
    for (size_t k = 0; k < m; k++) {
        double tau, b[ORR_USPLINE_MAX_DEGREE + 1], p = weight != NULL ? weight[k] : 1.0;
        size_t i = interval_of(&s, t_s[k], &tau);
        basis_values(degree, tau, b);
        for (size_t r = 0; r < w; r++) {
            for (size_t q = 0; q <= r; q++) a[(i + q) * w + (r - q)] += p * b[r] * b[q];
            for (size_t c = 0; c < d; c++) x[(i + r) * d + c] += p * b[r] * value[k * d + c];
        }
    }
    static const double third[4] = {-1.0, 3.0, -3.0, 1.0};
    for (size_t i = 0; i + 3 < nc; i++)
        for (size_t r = 0; r < 4; r++)
            for (size_t q = 0; q <= r; q++) a[(i + q) * w + (r - q)] += roughness * third[r] * third[q];
    if (orr_band_solve(a, nc, (size_t)degree, x, d) != ORR_OK) {
        status = orr_diag_set(diag, ORR_E_NUMERIC,
                              "the spline is not determined: %zu samples for %zu knot intervals of %g s; "
                              "take a longer knot step",
                              m, n_intervals, step_s);
        goto end;
    }
    double power[ORR_USPLINE_MAX_DEGREE + 1][ORR_USPLINE_MAX_DEGREE + 1];
    basis_powers(degree, power);
    for (size_t i = 0; i < n_intervals; i++)
        for (size_t k = 0; k < w; k++)
            for (size_t c = 0; c < d; c++) {
                // The basis sums to one: differences from the first coefficient give the derivatives of
                // neighbouring intervals to rounding of a step's motion, not of the distance from the origin.
                // Velocities that jump by 1e-10 m/s at each knot would be tenths of a millimetre after an
                // hour of navigation.
                double sum = 0.0, first = x[i * d + c];
                for (size_t r = 1; r < w; r++) sum += power[k][r] * (x[(i + r) * d + c] - first);
                s.poly[(i * w + k) * d + c] = k == 0 ? sum + first : sum;
            }
    *out = s;
    s.poly = NULL;
end:
    free(a);
    free(x);
    free(s.poly);
    return status;
}

void orr_uspline_free(orr_uspline *s)
{
    free(s->poly);
    memset(s, 0, sizeof *s);
}

// Horner for value and two derivatives at once; `dim` and `degree` are literals where it counts, so that it
// unrolls.
static inline void horner(const double *c, const int degree, const int dim, double tau, double k1, double k2,
                          double *v, double *d1, double *d2)
{
    double p[ORR_USPLINE_MAX_DIM], q[ORR_USPLINE_MAX_DIM], r[ORR_USPLINE_MAX_DIM];
    for (int j = 0; j < dim; j++) {
        p[j] = c[degree * dim + j];
        q[j] = 0.0;
        r[j] = 0.0;
    }
    for (int k = degree - 1; k >= 0; k--)
        for (int j = 0; j < dim; j++) {
            r[j] = r[j] * tau + q[j];
            q[j] = q[j] * tau + p[j];
            p[j] = p[j] * tau + c[k * dim + j];
        }
    for (int j = 0; j < dim; j++) {
        v[j] = p[j];
        d1[j] = k1 * q[j];
        d2[j] = k2 * r[j];
    }
}

void orr_uspline_eval(const orr_uspline *s, double t_s, double *value, double *d1, double *d2)
{
    double tau, spare1[ORR_USPLINE_MAX_DIM], spare2[ORR_USPLINE_MAX_DIM];
    size_t i = interval_of(s, t_s, &tau);
    const double *c = s->poly + i * ((size_t)s->degree + 1) * (size_t)s->dim;
    double k1 = 1.0 / s->step_s, k2 = 2.0 * k1 * k1;
    if (d1 == NULL) d1 = spare1;
    if (d2 == NULL) d2 = spare2;
    if (s->degree == 3 && s->dim == 3)
        horner(c, 3, 3, tau, k1, k2, value, d1, d2);
    else if (s->degree == 3 && s->dim == 4)
        horner(c, 3, 4, tau, k1, k2, value, d1, d2);
    else if (s->degree == 5 && s->dim == 3)
        horner(c, 5, 3, tau, k1, k2, value, d1, d2);
    else if (s->degree == 5 && s->dim == 4)
        horner(c, 5, 4, tau, k1, k2, value, d1, d2);
    else
        horner(c, s->degree, s->dim, tau, k1, k2, value, d1, d2);
}
