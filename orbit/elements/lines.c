// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/elements/lines.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/linalg.h"

enum { TREND = 4, UNKNOWNS = TREND + 2 };

orr_status orr_line_amplitude(const double *t, const double *y, size_t n, double period, bool windowed,
                              double *amplitude, double *explained, orr_diag *diag)
{
    double a[UNKNOWNS][UNKNOWNS] = {{0}}, b[UNKNOWNS] = {0}, first, last, mean = 0, weights = 0;
    if (n < UNKNOWNS || !(period > 0))
        return orr_diag_set(diag, ORR_E_ARG, "a period needs %d values and has to be above nothing",
                            UNKNOWNS);
    first = last = t[0];
    for (size_t i = 0; i < n; i++) {
        first = fmin(first, t[i]);
        last = fmax(last, t[i]);
        mean += y[i] / (double)n;
    }
    const double middle = 0.5 * (first + last), half = fmax(0.5 * (last - first), 1e-300);
    for (size_t i = 0; i < n; i++) {
        const double x = (t[i] - middle) / half, phase = 2 * ORR_PI * (t[i] - middle) / period;
        const double wave = cos(0.5 * ORR_PI * x), weight = windowed ? wave * wave : 1;
        const double row[UNKNOWNS] = {1, x, x * x, x * x * x, cos(phase), sin(phase)};
        weights += weight;
        for (int j = 0; j < UNKNOWNS; j++) {
            b[j] += weight * row[j] * (y[i] - mean);
            for (int k = 0; k <= j; k++) a[j][k] += weight * row[j] * row[k];
        }
    }
    // What a fit takes from the squares is its solution times the right-hand side.
    double trend[TREND][TREND], right[UNKNOWNS], alone[TREND];
    for (int j = 0; j < TREND; j++)
        for (int k = 0; k < TREND; k++) trend[j][k] = a[j][k];
    memcpy(right, b, sizeof right);
    memcpy(alone, b, sizeof alone);
    orr_status s = orr_symmetric_solve(&a[0][0], UNKNOWNS, UNKNOWNS, b, 1);
    if (s == ORR_OK) s = orr_symmetric_solve(&trend[0][0], TREND, TREND, alone, 1);
    if (s != ORR_OK)
        return orr_diag_set(diag, s, "the series cannot tell a period of %g from its trend", period);
    *amplitude = hypot(b[TREND], b[TREND + 1]);
    if (explained != NULL) {
        double taken = 0;
        for (int j = 0; j < UNKNOWNS; j++) taken += right[j] * (b[j] - (j < TREND ? alone[j] : 0));
        *explained = sqrt(2 * fmax(taken, 0) / weights);
    }
    return ORR_OK;
}
