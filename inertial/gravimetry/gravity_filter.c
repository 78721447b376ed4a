// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/gravimetry/gravity_filter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/constants.h"

#define MPS2_PER_MGAL 1e-5

double orr_gravity_filter_edge_s(const orr_gravity_filter *f)
{
    switch (f->kind) {
    case ORR_GRAVITY_FIR:
        return f->length_s;
    case ORR_GRAVITY_KALMAN:
        return 2.0 * f->length_s;
    case ORR_GRAVITY_GAUSSIAN:
        break;
    }
    return 3.0 * f->length_s;
}

// --- Weights that are the same before and after ---

// out[i]: weights w[0..half] over x, renormalised where they reach past the ends.
static void convolve(const double *w, size_t half, const double *x, size_t n, double *out)
{
    for (size_t i = 0; i < n; i++) {
        double sum = w[0] * x[i], weight = w[0];
        for (size_t d = 1; d <= half; d++) {
            if (d <= i) {
                sum += w[d] * x[i - d];
                weight += w[d];
            }
            if (i + d < n) {
                sum += w[d] * x[i + d];
                weight += w[d];
            }
        }
        out[i] = sum / weight;
    }
}

static double gaussian_weight(double t, double sigma) { return exp(-0.5 * t * t / (sigma * sigma)); }

// sin(2 pi t / T) / (pi t) under cos^2(pi t / 2T), |t| <= T.
static double fir_weight(double t, double period)
{
    const double a = 2.0 * ORR_PI * t / period, c = cos(0.5 * ORR_PI * t / period);
    return (fabs(a) > 1e-9 ? sin(a) / a : 1.0) * c * c;
}

static orr_status apply_weights(const orr_gravity_filter *f, const double *x, size_t n, double step_s,
                                double *out, orr_diag *diag)
{
    const bool fir = f->kind == ORR_GRAVITY_FIR;
    const size_t reach = (size_t)ceil((fir ? 1.0 : 4.0) * f->length_s / step_s),
                 half = reach < n ? reach : n - 1;
    double *w = malloc((half + 1) * sizeof *w);
    if (w == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for a filter of %zu weights", half);
    for (size_t d = 0; d <= half; d++) {
        const double t = (double)d * step_s;
        w[d] = fir ? (t < f->length_s ? fir_weight(t, f->length_s) : 0.0) : gaussian_weight(t, f->length_s);
    }
    convolve(w, half, x, n, out);
    free(w);
    return ORR_OK;
}

// --- Kalman smoother ---

enum { STATES = 4 }; // height, its rate, gravity, its rate

typedef struct step {
    double x[STATES], P[STATES][STATES];   // filtered
    double xp[STATES], Pp[STATES][STATES]; // predicted from the step before
} step;

static void multiply(double a[STATES][STATES], double b[STATES][STATES], bool transposed,
                     double out[STATES][STATES])
{
    double c[STATES][STATES];
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j < STATES; j++) {
            c[i][j] = 0;
            for (int k = 0; k < STATES; k++) c[i][j] += a[i][k] * (transposed ? b[j][k] : b[k][j]);
        }
    memcpy(out, c, sizeof c);
}

// Transition over T and its noise: heights by gravity at the begin, gravity exactly.
static void transition(const orr_gravity_filter *f, double T, double F[STATES][STATES],
                       double Q[STATES][STATES])
{
    const double b = 1.0 / f->length_s, e = exp(-b * T), s2 = pow(f->model_mgal * MPS2_PER_MGAL, 2);
    const double A[STATES][STATES] = {{1, T, 0.5 * T * T, T * T * T / 6},
                                      {0, 1, T, 0.5 * T * T},
                                      {0, 0, e * (1 + b * T), e * T},
                                      {0, 0, -b * b * e * T, e * (1 - b * T)}};
    memcpy(F, A, sizeof A);
    // Q of gravity is what keeps it stationary.
    double P[2][2] = {{s2, 0}, {0, b * b * s2}}, out[2][2];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            out[i][j] = P[i][j] - F[2 + i][2] * P[0][0] * F[2 + j][2] - F[2 + i][3] * P[1][1] * F[2 + j][3];
    memset(Q, 0, STATES * sizeof *Q);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) Q[2 + i][2 + j] = out[i][j];
}

// G = P F' Pp^-1, by Gauss and Jordan on the symmetric Pp; its diagonal spans many decades, so it is scaled.
static void gain(double P[STATES][STATES], double F[STATES][STATES], double Pp[STATES][STATES],
                 double G[STATES][STATES])
{
    double a[STATES][2 * STATES], s[STATES], C[STATES][STATES];
    for (int i = 0; i < STATES; i++) s[i] = sqrt(Pp[i][i]);
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j < STATES; j++) {
            a[i][j] = Pp[i][j] / (s[i] * s[j]);
            a[i][STATES + j] = i == j ? 1.0 : 0.0;
        }
    for (int k = 0; k < STATES; k++) {
        const double pivot = a[k][k];
        for (int j = 0; j < 2 * STATES; j++) a[k][j] /= pivot;
        for (int i = 0; i < STATES; i++) {
            const double m = a[i][k];
            if (i == k) continue;
            for (int j = 0; j < 2 * STATES; j++) a[i][j] -= m * a[k][j];
        }
    }
    double I[STATES][STATES];
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j < STATES; j++) I[i][j] = a[i][STATES + j] / (s[i] * s[j]);
    multiply(P, F, true, C);
    multiply(C, I, false, G);
}

