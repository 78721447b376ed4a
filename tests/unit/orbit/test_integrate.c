// SPDX-License-Identifier: GPL-3.0-or-later
// The tabulated sky against core/astro, and the integrator against Kepler and against itself.
#include "testing.h"

#include "orbit/force/integrate.h"

static orr_time at_utc(const char *text)
{
    orr_time t = 0;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}

static void sky_agrees_with_the_astronomy_it_tabulates(void **state)
{
    (void)state;
    orr_time from = at_utc("2024-02-04"), to = at_utc("2024-02-05");
    orr_sky *sky = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_sky_init(from, to, ORR_SKY_GCRS, NULL, NULL, &sky, NULL, &d), d);
    for (double t_s = 0; t_s <= 86400; t_s += 1237.3) {
        orr_time t = orr_time_add_s(from, t_s);
        orr_eop e = orr_eop_at(NULL, t, NULL, NULL);
        orr_mat3 R, dR;
        orr_astro_gcrs_to_itrs(t, &e, NULL, &R, &dR);
        orr_sky_point p, q;
        orr_sky_at(sky, t_s, &p);
        orr_sky_force_point(sky, t_s, &q);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                ASSERT_NEAR(p.R.m[i][j], R.m[i][j], 1e-12);   // 0.03 mm at the orbit
                ASSERT_NEAR(p.dR.m[i][j], dR.m[i][j], 3e-15); // 1e-7 m/s
                ASSERT_NEAR(p.R.m[i][j], q.R.m[i][j], 0);
            }
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(p.sun_m, orr_astro_sun(t))), 0, 1.0);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(p.moon_m, orr_astro_moon(t))), 0, 0.1);
    }
    orr_sky_free(sky);
}

static void sky_derivatives_are_derivatives(void **state)
{
    (void)state;
    for (int frame = 0; frame < 2; frame++) {
        orr_sky *sky = NULL;
        orr_diag d = {0};
        orr_time from = at_utc("2016-12-31"), to = at_utc("2017-01-01T12:00"); // across a leap second
        ASSERT_OK(
            orr_sky_init(from, to, frame == 0 ? ORR_SKY_GCRS : ORR_SKY_UNIFORM, NULL, NULL, &sky, NULL, &d),
            d);
        const double h = 5;
        for (double t_s = 100; t_s < 129000; t_s += 7777) {
            orr_sky_point a, b, c;
            orr_sky_at(sky, t_s - h, &a);
            orr_sky_at(sky, t_s, &b);
            orr_sky_at(sky, t_s + h, &c);
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++) { // central differences err by u^3 h^2/6 = 1.6e-12 and u^4 h^2/12
                    ASSERT_NEAR((c.R.m[i][j] - a.R.m[i][j]) / (2 * h), b.dR.m[i][j], 2e-12);
                    ASSERT_NEAR((c.dR.m[i][j] - a.dR.m[i][j]) / (2 * h), b.ddR.m[i][j], 2e-16);
                }
            orr_vec3 r = {2.1e7, -1e7, 1.2e7}, v = {1000, 3000, -2000}, re, ve, r2, v2;
            orr_sky_to_ecef(&b, r, v, &re, &ve);
            orr_sky_from_ecef(&b, re, ve, &r2, &v2);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(r, r2)), 0, 1e-7);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(v, v2)), 0, 1e-7); // R of the table is orthogonal to 1e-13
        }
        orr_sky_free(sky);
    }
}

typedef struct bed {
    orr_force force;
    orr_sky *sky;
    orr_integrator *it;
} bed;

static bed bed_make(int degree, bool sun_moon, double srp)
{
    bed b = {.force = {.sun_moon = sun_moon, .srp_mps2 = srp}};
    orr_diag d = {0};
    ASSERT_OK(orr_gravity_field_init(&b.force.earth, degree, false, &d), d);
    ASSERT_OK(
        orr_sky_init(at_utc("2024-02-04"), at_utc("2024-02-06"), ORR_SKY_GCRS, NULL, NULL, &b.sky, NULL, &d),
        d);
    return b;
}
static void bed_ready(bed *b) // the integrator keeps the force's address
{
    orr_diag d = {0};
    ASSERT_OK(orr_integrator_init(&b->force, b->sky, &b->it, &d), d);
}
static void bed_free(bed *b)
{
    orr_integrator_free(b->it);
    orr_sky_free(b->sky);
}

// Two bodies, eccentricity 0.2: after one period the state is back, and energy has not moved.
static void kepler_orbit_closes(void **state)
{
    (void)state;
    bed b = bed_make(0, false, 0);
    bed_ready(&b);
    const double a = 2.66e7, e = 0.2, mu = ORR_EGM96_GM, period = 2 * ORR_PI * sqrt(a * a * a / mu);
    orr_vec3 r0 = {a * (1 - e), 0, 0},
             v0 = {0, sqrt(mu / a * (1 + e) / (1 - e)) * 0.6, sqrt(mu / a * (1 + e) / (1 - e)) * 0.8};
    orr_vec3 r = r0, v = v0;
    ASSERT_OK(orr_integrate(b.it, 0, period, &r, &v), (orr_diag){0});
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(r, r0)), 0,
                2e-6); // 150 steps; e = 0.2 doubles the curvature at perigee
    double energy0 = 0.5 * orr_vec3_dot(v0, v0) - mu / orr_vec3_norm(r0),
           energy = 0.5 * orr_vec3_dot(v, v) - mu / orr_vec3_norm(r);
    ASSERT_NEAR(energy / energy0, 1, 1e-13);
    r = r0, v = v0; // half a period: apogee
    ASSERT_OK(orr_integrate(b.it, 0, period / 2, &r, &v), (orr_diag){0});
    ASSERT_NEAR(r.x, -a * (1 + e), 1e-5);
    bed_free(&b);
}

