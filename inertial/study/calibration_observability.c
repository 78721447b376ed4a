// SPDX-License-Identifier: GPL-3.0-or-later
// What a plan shows of each parameter. Unknowns are counted in sizes that are usual of them, and readings in their sigma: a
// combination whose singular value is below 1 is told no better by the readings than it is known without, and is not seen.
#include <math.h>
#include <stdlib.h>

#include "core/linalg.h"
#include "inertial/study/calibration_private.h"

#define ROUNDING 1e-13
#define PART 0.05 // of a unit vector along what is not seen: less does not count

// The factor in usual sizes, and its singular value decomposition U S V'.
static orr_status prepare(const orr_calibration_result *r, const double *size, double *U, double *S,
                          double *V)
{
    const size_t n = r->n;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) U[i * n + k] = r->factor[i * n + k] * size[k];
    return orr_singular_values(U, n, n, S, V);
}

static void solve(orr_calibration_result *r, const double *U, const double *S, const double *V,
                  const double *size, const double *y, double *x)
{
    const size_t n = r->n, seen = n - r->unseen;
    for (size_t k = 0; k < n; k++) x[k] = 0;
    for (size_t m = 0; m < seen; m++) {
        double along = 0;
        for (size_t i = 0; i < n; i++) along += U[i * n + m] * y[i];
        for (size_t k = 0; k < n; k++) x[k] += V[k * n + m] * along / S[m] * size[k];
    }
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            double sum = 0;
            for (size_t m = 0; m < seen; m++) sum += V[i * n + m] * V[k * n + m] / (S[m] * S[m]);
            r->covariance[i * n + k] = sum * size[i] * size[k];
        }
}

static void correlate(orr_calibration_result *r)
{
    const size_t n = r->n;
    for (size_t i = 0; i < n; i++) {
        r->sigma[i] = r->seen[i] ? sqrt(r->covariance[i * n + i]) : (double)INFINITY;
        r->partner[i] = i;
        for (size_t k = 0; k < n; k++) {
            if (k == i || !r->seen[i] || !r->seen[k]) continue;
            const double c =
                r->covariance[i * n + k] / sqrt(r->covariance[i * n + i] * r->covariance[k * n + k]);
            if (fabs(c) > fabs(r->correlation[i]) || r->partner[i] == i) {
                r->correlation[i] = c;
                r->partner[i] = k;
            }
        }
    }
}

orr_status orr_calibration_decompose(orr_calibration_result *r, const double *size, const double *y,
                                     double *x, orr_diag *diag)
{
    const size_t n = r->n;
    double *room = malloc((2 * n * n + n) * sizeof *room);
    if (room == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu unknowns", n);
    double *U = room, *V = room + n * n, *S = V + n * n;
    if (prepare(r, size, U, S, V) != ORR_OK) {
        free(room);
        return orr_diag_set(diag, ORR_E_NUMERIC, "the readings of a plan have no numbers");
    }
    r->unseen = 0;
    while (r->unseen < n && !(S[n - 1 - r->unseen] > fmax(1.0, ROUNDING * S[0]))) r->unseen++;
    r->condition = S[n - 1] > 0 ? S[0] / S[n - 1] : (double)INFINITY;
    for (size_t k = 0; k < n; k++) {
        r->seen[k] = true;
        for (size_t m = n - r->unseen; m < n; m++)
            if (fabs(V[k * n + m]) > PART) r->seen[k] = false;
    }
    solve(r, U, S, V, size, y, x);
    correlate(r);
    free(room);
    return ORR_OK;
}
