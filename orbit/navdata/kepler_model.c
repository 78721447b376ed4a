// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/kepler_model.h"

#include <stddef.h>

#include "core/astro.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"

orr_kepler_axes orr_kepler_axes_of(orr_sat sat, uint8_t message)
{
    orr_kepler_axes x;
    orr_broadcast_constants(orr_sat_system(sat), &x.gm, &x.earth_rate);
    x.turn = message == ORR_NAV_D2 ? 0 : x.earth_rate;
    return x;
}

orr_vec3 orr_kepler_tilted(const orr_kepler_axes *x, double tk, orr_vec3 pos)
{
    const orr_mat3 back = orr_mat3_rot3(-x->earth_rate * tk);
    const orr_vec3 p = orr_mat3_apply(&back, pos);
    const double c = cos(5 * ORR_RAD_PER_DEG), s = sin(5 * ORR_RAD_PER_DEG);
    return orr_vec3_make(p.x, c * p.y + s * p.z, c * p.z - s * p.y);
}

orr_vec3 orr_kepler_position(const orr_kepler_axes *x, const orr_nav_kepler *k, double tk,
                             orr_vec3 d[ORR_KEPLER_N])
{
    const double s = k->sqrt_a_sqrtm, a0 = s * s, e = k->e, n0 = sqrt(x->gm) / (s * a0);
    const double a = a0 + k->a_dot_mps * tk, dn = k->delta_n_radps + 0.5 * k->delta_n_dot_radps2 * tk;
    const double E = orr_kepler_solve(k->m0_rad + (n0 + dn) * tk, e);
    const double cE = cos(E), sE = sin(E), root = sqrt(1 - e * e), shape = 1 - e * cE;
    const double cn = (cE - e) / shape, sn = root * sE / shape; // of the true anomaly
    const double cw = cos(k->omega_rad), sw = sin(k->omega_rad);
    const double cp = cn * cw - sn * sw, sp = sn * cw + cn * sw; // of the argument of latitude
    const double c2 = cp * cp - sp * sp, s2 = 2 * sp * cp;
    const double phi = atan2(sp, cp), u = phi + k->cus_rad * s2 + k->cuc_rad * c2;
    const double r = a * shape + k->crs_m * s2 + k->crc_m * c2;
    const double i = k->i0_rad + k->idot_radps * tk + k->cis_rad * s2 + k->cic_rad * c2;
    const double node = k->omega0_rad + (k->omega_dot_radps - x->turn) * tk - x->earth_rate * k->toe_sow_s;
    const double cu = cos(u), su = sin(u), ci = cos(i), si = sin(i), co = cos(node), so = sin(node);
    const orr_vec3 P = {co, so, 0}, Q = {-ci * so, ci * co, si}, W = {si * so, -si * co, ci};
    const orr_vec3 radial = orr_vec3_axpy(su, Q, orr_vec3_scale(cu, P));
    const orr_vec3 along = orr_vec3_axpy(cu, Q, orr_vec3_scale(-su, P));
    const orr_vec3 pos = orr_vec3_scale(r, radial);
    if (d == NULL) return pos;

    // What a metre of radius and a radian of u, i and the node do to the position, and phi through the
    // harmonics.
    const orr_vec3 by_u = orr_vec3_scale(r, along), by_i = orr_vec3_scale(r * su, W),
                   by_node = {-pos.y, pos.x, 0};
    orr_vec3 by_phi = orr_vec3_scale(1 + 2 * (k->cus_rad * c2 - k->cuc_rad * s2), by_u);
    by_phi = orr_vec3_axpy(2 * (k->crs_m * c2 - k->crc_m * s2), radial, by_phi);
    by_phi = orr_vec3_axpy(2 * (k->cis_rad * c2 - k->cic_rad * s2), by_i, by_phi);

    // Mean anomaly and e move the true anomaly and the radius of the ellipse.
    const double root3 = root * root * root, q = 1 + e * cn;
    const orr_vec3 by_m = orr_vec3_axpy(q * q / root3, by_phi, orr_vec3_scale(a * e * sn / root, radial));
    const orr_vec3 by_e =
        orr_vec3_axpy(sn * (2 + e * cn) / (root * root), by_phi, orr_vec3_scale(-a * cn, radial));
    // omega forward and M0 back by as much, divided by e: (1 - q^2/root^3)/e without the difference of near
    // numbers.
    const double turn = -(e * (1 + root + root * root) / (1 + root) + 2 * cn + e * cn * cn) / root3;
    const orr_vec3 by_perigee = orr_vec3_axpy(turn, by_phi, orr_vec3_scale(-a * sn / root, radial));

    d[ORR_KEPLER_SQRT_A] = orr_vec3_axpy(-3 * n0 * tk / s, by_m, orr_vec3_scale(2 * s * shape, radial));
    d[ORR_KEPLER_EX] = orr_vec3_axpy(-sw, by_perigee, orr_vec3_scale(cw, by_e));
    d[ORR_KEPLER_EY] = orr_vec3_axpy(cw, by_perigee, orr_vec3_scale(sw, by_e));
    d[ORR_KEPLER_LAMBDA] = by_m;
    d[ORR_KEPLER_DELTA_N] = orr_vec3_scale(tk, by_m);
    d[ORR_KEPLER_N_DOT] = orr_vec3_scale(0.5 * tk * tk, by_m);
    d[ORR_KEPLER_A_DOT] = orr_vec3_scale(tk * shape, radial);
    d[ORR_KEPLER_I0] = by_i;
    d[ORR_KEPLER_IDOT] = orr_vec3_scale(tk, by_i);
    d[ORR_KEPLER_OMEGA0] = by_node;
    d[ORR_KEPLER_OMEGA_DOT] = orr_vec3_scale(tk, by_node);
    d[ORR_KEPLER_CRC] = orr_vec3_scale(c2, radial), d[ORR_KEPLER_CRS] = orr_vec3_scale(s2, radial);
    d[ORR_KEPLER_CUC] = orr_vec3_scale(c2, by_u), d[ORR_KEPLER_CUS] = orr_vec3_scale(s2, by_u);
    d[ORR_KEPLER_CIC] = orr_vec3_scale(c2, by_i), d[ORR_KEPLER_CIS] = orr_vec3_scale(s2, by_i);
    return pos;
}

void orr_kepler_by_elements(const orr_nav_kepler *k, orr_vec3 d[ORR_KEPLER_N])
{
    const double cw = cos(k->omega_rad), sw = sin(k->omega_rad);
    const orr_vec3 ex = d[ORR_KEPLER_EX], ey = d[ORR_KEPLER_EY];
    d[ORR_KEPLER_EX] = orr_vec3_axpy(sw, ey, orr_vec3_scale(cw, ex));
    d[ORR_KEPLER_EY] = orr_vec3_axpy(k->e * cw, ey, orr_vec3_axpy(-k->e * sw, ex, d[ORR_KEPLER_LAMBDA]));
}

void orr_kepler_secular(double a, double e, double i, double *omega_dot, double *delta_n)
{
    const double j2 = ORR_GPS_J2, re = ORR_WGS84_A_M, ci = cos(i), x = 1 - e * e;
    const double n = sqrt(ORR_GPS_GM / (a * a * a)), k = 0.75 * j2 * n * re * re / (a * a);
    *omega_dot = -2 * k * ci / (x * x);
    *delta_n = k * (3 * ci * ci - 1) / (x * sqrt(x)) + k * (5 * ci * ci - 1) / (x * x);
}
