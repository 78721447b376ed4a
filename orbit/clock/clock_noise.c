// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/clock/clock_noise.h"

#include <math.h>
#include <stdlib.h>

#include "orbit/clock/clock_curve.h"

enum { LEAST_NODES = 20, N_LAGS = 8, N_KINDS = 3 };
static const size_t lag[N_LAGS] = {1, 2, 4, 8, 16, 24, 32, 48};

size_t orr_clock_lattice(const orr_clock_node *node, size_t n, double window_s, size_t *index)
{
    size_t m = 0;
    for (size_t k = n; k-- > 0;) {
        const double age_s = orr_time_diff_s(node[n - 1].t, node[k].t);
        if (age_s > window_s + 1e-3) break;
        const bool first = m == 0;
        if (!first && orr_time_diff_s(node[index[m - 1]].t, node[k].t) < ORR_CLOCK_LATTICE_S - 1e-3) continue;
        index[m++] = k;
    }
    for (size_t i = 0; i < m / 2; i++) {
        const size_t swap = index[i];
        index[i] = index[m - 1 - i];
        index[m - 1 - i] = swap;
    }
    return m;
}

// What is left of the clock beyond parabola and harmonic, in slots of the lattice; NAN in slots without a
// node.
static size_t residuals(const orr_clock_node *node, const size_t *index, size_t m, double *days,
                        double *value, double *slot)
{
    const orr_time end = node[index[m - 1]].t;
    orr_clock_curve curve;
    double *weight = slot; // not needed before the fit is done
    for (size_t i = 0; i < m; i++) {
        days[i] = orr_time_diff_s(node[index[i]].t, end) / ORR_S_PER_DAY;
        value[i] = node[index[i]].clock_s - node[index[m - 1]].clock_s;
        weight[i] = 1;
    }
    if (orr_clock_curve_fit(2, true, days, value, weight, m, &curve) != ORR_OK) return 0;
    const size_t n = (size_t)llround(-days[0] * ORR_S_PER_DAY / ORR_CLOCK_LATTICE_S) + 1;
    for (size_t i = 0; i < n; i++) slot[i] = (double)NAN;
    for (size_t i = 0; i < m; i++) {
        const size_t at = (size_t)llround((days[i] - days[0]) * ORR_S_PER_DAY / ORR_CLOCK_LATTICE_S);
        if (at < n) slot[at] = value[i] - orr_clock_curve_at(&curve, days[i]);
    }
    return n;
}

// Mean square of x(t + tau) - 2 x(t) + x(t - tau); how many of them.
static double second_difference(const double *x, size_t n, size_t step, size_t *count)
{
    double sum = 0;
    *count = 0;
    for (size_t i = 0; i + 2 * step < n; i++) {
        const double d = x[i + 2 * step] - 2 * x[i + step] + x[i];
        if (isnan(d)) continue;
        sum += d * d;
        ++*count;
    }
    return *count > 0 ? sum / (double)*count : 0;
}

// Least squares for the kinds of noise in `wanted` alone; false where one of them comes out negative.
static bool solve(double row[N_LAGS][N_KINDS], const double *right, size_t rows, unsigned wanted,
                  double q[N_KINDS], double *misfit)
{
    double a[N_KINDS][N_KINDS + 1] = {{0}};
    int kind[N_KINDS], n = 0;
    for (int k = 0; k < N_KINDS; k++)
        if (wanted & (1u << k)) kind[n++] = k;
    for (size_t r = 0; r < rows; r++)
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) a[i][j] += row[r][kind[i]] * row[r][kind[j]];
            a[i][N_KINDS] += row[r][kind[i]] * right[r];
        }
    for (int k = 0; k < n; k++) { // positive definite: no pivoting
        if (!(a[k][k] > 0)) return false;
        for (int i = 0; i < n; i++) {
            const double f = i != k ? a[i][k] / a[k][k] : 0;
            for (int j = 0; j <= N_KINDS && i != k; j++) a[i][j] -= f * a[k][j];
        }
    }
    for (int k = 0; k < N_KINDS; k++) q[k] = 0;
    for (int k = 0; k < n; k++) {
        q[kind[k]] = a[k][N_KINDS] / a[k][k];
        if (!(q[kind[k]] >= 0)) return false;
    }
    *misfit = 0;
    for (size_t r = 0; r < rows; r++) {
        double e = right[r];
        for (int k = 0; k < N_KINDS; k++) e -= row[r][k] * q[k];
        *misfit += e * e;
    }
    return true;
}

// Second differences of white phase noise have the variance 6 w, of a random walk 2 q tau, of a random walk
// of frequency 2/3 q tau^3. Each lag counts alike, relative to its own size: a prediction asks for the long
// ones, of which there are few differences.
static bool fit_kinds(const double *x, size_t n, orr_clock_noise *out)
{
    double row[N_LAGS][N_KINDS], right[N_LAGS], least = HUGE_VAL;
    size_t rows = 0;
    bool told = false;
    for (int k = 0; k < N_LAGS; k++) {
        size_t count;
        if (2 * lag[k] * 4 >= n * 3) break;
        const double v = second_difference(x, n, lag[k], &count), tau = (double)lag[k] * ORR_CLOCK_LATTICE_S;
        if (count < 5) continue;
        told = true;
        if (!(v > 0)) continue; // a clock that is a parabola to the last digit
        // In units in which a quarter of an hour is one, so that the columns are of one size.
        const double w = 1 / v;
        const double u = tau / ORR_CLOCK_LATTICE_S;
        row[rows][0] = 6 * w;
        row[rows][1] = 2 * u * w;
        row[rows][2] = 2.0 / 3 * u * u * u * w;
        right[rows++] = v * w;
    }
    for (unsigned wanted = 1; wanted < 1u << N_KINDS && rows > 0; wanted++) {
        double q[N_KINDS], misfit;
        if (!solve(row, right, rows, wanted, q, &misfit) || !(misfit < least)) continue;
        least = misfit;
        *out = (orr_clock_noise){q[0], q[1] / ORR_CLOCK_LATTICE_S,
                                 q[2] / (ORR_CLOCK_LATTICE_S * ORR_CLOCK_LATTICE_S * ORR_CLOCK_LATTICE_S)};
    }
    return told;
}

orr_status orr_clock_noise_fit(const orr_clock_node *node, size_t n, orr_clock_noise *out)
{
    *out = (orr_clock_noise){0};
    if (n < LEAST_NODES) return ORR_E_NODATA;
    const double span_s = orr_time_diff_s(node[n - 1].t, node[0].t);
    const size_t slots = (size_t)(span_s / ORR_CLOCK_LATTICE_S) + 2 + n;
    size_t *index = malloc(n * sizeof *index);
    double *days = malloc(3 * slots * sizeof *days);
    orr_status s = index != NULL && days != NULL ? ORR_OK : ORR_E_MEMORY;
    if (s == ORR_OK) {
        const size_t m = orr_clock_lattice(node, n, span_s, index);
        double *value = &days[slots], *slot = &days[2 * slots];
        const size_t filled = m >= LEAST_NODES ? residuals(node, index, m, days, value, slot) : 0;
        if (filled == 0 || !fit_kinds(slot, filled, out)) s = ORR_E_NODATA;
    }
    free(index);
    free(days);
    return s;
}
