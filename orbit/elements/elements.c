// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/elements/elements.h"

#include "core/chebyshev.h"

#define DEFAULT_SPACING_S 300.0
#define MEAN_POINTS 64
// Of MEAN's series: it holds half a revolution to each side of anything that flies once a day or faster.
#define HALF_SPAN_S (13 * 3600.0)

static double spacing_of(const orr_elements_options *o)
{
    return o->spacing_s > 0 ? o->spacing_s : DEFAULT_SPACING_S;
}

static orr_mat3 wanted_at(orr_time t, orr_elements_frame frame, const orr_mat3 *R)
{
    orr_mat3 wanted = orr_mat3_identity();
    if (frame == ORR_ELEMENTS_ECEF) wanted = *R;
    if (frame == ORR_ELEMENTS_DATE) orr_astro_gcrs_to_tod(t, &wanted);
    return wanted;
}

static void rotation_at(orr_time t, const orr_eop_series *series, orr_mat3 *R, orr_mat3 *dR)
{
    orr_eop eop = orr_eop_at(series, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, R, dR);
}

// The wanted axes at another instant of a revolution: those of ecef stay where they are at the axes' own, or
// the node would go round.
static orr_mat3 wanted_near(const orr_elements_axes *a, orr_time t)
{
    return a->o.frame == ORR_ELEMENTS_ECEF ? a->wanted : wanted_at(t, a->o.frame, NULL);
}

// Earth-fixed state to the wanted axes: x = M x_ecef, v = M (v_ecef - w x r_ecef) by way of the matrices.
static void inertial_state(const orr_mat3 *R, const orr_mat3 *dR, const orr_mat3 *wanted,
                           const orr_sat_state *s, orr_vec3 *r, orr_vec3 *v)
{
    orr_vec3 rg = orr_mat3_apply_t(R, s->pos_m);
    orr_vec3 vg = orr_mat3_apply_t(R, orr_vec3_sub(s->vel_mps, orr_mat3_apply(dR, rg)));
    *r = orr_mat3_apply(wanted, rg);
    *v = orr_mat3_apply(wanted, vg);
}

// MEAN asks at 64 instants of each satellite's own revolution. What is left of M(t) = wanted R^T after a
// uniform turn, M(t) R3(u (t - t0)), is precession, nutation and UT1, which are slow, and the pole, whose
// 1.5e-6 rad turn once a day: a series of degree 16 over 26 hours errs by less than 1e-15. The same holds for
// the rate w of R' = hat(w) R.
static void fill_series(orr_elements_axes *a)
{
    enum { N = ORR_ELEMENTS_DEGREE };
    double value[12][N + 1];
    for (int k = 0; k <= N; k++) {
        orr_time t = orr_time_add_s(a->t, -HALF_SPAN_S * cos(ORR_PI * k / N));
        orr_mat3 R, dR;
        rotation_at(t, a->o.eop, &R, &dR);
        orr_mat3 back = orr_mat3_transpose(&R), wanted = wanted_near(a, t);
        orr_mat3 turn = orr_mat3_rot3(ORR_EARTH_RATE_RADPS * orr_time_diff_s(t, a->t));
        orr_mat3 M = orr_mat3_mul(&wanted, &back), P = orr_mat3_mul(&M, &turn), W = orr_mat3_mul(&dR, &back);
        for (int i = 0; i < 9; i++) value[i][k] = P.m[i / 3][i % 3];
        value[9][k] = W.m[1][2];
        value[10][k] = W.m[2][0];
        value[11][k] = W.m[0][1];
    }
    for (int i = 0; i < 12; i++) orr_cheb_from_lobatto(N, value[i], a->series[i]);
}

void orr_elements_axes_at(orr_time t, const orr_elements_options *o, orr_elements_axes *a)
{
    *a = (orr_elements_axes){.t = t, .o = *o};
    rotation_at(t, o->eop, &a->R[1], &a->dR);
    a->wanted = wanted_at(t, o->frame, &a->R[1]);
    if (o->method == ORR_ELEMENTS_THREE_POSITIONS)
        for (int k = 0; k < 3; k += 2)
            rotation_at(orr_time_add_s(t, spacing_of(o) * (k - 1)), o->eop, &a->R[k], NULL);
    if (o->method == ORR_ELEMENTS_MEAN) fill_series(a);
}

static orr_status osculating(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *a, orr_kepler *out)
{
    orr_sat_state s;
    orr_status status = orr_ephemeris_eval(e, sat, a->t, &s);
    if (status != ORR_OK) return status;
    orr_vec3 r, v;
    inertial_state(&a->R[1], &a->dR, &a->wanted, &s, &r, &v);
    return orr_kepler_from_state(r, v, ORR_EGM96_GM, out);
}

