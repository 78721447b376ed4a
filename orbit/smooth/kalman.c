// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/kalman.h"

#include <string.h>

// The loops below run over nine or eighteen unknowns; a compiler that knows which makes them twice as fast.
#define FOR_SIZE(nx, call9, call18)                                                                          \
    do {                                                                                                     \
        if ((nx) == ORR_NX_PLAIN)                                                                            \
            call9;                                                                                           \
        else                                                                                                 \
            call18;                                                                                          \
    } while (0)

static inline void keep_half(const double *full, size_t stride, int n, double *half)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) *half++ = full[(size_t)i * stride + (size_t)j];
}

static inline void recall_half(const double *half, size_t stride, int n, double *full)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++)
            full[(size_t)i * stride + (size_t)j] = full[(size_t)j * stride + (size_t)i] = *half++;
}

void orr_gauss_keep(const orr_gauss *g, int nx, orr_gauss_kept *out)
{
    memcpy(out->x, g->x, (size_t)nx * sizeof out->x[0]);
    FOR_SIZE(nx, keep_half(&g->P[0][0], ORR_NX, ORR_NX_PLAIN, out->P),
             keep_half(&g->P[0][0], ORR_NX, ORR_NX, out->P));
}

void orr_gauss_recall(const orr_gauss_kept *g, int nx, orr_gauss *out)
{
    memcpy(out->x, g->x, (size_t)nx * sizeof out->x[0]);
    FOR_SIZE(nx, recall_half(g->P, ORR_NX, ORR_NX_PLAIN, &out->P[0][0]),
             recall_half(g->P, ORR_NX, ORR_NX, &out->P[0][0]));
}

void orr_transition_keep(const orr_transition *t, orr_transition_kept *out)
{
    memcpy(out->F, t->F, sizeof out->F);
    keep_half(&t->Q[0][0], ORR_NW, ORR_NW, out->Q);
    keep_half(&t->S[0][0], ORR_NW, ORR_NW, out->S);
    out->near_shadow = t->near_shadow;
}

void orr_transition_recall(const orr_transition_kept *t, orr_transition *out)
{
    memcpy(out->F, t->F, sizeof out->F);
    recall_half(t->Q, ORR_NW, ORR_NW, &out->Q[0][0]);
    recall_half(t->S, ORR_NW, ORR_NW, &out->S[0][0]);
    out->near_shadow = t->near_shadow;
}

void orr_transition_start(orr_transition *t)
{
    memset(t, 0, sizeof *t);
    for (int i = 0; i < 6; i++) t->F[i][i] = 1;
}

// Covariance that white noise in d(f0)/dt (qf) and dV/dt (qv) builds up over a step h: integrals of the
// powers of time, with f0 acting on velocity through its axes.
static void add_noise(double P[ORR_NW][ORR_NW], const orr_mat3 *axes, double h, double qf, double qv)
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

void orr_noise_expected(const orr_mat3 *axes, double h, double qf, double qv, const double b[ORR_NW],
                        double w[ORR_NW])
{
    double Q[ORR_NW][ORR_NW];
    memset(Q, 0, sizeof Q);
    add_noise(Q, axes, h, qf, qv);
    for (int i = 0; i < ORR_NW; i++) {
        w[i] = 0;
        for (int j = 0; j < ORR_NW; j++) w[i] += Q[i][j] * b[j];
    }
}

// Q -> A Q A' with A = (F; 0 0 E), the first nine columns.
static void carry_noise(double Q[ORR_NW][ORR_NW], double F[6][ORR_NX])
{
    double T[6][ORR_NW];
    memset(T, 0, sizeof T);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < ORR_NW; k++)
            for (int j = 0; j < ORR_NW; j++) T[i][j] += F[i][k] * Q[k][j];
    for (int i = 0; i < 6; i++) {
        for (int j = i; j < 6; j++) {
            double sum = 0;
            for (int k = 0; k < ORR_NW; k++) sum += T[i][k] * F[j][k];
            Q[i][j] = Q[j][i] = sum;
        }
        for (int j = 6; j < ORR_NW; j++) Q[i][j] = Q[j][i] = T[i][j];
    }
}

void orr_transition_append(orr_transition *t, double F[6][ORR_NX], const orr_mat3 *axes, double h, double qf,
                           double qv, bool near_shadow)
{
    double old[6][ORR_NX];
    memcpy(old, t->F, sizeof old);
    memcpy(t->F, F, sizeof t->F);
    for (int i = 0; i < 6; i++) {
        for (int c = 0; c < 6; c++) t->F[i][c] = 0;
        for (int j = 0; j < 6; j++)
            for (int c = 0; c < ORR_NX; c++) t->F[i][c] += F[i][j] * old[j][c];
    }
    carry_noise(t->Q, F);
    add_noise(t->Q, axes, h, qf, qv);
    if (t->near_shadow) carry_noise(t->S, F);
    if (near_shadow) add_noise(t->S, axes, h, qf, qv);
    t->near_shadow = t->near_shadow || near_shadow;
}

