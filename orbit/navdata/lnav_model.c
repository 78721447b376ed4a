// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/lnav_model.h"

#include <stddef.h>

#include "orbit/force/kepler.h"

orr_vec3 orr_lnav_position(const orr_nav_kepler *k, double tk, orr_vec3 d[ORR_LNAV_N])
{
    const double s = k->sqrt_a_sqrtm, a = s * s, e = k->e, n0 = sqrt(ORR_GPS_GM) / (s * a);
    const double E = orr_kepler_solve(k->m0_rad + (n0 + k->delta_n_radps) * tk, e);
    const double cE = cos(E), sE = sin(E), root = sqrt(1 - e * e), shape = 1 - e * cE;
    const double cn = (cE - e) / shape, sn = root * sE / shape; // of the true anomaly
    const double cw = cos(k->omega_rad), sw = sin(k->omega_rad);
    const double cp = cn * cw - sn * sw, sp = sn * cw + cn * sw; // of the argument of latitude
    const double c2 = cp * cp - sp * sp, s2 = 2 * sp * cp;
    const double phi = atan2(sp, cp), u = phi + k->cus_rad * s2 + k->cuc_rad * c2;
    const double r = a * shape + k->crs_m * s2 + k->crc_m * c2;
    const double i = k->i0_rad + k->idot_radps * tk + k->cis_rad * s2 + k->cic_rad * c2;
    const double node = k->omega0_rad + (k->omega_dot_radps - ORR_GPS_EARTH_RATE_RADPS) * tk -
                        ORR_GPS_EARTH_RATE_RADPS * k->toe_sow_s;
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

    d[ORR_LNAV_SQRT_A] = orr_vec3_axpy(-3 * n0 * tk / s, by_m, orr_vec3_scale(2 * s * shape, radial));
    d[ORR_LNAV_EX] = orr_vec3_axpy(-sw, by_perigee, orr_vec3_scale(cw, by_e));
    d[ORR_LNAV_EY] = orr_vec3_axpy(cw, by_perigee, orr_vec3_scale(sw, by_e));
    d[ORR_LNAV_LAMBDA] = by_m;
    d[ORR_LNAV_DELTA_N] = orr_vec3_scale(tk, by_m);
    d[ORR_LNAV_I0] = by_i;
    d[ORR_LNAV_IDOT] = orr_vec3_scale(tk, by_i);
    d[ORR_LNAV_OMEGA0] = by_node;
    d[ORR_LNAV_OMEGA_DOT] = orr_vec3_scale(tk, by_node);
    d[ORR_LNAV_CRC] = orr_vec3_scale(c2, radial), d[ORR_LNAV_CRS] = orr_vec3_scale(s2, radial);
    d[ORR_LNAV_CUC] = orr_vec3_scale(c2, by_u), d[ORR_LNAV_CUS] = orr_vec3_scale(s2, by_u);
    d[ORR_LNAV_CIC] = orr_vec3_scale(c2, by_i), d[ORR_LNAV_CIS] = orr_vec3_scale(s2, by_i);
    return pos;
}

void orr_lnav_by_elements(const orr_nav_kepler *k, orr_vec3 d[ORR_LNAV_N])
{
    const double cw = cos(k->omega_rad), sw = sin(k->omega_rad);
    const orr_vec3 ex = d[ORR_LNAV_EX], ey = d[ORR_LNAV_EY];
    d[ORR_LNAV_EX] = orr_vec3_axpy(sw, ey, orr_vec3_scale(cw, ex));
    d[ORR_LNAV_EY] = orr_vec3_axpy(k->e * cw, ey, orr_vec3_axpy(-k->e * sw, ex, d[ORR_LNAV_LAMBDA]));
}

void orr_lnav_secular(double a, double e, double i, double *omega_dot, double *delta_n)
{
    const double j2 = ORR_GPS_J2, re = ORR_WGS84_A_M, ci = cos(i), x = 1 - e * e;
    const double n = sqrt(ORR_GPS_GM / (a * a * a)), k = 0.75 * j2 * n * re * re / (a * a);
    *omega_dot = -2 * k * ci / (x * x);
    *delta_n = k * (3 * ci * ci - 1) / (x * sqrt(x)) + k * (5 * ci * ci - 1) / (x * x);
}
