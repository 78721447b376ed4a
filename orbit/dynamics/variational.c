// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/dynamics/variational.h"

#include <string.h>

void orr_orbit_step_middle(const orr_orbit_step *s, orr_vec3 *r, orr_vec3 *v)
{
    *r = orr_vec3_axpy(s->h_s / 8, orr_vec3_sub(s->v0_mps, s->v1_mps),
                       orr_vec3_scale(0.5, orr_vec3_add(s->r0_m, s->r1_m)));
    *v = orr_vec3_axpy(-0.25, orr_vec3_add(s->v0_mps, s->v1_mps),
                       orr_vec3_scale(1.5 / s->h_s, orr_vec3_sub(s->r1_m, s->r0_m)));
}

static orr_mat3 plus(double k, const orr_mat3 *b, const orr_mat3 *a)
{
    const orr_mat3 kb = orr_mat3_scale(k, b);
    return orr_mat3_add(a, &kb);
}

static void put(const orr_mat3 *m, int row, int column, double partial[6][ORR_PARTIALS])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) partial[row + i][column + j] = m->m[i][j];
}

// Columns of the state. With y'' = G y the four stages are k1 = G0 y, k2 = Gm (y + h/2 y'), k3 = Gm (y + h/2
// y' + h^2/4 k1), k4 = G1 (y + h y' + h^2/2 k2); y moves by h y' + h^2/6 (k1 + k2 + k3), y' by h/6 (k1 + 2 k2
// + 2 k3 + k4).
static void state_columns(const orr_mat3 G[3], double h, double partial[6][ORR_PARTIALS])
{
    const orr_mat3 one = orr_mat3_identity(), m0 = orr_mat3_mul(&G[1], &G[0]),
                   e_m = orr_mat3_mul(&G[2], &G[1]);
    // y = 1, y' = 0
    const orr_mat3 k3 = plus(h * h / 4, &m0, &G[1]), k4 = plus(h * h / 2, &e_m, &G[2]);
    orr_mat3 sum = orr_mat3_add(&G[0], &G[1]);
    sum = orr_mat3_add(&sum, &k3);
    const orr_mat3 rr = plus(h * h / 6, &sum, &one);
    sum = plus(2, &G[1], &G[0]);
    sum = plus(2, &k3, &sum);
    sum = orr_mat3_add(&sum, &k4);
    const orr_mat3 vr = orr_mat3_scale(h / 6, &sum);
    // y = 0, y' = 1: k1 = 0, k2 = k3 = h/2 Gm, k4 = h G1 + h^3/4 G1 Gm
    const orr_mat3 h_one = orr_mat3_scale(h, &one), rv = plus(h * h * h / 6, &G[1], &h_one);
    sum = orr_mat3_scale(2 * h, &G[1]);
    sum = plus(h, &G[2], &sum);
    sum = plus(h * h * h / 4, &e_m, &sum);
    const orr_mat3 vv = plus(h / 6, &sum, &one);
    put(&rr, 0, 0, partial);
    put(&rv, 0, 3, partial);
    put(&vr, 3, 0, partial);
    put(&vv, 3, 3, partial);
}

// A column of what accelerates by b0, bm, b1 at begin, middle and end: k1 = b0, k2 = bm, k3 = h^2/4 Gm b0 +
// bm, k4 = h^2/2 G1 bm + b1.
static void driven_column(const orr_mat3 G[3], double h, const orr_vec3 b[3], int column,
                          double partial[6][ORR_PARTIALS])
{
    const orr_vec3 k3 = orr_vec3_axpy(h * h / 4, orr_mat3_apply(&G[1], b[0]), b[1]);
    const orr_vec3 k4 = orr_vec3_axpy(h * h / 2, orr_mat3_apply(&G[2], b[1]), b[2]);
    const orr_vec3 r = orr_vec3_scale(h * h / 6, orr_vec3_add(orr_vec3_add(b[0], b[1]), k3));
    const orr_vec3 twice = orr_vec3_scale(2, orr_vec3_add(b[1], k3));
    const orr_vec3 v = orr_vec3_scale(h / 6, orr_vec3_add(orr_vec3_add(b[0], twice), k4));
    partial[0][column] = r.x, partial[1][column] = r.y, partial[2][column] = r.z;
    partial[3][column] = v.x, partial[4][column] = v.y, partial[5][column] = v.z;
}

void orr_variational_step(const orr_force *force, const orr_sky *sky, const orr_orbit_step *s,
                          const orr_mat3 axes[3], double partial[6][ORR_PARTIALS])
{
    orr_vec3 r[3] = {s->r0_m, {0, 0, 0}, s->r1_m}, v[3] = {s->v0_mps, {0, 0, 0}, s->v1_mps};
    orr_vec3 basis[3][ORR_ECOM_TERMS];
    orr_mat3 G[3];
    orr_orbit_step_middle(s, &r[1], &v[1]);
    for (int i = 0; i < 3; i++) {
        orr_sky_point p = {0};
        if (force->earth.degree >= 2 || force->precise)
            orr_sky_force_point(sky, s->t_s + 0.5 * i * s->h_s, &p);
        G[i] = orr_force_gradient(force, (orr_vec3){p.R.m[2][0], p.R.m[2][1], p.R.m[2][2]}, r[i]);
        if (force->precise) orr_ecom_basis(r[i], v[i], p.sun_m, basis[i]);
    }
    memset(partial, 0, 6 * sizeof partial[0]);
    state_columns(G, s->h_s, partial);
    for (int j = 0; j < 3 && axes != NULL; j++) {
        orr_vec3 b[3];
        for (int i = 0; i < 3; i++) b[i] = (orr_vec3){axes[i].m[0][j], axes[i].m[1][j], axes[i].m[2][j]};
        driven_column(G, s->h_s, b, ORR_PARTIAL_F0 + j, partial);
    }
    for (int j = 0; j < ORR_ECOM_TERMS && force->precise; j++) {
        const orr_vec3 b[3] = {basis[0][j], basis[1][j], basis[2][j]};
        driven_column(G, s->h_s, b, ORR_PARTIAL_ECOM + j, partial);
    }
}
