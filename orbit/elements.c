// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/elements.h"

#define DEFAULT_SPACING_S 300.0
#define MEAN_POINTS 64

// ITRS to the wanted inertial axes at t, with the derivative of GCRS-to-ITRS for velocities.
typedef struct axes {
    orr_mat3 R, dR;  // GCRS to ITRS
    orr_mat3 wanted; // GCRS to the axes of the elements
} axes;

static axes axes_at(orr_time t, const orr_elements_options *o)
{
    axes a;
    orr_eop eop = orr_eop_at(o->eop, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &a.R, &a.dR);
    switch (o->frame) {
    case ORR_ELEMENTS_J2000:
        a.wanted = orr_mat3_identity();
        break;
    case ORR_ELEMENTS_ECEF:
        a.wanted = a.R;
        break;
    case ORR_ELEMENTS_DATE:
        orr_astro_gcrs_to_tod(t, &a.wanted);
        break;
    }
    return a;
}

static void inertial_state(const axes *a, const orr_sat_state *s, orr_vec3 *r, orr_vec3 *v)
{
    orr_vec3 rg = orr_mat3_apply_t(&a->R, s->pos_m);
    orr_vec3 vg = orr_mat3_apply_t(&a->R, orr_vec3_sub(s->vel_mps, orr_mat3_apply(&a->dR, rg)));
    *r = orr_mat3_apply(&a->wanted, rg);
    *v = orr_mat3_apply(&a->wanted, vg);
}

static orr_status osculating(const orr_ephemeris *e, orr_sat sat, orr_time t, const orr_elements_options *o,
                             orr_kepler *out)
{
    orr_sat_state s;
    orr_status status = orr_ephemeris_eval(e, sat, t, &s);
    if (status != ORR_OK) return status;
    axes a = axes_at(t, o);
    orr_vec3 r, v;
    inertial_state(&a, &s, &r, &v);
    return orr_kepler_from_state(r, v, ORR_KEPLER_GM, out);
}

// A neighbour is asked for within the same arc: across an arc's end there is a manoeuvre or nothing.
static orr_status neighbour(const orr_ephemeris *e, orr_sat sat, orr_time t, const orr_sat_state *home,
                            orr_sat_state *out)
{
    if (t < home->valid_from || t > home->valid_to) return ORR_E_NODATA;
    return orr_ephemeris_eval(e, sat, t, out);
}

static orr_status three_positions(const orr_ephemeris *e, orr_sat sat, orr_time t,
                                  const orr_elements_options *o, orr_kepler *out)
{
    double spacing = o->spacing_s > 0 ? o->spacing_s : DEFAULT_SPACING_S;
    orr_sat_state s[3];
    orr_vec3 r[3];
    orr_status status = orr_ephemeris_eval(e, sat, t, &s[1]);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(t, -spacing), &s[1], &s[0]);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(t, spacing), &s[1], &s[2]);
    if (status != ORR_OK) return status;
    orr_mat3 wanted = axes_at(t, o).wanted; // one set of axes for all three
    for (int k = 0; k < 3; k++) {
        axes a = axes_at(orr_time_add_s(t, spacing * (k - 1)), o);
        r[k] = orr_mat3_apply(&wanted, orr_mat3_apply_t(&a.R, s[k].pos_m));
    }
    return orr_kepler_from_positions(r[0], r[1], r[2], ORR_KEPLER_GM, out);
}

// Averages of a, the vectors of eccentricity and of the node (no singularity at e = 0), and of the mean
// longitude less its uniform growth, over one osculating period in equal steps of time: short-period terms
// average out to second order.
static orr_status averaged(const orr_ephemeris *e, orr_sat sat, orr_time t, const orr_elements_options *o,
                           orr_kepler *out)
{
    orr_kepler centre;
    orr_sat_state home, edge;
    orr_status status = osculating(e, sat, t, o, &centre);
    if (status == ORR_OK) status = orr_ephemeris_eval(e, sat, t, &home);
    if (status != ORR_OK) return status;
    const double n = sqrt(ORR_KEPLER_GM / pow(centre.a_m, 3)), period = 2 * ORR_PI / n;
    status = neighbour(e, sat, orr_time_add_s(t, -period / 2), &home, &edge);
    if (status == ORR_OK) status = neighbour(e, sat, orr_time_add_s(t, period / 2), &home, &edge);
    if (status != ORR_OK) return status;
    const double longitude0 = centre.raan_rad + centre.argp_rad + centre.m_rad;
    double a = 0, h = 0, k = 0, p = 0, q = 0, longitude = 0;
    for (int j = 0; j < MEAN_POINTS; j++) {
        double dt = period * ((j + 0.5) / MEAN_POINTS - 0.5);
        orr_kepler el;
        status = osculating(e, sat, orr_time_add_s(t, dt), o, &el);
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
    out->raan_rad = fmod(raan + two_pi, two_pi);
    out->argp_rad = fmod(perigee - raan + 2 * two_pi, two_pi);
    out->m_rad = fmod(fmod(longitude0 + longitude - perigee, two_pi) + two_pi, two_pi);
    double E = orr_kepler_solve(out->m_rad, out->e);
    double nu = atan2(sqrt(1 - out->e * out->e) * sin(E), cos(E) - out->e);
    out->u_rad = fmod(out->argp_rad + nu + 2 * two_pi, two_pi);
    return ORR_OK;
}

orr_status orr_elements_at(const orr_ephemeris *e, orr_sat sat, orr_time t, const orr_elements_options *o,
                           orr_kepler *out)
{
    orr_kepler el = {0};
    orr_status s = ORR_E_ARG;
    switch (o->method) {
    case ORR_ELEMENTS_STATE:
        s = osculating(e, sat, t, o, &el);
        break;
    case ORR_ELEMENTS_THREE_POSITIONS:
        s = three_positions(e, sat, t, o, &el);
        break;
    case ORR_ELEMENTS_MEAN:
        s = averaged(e, sat, t, o, &el);
        break;
    }
    if (s == ORR_OK) *out = el;
    return s;
}
