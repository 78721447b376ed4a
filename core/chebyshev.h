// SPDX-License-Identifier: GPL-3.0-or-later
// Chebyshev series on [-1, 1]: sum_{j=0}^{degree} c[j] T_j(x), the first coefficient not halved.
#ifndef ORR_CORE_CHEBYSHEV_H
#define ORR_CORE_CHEBYSHEV_H

#include "core/status.h"

#define ORR_CHEB_MAX_DEGREE 32

// The polynomials themselves at x, by recurrence.
//   Given:    degree   0 or more
//             x        in [-1, 1]
//   Returned: t        T_0(x) .. T_degree(x), degree + 1 values
//             d        their first derivatives, as many; may be NULL
//             dd       their second derivatives, as many; may be NULL
void orr_cheb_basis(int degree, double x, double *t, double *d, double *dd);
// Coefficients c[degree + 1] of the interpolant through value[degree + 1] at the Chebyshev-Lobatto points
// x_k = -cos(pi k / degree). degree: 0 to ORR_CHEB_MAX_DEGREE.
void orr_cheb_from_lobatto(int degree, const double *value, double *c);

#endif
