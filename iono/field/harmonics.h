// SPDX-License-Identifier: GPL-3.0-or-later
// Surface spherical harmonics, as the maps of vertical TEC are written in (Bogdanov 2015, eq. (35)):
//     E(beta, s) = sum_{n <= N} sum_{m <= n} Pnm(sin beta) (a_nm cos m s + b_nm sin m s)
// with Pnm normalised by sqrt((2n+1) (2 - d0m) (n-m)!/(n+m)!) and no Condon-Shortley phase (Schaer 1999, eq.
// (4.4)). Laid out for speed: the recurrence in n - m runs over all orders at once, so a plain loop is a
// vector loop.
#ifndef ORR_IONO_FIELD_HARMONICS_H
#define ORR_IONO_FIELD_HARMONICS_H

#include "core/status.h"

#define ORR_HARM_MAX_DEGREE 32
#define ORR_HARM_MAX_ROW (ORR_HARM_MAX_DEGREE + 4) // doubles in the longest row

// Tables of one degree. A coefficient array that belongs to it has `size` doubles: rows k = n - m =
// 0..degree, each `stride` cosine terms (by m) and then `stride` sine terms; what is no coefficient is zero.
typedef struct orr_harm_basis {
    int degree;
    size_t stride;        // degree + 1, rounded up to a multiple of four
    size_t size;          // doubles in a coefficient array
    size_t n_coef;        // (degree + 1)^2
    double *alpha, *beta; // [k stride + m]: P(m+k,m) = alpha x P(m+k-1,m) - beta P(m+k-2,m)
    double *sectoral;     // [m]: P(m,m) = sectoral[m] cos(beta) P(m-1,m-1)
} orr_harm_basis;

// degree 0..ORR_HARM_MAX_DEGREE, else ORR_E_ARG. Free with orr_harm_basis_free.
orr_status orr_harm_basis_init(int degree, orr_harm_basis *out, orr_diag *diag);
// Frees the tables; harmless on a basis that is all zeroes.
void orr_harm_basis_free(orr_harm_basis *b);

// Where a_nm (m >= 0) or b_n|m| (m < 0) lives in a coefficient array. 0 <= |m| <= n <= degree.
static inline size_t orr_harm_slot(const orr_harm_basis *b, int n, int m)
{
    size_t order = (size_t)(m < 0 ? -m : m);
    return (2 * ((size_t)n - order) + (m < 0 ? 1 : 0)) * b->stride + order;
}

// Sum of the expansion at one point.
// Given:
//   b                 tables of the degree
//   coef              [b->size] coefficient array
//   sin_lat, cos_lat  of the point's latitude in the expansion's axes; cos_lat >= 0
//   sin_lon, cos_lon  of its longitude there
// Returned: the value, in the unit of the coefficients.
// Notes: orders are summed by Clenshaw's recurrence.
// Reference: Bogdanov 2015, eq. (35); Schaer 1999, eq. (4.4).
double orr_harm_eval(const orr_harm_basis *b, const double *coef, double sin_lat, double cos_lat,
                     double sin_lon, double cos_lon);
// The basis functions at one point: a row of the design matrix of a fit.
// Given:
//   b                 tables of the degree
//   sin_lat, cos_lat  of the point's latitude in the expansion's axes; cos_lat >= 0
//   sin_lon, cos_lon  of its longitude there
// Returned:
//   row               [b->n_coef], listed by n = 0.. and within each n by m = 0, 1, -1, 2, -2, .. (as Bernese files
//                     list them)
void orr_harm_row(const orr_harm_basis *b, double sin_lat, double cos_lat, double sin_lon, double cos_lon,
                  double *row);
// Turns n_coef coefficients listed in the order of orr_harm_row into a coefficient array of `size`.
void orr_harm_unpack(const orr_harm_basis *b, const double *listed, double *coef);
// The way back: a coefficient array to n_coef coefficients in the order of orr_harm_row.
void orr_harm_pack(const orr_harm_basis *b, const double *coef, double *listed);
// The same function seen in axes turned about the pole: longitude' = longitude - turn. in and out may be one
// array.
void orr_harm_turn(const orr_harm_basis *b, double turn_rad, const double *in, double *out);

#endif
