// SPDX-License-Identifier: GPL-3.0-or-later
// Forces: closed forms, field equations, shadow geometry.
#include "testing.h"

#include "core/earth.h"
#include "orbit/force/force.h"

static orr_gravity_field field(int degree, bool zonal)
{
    orr_gravity_field f;
    orr_diag d = {0};
    ASSERT_OK(orr_gravity_field_init(&f, degree, zonal, &d), d);
    return f;
}

static const orr_vec3 places[] = {
    {26.5e6, 1e6, 2e6}, {-1.2e7, 1.9e7, 1.3e7}, {3e6, -2e6, 2.55e7}, {-6.9e6, 1e5, -4e5}, {1.0, 2.0, 2.9e7}};

static void degree_zero_is_newton(void **state)
{
    (void)state;
    orr_gravity_field f = field(0, false);
    orr_vec3 a = orr_gravity_field_gravitation(&f, (orr_vec3){2.0e7, 0, 0});
    ASSERT_NEAR(a.x, -ORR_EGM96_GM / 4.0e14, 1e-15);
    ASSERT_NEAR(a.y, 0, 0);
}

// J2 alone: a = -mu r/r^3 - 3/2 J2 mu R^2/r^5 (x (1 - 5 z^2/r^2), y (..), z (3 - 5 z^2/r^2)).
static void degree_two_zonal_is_the_textbook_j2(void **state)
{
    (void)state;
    orr_gravity_field f = field(2, true);
    const double j2 = 0.484165371736e-3 * sqrt(5.0);
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        orr_vec3 r = places[i], a = orr_gravity_field_gravitation(&f, r);
        double n = orr_vec3_norm(r), q = 5 * r.z * r.z / (n * n);
        double k = 1.5 * j2 * ORR_EGM96_GM * ORR_EGM96_RADIUS_M * ORR_EGM96_RADIUS_M / pow(n, 5),
               c = ORR_EGM96_GM / pow(n, 3);
        ASSERT_NEAR(a.x, -c * r.x - k * r.x * (1 - q), 1e-14); // 1e-15 of 10 m/s^2 at the lowest place
        ASSERT_NEAR(a.y, -c * r.y - k * r.y * (1 - q), 1e-14);
        ASSERT_NEAR(a.z, -c * r.z - k * r.z * (3 - q), 1e-14);
    }
}

// In empty space gravitation has neither divergence nor curl: every coefficient's term is harmonic, or a
// recursion is wrong.
static void field_is_harmonic_and_irrotational(void **state)
{
    (void)state;
    orr_gravity_field f = field(12, false);
    const double h = 200.0;
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        double g[3][3]; // g[j][k] = d a_j / d x_k
        for (int k = 0; k < 3; k++) {
            orr_vec3 e = {k == 0 ? h : 0, k == 1 ? h : 0, k == 2 ? h : 0};
            orr_vec3 p = orr_gravity_field_gravitation(&f, orr_vec3_add(places[i], e));
            orr_vec3 m = orr_gravity_field_gravitation(&f, orr_vec3_sub(places[i], e));
            orr_vec3 d = orr_vec3_scale(0.5 / h, orr_vec3_sub(p, m));
            g[0][k] = d.x, g[1][k] = d.y, g[2][k] = d.z;
        }
        double size = ORR_EGM96_GM / pow(orr_vec3_norm(places[i]), 3);
        double tol = size * 1e-8; // central difference: (h/r)^2 = 1e-9, rounding 1e-16 r/h = 1e-11
        ASSERT_NEAR(g[0][0] + g[1][1] + g[2][2], 0, tol);
        ASSERT_NEAR(g[0][1] - g[1][0], 0, tol);
        ASSERT_NEAR(g[0][2] - g[2][0], 0, tol);
        ASSERT_NEAR(g[1][2] - g[2][1], 0, tol);
    }
}

