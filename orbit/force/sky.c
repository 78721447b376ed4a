// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/sky.h"

#include <stdlib.h>
#include <string.h>

#include "core/eop_tides.h"
#include "orbit/force/tides.h"

#define NODE_S 600.0
#define MARGIN_NODES 3 // so that the four-point window always has its neighbours
#define N_SLOW 20      // 9 of the slow matrix, Sun, Moon, 5 of the tide

// R(t) = R3(u t) N(t): what is left in N after the uniform turn is precession, nutation, pole and UT1, all
// small and slow.
typedef struct slow_node {
    double q[N_SLOW];
} slow_node;

struct orr_sky {
    orr_time origin;
    orr_sky_frame frame;
    double first_s; // time of node[0]
    size_t n;
    slow_node *node;
    // of a precise sky, by node: what does not change with its rotation
    orr_mat3 *cirs;
    orr_eop_tides *ocean;
};

orr_time orr_sky_origin(const orr_sky *sky) { return sky->origin; }

void orr_sky_free(orr_sky *sky)
{
    if (sky == NULL) return;
    free(sky->node);
    free(sky->cirs);
    free(sky->ocean);
    free(sky);
}

static orr_status allocate(orr_time from, orr_time to, orr_sky **out, orr_diag *diag)
{
    *out = NULL;
    if (to < from) return orr_diag_set(diag, ORR_E_ARG, "a span that ends before it begins");
    double span_s = orr_time_diff_s(to, from);
    if (span_s > 10.0 * 366 * 86400) {
        char begin[ORR_TIME_TEXT], end[ORR_TIME_TEXT];
        return orr_diag_set(diag, ORR_E_ARG,
                            "the positions reach from %s to %s; a product holds ten years at most",
                            orr_time_text(from, begin), orr_time_text(to, end));
    }
    orr_sky *sky = calloc(1, sizeof *sky);
    if (sky == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    sky->origin = from;
    sky->frame = ORR_SKY_GCRS;
    sky->first_s = -MARGIN_NODES * NODE_S;
    sky->n = (size_t)(span_s / NODE_S) + 2 + 2 * MARGIN_NODES;
    sky->node = calloc(sky->n, sizeof *sky->node);
    if (sky->node == NULL) {
        size_t n = sky->n;
        orr_sky_free(sky);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for %zu nodes of Earth rotation", n);
    }
    *out = sky;
    return ORR_OK;
}

static void set_bodies(double *q, orr_vec3 sun, orr_vec3 moon)
{
    q[9] = sun.x, q[10] = sun.y, q[11] = sun.z;
    q[12] = moon.x, q[13] = moon.y, q[14] = moon.z;
}

orr_status orr_sky_init(orr_time from, orr_time to, orr_sky_frame frame, const orr_eop_series *eop,
                        const orr_leap_table *leap, orr_sky **out, bool *eop_known, orr_diag *diag)
{
    orr_sky *sky = NULL;
    *out = NULL;
    const orr_status status = allocate(from, to, &sky, diag);
    if (status != ORR_OK) return status;
    sky->frame = frame;
    const double span_s = orr_time_diff_s(to, from);
    bool known = true;
    for (size_t i = 0; i < sky->n; i++) {
        double t_s = sky->first_s + NODE_S * (double)i;
        orr_time t = orr_time_add_s(from, t_s);
        bool from_series = false;
        orr_eop e = orr_eop_at(eop, t, leap, &from_series);
        bool inside = t_s >= 0 && t_s <= span_s;
        if (inside && !from_series) known = false;
        orr_mat3 R, turn = orr_mat3_rot3(ORR_EARTH_RATE_RADPS * t_s), N;
        orr_astro_gcrs_to_itrs(t, &e, leap, &R, NULL);
        orr_vec3 sun = orr_astro_sun(t), moon = orr_astro_moon(t);
        if (frame == ORR_SKY_GCRS) {
            orr_mat3 back = orr_mat3_transpose(&turn);
            N = orr_mat3_mul(&back, &R);
        } else { // integration axes are ecef turned back by u t: Sun and Moon follow through ecef
            N = orr_mat3_identity();
            sun = orr_mat3_apply_t(&turn, orr_mat3_apply(&R, sun));
            moon = orr_mat3_apply_t(&turn, orr_mat3_apply(&R, moon));
        }
        double *q = sky->node[i].q;
        memcpy(q, N.m, sizeof N.m);
        set_bodies(q, sun, moon);
    }
    if (eop_known != NULL) *eop_known = known;
    *out = sky;
    return ORR_OK;
}

orr_status orr_sky_init_precise(orr_time from, orr_time to, orr_sky **out, orr_diag *diag)
{
    orr_sky *sky = NULL;
    *out = NULL;
    const orr_status status = allocate(from, to, &sky, diag);
    if (status != ORR_OK) return status;
    sky->cirs = malloc(sky->n * sizeof *sky->cirs);
    sky->ocean = malloc(sky->n * sizeof *sky->ocean);
    if (sky->cirs == NULL || sky->ocean == NULL) {
        orr_sky_free(sky);
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory for the Earth's rotation");
    }
    for (size_t i = 0; i < sky->n; i++) {
        const orr_time t = orr_time_add_s(from, sky->first_s + NODE_S * (double)i);
        sky->cirs[i] = orr_astro_gcrs_to_cirs(t);
        sky->ocean[i] = orr_eop_tides_subdaily(t);
        set_bodies(sky->node[i].q, orr_astro_sun(t), orr_astro_moon(t));
    }
    *out = sky;
    return ORR_OK;
}

void orr_sky_turn(orr_sky *sky, const orr_eop_series *eop)
{
    for (size_t i = 0; i < sky->n; i++) {
        const double t_s = sky->first_s + NODE_S * (double)i;
        const orr_time t = orr_time_add_s(sky->origin, t_s);
        orr_eop e = orr_eop_at(eop, t, NULL, NULL);
        e.xp_rad += sky->ocean[i].xp_rad;
        e.yp_rad += sky->ocean[i].yp_rad;
        e.ut1_utc_s += sky->ocean[i].ut1_s;
        const orr_mat3 spin = orr_astro_cirs_to_itrs(t, &e, NULL), R = orr_mat3_mul(&spin, &sky->cirs[i]);
        const orr_mat3 turn = orr_mat3_rot3(ORR_EARTH_RATE_RADPS * t_s), back = orr_mat3_transpose(&turn);
        const orr_mat3 N = orr_mat3_mul(&back, &R);
        double *q = sky->node[i].q;
        memcpy(q, N.m, sizeof N.m);
        const orr_vec3 sun = {q[9], q[10], q[11]}, moon = {q[12], q[13], q[14]};
        orr_tides_gravitation(t, orr_mat3_apply(&R, sun), orr_mat3_apply(&R, moon), e.xp_rad, e.yp_rad,
                              q + 15);
    }
}

// Four-point Lagrange weights at x in [0, 1] between nodes 1 and 2 of -1, 0, 1, 2, with derivatives by x.
static void weights(double x, double w[4], double dw[4], double ddw[4])
{
    double x2 = x * x, x3 = x2 * x;
    w[0] = (-x3 + 3 * x2 - 2 * x) / 6;
    w[1] = (x3 - 2 * x2 - x + 2) / 2;
    w[2] = (-x3 + x2 + 2 * x) / 2;
    w[3] = (x3 - x) / 6;
    if (dw == NULL) return;
    dw[0] = (-3 * x2 + 6 * x - 2) / 6;
    dw[1] = (3 * x2 - 4 * x - 1) / 2;
    dw[2] = (-3 * x2 + 2 * x + 2) / 2;
    dw[3] = (3 * x2 - 1) / 6;
    ddw[0] = -x + 1;
    ddw[1] = 3 * x - 2;
    ddw[2] = -3 * x + 1;
    ddw[3] = x;
}

static const slow_node *window(const orr_sky *sky, double t_s, double *x)
{
    double k = (t_s - sky->first_s) / NODE_S;
    double whole = floor(k);
    if (whole < 1) whole = 1;
    if (whole > (double)(sky->n - 3)) whole = (double)(sky->n - 3);
    *x = k - whole;
    return sky->node + (size_t)whole - 1;
}

static void combine(const slow_node *n, const double w[4], size_t count, double scale, double *out)
{
    for (size_t j = 0; j < count; j++)
        out[j] = scale * (w[0] * n[0].q[j] + w[1] * n[1].q[j] + w[2] * n[2].q[j] + w[3] * n[3].q[j]);
}

static void turn_matrices(double t_s, orr_mat3 *T, orr_mat3 *dT, orr_mat3 *ddT)
{
    const double u = ORR_EARTH_RATE_RADPS, c = cos(u * t_s), s = sin(u * t_s);
    *T = (orr_mat3){{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
    *dT = (orr_mat3){{{-u * s, u * c, 0}, {-u * c, -u * s, 0}, {0, 0, 0}}};
    *ddT = (orr_mat3){{{-u * u * c, -u * u * s, 0}, {u * u * s, -u * u * c, 0}, {0, 0, 0}}};
}

static void bodies(const double *q, orr_sky_point *out)
{
    out->sun_m = orr_vec3_make(q[9], q[10], q[11]);
    out->moon_m = orr_vec3_make(q[12], q[13], q[14]);
    memcpy(out->tide, q + 15, sizeof out->tide);
}

void orr_sky_force_point(const orr_sky *sky, double t_s, orr_sky_point *out)
{
    double x, w[4], q[N_SLOW];
    const slow_node *n = window(sky, t_s, &x);
    weights(x, w, NULL, NULL);
    combine(n, w, N_SLOW, 1.0, q);
    const double c = cos(ORR_EARTH_RATE_RADPS * t_s), s = sin(ORR_EARTH_RATE_RADPS * t_s);
    for (int j = 0; j < 3; j++) { // R3(u t) N
        out->R.m[0][j] = c * q[j] + s * q[3 + j];
        out->R.m[1][j] = -s * q[j] + c * q[3 + j];
        out->R.m[2][j] = q[6 + j];
    }
    bodies(q, out);
}

void orr_sky_at(const orr_sky *sky, double t_s, orr_sky_point *out)
{
    double x, w[4], dw[4], ddw[4], q[N_SLOW];
    const slow_node *n = window(sky, t_s, &x);
    weights(x, w, dw, ddw);
    orr_mat3 N, dN, ddN, T, dT, ddT;
    combine(n, w, N_SLOW, 1.0, q);
    memcpy(N.m, q, sizeof N.m);
    bodies(q, out);
    combine(n, dw, 9, 1.0 / NODE_S, q);
    memcpy(dN.m, q, sizeof dN.m);
    combine(n, ddw, 9, 1.0 / (NODE_S * NODE_S), q);
    memcpy(ddN.m, q, sizeof ddN.m);
    turn_matrices(t_s, &T, &dT, &ddT);

    // (T N)' = T' N + T N', (T N)'' = T'' N + 2 T' N' + T N''
    out->R = orr_mat3_mul(&T, &N);
    orr_mat3 a = orr_mat3_mul(&dT, &N), b = orr_mat3_mul(&T, &dN);
    out->dR = orr_mat3_add(&a, &b);
    a = orr_mat3_mul(&ddT, &N);
    b = orr_mat3_mul(&dT, &dN);
    b = orr_mat3_scale(2.0, &b);
    a = orr_mat3_add(&a, &b);
    b = orr_mat3_mul(&T, &ddN);
    out->ddR = orr_mat3_add(&a, &b);
}

void orr_sky_to_ecef(const orr_sky_point *p, orr_vec3 r, orr_vec3 v, orr_vec3 *r_ecef, orr_vec3 *v_ecef)
{
    *r_ecef = orr_mat3_apply(&p->R, r);
    *v_ecef = orr_vec3_add(orr_mat3_apply(&p->R, v), orr_mat3_apply(&p->dR, r));
}

void orr_sky_from_ecef(const orr_sky_point *p, orr_vec3 r_ecef, orr_vec3 v_ecef, orr_vec3 *r, orr_vec3 *v)
{
    *r = orr_mat3_apply_t(&p->R, r_ecef);
    *v = orr_mat3_apply_t(&p->R, orr_vec3_sub(v_ecef, orr_mat3_apply(&p->dR, *r)));
}