// Whether the arc of another product goes on where this one's ends, at the instant of the joint.
static bool meets(const orr_ephemeris *e, const orr_ephemeris *other, orr_sat sat, orr_time joint,
                  orr_sat_state *there)
{
    static const double SAME_M = 1e-3, SAME_MPS = 1e-6;
    orr_sat_state here;
    if (orr_ephemeris_eval(e, sat, joint, &here) != ORR_OK) return false;
    if (orr_ephemeris_eval(other, sat, joint, there) != ORR_OK) return false;
    return orr_vec3_norm(orr_vec3_sub(here.pos_m, there->pos_m)) <= SAME_M &&
           orr_vec3_norm(orr_vec3_sub(here.vel_mps, there->vel_mps)) <= SAME_MPS;
}

// A neighbour is asked for within the same arc, or in the product that goes on where it ends: across an arc's end there is a
// manoeuvre or nothing.
static orr_status neighbour(const orr_ephemeris *e, orr_sat sat, orr_time t, const orr_sat_state *home,
                            const orr_elements_axes *a, orr_sat_state *out)
{
    if (t >= home->valid_from && t <= home->valid_to) return orr_ephemeris_eval(e, sat, t, out);
    const bool later = t > home->valid_to;
    const orr_ephemeris *other = later ? a->o.after : a->o.before;
    orr_sat_state there;
    if (other == NULL || !meets(e, other, sat, later ? home->valid_to : home->valid_from, &there))
        return ORR_E_NODATA;
    if (t < there.valid_from || t > there.valid_to) return ORR_E_NODATA;
    return orr_ephemeris_eval(other, sat, t, out);
}

orr_status orr_elements_state_near(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *axes,
                                   orr_time t, orr_sat_state *out)
{
    orr_sat_state home;
    const orr_status s = orr_ephemeris_eval(e, sat, axes->t, &home);
    return s == ORR_OK ? neighbour(e, sat, t, &home, axes, out) : s;
}

orr_status orr_elements_from_frozen(const orr_elements_axes *axes, const orr_kepler *frozen, orr_kepler *out)
{
    orr_vec3 r, v;
    orr_kepler_to_state(frozen, ORR_EGM96_GM, &r, &v);
    r = orr_mat3_apply(&axes->wanted, orr_mat3_apply_t(&axes->R[1], r));
    v = orr_mat3_apply(&axes->wanted, orr_mat3_apply_t(&axes->R[1], v));
    return orr_kepler_from_state(r, v, ORR_EGM96_GM, out);
}

static orr_status three_positions(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *a,
                                  orr_kepler *out)
{
    double spacing = spacing_of(&a->o);
    orr_sat_state s[3];
    orr_vec3 r[3];
    orr_status status = orr_ephemeris_eval(e, sat, a->t, &s[1]);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(a->t, -spacing), &s[1], a, &s[0]);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(a->t, spacing), &s[1], a, &s[2]);
    orr_kepler now;
    if (status == ORR_OK) status = osculating(e, sat, a, &now);
    if (status != ORR_OK) return status;
    if (2 * spacing > ORR_PI * sqrt(pow(now.a_m, 3) / ORR_EGM96_GM))
        return ORR_E_NUMERIC;   // a half revolution
    for (int k = 0; k < 3; k++) // one set of axes for all three
        r[k] = orr_mat3_apply(&a->wanted, orr_mat3_apply_t(&a->R[k], s[k].pos_m));
    return orr_kepler_from_positions(r[0], r[1], r[2], ORR_EGM96_GM, out);
}

