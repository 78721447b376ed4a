// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/kepler.h"

#define CIRCULAR 1e-12 // below it the direction of perigee is rounding
#define EQUATORIAL 1e-12

double orr_kepler_turn(double angle_rad)
{
    double a = fmod(angle_rad, 2 * ORR_PI);
    return a < 0 ? a + 2 * ORR_PI : a;
}

double orr_kepler_solve(double m, double e)
{
    m = remainder(m, 2 * ORR_PI);
    double E =
        m + e * sin(m) / (1 - sin(m + e) + sin(m)); // a good start for all e < 1 (Murray & Dermott 1999, 2.4)
    if (!(fabs(E - m) <= e)) E = m + (m > 0 ? e : -e) * 0.85;
    for (int k = 0; k < 50; k++) {
        double f = E - e * sin(E) - m, d = 1 - e * cos(E), step = f / d;
        step = f / (d - 0.5 * step * e * sin(E)); // Halley
        E -= step;
        if (fabs(step) < 1e-15 * (1 + fabs(E))) break;
    }
    return E;
}

double orr_kepler_true_anomaly(double m_rad, double e)
{
    const double E = orr_kepler_solve(m_rad, e);
    return atan2(sqrt(1 - e * e) * sin(E), cos(E) - e);
}

orr_mat3 orr_orbit_axes(orr_vec3 r, orr_vec3 v)
{
    const orr_vec3 radial = orr_vec3_unit(r), cross = orr_vec3_unit(orr_vec3_cross(r, v)),
                   along = orr_vec3_cross(cross, radial);
    return (orr_mat3){
        {{radial.x, along.x, cross.x}, {radial.y, along.y, cross.y}, {radial.z, along.z, cross.z}}};
}

orr_status orr_kepler_from_state(orr_vec3 r, orr_vec3 v, double gm, orr_kepler *out)
{
    orr_vec3 h = orr_vec3_cross(r, v);
    double radius = orr_vec3_norm(r), hn = orr_vec3_norm(h), v2 = orr_vec3_dot(v, v);
    double inverse_a = 2 / radius - v2 / gm;
    if (!(radius > 0) || !(hn > 1e-9 * radius * sqrt(v2)) || !(inverse_a > 0)) return ORR_E_NUMERIC;
    orr_vec3 w = orr_vec3_scale(1 / hn, h);
    orr_vec3 ev = orr_vec3_axpy(-1 / radius, r, orr_vec3_scale(1 / gm, orr_vec3_cross(v, h)));
    out->a_m = 1 / inverse_a;
    out->e = orr_vec3_norm(ev);
    if (!(out->e < 1)) return ORR_E_NUMERIC; // next to a straight line, by rounding
    double flat = hypot(w.x, w.y);
    out->i_rad = atan2(flat, w.z);
    out->raan_rad = flat > EQUATORIAL ? orr_kepler_turn(atan2(w.x, -w.y)) : 0;
    orr_vec3 node = {cos(out->raan_rad), sin(out->raan_rad), 0}, across = orr_vec3_cross(w, node);
    out->u_rad = orr_kepler_turn(atan2(orr_vec3_dot(r, across), orr_vec3_dot(r, node)));
    out->argp_rad =
        out->e > CIRCULAR ? orr_kepler_turn(atan2(orr_vec3_dot(ev, across), orr_vec3_dot(ev, node))) : 0;
    // e cos E = 1 - r/a, e sin E = r.v/sqrt(mu a): well conditioned for M even where e is small.
    double nu = out->u_rad - out->argp_rad;
    double E = atan2(sqrt(1 - out->e * out->e) * sin(nu), out->e + cos(nu));
    out->m_rad = orr_kepler_turn(E - out->e * sin(E));
    return ORR_OK;
}

void orr_kepler_to_state(const orr_kepler *k, double gm, orr_vec3 *r, orr_vec3 *v)
{
    double E = orr_kepler_solve(k->m_rad, k->e), c = cos(E), s = sin(E), root = sqrt(1 - k->e * k->e);
    double x = k->a_m * (c - k->e), y = k->a_m * root * s, rate = sqrt(gm / k->a_m) / (1 - k->e * c);
    double vx = -rate * s, vy = rate * root * c;
    double co = cos(k->raan_rad), so = sin(k->raan_rad), ci = cos(k->i_rad), si = sin(k->i_rad);
    double cw = cos(k->argp_rad), sw = sin(k->argp_rad);
    orr_vec3 p = {cw * co - sw * ci * so, cw * so + sw * ci * co, sw * si};
    orr_vec3 q = {-sw * co - cw * ci * so, -sw * so + cw * ci * co, cw * si};
    *r = orr_vec3_axpy(y, q, orr_vec3_scale(x, p));
    *v = orr_vec3_axpy(vy, q, orr_vec3_scale(vx, p));
}

orr_status orr_kepler_from_positions(orr_vec3 r1, orr_vec3 r2, orr_vec3 r3, double gm, orr_kepler *out)
{
    orr_vec3 normal = orr_vec3_cross(r1, r3);
    double size = orr_vec3_norm(normal), d1 = orr_vec3_norm(r1), d3 = orr_vec3_norm(r3);
    if (!(size > 1e-9 * d1 * d3)) return ORR_E_NUMERIC;
    normal = orr_vec3_scale(1 / size, normal);
    r2 = orr_vec3_axpy(-orr_vec3_dot(r2, normal), normal,
                       r2); // the regularisation: r2 into the plane of r1 and r3
    double d2 = orr_vec3_norm(r2);

    // Gibbs' velocity at r2: sqrt(mu/(N D)) (D x r2/r2 + S).
    orr_vec3 c12 = orr_vec3_cross(r1, r2), c23 = orr_vec3_cross(r2, r3), c31 = orr_vec3_cross(r3, r1);
    orr_vec3 D = orr_vec3_add(c12, orr_vec3_add(c23, c31));
    orr_vec3 N = orr_vec3_axpy(d3, c12, orr_vec3_axpy(d2, c31, orr_vec3_scale(d1, c23)));
    orr_vec3 S = orr_vec3_axpy(d1 - d2, r3, orr_vec3_axpy(d3 - d1, r2, orr_vec3_scale(d2 - d3, r1)));
    if (!(orr_vec3_dot(c12, normal) > 0) || !(orr_vec3_dot(c23, normal) > 0)) return ORR_E_NUMERIC;
    double nd = orr_vec3_norm(N) * orr_vec3_norm(D);
    if (!(nd > 0) || !(d2 > 0)) return ORR_E_NUMERIC;
    orr_vec3 v2 = orr_vec3_scale(sqrt(gm / nd), orr_vec3_axpy(1 / d2, orr_vec3_cross(D, r2), S));
    return orr_kepler_from_state(r2, v2, gm, out);
}
