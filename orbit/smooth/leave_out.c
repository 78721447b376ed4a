// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/smooth/leave_out.h"

#include <string.h>

#include "core/linalg.h"

#define UNTOLD 1e-6 // of a node's variance: so little is left of it where the node alone tells its orbit

static double determinant(const orr_mat3 *s)
{
    const orr_vec3 a = {s->m[0][0], s->m[0][1], s->m[0][2]}, b = {s->m[1][0], s->m[1][1], s->m[1][2]},
                   c = {s->m[2][0], s->m[2][1], s->m[2][2]};
    return orr_vec3_dot(a, orr_vec3_cross(b, c));
}

// e = measured minus smoothed, P the smoothed covariance, R = sigma^2 E. Of a node that was not used the
// covariance of e is R + P. Of one that was, R - P; without it e would be R (R - P)^-1 e, of covariance R (R
// - P)^-1 R, so that e' (R - P)^-1 e is its normalised square as well.
orr_left_out orr_leave_node_out(const orr_track_context *c, const orr_instant *at, const orr_node *node,
                                bool used)
{
    const orr_gauss_kept *g = &at->state;
    const double r = node->sigma_m * node->sigma_m;
    orr_mat3 s;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            s.m[j][k] = (j == k ? r : 0) + (used ? -orr_gauss_kept_P(g, j, k) : orr_gauss_kept_P(g, j, k));
    const double least = UNTOLD * r;
    if (!(determinant(&s) > least * least * least)) return (orr_left_out){0};
    const orr_vec3 x = orr_vec3_make(g->x[0], g->x[1], g->x[2]);
    const orr_vec3 e = orr_vec3_sub(orr_track_measured(c, at, node), x);
    const orr_mat3 weight = orr_mat3_inverse(&s);
    const orr_vec3 u = orr_mat3_apply(&weight, e);
    return (orr_left_out){used ? r * orr_vec3_norm(u) : orr_vec3_norm(e), fmax(orr_vec3_dot(e, u), 0) / 3};
}

// With u = P^-1 (smoothed minus predicted), of covariance N = P^-1 (P - smoothed P) P^-1, a change d of the
// state at the instant takes 2 d'u - d'N d from the sum of squares.
orr_fresh_start orr_fresh_start_at(const orr_gauss *predicted, const orr_gauss *smoothed,
                                   const double u[ORR_NX], int nx)
{
    double P[ORR_NX][ORR_NX], X[ORR_NX][6], N[6][6], d[6];
    const size_t n = (size_t)nx;
    orr_fresh_start out = {0};
    memcpy(P, predicted->P, sizeof P);
    memset(X, 0, sizeof X);
    for (int i = 0; i < 6; i++) X[i][i] = 1;
    if (orr_symmetric_solve(&P[0][0], ORR_NX, n, &X[0][0], 6) != ORR_OK) return out;
    for (int a = 0; a < 6; a++) {
        double y[ORR_NX];
        for (size_t i = 0; i < n; i++) {
            y[i] = 0;
            for (size_t k = 0; k < n; k++) y[i] += (predicted->P[i][k] - smoothed->P[i][k]) * X[k][a];
        }
        for (int b = 0; b < 6; b++) {
            N[b][a] = 0;
            for (size_t i = 0; i < n; i++) N[b][a] += X[i][b] * y[i];
        }
        d[a] = u[a];
    }
    if (orr_symmetric_solve(&N[0][0], 6, 6, d, 1) != ORR_OK) return out;
    for (int i = 0; i < 6; i++) out.gain += d[i] * u[i];
    out.r_m = (orr_vec3){d[0], d[1], d[2]};
    out.v_mps = (orr_vec3){d[3], d[4], d[5]};
    out.told = isfinite(out.gain) != 0;
    return out;
}
