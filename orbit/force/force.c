// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/force.h"

// Attraction of a distant body on the satellite minus that on the Earth: the tide, m/s^2.
static orr_vec3 third_body(orr_vec3 r, orr_vec3 body, double gm)
{
    orr_vec3 d = orr_vec3_sub(body, r);
    double d2 = orr_vec3_dot(d, d), b2 = orr_vec3_dot(body, body);
    orr_vec3 direct = orr_vec3_scale(gm / (d2 * sqrt(d2)), d);
    return orr_vec3_axpy(-gm / (b2 * sqrt(b2)), body, direct);
}

orr_vec3 orr_force_acceleration(const orr_force *f, const orr_sky_point *p, orr_vec3 r)
{
    orr_vec3 a =
        f->earth.degree < 2
            ? orr_gravity_field_gravitation(&f->earth, r)
            : orr_mat3_apply_t(&p->R, orr_gravity_field_gravitation(&f->earth, orr_mat3_apply(&p->R, r)));
    if (f->sun_moon) {
        a = orr_vec3_add(a, third_body(r, p->sun_m, ORR_SUN_GM));
        a = orr_vec3_add(a, third_body(r, p->moon_m, ORR_MOON_GM));
    }
    if (f->srp_mps2 > 0 || f->srp_mps2 < 0) {
        orr_vec3 d = orr_vec3_sub(r, p->sun_m);
        double n = orr_vec3_norm(d), au = ORR_AU_M / n;
        a = orr_vec3_axpy(f->srp_mps2 * au * au / n * orr_force_sunlight(r, p->sun_m), d, a);
    }
    return a;
}

#define ALBEDO_MPS2 1e-9 // at the distance of GPS
#define ALBEDO_RADIUS_M 2.66e7

orr_vec3 orr_force_of_state(const orr_force *f, const orr_sky_point *p, orr_vec3 r, orr_vec3 v)
{
    if (!f->precise) return orr_force_acceleration(f, p, r);
    const orr_vec3 ecef = orr_mat3_apply(&p->R, r);
    orr_vec3 a =
        orr_mat3_apply_t(&p->R, f->earth.degree < 2 ? orr_gravity_field_gravitation(&f->earth, ecef)
                                                    : orr_gravity_field_with_tide(&f->earth, p->tide, ecef));
    if (f->sun_moon) {
        a = orr_vec3_add(a, third_body(r, p->sun_m, ORR_SUN_GM));
        a = orr_vec3_add(a, third_body(r, p->moon_m, ORR_MOON_GM));
    }
    const double r2 = orr_vec3_dot(r, r), rn = sqrt(r2);
    // Schwarzschild's term, IERS Conventions 2010, (10.12).
    const double k = ORR_EGM96_GM / (ORR_LIGHT_MPS * ORR_LIGHT_MPS * r2 * rn);
    a = orr_vec3_axpy(k * (4 * ORR_EGM96_GM / rn - orr_vec3_dot(v, v)), r, a);
    a = orr_vec3_axpy(k * 4 * orr_vec3_dot(r, v), v, a);
    // Light and heat of the Earth press outward, more above the lit side.
    const double day = orr_vec3_dot(r, p->sun_m) / (rn * orr_vec3_norm(p->sun_m));
    const double near = ALBEDO_RADIUS_M / rn;
    a = orr_vec3_axpy(ALBEDO_MPS2 * near * near * (0.65 + 0.35 * day) / rn, r, a);
    orr_vec3 basis[ORR_ECOM_TERMS];
    orr_ecom_basis(r, v, p->sun_m, basis);
    for (int i = 0; i < ORR_ECOM_TERMS; i++) a = orr_vec3_axpy(f->ecom_nmps2[i], basis[i], a);
    return a;
}

orr_mat3 orr_force_gradient(const orr_force *f, orr_vec3 axis, orr_vec3 r)
{
    orr_mat3 g = orr_force_central_gradient(r);
    if (f->earth.degree < 2) return g;
    // a = -c (r (1 - q) + 2 s z) with s = z'r, q = 5 s^2/r^2, c = 3/2 J2 GM R^2/r^5
    const double r2 = orr_vec3_dot(r, r), s = orr_vec3_dot(axis, r), q = 5 * s * s / r2;
    const double c = -1.5 * f->earth.c[2][0] * ORR_EGM96_GM * ORR_EGM96_RADIUS_M * ORR_EGM96_RADIUS_M /
                     (r2 * r2 * sqrt(r2));
    const double x[3] = {r.x, r.y, r.z}, z[3] = {axis.x, axis.y, axis.z};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double b = x[i] * (1 - q) + 2 * s * z[i];
            const double db =
                (i == j ? 1 - q : 0) - x[i] * (10 * s * z[j] - 2 * q * x[j]) / r2 + 2 * z[i] * z[j];
            g.m[i][j] += c * (5 * x[j] / r2 * b - db);
        }
    return g;
}

orr_mat3 orr_force_central_gradient(orr_vec3 r)
{
    double r2 = orr_vec3_dot(r, r), k = ORR_EGM96_GM / (r2 * sqrt(r2)), k3 = 3 * k / r2;
    return (orr_mat3){{{k3 * r.x * r.x - k, k3 * r.x * r.y, k3 * r.x * r.z},
                       {k3 * r.y * r.x, k3 * r.y * r.y - k, k3 * r.y * r.z},
                       {k3 * r.z * r.x, k3 * r.z * r.y, k3 * r.z * r.z - k}}};
}
