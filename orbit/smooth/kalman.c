// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/kalman.h"

#include <string.h>

void orr_kalman_start(orr_gauss *g, double r_m, double v_mps, double f_mps2)
{
    memset(g, 0, sizeof *g);
    for (int i = 0; i < 3; i++) {
        g->P[i][i] = r_m * r_m;
        g->P[3 + i][3 + i] = v_mps * v_mps;
        g->P[6 + i][6 + i] = f_mps2 * f_mps2;
    }
}

// F P: the lower three rows of F are (0 0 E).
static void transit(const double F[6][ORR_NX], const double P[ORR_NX][ORR_NX], double out[ORR_NX][ORR_NX])
{
    memset(out, 0, 6 * sizeof out[0]);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < ORR_NX; k++)
            for (int j = 0; j < ORR_NX; j++) out[i][j] += F[i][k] * P[k][j];
    memcpy(out[6], P[6], 3 * sizeof out[0]);
}

// Covariance that white noise in d(f0)/dt (qf) and dV/dt (qv) builds up over a step h: integrals of the
// powers of time, with f0 acting on velocity through its axes.
static void add_noise(double P[ORR_NX][ORR_NX], const orr_mat3 *axes, double h, double qf, double qv)
{
    const double h2 = h * h, h3 = h2 * h;
    const double rr = qf * h3 * h2 / 20 + qv * h3 / 3, rv = qf * h2 * h2 / 8 + qv * h2 / 2,
                 vv = qf * h3 / 3 + qv * h;
    for (int i = 0; i < 3; i++) {
        P[i][i] += rr;
        P[i][3 + i] += rv;
        P[3 + i][i] += rv;
        P[3 + i][3 + i] += vv;
        P[6 + i][6 + i] += qf * h;
        for (int j = 0; j < 3; j++) {
            double b = axes->m[i][j];
            P[i][6 + j] += qf * h3 / 6 * b;
            P[6 + j][i] += qf * h3 / 6 * b;
            P[3 + i][6 + j] += qf * h2 / 2 * b;
            P[6 + j][3 + i] += qf * h2 / 2 * b;
        }
    }
}

void orr_kalman_predict(const orr_gauss *from, const orr_transition *t, double qf, double qv,
                        const double shift[6], orr_gauss *to)
{
    double T[ORR_NX][ORR_NX];
    transit(t->F, from->P, T);
    for (int i = 0; i < ORR_NX; i++) { // (F P) F'
        for (int j = i; j < 6; j++) {
            double sum = 0;
            for (int k = 0; k < ORR_NX; k++) sum += T[i][k] * t->F[j][k];
            to->P[i][j] = sum;
        }
        for (int j = i > 6 ? i : 6; j < ORR_NX; j++) to->P[i][j] = T[i][j];
    }
    for (int i = 0; i < ORR_NX; i++)
        for (int j = 0; j < i; j++) to->P[i][j] = to->P[j][i];
    add_noise(to->P, &t->axes, t->h_s, qf, qv);

    double x[ORR_NX];
    for (int i = 0; i < 6; i++) {
        x[i] = shift[i];
        for (int k = 0; k < ORR_NX; k++) x[i] += t->F[i][k] * from->x[k];
    }
    memcpy(x + 6, from->x + 6, 3 * sizeof *x);
    memcpy(to->x, x, sizeof x);
}

// Inverse of the innovation's covariance S = P_rr + sigma^2 E.
static orr_mat3 innovation_weight(const orr_gauss *g, double sigma)
{
    orr_mat3 s;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) s.m[i][j] = g->P[i][j] + (i == j ? sigma * sigma : 0);
    return orr_mat3_inverse(&s);
}

static orr_vec3 innovation(const orr_gauss *g, orr_vec3 z)
{
    return orr_vec3_sub(z, orr_vec3_make(g->x[0], g->x[1], g->x[2]));
}

double orr_kalman_innovation2(const orr_gauss *g, orr_vec3 z, double sigma, double *length_m)
{
    orr_vec3 e = innovation(g, z);
    orr_mat3 W = innovation_weight(g, sigma);
    if (length_m != NULL) *length_m = orr_vec3_norm(e);
    return orr_vec3_dot(e, orr_mat3_apply(&W, e)) / 3;
}

