// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/motion.h"

static const double U = ORR_EARTH_RATE_RADPS;

orr_mat3 orr_body_from_enu(orr_angles a)
{
    orr_mat3 r3 = orr_mat3_rot3(-a.heading_rad), r1 = orr_mat3_rot1(a.pitch_rad),
             r2 = orr_mat3_rot2(a.roll_rad);
    orr_mat3 r13 = orr_mat3_mul(&r1, &r3);
    return orr_mat3_mul(&r2, &r13);
}

orr_angles orr_angles_from_body_enu(const orr_mat3 *L)
{
    orr_angles a;
    double level = hypot(L->m[1][0], L->m[1][1]);
    a.pitch_rad = atan2(L->m[1][2], level);
    if (level > 1e-12) {
        a.heading_rad = atan2(L->m[1][0], L->m[1][1]);
        a.roll_rad = atan2(-L->m[0][2], L->m[2][2]);
    } else {
        a.heading_rad = atan2(-L->m[0][1], L->m[0][0]);
        a.roll_rad = 0.0;
    }
    if (a.heading_rad < 0.0) a.heading_rad += 2.0 * ORR_PI;
    return a;
}

static orr_mat3 enu_at(orr_vec3 r_m)
{
    orr_geodetic g = orr_earth_from_ecef(r_m);
    return orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
}

orr_angles orr_motion_angles(const orr_motion *m)
{
    orr_mat3 E = enu_at(m->r_m), B = orr_mat3_from_quat(m->q_be), Et = orr_mat3_transpose(&E);
    orr_mat3 L = orr_mat3_mul(&B, &Et);
    return orr_angles_from_body_enu(&L);
}

double orr_heading_shown_deg(double heading_rad, int decimals)
{
    double unit = pow(10.0, -decimals), deg = nearbyint(heading_rad * ORR_DEG_PER_RAD / unit) * unit;
    return deg < 360.0 - 0.5 * unit ? deg + 0.0 : 0.0;
}

orr_vec3 orr_motion_velocity_enu(const orr_motion *m)
{
    orr_mat3 E = enu_at(m->r_m);
    return orr_mat3_apply(&E, m->v_mps);
}

orr_vec3 orr_motion_absolute_acceleration(const orr_motion *m)
{
    return orr_vec3_make(m->a_mps2.x - 2.0 * U * m->v_mps.y - U * U * m->r_m.x,
                         m->a_mps2.y + 2.0 * U * m->v_mps.x - U * U * m->r_m.y, m->a_mps2.z);
}

void orr_motion_sense(const orr_motion *m, orr_vec3 gravitation_mps2, orr_vec3 *rate_radps,
                      orr_vec3 *force_mps2)
{
    orr_mat3 B = orr_mat3_from_quat(m->q_be);
    *rate_radps = orr_vec3_make(m->w_radps.x + U * B.m[0][2], m->w_radps.y + U * B.m[1][2],
                                m->w_radps.z + U * B.m[2][2]);
    *force_mps2 = orr_mat3_apply(&B, orr_vec3_sub(orr_motion_absolute_acceleration(m), gravitation_mps2));
}

// Vector part of conj(a) b.
static orr_vec3 conj_mul_vec(const double a[4], const double b[4])
{
    return orr_vec3_make(a[0] * b[1] - a[1] * b[0] - (a[2] * b[3] - a[3] * b[2]),
                         a[0] * b[2] - a[2] * b[0] - (a[3] * b[1] - a[1] * b[3]),
                         a[0] * b[3] - a[3] * b[0] - (a[1] * b[2] - a[2] * b[1]));
}

void orr_rates_from_quat(const double p[4], const double d1[4], const double d2[4], orr_quat *unit,
                         orr_vec3 *w_radps, orr_vec3 *wdot_radps2)
{
    // With p = s q: vec(conj(p) p') = s^2 w / 2, and vec(conj(p) p'') is half the derivative of s^2 w,
    // because conj(p') p' has no vector part.
    double n2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3];
    double n2_dot = 2.0 * (p[0] * d1[0] + p[1] * d1[1] + p[2] * d1[2] + p[3] * d1[3]);
    double inv = 1.0 / sqrt(n2);
    *unit = (orr_quat){p[0] * inv, p[1] * inv, p[2] * inv, p[3] * inv};
    orr_vec3 w = orr_vec3_scale(2.0 / n2, conj_mul_vec(p, d1));
    orr_vec3 wd = orr_vec3_scale(2.0 / n2, conj_mul_vec(p, d2));
    *w_radps = w;
    *wdot_radps2 = orr_vec3_axpy(-n2_dot / n2, w, wd);
}

double orr_motion_eotvos(const orr_motion *m, double *round_mps2)
{
    orr_geodetic g = orr_earth_from_ecef(m->r_m);
    orr_mat3 E = orr_earth_enu_from_ecef(g.lat_rad, g.lon_rad);
    orr_vec3 v = orr_mat3_apply(&E, m->v_mps);
    double M, N;
    orr_earth_radii(g.lat_rad, &M, &N);
    *round_mps2 = v.x * v.x / (N + g.height_m) + v.y * v.y / (M + g.height_m);
    return 2.0 * U * v.x * cos(g.lat_rad) + *round_mps2;
}
