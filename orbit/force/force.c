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

double orr_force_limb_distance(orr_vec3 r, orr_vec3 sun)
{
    if (orr_vec3_dot(r, sun) >= 0) return HUGE_VAL; // the day side
    orr_vec3 d = orr_vec3_sub(sun, r);
    double dn = orr_vec3_norm(d), rn = orr_vec3_norm(r);
    double cosine = -orr_vec3_dot(r, d) / (dn * rn);
    double separation = acos(cosine < 1.0 ? cosine : 1.0);
    return (separation - asin(ORR_EARTH_SHADOW_RADIUS_M / rn)) / asin(ORR_SUN_RADIUS_M / dn);
}

double orr_force_sunlight(orr_vec3 r, orr_vec3 sun)
{
    double x = orr_force_limb_distance(r, sun);
    if (x >= 1) return 1.0;
    if (x <= -1) return 0.0;
    return 0.5 + (x * sqrt(1 - x * x) + asin(x)) / ORR_PI;
}

orr_vec3 orr_force_acceleration(const orr_force *f, const orr_sky_point *p, orr_vec3 r)
{
    orr_vec3 a =
        f->earth.degree < 2
            ? orr_gravity_field_gravitation(&f->earth, r)
            : orr_mat3_apply_t(&p->R, orr_gravity_field_gravitation(&f->earth, orr_mat3_apply(&p->R, r)));
    if (f->sun_moon) {
        a = orr_vec3_add(a, third_body(r, p->sun_m, ORR_GM_SUN));
        a = orr_vec3_add(a, third_body(r, p->moon_m, ORR_GM_MOON));
    }
    if (f->srp_mps2 > 0 || f->srp_mps2 < 0) {
        orr_vec3 d = orr_vec3_sub(r, p->sun_m);
        double n = orr_vec3_norm(d), au = ORR_AU_M / n;
        a = orr_vec3_axpy(f->srp_mps2 * au * au / n * orr_force_sunlight(r, p->sun_m), d, a);
    }
    return a;
}

orr_mat3 orr_force_central_gradient(orr_vec3 r)
{
    double r2 = orr_vec3_dot(r, r), k = ORR_EGM96_GM / (r2 * sqrt(r2)), k3 = 3 * k / r2;
    return (orr_mat3){{{k3 * r.x * r.x - k, k3 * r.x * r.y, k3 * r.x * r.z},
                       {k3 * r.y * r.x, k3 * r.y * r.y - k, k3 * r.y * r.z},
                       {k3 * r.z * r.x, k3 * r.z * r.y, k3 * r.z * r.z - k}}};
}