// Joseph's form: P = (E - K H) P (E - K H)' + sigma^2 K K', which keeps P positive whatever the rounding.
void orr_kalman_update(orr_gauss *g, orr_vec3 z, double sigma)
{
    orr_vec3 e = innovation(g, z);
    orr_mat3 W = innovation_weight(g, sigma);
    double K[ORR_NX][3], A[ORR_NX][ORR_NX], AP[ORR_NX][ORR_NX];
    for (int i = 0; i < ORR_NX; i++)
        for (int j = 0; j < 3; j++)
            K[i][j] = g->P[i][0] * W.m[0][j] + g->P[i][1] * W.m[1][j] + g->P[i][2] * W.m[2][j];
    for (int i = 0; i < ORR_NX; i++) {
        g->x[i] += K[i][0] * e.x + K[i][1] * e.y + K[i][2] * e.z;
        for (int j = 0; j < ORR_NX; j++) A[i][j] = (i == j ? 1.0 : 0.0) - (j < 3 ? K[i][j] : 0.0);
    }
    memset(AP, 0, sizeof AP);
    for (int i = 0; i < ORR_NX; i++)
        for (int k = 0; k < ORR_NX; k++)
            for (int j = 0; j < ORR_NX; j++) AP[i][j] += A[i][k] * g->P[k][j];
    for (int i = 0; i < ORR_NX; i++)
        for (int j = i; j < ORR_NX; j++) {
            double sum = sigma * sigma * (K[i][0] * K[j][0] + K[i][1] * K[j][1] + K[i][2] * K[j][2]);
            for (int k = 0; k < ORR_NX; k++) sum += AP[i][k] * A[j][k];
            g->P[i][j] = g->P[j][i] = sum;
        }
}

// Cholesky L L' of the correlation matrix of P with the scales taken out; false if not positive definite.
static bool cholesky(const double P[ORR_NX][ORR_NX], double scale[ORR_NX], double L[ORR_NX][ORR_NX])
{
    for (int i = 0; i < ORR_NX; i++) {
        if (!(P[i][i] > 0)) return false;
        scale[i] = 1.0 / sqrt(P[i][i]);
    }
    for (int i = 0; i < ORR_NX; i++)
        for (int j = 0; j <= i; j++) {
            double sum = P[i][j] * scale[i] * scale[j];
            for (int k = 0; k < j; k++) sum -= L[i][k] * L[j][k];
            if (i != j) {
                L[i][j] = sum / L[j][j];
            } else if (sum > 0) {
                L[i][i] = sqrt(sum);
            } else {
                return false;
            }
        }
    return true;
}

orr_status orr_kalman_smooth(const orr_gauss *f, const orr_transition *t, const orr_gauss *pred,
                             const orr_gauss *next, orr_gauss *out)
{
    // Gain J = P F' Ppred^-1, from Ppred J' = F P column by column.
    double scale[ORR_NX], L[ORR_NX][ORR_NX], Jt[ORR_NX][ORR_NX];
    if (!cholesky(pred->P, scale, L)) return ORR_E_NUMERIC;
    transit(t->F, f->P, Jt);
    for (int i = 0; i < ORR_NX; i++) { // forward, all columns at once
        for (int c = 0; c < ORR_NX; c++) Jt[i][c] *= scale[i];
        for (int k = 0; k < i; k++)
            for (int c = 0; c < ORR_NX; c++) Jt[i][c] -= L[i][k] * Jt[k][c];
        for (int c = 0; c < ORR_NX; c++) Jt[i][c] /= L[i][i];
    }
    for (int i = ORR_NX - 1; i >= 0; i--) { // backward
        for (int k = i + 1; k < ORR_NX; k++)
            for (int c = 0; c < ORR_NX; c++) Jt[i][c] -= L[k][i] * Jt[k][c];
        for (int c = 0; c < ORR_NX; c++) Jt[i][c] /= L[i][i];
    }
    for (int i = 0; i < ORR_NX; i++)
        for (int c = 0; c < ORR_NX; c++) Jt[i][c] *= scale[i];

    double D[ORR_NX][ORR_NX], DJt[ORR_NX][ORR_NX], x[ORR_NX];
    for (int i = 0; i < ORR_NX; i++) {
        x[i] = f->x[i];
        for (int k = 0; k < ORR_NX; k++) x[i] += Jt[k][i] * (next->x[k] - pred->x[k]);
        for (int j = 0; j < ORR_NX; j++) D[i][j] = next->P[i][j] - pred->P[i][j];
    }
    memset(DJt, 0, sizeof DJt);
    for (int i = 0; i < ORR_NX; i++)
        for (int k = 0; k < ORR_NX; k++)
            for (int c = 0; c < ORR_NX; c++) DJt[i][c] += D[i][k] * Jt[k][c];
    double P[ORR_NX][ORR_NX];
    for (int i = 0; i < ORR_NX; i++)
        for (int j = i; j < ORR_NX; j++) {
            double sum = f->P[i][j];
            for (int k = 0; k < ORR_NX; k++) sum += Jt[k][i] * DJt[k][j];
            P[i][j] = P[j][i] = sum;
        }
    memcpy(out->x, x, sizeof x);
    memcpy(out->P, P, sizeof P);
    return ORR_OK;
}