// Full force: there and back, and long steps against short ones, also through eclipses.
static void integration_reverses_and_does_not_depend_on_the_step(void **state)
{
    (void)state;
    for (int eclipse = 0; eclipse < 2; eclipse++) {
        bed b = bed_make(8, true, 1e-7);
        bed_ready(&b);
        orr_sky_point p;
        orr_sky_at(b.sky, 0, &p);
        orr_vec3 s = orr_vec3_unit(p.sun_m), up = {0, 0, 1}, side = orr_vec3_unit(orr_vec3_cross(s, up));
        double speed = sqrt(ORR_EGM96_GM / 2.6e7);
        orr_vec3 normal =
            eclipse ? orr_vec3_unit(orr_vec3_cross(s, side)) : s; // orbit plane through, or facing, the Sun
        orr_vec3 r0 = orr_vec3_scale(2.6e7, side), v0 = orr_vec3_scale(speed, orr_vec3_cross(normal, side));
        orr_vec3 r = r0, v = v0, q = r0, w = v0;
        ASSERT_OK(orr_integrate(b.it, 0, 43200, &r, &v), (orr_diag){0});
        for (int i = 0; i < 864; i++) ASSERT_OK(orr_integrate(b.it, 50.0 * i, 50, &q, &w), (orr_diag){0});
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(r, q)), 0, eclipse ? 1e-4 : 2e-6);
        ASSERT_OK(orr_integrate(b.it, 43200, -43200, &r, &v), (orr_diag){0});
        // The penumbra lasts a minute; a quadrature of 15 s over its kinks leaves 1e-9 m/s, which grows for
        // 24 hours.
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(r, r0)), 0, eclipse ? 1e-4 : 2e-6);
        bed_free(&b);
    }
}

// The longest steps that the reference fit takes, a day, four passages of the shadow: against steps of 20 s.
static void steps_of_a_quarter_of_an_hour_are_short_enough(void **state)
{
    (void)state;
    bed b = bed_make(8, true, 1e-7);
    bed_ready(&b);
    orr_sky_point p;
    orr_sky_at(b.sky, 0, &p);
    const orr_vec3 s = orr_vec3_unit(p.sun_m), side = orr_vec3_unit(orr_vec3_cross(s, (orr_vec3){0, 0, 1})),
                   normal = orr_vec3_unit(orr_vec3_cross(s, side));
    const double radius = 2.55e7, speed = sqrt(ORR_EGM96_GM / radius);
    orr_vec3 r = orr_vec3_scale(radius, side), v = orr_vec3_scale(speed, orr_vec3_cross(normal, side));
    orr_vec3 q = r, w = v;
    orr_integrator_set(b.it, &b.force, 900);
    size_t borders = 0;
    double furthest = 0;
    for (int k = 0; k < 96; k++) {
        double dt[ORR_INTEGRATE_BORDERS];
        const size_t n = orr_integrate_borders(b.it, 900.0 * k, 900, r, v, dt);
        for (size_t i = 0; i < n; i++) assert_true(dt[i] > (i > 0 ? dt[i - 1] : 0) && dt[i] < 900);
        borders += n;
        ASSERT_OK(orr_integrate(b.it, 900.0 * k, 900, &r, &v), (orr_diag){0});
        for (int i = 0; i < 45; i++)
            ASSERT_OK(orr_integrate(b.it, 900.0 * k + 20 * i, 20, &q, &w), (orr_diag){0});
        furthest = fmax(furthest, orr_vec3_norm(orr_vec3_sub(r, q)));
    }
    // two revolutions: into and out of penumbra and umbra, twice
    assert_int_equal(borders, 8);
    print_message("after a day in steps of 900 s: %.2e m\n", furthest);
    // Truncation of the stepper, a drift along the orbit: what 1e-13 m/s^2 do in a day, a ten-thousandth of f0.
    ASSERT_NEAR(furthest, 0, 2e-4);
    bed_free(&b);
}

static void nonsense_is_an_error_not_a_number(void **state)
{
    (void)state;
    bed b = bed_make(2, false, 0);
    bed_ready(&b);
    orr_vec3 r = {10, 0, 0}, v = {0, 0, 0};
    assert_int_equal(orr_integrate(b.it, 0, 900, &r, &v), ORR_E_NUMERIC);
    orr_diag d = {0};
    orr_sky *sky = NULL;
    assert_int_equal(orr_sky_init(10, 5, ORR_SKY_GCRS, NULL, NULL, &sky, NULL, &d), ORR_E_ARG);
    bed_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sky_agrees_with_the_astronomy_it_tabulates),
        cmocka_unit_test(sky_derivatives_are_derivatives),
        cmocka_unit_test(kepler_orbit_closes),
        cmocka_unit_test(integration_reverses_and_does_not_depend_on_the_step),
        cmocka_unit_test(steps_of_a_quarter_of_an_hour_are_short_enough),
        cmocka_unit_test(nonsense_is_an_error_not_a_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
