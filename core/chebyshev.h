// SPDX-License-Identifier: GPL-3.0-or-later
// Chebyshev series on [-1, 1]: sum_{j=0}^{degree} c[j] T_j(x), the first coefficient not halved.
#ifndef ORR_CORE_CHEBYSHEV_H
#define ORR_CORE_CHEBYSHEV_H

#include "core/status.h"

#define ORR_CHEB_MAX_DEGREE 32

// Value, and first and second derivative with respect to x (dv, ddv may be NULL). Clenshaw.
double orr_cheb_eval(const double *c, int degree, double x, double *dv, double *ddv);
// T_j(x), T'_j(x), T''_j(x) for j = 0..degree, by recurrence. d, dd may be NULL.
void orr_cheb_basis(int degree, double x, double *t, double *d, double *dd);
// Coefficients of the interpolant through values at the degree+1 Chebyshev-Lobatto points x_k = -cos(pi k /
// degree).
void orr_cheb_from_lobatto(int degree, const double *value, double *c);
// Coefficients of the derivative series (degree-1).
void orr_cheb_differentiate(int degree, const double *c, double *dc);

#endif
