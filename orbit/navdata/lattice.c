// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/lattice.h"

#include <math.h>
#include <string.h>

#define N ORR_LATTICE_MAX
#define MAX_SWAPS 4000 // a basis of 15 needs a few hundred

typedef struct lattice {
    size_t n;
    double r[N][N]; // upper triangular: the reduced basis
    double y[N];
    double t[N][N]; // the reduced basis in the old one: integers of determinant +-1
} lattice;

// Column k less the multiple of column j that leaves |r[j][k]| <= |r[j][j]|/2.
static void reduce(lattice *l, size_t j, size_t k)
{
    double m = round(l->r[j][k] / l->r[j][j]);
    if (fabs(m) < 0.5) return;
    for (size_t i = 0; i <= j; i++) l->r[i][k] -= m * l->r[i][j];
    for (size_t i = 0; i < l->n; i++) l->t[i][k] -= m * l->t[i][j];
}

// Columns k-1 and k change places; a rotation of rows k-1 and k makes the matrix triangular again.
static void swap(lattice *l, size_t k)
{
    for (size_t i = 0; i < l->n; i++) {
        double a = l->r[i][k - 1], b = l->t[i][k - 1];
        l->r[i][k - 1] = l->r[i][k], l->r[i][k] = a;
        l->t[i][k - 1] = l->t[i][k], l->t[i][k] = b;
    }
    double length = hypot(l->r[k - 1][k - 1], l->r[k][k - 1]);
    double c = l->r[k - 1][k - 1] / length, s = l->r[k][k - 1] / length;
    for (size_t i = k - 1; i < l->n; i++) {
        double a = l->r[k - 1][i], b = l->r[k][i];
        l->r[k - 1][i] = c * a + s * b, l->r[k][i] = c * b - s * a;
    }
    double a = l->y[k - 1], b = l->y[k];
    l->y[k - 1] = c * a + s * b, l->y[k] = c * b - s * a;
    l->r[k][k - 1] = 0;
}

static orr_status reduce_basis(lattice *l)
{
    int swaps = 0;
    for (size_t k = 1; k < l->n;) {
        reduce(l, k - 1, k);
        double a = l->r[k - 1][k - 1], b = l->r[k - 1][k], c = l->r[k][k];
        if (0.75 * a * a > b * b + c * c) {
            if (++swaps > MAX_SWAPS) return ORR_E_NUMERIC;
            swap(l, k);
            if (k > 1) k--;
        } else {
            for (size_t j = k - 1; j-- > 0;) reduce(l, j, k);
            k++;
        }
    }
    return ORR_OK;
}

// Where the best value of coordinate k lies, the ones above it being fixed.
static double centre(const lattice *l, size_t k, const double *x)
{
    double s = l->y[k];
    for (size_t j = k + 1; j < l->n; j++) s -= l->r[k][j] * x[j];
    return s / l->r[k][k];
}

static void search(const lattice *l, size_t max_nodes, double *best)
{
    double x[N] = {0}, c[N] = {0}, step[N] = {0}, above[N + 1] = {0}, found = HUGE_VAL;
    size_t k = l->n - 1, nodes = 0; // above[k]: distance^2 that the coordinates from k on have cost
    c[k] = centre(l, k, x);
    x[k] = round(c[k]);
    step[k] = c[k] >= x[k] ? 1 : -1;
    for (;;) {
        double off = l->r[k][k] * (x[k] - c[k]);
        above[k] = above[k + 1] + off * off;
        if (above[k] < found && k > 0) { // down to the next coordinate
            k--;
            c[k] = centre(l, k, x);
            x[k] = round(c[k]);
            step[k] = c[k] >= x[k] ? 1 : -1;
            continue;
        }
        if (above[k] < found) {
            found = above[k];
            memcpy(best, x, l->n * sizeof *x);
            if (max_nodes == 0) return;
        }
        // Nothing closer below here: up, and there the next value outward on alternate sides.
        if (++k == l->n || ++nodes > max_nodes) return;
        x[k] += step[k];
        step[k] = -step[k] - (step[k] > 0 ? 1 : -1);
    }
}

orr_status orr_lattice_closest(size_t n, const double *R, const double *y, size_t max_nodes, double *z)
{
    lattice l = {.n = n};
    if (n == 0 || n > N) return ORR_E_ARG;
    for (size_t i = 0; i < n; i++) {
        for (size_t j = i; j < n; j++) {
            l.r[i][j] = R[i * n + j];
            if (!isfinite(l.r[i][j])) return ORR_E_NUMERIC;
        }
        if (!(fabs(l.r[i][i]) > 0) || !isfinite(y[i])) return ORR_E_NUMERIC;
        l.y[i] = y[i];
        l.t[i][i] = 1;
    }
    orr_status s = reduce_basis(&l);
    if (s != ORR_OK) return s;
    double x[N];
    search(&l, max_nodes, x);
    for (size_t i = 0; i < n; i++) {
        z[i] = 0;
        for (size_t j = 0; j < n; j++) z[i] += l.t[i][j] * x[j];
    }
    return ORR_OK;
}
