// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/chebyshev.h"

#include <assert.h>
#include <math.h>

#include "core/constants.h"

void orr_cheb_basis(int degree, double x, double *t, double *d, double *dd)
{
    double d1 = 0, d2 = 0; // T'_{j-1}, T'_{j-2}: the second derivative needs them where d is not wanted too
    for (int j = 0; j <= degree; j++) {
        t[j] = j == 0 ? 1 : j == 1 ? x : 2 * x * t[j - 1] - t[j - 2];
        const double slope = j == 0 ? 0 : j == 1 ? 1 : 2 * t[j - 1] + 2 * x * d1 - d2;
        if (d != NULL) d[j] = slope;
        if (dd != NULL) dd[j] = j <= 1 ? 0 : 4 * d1 + 2 * x * dd[j - 1] - dd[j - 2];
        d2 = d1;
        d1 = slope;
    }
}

void orr_cheb_from_lobatto(int degree, const double *value, double *c)
{
    assert(degree >= 0 && degree <= ORR_CHEB_MAX_DEGREE);
    if (degree == 0) {
        c[0] = value[0];
        return;
    }
    // cos(pi j k / n) from a table: its argument has period 2 n in j k
    double cosine[2 * ORR_CHEB_MAX_DEGREE];
    for (int i = 0; i < 2 * degree; i++) cosine[i] = cos(ORR_PI * i / degree);
    for (int j = 0; j <= degree; j++) {
        double sum = 0;
        for (int k = 0; k <= degree; k++) {
            double weight = k == 0 || k == degree ? 0.5 : 1.0;
            sum += weight * value[degree - k] * cosine[j * k % (2 * degree)];
        }
        c[j] = sum * (j == 0 || j == degree ? 1.0 : 2.0) / degree;
    }
}
