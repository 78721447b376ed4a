// SPDX-License-Identifier: GPL-3.0-or-later
// Nominal yaw steering against its closed form, and where antennas are then.
#include "testing.h"

#include "orbit/spacecraft/attitude.h"

#define DEG ORR_RAD_PER_DEG

// A circular orbit in the x-y plane, the Sun beta above it over the x axis; mu counts from midnight.
static void place(double mu, double beta, orr_vec3 *r, orr_vec3 *v, orr_vec3 *sun)
{
    *r = (orr_vec3){-2.656e7 * cos(mu), -2.656e7 * sin(mu), 0};
    *v = (orr_vec3){3874 * sin(mu), -3874 * cos(mu), 0};
    *sun = (orr_vec3){1.496e11 * cos(beta), 0, 1.496e11 * sin(beta)};
}

// tan(yaw) = -tan(beta) / sin(mu), mu from midnight (Bar-Sever 1996); the Sun's finite distance turns it by
// 2e-4.
static void yaw_is_the_closed_form(void **state)
{
    (void)state;
    for (double beta = -70; beta < 71; beta += 20)
        for (double mu = 5; mu < 360; mu += 10) {
            orr_vec3 r, v, sun;
            orr_attitude a;
            place(mu * DEG, beta * DEG, &r, &v, &sun);
            assert_int_equal(orr_attitude_nominal(r, v, sun, &a), ORR_OK);
            ASSERT_NEAR(a.beta_rad, beta * DEG, 1e-12);
            double yaw = atan2(-tan(beta * DEG), sin(mu * DEG));
            ASSERT_NEAR(remainder(a.yaw_rad - yaw, 2 * ORR_PI), 0, 2.5e-3);
            // A rotation whose Z looks down, whose panels' axis stands across the Sun, whose +X side sees it.
            const orr_vec3 to_sun = orr_mat3_apply(&a.body, orr_vec3_unit(orr_vec3_sub(sun, r)));
            const orr_vec3 down = orr_mat3_apply(&a.body, orr_vec3_scale(-1, orr_vec3_unit(r)));
            ASSERT_NEAR(to_sun.y, 0, 1e-12);
            assert_true(to_sun.x > 0);
            ASSERT_NEAR(down.z, 1, 1e-12);
            const orr_vec3 x = {1, 0, 0}, y = {0, 1, 0};
            const orr_vec3 z = orr_vec3_cross(orr_mat3_apply_t(&a.body, x), orr_mat3_apply_t(&a.body, y));
            ASSERT_NEAR(orr_vec3_dot(z, orr_vec3_unit(r)), -1, 1e-12);
            assert_false(a.fast_turn);
            // The rate is the yaw's own change as mu grows by n.
            orr_attitude before, after;
            place((mu - 0.01) * DEG, beta * DEG, &r, &v, &sun);
            assert_int_equal(orr_attitude_nominal(r, v, sun, &before), ORR_OK);
            place((mu + 0.01) * DEG, beta * DEG, &r, &v, &sun);
            assert_int_equal(orr_attitude_nominal(r, v, sun, &after), ORR_OK);
            const double n = 3874 / 2.656e7, turn = remainder(after.yaw_rad - before.yaw_rad, 2 * ORR_PI);
            ASSERT_NEAR(a.yaw_rate_radps, turn / (0.02 * DEG) * n, 1e-3 * fabs(a.yaw_rate_radps) + 1e-3 * n);
        }
}

static void turns_and_shadow_are_flagged(void **state)
{
    (void)state;
    orr_vec3 r, v, sun;
    orr_attitude a;
    // 0.10 deg/s are 12 times the mean motion: exceeded at noon for beta below 4.8 deg, and 180 deg of it
    // take half an hour, 15 deg of orbit. The Earth is 13.9 deg wide from there.
    const struct {
        double mu, beta, light;
        bool turn;
    } k[] = {{2, 0.05, 0, true},  {182, 0.05, 1, true}, {14, 0.5, 0.5, true}, {166, 4, 1, true},
             {16, 0.5, 1, false}, {2, 5, 0, false},     {90, 0.05, 1, false}, {182, 5, 1, false},
             {0, 14, 0.5, false}, {0, 12, 0, false}};
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        place(k[i].mu * DEG, k[i].beta * DEG + 1e-9, &r, &v, &sun);
        assert_int_equal(orr_attitude_nominal(r, v, sun, &a), ORR_OK);
        assert_int_equal(a.fast_turn, k[i].turn);
        if (k[i].light != 0.5)
            ASSERT_NEAR(a.sunlight, k[i].light, 1e-12);
        else
            assert_true(a.sunlight > 0 && a.sunlight <= 1); // at the shadow's border
    }
    place(0, 0, &r, &v, &sun); // in line: no yaw can be told
    assert_int_equal(orr_attitude_nominal(r, v, sun, &a), ORR_E_NUMERIC);
}