static void forward(const orr_gravity_filter *f, double F[STATES][STATES], double Q[STATES][STATES], double z,
                    step *now, const step *before)
{
    if (before != NULL) {
        for (int i = 0; i < STATES; i++) {
            now->xp[i] = 0;
            for (int k = 0; k < STATES; k++) now->xp[i] += F[i][k] * before->x[k];
        }
        double P[STATES][STATES], FP[STATES][STATES];
        memcpy(P, before->P, sizeof P);
        multiply(F, P, false, FP);
        multiply(FP, F, true, now->Pp);
        for (int i = 0; i < STATES; i++)
            for (int j = 0; j < STATES; j++) now->Pp[i][j] += Q[i][j];
    }
    const double R = f->place_m * f->place_m, S = now->Pp[0][0] + R;
    double K[STATES];
    for (int i = 0; i < STATES; i++) K[i] = now->Pp[i][0] / S;
    for (int i = 0; i < STATES; i++) now->x[i] = now->xp[i] + K[i] * (z - now->xp[0]);
    for (int i = 0; i < STATES; i++)
        for (int j = 0; j < STATES; j++) // Joseph's form, which stays positive
            now->P[i][j] = now->Pp[i][j] - K[i] * now->Pp[0][j] - now->Pp[i][0] * K[j] + K[i] * S * K[j];
}

static orr_status smooth(const orr_gravity_filter *f, const double *x, size_t n, double T, double *out,
                         orr_diag *diag)
{
    step *s = calloc(n, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "no memory for %zu steps of a smoother", n);
    double mean = 0, F[STATES][STATES], Q[STATES][STATES], p = 0, v = 0;
    for (size_t k = 0; k < n; k++) mean += x[k] / (double)n;
    transition(f, T, F, Q);
    const double g = f->model_mgal * MPS2_PER_MGAL, b = 1.0 / f->length_s;
    const double start[STATES] = {pow(100 * f->place_m + 1, 2), 1.0, g * g, b * b * g * g};
    for (int i = 0; i < STATES; i++) s[0].Pp[i][i] = start[i];
    for (size_t k = 0; k < n; k++) { // heights at the middle of each step, by twice summing
        const double a = (x[k] - mean) * MPS2_PER_MGAL;
        forward(f, F, Q, p, &s[k], k > 0 ? &s[k - 1] : NULL);
        const double next = k + 1 < n ? (x[k + 1] - mean) * MPS2_PER_MGAL : a;
        p += v * T + T * T * (a / 3 + next / 6); // acceleration linear between middles
        v += 0.5 * (a + next) * T;
    }
    double xs[STATES];
    memcpy(xs, s[n - 1].x, sizeof xs);
    out[n - 1] = xs[2] / MPS2_PER_MGAL + mean;
    for (size_t k = n - 1; k-- > 0;) {
        double G[STATES][STATES], y[STATES];
        gain(s[k].P, F, s[k + 1].Pp, G);
        for (int i = 0; i < STATES; i++) {
            y[i] = s[k].x[i];
            for (int j = 0; j < STATES; j++) y[i] += G[i][j] * (xs[j] - s[k + 1].xp[j]);
        }
        memcpy(xs, y, sizeof xs);
        out[k] = xs[2] / MPS2_PER_MGAL + mean;
    }
    free(s);
    return ORR_OK;
}

orr_status orr_gravity_filter_apply(const orr_gravity_filter *f, const double *x, size_t n, double step_s,
                                    double *out, orr_diag *diag)
{
    if (!(f->length_s > 0) || !(step_s > 0))
        return orr_diag_set(diag, ORR_E_ARG, "a filter of %g s on steps of %g s; both are above 0",
                            f->length_s, step_s);
    if (n < 2 || (double)n * step_s < 2.0 * orr_gravity_filter_edge_s(f))
        return orr_diag_set(diag, ORR_E_ARG,
                            "a filter whose ends take %g s each needs more than a series of %g s",
                            orr_gravity_filter_edge_s(f), (double)n * step_s);
    if (f->kind != ORR_GRAVITY_KALMAN) return apply_weights(f, x, n, step_s, out, diag);
    if (!(f->model_mgal > 0) || !(f->place_m > 0))
        return orr_diag_set(diag, ORR_E_ARG,
                            "a smoother wants a gravity of more than %g mGal and heights to more than %g m",
                            f->model_mgal, f->place_m);
    return smooth(f, x, n, step_s, out, diag);
}
