// SPDX-License-Identifier: GPL-3.0-or-later
// Linear systems, solved by GSL in memory of the caller's: nothing allocates. Matrices are row-major.
//
// GSL's error handler must be off (gsl_set_error_handler_off in main): failures come back as ORR_E_NUMERIC.
#ifndef ORR_CORE_LINALG_H
#define ORR_CORE_LINALG_H

#include "core/status.h"

// --- Symmetric positive definite systems ---

// Factor L of a = L L', lower triangle of a[n][n], in place; a's lower triangle is read. ORR_E_NUMERIC where a
// is not positive definite, or a pivot (a diagonal element of L, squared) is not above `least_pivot` times a's
// largest diagonal element. What is above the diagonal afterwards means nothing.
orr_status orr_cholesky_factor(double *a, size_t n, double least_pivot);
// x of L L' x = b; x[n] holds b before.
orr_status orr_cholesky_solve(const double *l, size_t n, double *x);
// x of L x = b; x[n] holds b before.
orr_status orr_cholesky_solve_lower(const double *l, size_t n, double *x);
// (L L')^-1 in place of L, both triangles.
orr_status orr_cholesky_invert(double *l, size_t n);

#define ORR_SYMMETRIC_MOST 64
// A small system whose unknowns may be of quite different sizes, by one call: x of a x = b for `columns` right sides, with
// the diagonal of a scaled to ones first.
//   Given:    a        lower triangle of a symmetric matrix, overwritten
//             stride   doubles from row to row of a
//             n        rows, ORR_SYMMETRIC_MOST at most
//             b        [n][columns], the right sides
//   Returned: b        the solutions
//   Notes:    ORR_E_NUMERIC where a is not positive definite, or so nearly not that less than 1e-14 of a diagonal element is
//             left; ORR_E_ARG where n is too large.
orr_status orr_symmetric_solve(double *a, size_t stride, size_t n, double *b, size_t columns);

// Factor of a band matrix in place, for orr_band_factored: a[n][band + 1], a[i][d] the element of row i + d and column i, 0
// beyond the last row; band below n. ORR_E_NUMERIC where a is not positive definite.
orr_status orr_band_factor(double *a, size_t n, size_t band);
// x of a x = b by it; x[n] holds b before.
orr_status orr_band_factored(const double *factor, size_t n, size_t band, double *x);
// Both by one call: x of a x = b for `columns` right sides. ORR_E_NUMERIC where a is not positive definite.
//   Given:    a        [n][band + 1], a[i][d] the element of row i + d and column i, 0 beyond the last row; it
//                      is overwritten
//             n, band  rows, and diagonals below the main one (fewer than n)
//             x        [n][columns], the right sides
//   Returned: x        the solutions
orr_status orr_band_solve(double *a, size_t n, size_t band, double *x, size_t columns);

// --- Least squares ---

// x[n] that makes the length of a x - b least, by Householder's QR. rows >= n.
//   Given:    a    [rows][n], overwritten with R in its upper triangle
//             b    [rows], overwritten with Q' b
//             tau  [n], workspace
//   Returned: x    [n]; NULL leaves it at the triangular system R x = (Q' b)[0..n-1]
//   Notes:    ORR_E_NUMERIC where the columns of a depend on each other.
orr_status orr_least_squares(double *a, size_t rows, size_t n, double *b, double *tau, double *x);

// U S V' of a, U in its place: singular values descend. rows >= n.
//   Given:    a    [rows][n]
//   Returned: a    U
//             s    [n]
//             v    [n][n], V and not its transpose
//   Notes:    ORR_E_NUMERIC where a has no numbers, ORR_E_MEMORY. By one-sided Jacobi rotations (Demmel and Veselic 1992), which
//             keeps small singular values to their own digits.
orr_status orr_singular_values(double *a, size_t rows, size_t n, double *s, double *v);

#endif