static void zonal_field_is_symmetric_about_the_axis(void **state)
{
    (void)state;
    orr_gravity_field f = field(8, true);
    orr_mat3 turn = orr_mat3_rot3(1.234);
    orr_vec3 a = orr_gravity_field_gravitation(&f, orr_mat3_apply(&turn, places[1]));
    orr_vec3 b = orr_mat3_apply(&turn, orr_gravity_field_gravitation(&f, places[1]));
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a, b)), 0, 1e-15);
}

// The ellipsoid's own gravitation differs from the Earth's by anomalies of tens of mGal at the surface, much
// less aloft.
static void field_agrees_with_the_normal_ellipsoid(void **state)
{
    (void)state;
    orr_gravity_field f = field(12, false);
    for (size_t i = 0; i < 3; i++) {
        orr_vec3 a = orr_gravity_field_gravitation(&f, places[i]),
                 n = orr_earth_normal_gravitation(places[i]);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a, n)) / orr_vec3_norm(n), 0,
                    3e-6); // C22 is 2.4e-6, times (R/r)^2 3 < 1
    }
}

static void bad_degree_is_refused(void **state)
{
    (void)state;
    orr_gravity_field f;
    orr_diag d = {0};
    assert_int_equal(orr_gravity_field_init(&f, 22, false, &d), ORR_E_ARG);
    assert_int_equal(orr_gravity_field_init(&f, -1, false, &d), ORR_E_ARG);
    assert_non_null(strstr(d.text, "-1"));
}

// Tide of a distant body on the line to it: 2 GM r/d^3 outwards, on the far side likewise, -GM r/d^3 across.
static void tides_have_their_closed_form(void **state)
{
    (void)state;
    orr_force f = {.earth = field(0, false), .sun_moon = true};
    orr_sky_point p = {.R = orr_mat3_identity(), .sun_m = {1.5e13, 0, 0}, .moon_m = {3.8e13, 0, 0}};
    const double r = 2.6e7, unit = ORR_SUN_GM * r / 3.375e39;
    double central = ORR_EGM96_GM / (r * r);
    orr_vec3 near = orr_force_acceleration(&f, &p, (orr_vec3){r, 0, 0});
    orr_vec3 side = orr_force_acceleration(&f, &p, (orr_vec3){0, r, 0});
    ASSERT_NEAR((near.x + central) / unit, 2, 2e-3); // what is left of a subtraction of 6e-7: rounding
    ASSERT_NEAR((side.y + central) / unit, -1, 2e-3);
}

static void shadow_is_dark_behind_and_grey_at_the_limb(void **state)
{
    (void)state;
    const orr_vec3 sun = {ORR_AU_M, 0, 0};
    const double r = 2.656e7;
    ASSERT_NEAR(orr_force_sunlight((orr_vec3){r, 0, 0}, sun), 1, 0);
    ASSERT_NEAR(orr_force_sunlight((orr_vec3){-r, 0, 0}, sun), 0, 0);
    ASSERT_NEAR(orr_force_sunlight((orr_vec3){-1, r, 0}, sun), 1, 0);
    // The Sun's centre on the limb leaves half of it: the line of sight touches the Earth.
    double angle = asin(ORR_SHADOW_RADIUS_M / r), parallax = r * sin(angle) / ORR_AU_M;
    orr_vec3 limb = {-r * cos(angle + parallax), r * sin(angle + parallax), 0};
    ASSERT_NEAR(orr_force_sunlight(limb, sun), 0.5, 0.01);
    // Across the penumbra light only grows, and the penumbra is as wide as the Sun's disc, 0.533 deg.
    double last = 0, first_light = 0, full = 0;
    for (double a = 0.10; a < 0.40; a += 1e-5) {
        double light = orr_force_sunlight((orr_vec3){-r * cos(a), r * sin(a), 0}, sun);
        assert_true(light >= last);
        if (last <= 0 && light > 0) first_light = a;
        if (last < 1 && light >= 1) full = a;
        last = light;
    }
    ASSERT_NEAR((full - first_light) * ORR_DEG_PER_RAD, 2 * ORR_SUN_RADIUS_M / ORR_AU_M * ORR_DEG_PER_RAD,
                0.002);
}