static void orbit_normal_does_not_look_at_the_sun(void **state)
{
    (void)state;
    orr_vec3 r, v, sun;
    orr_attitude a, steered;
    place(200 * DEG, 10 * DEG, &r, &v, &sun);
    orr_attitude_orbit_normal(r, v, sun, &a);
    assert_int_equal(orr_attitude_nominal(r, v, sun, &steered), ORR_OK);
    ASSERT_NEAR(a.beta_rad, steered.beta_rad, 1e-15);
    ASSERT_NEAR(a.yaw_rad, 0, 0);
    ASSERT_NEAR(orr_mat3_apply(&a.body, orr_vec3_unit(v)).x, 1,
                1e-12); // a circular orbit: v is along the track
    ASSERT_NEAR(orr_mat3_apply(&a.body, orr_vec3_unit(r)).z, -1, 1e-12);
    const orr_vec3 y = {0, 1, 0};
    ASSERT_NEAR(orr_mat3_apply_t(&a.body, y).z, -1, 1e-12);
    assert_false(a.fast_turn);
}

static void offsets_turn_with_the_body(void **state)
{
    (void)state;
    orr_antex_frequency f[2] = {{.code = "G01", .offset_m = {0.3, -0.1, 1.5}},
                                {.code = "G02", .offset_m = {0.2, 0.1, 1.1}}};
    const orr_antex_antenna antenna = {.n_frequencies = 2, .frequency = f};
    const orr_antenna_pair *p = orr_antenna_pair_of('G');
    assert_non_null(p);
    double body[3];
    assert_int_equal(orr_antenna_offset_body(&antenna, "G02", p->f2_hz, NULL, 0, body), ORR_OK);
    for (int i = 0; i < 3; i++) ASSERT_NEAR(body[i], f[1].offset_m[i], 0);
    // L1/L2 without ionosphere: 2.546 and -1.546 of the two, as everybody writes it.
    assert_int_equal(orr_antenna_offset_body(&antenna, p->code1, p->f1_hz, p->code2, p->f2_hz, body), ORR_OK);
    for (int i = 0; i < 3; i++)
        ASSERT_NEAR(body[i], 2.545728 * f[0].offset_m[i] - 1.545728 * f[1].offset_m[i], 1e-6);
    orr_vec3 r, v, sun, offset;
    orr_attitude a;
    place(40 * DEG, 30 * DEG, &r, &v, &sun);
    assert_int_equal(orr_attitude_nominal(r, v, sun, &a), ORR_OK);
    assert_int_equal(orr_antenna_offset(&antenna, &a, p->code1, p->f1_hz, p->code2, p->f2_hz, &offset),
                     ORR_OK);
    ASSERT_NEAR(orr_vec3_dot(offset, orr_vec3_unit(r)), -body[2], 1e-12); // Z looks down
    ASSERT_NEAR(orr_vec3_norm(offset), sqrt(body[0] * body[0] + body[1] * body[1] + body[2] * body[2]),
                1e-12);
    // What ANTEX does not know is not zero.
    assert_int_equal(orr_antenna_offset_body(&antenna, "G01", p->f1_hz, "G05", 1176.45e6, body),
                     ORR_E_NODATA);
    assert_int_equal(orr_antenna_offset_body(&antenna, "E01", p->f1_hz, NULL, 0, body), ORR_E_NODATA);
    assert_null(orr_antenna_pair_of('S'));
    // All channels of GLONASS have the same combination.
    p = orr_antenna_pair_of('R');
    ASSERT_NEAR(p->f1_hz / p->f2_hz, (1602 + 0.5625 * 6) / (1246 + 0.4375 * 6), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(yaw_is_the_closed_form),
        cmocka_unit_test(turns_and_shadow_are_flagged),
        cmocka_unit_test(orbit_normal_does_not_look_at_the_sun),
        cmocka_unit_test(offsets_turn_with_the_body),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
