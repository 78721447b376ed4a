// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/harmonics_private.h"

#include <assert.h>
#include <math.h>

// The recursions of Cunningham (1970).
void orr_place_harmonics(int degree, double lat_rad, double lon_rad, double *c, double *s)
{
    enum { N = ORR_HARMONICS_MOST + 1 };
    double v[N][N] = {{0}}, w[N][N] = {{0}};
    assert(degree <= ORR_HARMONICS_MOST);
    const double x = cos(lat_rad) * cos(lon_rad), y = cos(lat_rad) * sin(lon_rad), z = sin(lat_rad);
    v[0][0] = 1;
    for (int m = 0; m <= degree; m++) {
        if (m > 0) {
            v[m][m] = (2 * m - 1) * (x * v[m - 1][m - 1] - y * w[m - 1][m - 1]);
            w[m][m] = (2 * m - 1) * (x * w[m - 1][m - 1] + y * v[m - 1][m - 1]);
        }
        if (m == degree) break;
        v[m + 1][m] = (2 * m + 1) * z * v[m][m];
        w[m + 1][m] = (2 * m + 1) * z * w[m][m];
        for (int n = m + 2; n <= degree; n++) {
            v[n][m] = ((2 * n - 1) * z * v[n - 1][m] - (n + m - 1) * v[n - 2][m]) / (n - m);
            w[n][m] = ((2 * n - 1) * z * w[n - 1][m] - (n + m - 1) * w[n - 2][m]) / (n - m);
        }
    }
    for (int n = 0, k = 0; n <= degree; n++)
        for (int m = 0; m <= n; m++, k++) {
            c[k] = v[n][m];
            s[k] = w[n][m];
        }
}