void orr_kalman_start(double r_m, double v_mps, double f_mps2, const double ecom_nmps2[ORR_ECOM_TERMS],
                      orr_gauss *g)
{
    memset(g, 0, sizeof *g);
    for (int i = 0; i < 3; i++) {
        g->P[i][i] = r_m * r_m;
        g->P[3 + i][3 + i] = v_mps * v_mps;
        g->P[6 + i][6 + i] = f_mps2 * f_mps2;
    }
    for (int i = 0; i < ORR_ECOM_TERMS; i++)
        g->P[ORR_PARTIAL_ECOM + i][ORR_PARTIAL_ECOM + i] = ecom_nmps2[i] * ecom_nmps2[i];
}

// F P: the lower rows of F are those of the unit matrix.
static inline void transit(const double F[6][ORR_NX], const double P[ORR_NX][ORR_NX],
                           double out[ORR_NX][ORR_NX], const int n)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < n; j++) out[i][j] = 0;
        for (int k = 0; k < n; k++)
            for (int j = 0; j < n; j++) out[i][j] += F[i][k] * P[k][j];
    }
    for (int i = 6; i < n; i++) memcpy(out[i], P[i], (size_t)n * sizeof out[i][0]);
}

static inline void predict(const orr_gauss *from, const orr_transition *t, orr_noise_factor factor,
                           const double *shift, orr_gauss *to, const int n)
{
    double T[ORR_NX][ORR_NX], x[ORR_NX];
    transit(t->F, from->P, T, n);
    for (int i = 0; i < 6; i++) { // (F P) F'
        for (int j = i; j < 6; j++) {
            double sum = 0;
            for (int k = 0; k < n; k++) sum += T[i][k] * t->F[j][k];
            to->P[i][j] = to->P[j][i] = sum;
        }
        for (int j = 6; j < n; j++) to->P[i][j] = to->P[j][i] = T[i][j];
    }
    for (int i = 6; i < n; i++)
        for (int j = 6; j < n; j++) to->P[i][j] = T[i][j];
    for (int i = 0; i < ORR_NW; i++)
        for (int j = 0; j < ORR_NW; j++) to->P[i][j] += factor.q * t->Q[i][j];
    if (t->near_shadow)
        for (int i = 0; i < ORR_NW; i++)
            for (int j = 0; j < ORR_NW; j++) to->P[i][j] += factor.q * factor.shadow * t->S[i][j];
    for (int i = 0; i < n; i++) {
        x[i] = shift[i] + (i < 6 ? 0 : from->x[i]);
        for (int k = 0; k < n && i < 6; k++) x[i] += t->F[i][k] * from->x[k];
    }
    memcpy(to->x, x, (size_t)n * sizeof *x);
}

void orr_kalman_predict(const orr_gauss *from, const orr_transition *t, int nx, orr_noise_factor factor,
                        const double shift[ORR_NX], orr_gauss *to)
{
    FOR_SIZE(nx, predict(from, t, factor, shift, to, ORR_NX_PLAIN),
             predict(from, t, factor, shift, to, ORR_NX));
}

// Inverse of the innovation's covariance S = P_rr + sigma^2 E, and the determinant of S.
static orr_mat3 innovation_weight(const orr_gauss *g, double sigma, double *det)
{
    orr_mat3 s;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) s.m[i][j] = g->P[i][j] + (i == j ? sigma * sigma : 0);
    const orr_vec3 a = {s.m[0][0], s.m[0][1], s.m[0][2]}, b = {s.m[1][0], s.m[1][1], s.m[1][2]},
                   c = {s.m[2][0], s.m[2][1], s.m[2][2]};
    *det = orr_vec3_dot(a, orr_vec3_cross(b, c));
    return orr_mat3_inverse(&s);
}

static orr_vec3 innovation(const orr_gauss *g, orr_vec3 z)
{
    return orr_vec3_sub(z, orr_vec3_make(g->x[0], g->x[1], g->x[2]));
}

double orr_kalman_innovation2(const orr_gauss *g, orr_vec3 z, double sigma, double *length_m, double *log_det)
{
    double det;
    const orr_vec3 e = innovation(g, z);
    const orr_mat3 W = innovation_weight(g, sigma, &det);
    if (length_m != NULL) *length_m = orr_vec3_norm(e);
    if (log_det != NULL) *log_det = 0.5 * log(det);
    return orr_vec3_dot(e, orr_mat3_apply(&W, e)) / 3;
}

