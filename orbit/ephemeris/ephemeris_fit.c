// SPDX-License-Identifier: GPL-3.0-or-later
// The fit of a segment: samples are equally spaced, so it is one matrix for all segments of the same shape.
#include <gsl/gsl_linalg.h>
#include <stdlib.h>
#include <string.h>

#include "core/chebyshev.h"
#include "orbit/ephemeris/ephemeris_private.h"

// How a velocity's misfit (times h) and an acceleration's (times h^2) count beside a position's. In units of
// the segment an error of the polynomial's last terms is n and n^2 times larger in them.
static double weight(int kind, int degree)
{
    return kind == 0 ? 1.0 : kind == 1 ? 1.0 / degree : 1.0 / (degree * degree);
}

int eph_fit_max_degree(size_t samples_per_segment)
{
    size_t n = 2 * samples_per_segment + 1;
    return n < EPH_MIN_DEGREE ? EPH_MIN_DEGREE : n > EPH_MAX_DEGREE ? EPH_MAX_DEGREE : (int)n;
}

// Chebyshev coefficients of the quintics that have one end value 1 and the other five 0: hermite[j][k], k =
// position at -1, +1, velocity at -1, +1, acceleration at -1, +1. By solving the 6 x 6 system of conditions.
static orr_status hermite_columns(double hermite[6][6])
{
    double rows[6][6];
    orr_cheb_basis(5, -1.0, rows[0], rows[2], rows[4]);
    orr_cheb_basis(5, 1.0, rows[1], rows[3], rows[5]);
    gsl_matrix_view m = gsl_matrix_view_array(&rows[0][0], 6, 6);
    size_t order[6];
    gsl_permutation p = {6, order};
    int sign;
    if (gsl_linalg_LU_decomp(&m.matrix, &p, &sign) != 0) return ORR_E_NUMERIC;
    for (size_t k = 0; k < 6; k++) {
        double unit[6] = {0}, solution[6];
        unit[k] = 1.0;
        gsl_vector_view b = gsl_vector_view_array(unit, 6), x = gsl_vector_view_array(solution, 6);
        if (gsl_linalg_LU_solve(&m.matrix, &p, &b.vector, &x.vector) != 0) return ORR_E_NUMERIC;
        for (size_t j = 0; j < 6; j++) hermite[j][k] = solution[j];
    }
    return ORR_OK;
}

// Chebyshev coefficients of (1 - x^2)^3 T_k(x), which vanishes with two derivatives at both ends; length k
// + 7.
static void bubble(size_t k, double *c)
{
    size_t n = k + 7;
    memset(c, 0, n * sizeof *c);
    c[k] = 1.0;
    for (int times = 0; times < 3; times++) {
        // (1 - x^2) T_j = T_j / 2 - (T_{j+2} + T_|j-2|) / 4
        double next[EPH_MAX_DEGREE + 3] = {0};
        for (size_t j = 0; j < n; j++) {
            if (c[j] == 0.0) continue;
            next[j] += 0.5 * c[j];
            next[j + 2] -= 0.25 * c[j];
            next[j >= 2 ? j - 2 : 2 - j] -= 0.25 * c[j];
        }
        memcpy(c, next, n * sizeof *c);
    }
}

// Least squares of the free part: on top of the quintic through the ends, bubbles over the misfit at all
// samples. matrix = H E + N P (1 - B H E), where E picks the end values of the data.
static orr_status solve(eph_fit *f, double hermite[6][6], gsl_matrix *bn, gsl_vector *tau)
{
    size_t n = (size_t)f->degree + 1, rows = 3 * f->samples, free_n = n - 6, last = f->samples - 1;
    const size_t end_column[6] = {
        0, last, f->samples, f->samples + last, 2 * f->samples, 2 * f->samples + last};
    for (size_t k = 0; k < 6; k++)
        for (size_t j = 0; j < 6; j++) f->matrix[j * rows + end_column[k]] = hermite[j][k];
    if (free_n == 0) return ORR_OK;

    double bubbles[EPH_MAX_DEGREE + 1][EPH_MAX_DEGREE + 1];
    for (size_t k = 0; k < free_n; k++) bubble(k, bubbles[k]);
    for (size_t r = 0; r < rows; r++) {
        double w = weight((int)(r / f->samples), f->degree);
        for (size_t k = 0; k < free_n; k++) {
            double s = 0;
            for (size_t j = 0; j < k + 7; j++) s += f->basis[r * n + j] * bubbles[k][j];
            gsl_matrix_set(bn, r, k, w * s);
        }
    }
    if (gsl_linalg_QR_decomp(bn, tau) != 0) return ORR_E_NUMERIC;

    double rhs[3 * (EPH_MAX_SAMPLES_PER_SEGMENT + 1)], residual[3 * (EPH_MAX_SAMPLES_PER_SEGMENT + 1)];
    double y[EPH_MAX_DEGREE + 1];
    for (size_t column = 0; column < rows; column++) {
        for (size_t r = 0; r < rows; r++) {
            double v = r == column ? 1.0 : 0.0;
            for (size_t j = 0; j < 6; j++) v -= f->basis[r * n + j] * f->matrix[j * rows + column];
            rhs[r] = v * weight((int)(r / f->samples), f->degree);
        }
        gsl_vector_view b = gsl_vector_view_array(rhs, rows), res = gsl_vector_view_array(residual, rows);
        gsl_vector_view x = gsl_vector_view_array(y, free_n);
        if (gsl_linalg_QR_lssolve(bn, tau, &b.vector, &x.vector, &res.vector) != 0) return ORR_E_NUMERIC;
        for (size_t k = 0; k < free_n; k++)
            for (size_t j = 0; j < k + 7; j++) f->matrix[j * rows + column] += y[k] * bubbles[k][j];
    }
    return ORR_OK;
}