// Osculating elements dt_s away from the axes' instant.
static orr_status osculating_near(const orr_ephemeris *e, orr_sat sat, double dt_s, const orr_sat_state *home,
                                  const orr_elements_axes *a, orr_kepler *out)
{
    orr_sat_state s;
    orr_time t = orr_time_add_s(a->t, dt_s);
    orr_status status = neighbour(e, sat, t, home, a, &s);
    if (status != ORR_OK) return status;
    orr_vec3 r, v;
    double at_s = orr_time_diff_s(t, a->t);
    if (!(fabs(at_s) <= HALF_SPAN_S)) {
        orr_mat3 R, dR;
        rotation_at(t, a->o.eop, &R, &dR);
        orr_mat3 wanted = wanted_near(a, t);
        inertial_state(&R, &dR, &wanted, &s, &r, &v);
        return orr_kepler_from_state(r, v, ORR_EGM96_GM, out);
    }
    double basis[ORR_ELEMENTS_DEGREE + 1], q[12] = {0};
    orr_cheb_basis(ORR_ELEMENTS_DEGREE, at_s / HALF_SPAN_S, basis, NULL, NULL);
    for (int i = 0; i < 12; i++)
        for (int j = 0; j <= ORR_ELEMENTS_DEGREE; j++) q[i] += a->series[i][j] * basis[j];
    orr_mat3 P = {{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}, {q[6], q[7], q[8]}}};
    orr_mat3 turn = orr_mat3_rot3(-ORR_EARTH_RATE_RADPS * at_s), M = orr_mat3_mul(&P, &turn);
    orr_mat3 rate = orr_mat3_hat((orr_vec3){q[9], q[10], q[11]});
    r = orr_mat3_apply(&M, s.pos_m);
    v = orr_mat3_apply(&M, orr_vec3_sub(s.vel_mps, orr_mat3_apply(&rate, s.pos_m)));
    return orr_kepler_from_state(r, v, ORR_EGM96_GM, out);
}

// Averages of a, the vectors of eccentricity and of the node (no singularity at e = 0), and of the mean
// longitude less its uniform growth, over one osculating period in equal steps of time: short-period terms
// average out to second order.
static orr_status averaged(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *axes,
                           orr_kepler *out)
{
    orr_kepler centre;
    orr_sat_state home, edge;
    orr_status status = osculating(e, sat, axes, &centre);
    if (status == ORR_OK) status = orr_ephemeris_eval(e, sat, axes->t, &home);
    if (status != ORR_OK) return status;
    const double n = sqrt(ORR_EGM96_GM / pow(centre.a_m, 3)), period = 2 * ORR_PI / n;
    status = neighbour(e, sat, orr_time_add_s(axes->t, -period / 2), &home, axes, &edge);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(axes->t, period / 2), &home, axes, &edge);
    if (status != ORR_OK) return status;
    const double longitude0 = centre.raan_rad + centre.argp_rad + centre.m_rad;
    double a = 0, h = 0, k = 0, p = 0, q = 0, longitude = 0;
    for (int j = 0; j < MEAN_POINTS; j++) {
        double dt = period * ((j + 0.5) / MEAN_POINTS - 0.5);
        orr_kepler el;
        status = osculating_near(e, sat, dt, &home, axes, &el);
        if (status != ORR_OK) return status;
        double perigee = el.raan_rad + el.argp_rad;
        a += el.a_m / MEAN_POINTS;
        h += el.e * sin(perigee) / MEAN_POINTS;
        k += el.e * cos(perigee) / MEAN_POINTS;
        p += tan(el.i_rad / 2) * sin(el.raan_rad) / MEAN_POINTS;
        q += tan(el.i_rad / 2) * cos(el.raan_rad) / MEAN_POINTS;
        longitude += remainder(perigee + el.m_rad - n * dt - longitude0, 2 * ORR_PI) / MEAN_POINTS;
    }
    double raan = atan2(p, q), perigee = atan2(h, k), two_pi = 2 * ORR_PI;
    *out = (orr_kepler){.a_m = a, .e = hypot(h, k), .i_rad = 2 * atan(hypot(p, q))};
    if (!(out->e < 1)) return ORR_E_NUMERIC; // all of them next to 1, and the sum rounded
    out->raan_rad = fmod(raan + two_pi, two_pi);
    out->argp_rad = fmod(perigee - raan + 2 * two_pi, two_pi);
    out->m_rad = fmod(fmod(longitude0 + longitude - perigee, two_pi) + two_pi, two_pi);
    out->u_rad = fmod(out->argp_rad + orr_kepler_true_anomaly(out->m_rad, out->e) + 2 * two_pi, two_pi);
    return ORR_OK;
}

orr_status orr_elements_of(const orr_ephemeris *e, orr_sat sat, const orr_elements_axes *axes,
                           orr_kepler *out)
{
    orr_kepler el = {0};
    orr_status s = ORR_E_ARG;
    switch (axes->o.method) {
    case ORR_ELEMENTS_STATE:
        s = osculating(e, sat, axes, &el);
        break;
    case ORR_ELEMENTS_THREE_POSITIONS:
        s = three_positions(e, sat, axes, &el);
        break;
    case ORR_ELEMENTS_MEAN:
        s = averaged(e, sat, axes, &el);
        break;
    }
    if (s == ORR_OK) *out = el;
    return s;
}