// Joseph's form: P = (E - K H) P (E - K H)' + sigma^2 K K', which keeps P positive whatever the rounding.
static inline void update(orr_gauss *g, orr_vec3 z, double sigma, const int n)
{
    double det, K[ORR_NX][3], A[ORR_NX][ORR_NX];
    const orr_vec3 e = innovation(g, z);
    const orr_mat3 W = innovation_weight(g, sigma, &det);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < 3; j++)
            K[i][j] = g->P[i][0] * W.m[0][j] + g->P[i][1] * W.m[1][j] + g->P[i][2] * W.m[2][j];
        g->x[i] += K[i][0] * e.x + K[i][1] * e.y + K[i][2] * e.z;
    }
    for (int i = 0; i < n; i++) // (E - K H) P
        for (int j = 0; j < n; j++)
            A[i][j] = g->P[i][j] - (K[i][0] * g->P[0][j] + K[i][1] * g->P[1][j] + K[i][2] * g->P[2][j]);
    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++) {
            const double noise = sigma * sigma * (K[i][0] * K[j][0] + K[i][1] * K[j][1] + K[i][2] * K[j][2]);
            g->P[i][j] = g->P[j][i] =
                A[i][j] - (A[i][0] * K[j][0] + A[i][1] * K[j][1] + A[i][2] * K[j][2]) + noise;
        }
}

void orr_kalman_update(orr_gauss *g, int nx, orr_vec3 z, double sigma)
{
    FOR_SIZE(nx, update(g, z, sigma, ORR_NX_PLAIN), update(g, z, sigma, ORR_NX));
}

// Cholesky L L' of the correlation matrix of P with the scales taken out; false if not positive definite.
static inline bool cholesky(const double P[ORR_NX][ORR_NX], double scale[ORR_NX], double L[ORR_NX][ORR_NX],
                            const int n)
{
    for (int i = 0; i < n; i++) {
        if (!(P[i][i] > 0)) return false;
        scale[i] = 1.0 / sqrt(P[i][i]);
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            double sum = P[i][j] * scale[i] * scale[j];
            for (int k = 0; k < j; k++) sum -= L[i][k] * L[j][k];
            if (i != j) {
                L[i][j] = sum * L[j][j];
            } else if (sum > 0) {
                L[i][i] = 1 / sqrt(sum); // its inverse is what the solutions need
            } else {
                return false;
            }
        }
    return true;
}

static inline orr_status smooth(const orr_gauss *f, const orr_transition *t, const orr_gauss *pred,
                                const orr_gauss *next, orr_gauss *out, double *u, const int n)
{
    // Gain J = P F' Ppred^-1, from Ppred J' = F P column by column; one more column for u.
    double scale[ORR_NX], L[ORR_NX][ORR_NX], Jt[ORR_NX][ORR_NX], d[ORR_NX];
    if (!cholesky(pred->P, scale, L, n)) return ORR_E_NUMERIC;
    transit(t->F, f->P, Jt, n);
    for (int i = 0; i < n; i++) d[i] = u[i] = next->x[i] - pred->x[i];
    for (int i = 0; i < n; i++) { // forward, all columns at once
        for (int c = 0; c < n; c++) Jt[i][c] *= scale[i];
        u[i] *= scale[i];
        for (int k = 0; k < i; k++) {
            for (int c = 0; c < n; c++) Jt[i][c] -= L[i][k] * Jt[k][c];
            u[i] -= L[i][k] * u[k];
        }
        for (int c = 0; c < n; c++) Jt[i][c] *= L[i][i];
        u[i] *= L[i][i];
    }
    for (int i = n - 1; i >= 0; i--) { // backward
        for (int k = i + 1; k < n; k++) {
            for (int c = 0; c < n; c++) Jt[i][c] -= L[k][i] * Jt[k][c];
            u[i] -= L[k][i] * u[k];
        }
        for (int c = 0; c < n; c++) Jt[i][c] *= L[i][i];
        u[i] *= L[i][i];
    }
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < n; c++) Jt[i][c] *= scale[i];
        u[i] *= scale[i];
    }

    double DJt[ORR_NX][ORR_NX], x[ORR_NX], P[ORR_NX][ORR_NX];
    for (int i = 0; i < n; i++) {
        x[i] = f->x[i];
        for (int k = 0; k < n; k++) x[i] += Jt[k][i] * d[k];
        for (int c = 0; c < n; c++) DJt[i][c] = 0;
        for (int k = 0; k < n; k++) {
            const double D = next->P[i][k] - pred->P[i][k];
            for (int c = 0; c < n; c++) DJt[i][c] += D * Jt[k][c];
        }
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) P[i][j] = f->P[i][j];
        for (int k = 0; k < n; k++)
            for (int j = 0; j < n; j++) P[i][j] += Jt[k][i] * DJt[k][j];
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) out->P[i][j] = 0.5 * (P[i][j] + P[j][i]);
    memcpy(out->x, x, (size_t)n * sizeof *x);
    return ORR_OK;
}

orr_status orr_kalman_smooth(const orr_gauss *f, const orr_transition *t, int nx, const orr_gauss *pred,
                             const orr_gauss *next, orr_gauss *out, double u[ORR_NX])
{
    FOR_SIZE(nx, return smooth(f, t, pred, next, out, u, ORR_NX_PLAIN),
             return smooth(f, t, pred, next, out, u, ORR_NX));
}