static void gradient_is_the_derivative_of_the_central_field(void **state)
{
    (void)state;
    orr_gravity_field f = field(0, false);
    orr_vec3 r = places[1], e = {30, -20, 50};
    orr_mat3 G = orr_force_central_gradient(r);
    orr_vec3 d = orr_vec3_sub(orr_gravity_field_gravitation(&f, orr_vec3_add(r, e)),
                              orr_gravity_field_gravitation(&f, orr_vec3_sub(r, e)));
    orr_vec3 g = orr_vec3_scale(2, orr_mat3_apply(&G, e));
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(d, g)) / orr_vec3_norm(g), 0, 1e-8);
    ASSERT_NEAR(G.m[0][0] + G.m[1][1] + G.m[2][2], 0, 1e-22);
}

// Panels that turn about the orbit's normal alone meet the Sun aslant by beta; what they throw back leaves along their own
// normal, which is the Sun's projection. That is constant along the whole orbit, and so are its coefficients of D and Y:
// F = -((1 - q) cos b + 2 q cos^3 b) D + 2 q cos^2 b sin b Y, for a part q thrown back. For a satellite that yaws Y stands across
// the radius.
static void radiation_on_geostationary_satellites_is_constant(void **state)
{
    (void)state;
    const double beta = 0.28, q = 0.25, radius = 4.2164e7, speed = 3074.66;
    const orr_vec3 far = {1.496e11 * cos(beta), 0, 1.496e11 * sin(beta)};
    for (int k = 0; k < 24; k++) {
        const double u = 0.3 + k * ORR_PI / 12;
        const orr_vec3 r = {radius * cos(u), radius * sin(u), 0}, v = {-speed * sin(u), speed * cos(u), 0},
                       sun = orr_vec3_add(far, r), // its direction is the same all along
            normal = {0, 0, 1}, d = orr_vec3_unit(far), panel = {1, 0, 0};
        orr_vec3 basis[ORR_ECOM_TERMS], f = orr_vec3_scale(-(1 - q) * cos(beta), d);
        f = orr_vec3_axpy(-2 * q * cos(beta) * cos(beta), panel, f);
        orr_ecom_basis(r, v, sun, basis);
        const orr_vec3 D = orr_vec3_unit(far), Y = orr_vec3_unit(basis[1]), B = orr_vec3_unit(basis[2]);
        ASSERT_NEAR(orr_vec3_dot(Y, normal), cos(beta), 1e-12);
        ASSERT_NEAR(orr_vec3_dot(f, D), -(1 - q) * cos(beta) - 2 * q * pow(cos(beta), 3), 1e-12);
        ASSERT_NEAR(orr_vec3_dot(f, Y), 2 * q * cos(beta) * cos(beta) * sin(beta), 1e-12);
        ASSERT_NEAR(orr_vec3_dot(f, B), 0, 1e-12);
        // One that is inclined by 50 degrees yaws.
        const double c = cos(0.9), s = sin(0.9);
        const orr_vec3 ri = {r.x, c * r.y, s * r.y}, vi = {v.x, c * v.y, s * v.y};
        orr_ecom_basis(ri, vi, orr_vec3_add(far, ri), basis);
        ASSERT_NEAR(orr_vec3_dot(orr_vec3_unit(basis[1]), orr_vec3_unit(ri)), 0, 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degree_zero_is_newton),
        cmocka_unit_test(degree_two_zonal_is_the_textbook_j2),
        cmocka_unit_test(field_is_harmonic_and_irrotational),
        cmocka_unit_test(zonal_field_is_symmetric_about_the_axis),
        cmocka_unit_test(field_agrees_with_the_normal_ellipsoid),
        cmocka_unit_test(bad_degree_is_refused),
        cmocka_unit_test(tides_have_their_closed_form),
        cmocka_unit_test(shadow_is_dark_behind_and_grey_at_the_limb),
        cmocka_unit_test(gradient_is_the_derivative_of_the_central_field),
        cmocka_unit_test(radiation_on_geostationary_satellites_is_constant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
