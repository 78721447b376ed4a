// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/make/force.h"

#define PRESSURE 4.5391e-6 // N/m^2 at 1 au: 1360.8 W/m^2 over c (Kopp and Lean 2011)
#define LOVE_K2 0.29525    // IERS Conventions 2010, table 6.3 (elastic, degree 2)

void orr_sample_sky_at(orr_time t, orr_sample_sky *sky)
{
    orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &sky->itrs_gcrs, NULL);
    sky->sun_m = orr_astro_sun(t);
    sky->moon_m = orr_astro_moon(t);
}

// Direct attraction less that of the Earth's centre.
static orr_vec3 third_body(double gm, orr_vec3 body, orr_vec3 r)
{
    orr_vec3 d = orr_vec3_sub(body, r);
    double nd = orr_vec3_norm(d), nb = orr_vec3_norm(body);
    return orr_vec3_axpy(-gm / (nb * nb * nb), body, orr_vec3_scale(gm / (nd * nd * nd), d));
}

// The bulge that a body raises, k2 alone: U = k2 GM_b R^5 / (2 r_b^3 r^3) (3 cos^2 - 1) (Montenbruck and Gill
// 2000, 3.7.2).
static orr_vec3 tide(double gm, orr_vec3 body, orr_vec3 r)
{
    double n = orr_vec3_norm(r), nb = orr_vec3_norm(body);
    orr_vec3 u = orr_vec3_scale(1 / n, r), ub = orr_vec3_scale(1 / nb, body);
    double c = orr_vec3_dot(u, ub);
    double k = 0.5 * LOVE_K2 * gm * pow(ORR_EGM96_RADIUS_M, 5) / (pow(nb, 3) * pow(n, 4));
    return orr_vec3_axpy(k * (3 - 15 * c * c), u, orr_vec3_scale(6 * k * c, ub));
}

// Schwarzschild's term (IERS Conventions 2010, eq. (10.12), beta = gamma = 1).
static orr_vec3 relativity(orr_vec3 r, orr_vec3 v)
{
    double n = orr_vec3_norm(r), k = ORR_EGM96_GM / (ORR_LIGHT_MPS * ORR_LIGHT_MPS * n * n * n);
    orr_vec3 a = orr_vec3_scale(k * (4 * ORR_EGM96_GM / n - orr_vec3_dot(v, v)), r);
    return orr_vec3_axpy(4 * k * orr_vec3_dot(r, v), v, a);
}

double orr_sample_sunlight(orr_vec3 r, orr_vec3 sun)
{
    orr_vec3 to_sun = orr_vec3_sub(sun, r);
    double ds = orr_vec3_norm(to_sun), de = orr_vec3_norm(r);
    double a = asin(ORR_SUN_RADIUS_M / ds), b = asin(ORR_SHADOW_RADIUS_M / de); // discs as seen
    orr_vec3 cross = orr_vec3_cross(r, to_sun);
    double c = atan2(orr_vec3_norm(cross), -orr_vec3_dot(r, to_sun)); // between their centres
    if (c >= a + b) return 1;
    if (c <= b - a) return 0;
    double x = (c * c + a * a - b * b) / (2 * c), y = sqrt(fmax(a * a - x * x, 0));
    double lens =
        a * a * acos(fmax(-1, fmin(1, x / a))) + b * b * acos(fmax(-1, fmin(1, (c - x) / b))) - c * y;
    return 1 - lens / (ORR_PI * a * a);
}

// Force over pressure of a flat surface of area m^2 whose normal n looks at angle acos(c) from the Sun's
// direction s.
static orr_vec3 face(double area, double rho, double delta, orr_vec3 s, orr_vec3 n)
{
    double c = orr_vec3_dot(s, n);
    if (c <= 0) return (orr_vec3){0, 0, 0};
    return orr_vec3_axpy(-area * c * 2 * (delta / 3 + rho * c), n, orr_vec3_scale(-area * c * (1 - rho), s));
}

static orr_vec3 sunlight_pressure(const orr_sample_body *b, orr_vec3 sun, orr_vec3 r)
{
    double light = orr_sample_sunlight(r, sun);
    orr_vec3 d = orr_vec3_sub(sun, r), s = orr_vec3_unit(d), z = orr_vec3_scale(-1, orr_vec3_unit(r));
    orr_vec3 y = orr_vec3_unit(orr_vec3_cross(z, s)), x = orr_vec3_cross(y, z);
    orr_vec3 f = face(b->wing_m2, b->wing_rho, b->wing_delta, s, s); // the wing follows the Sun
    f = orr_vec3_add(f, face(b->x_m2, b->box_rho, b->box_delta, s, x));
    f = orr_vec3_add(f, face(b->z_m2, b->box_rho, b->box_delta, s, z));
    f = orr_vec3_add(f, face(b->z_m2, b->box_rho, b->box_delta, s, orr_vec3_scale(-1, z)));
    double au = ORR_AU_M / orr_vec3_norm(d);
    f = orr_vec3_scale(PRESSURE * au * au / b->mass_kg, f);
    return orr_vec3_scale(light, orr_vec3_axpy(b->y_bias_mps2, y, f));
}

orr_vec3 orr_sample_acceleration(const orr_sample_gravity *g, const orr_sample_sky *sky,
                                 const orr_sample_body *body, orr_vec3 r, orr_vec3 v)
{
    orr_vec3 a =
        orr_mat3_apply_t(&sky->itrs_gcrs, orr_sample_gravitation(g, orr_mat3_apply(&sky->itrs_gcrs, r)));
    a = orr_vec3_add(a, third_body(ORR_SUN_GM, sky->sun_m, r));
    a = orr_vec3_add(a, third_body(ORR_MOON_GM, sky->moon_m, r));
    a = orr_vec3_add(a, tide(ORR_SUN_GM, sky->sun_m, r));
    a = orr_vec3_add(a, tide(ORR_MOON_GM, sky->moon_m, r));
    a = orr_vec3_add(a, relativity(r, v));
    return orr_vec3_add(a, sunlight_pressure(body, sky->sun_m, r));
}