orr_status eph_fit_init(int degree, size_t samples_per_segment, eph_fit *f, orr_diag *diag)
{
    size_t n = (size_t)degree + 1;
    *f = (eph_fit){.degree = degree, .samples = samples_per_segment + 1};
    if (degree < EPH_MIN_DEGREE || degree > eph_fit_max_degree(samples_per_segment) ||
        samples_per_segment < 1 || samples_per_segment > EPH_MAX_SAMPLES_PER_SEGMENT)
        return orr_diag_set(diag, ORR_E_ARG, "no fit of degree %d to %zu samples a segment", degree,
                            samples_per_segment);
    size_t rows = 3 * f->samples, free_n = n - 6;
    f->matrix = calloc(n * rows, sizeof *f->matrix);
    f->basis = calloc(rows * n, sizeof *f->basis);
    gsl_matrix *bn = gsl_matrix_calloc(rows, free_n > 0 ? free_n : 1);
    gsl_vector *tau = gsl_vector_calloc(free_n > 0 ? free_n : 1);
    orr_status s = ORR_OK;
    if (f->matrix == NULL || f->basis == NULL || bn == NULL || tau == NULL) {
        s = orr_diag_set(diag, ORR_E_MEMORY, "no memory for the fit of a segment");
    } else {
        for (size_t i = 0; i < f->samples; i++) {
            double x = i == samples_per_segment ? 1.0 : 2.0 * (double)i / (double)samples_per_segment - 1.0;
            orr_cheb_basis(degree, x, &f->basis[i * n], &f->basis[(f->samples + i) * n],
                           &f->basis[(2 * f->samples + i) * n]);
        }
        double hermite[6][6];
        s = hermite_columns(hermite);
        if (s == ORR_OK) s = solve(f, hermite, bn, tau);
        if (s != ORR_OK)
            orr_diag_set(diag, s, "the fit of degree %d to %zu samples is singular", degree, f->samples);
    }
    gsl_matrix_free(bn);
    gsl_vector_free(tau);
    if (s != ORR_OK) eph_fit_free(f);
    return s;
}

void eph_fit_free(eph_fit *f)
{
    free(f->matrix);
    free(f->basis);
    *f = (eph_fit){0};
}

void eph_fit_apply(const eph_fit *f, const double *data, double *coef)
{
    size_t n = (size_t)f->degree + 1, rows = 3 * f->samples;
    double left[3 * (EPH_MAX_SAMPLES_PER_SEGMENT + 1)];
    memcpy(left, data, rows * sizeof *left);
    memset(coef, 0, n * sizeof *coef);
    // Twice: the second turn takes up what the first lost to rounding of numbers of 1e7 m, so that
    // neighbouring segments meet to nanometres.
    for (int turn = 0; turn < 2; turn++) {
        for (size_t j = 0; j < n; j++) {
            double s = 0;
            for (size_t r = 0; r < rows; r++) s += f->matrix[j * rows + r] * left[r];
            coef[j] += s;
        }
        if (turn == 1) break;
        for (size_t r = 0; r < rows; r++) {
            double s = data[r];
            for (size_t j = 0; j < n; j++) s -= f->basis[r * n + j] * coef[j];
            left[r] = s;
        }
    }
}
