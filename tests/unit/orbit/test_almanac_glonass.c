// SPDX-License-Identifier: GPL-3.0-or-later
// The GLONASS almanac against the ICD's own worked example (edition 5.1, A.3.2.3), and its fit against made
// orbits whose almanac is known.
#include "testing.h"

#include "core/rng.h"
#include "orbit/navdata/almanac_glonass.h"

#define PI_ ORR_PI

static orr_time utc(int year, int month, int day, int hour, int minute, int second)
{
    orr_civil c = {year, month, day, hour, minute, second, 0};
    orr_time t = 0;
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_UTC, NULL, &t), ORR_OK);
    return t;
}

static orr_glonass_almanac example(void)
{
    return (orr_glonass_almanac){.number = 1,
                                 .day = utc(2001, 9, 5, 21, 0, 0), // N 615: 2001-09-06 in Moscow
                                 .lambda_rad = -0.189986229 * PI_,
                                 .t_lambda_s = 27122.09375,
                                 .delta_i_rad = 0.011929512 * PI_,
                                 .delta_t_s = -2655.76171875,
                                 .delta_t_rate = 0.000549316,
                                 .e = 0.001482010,
                                 .omega_rad = 0.440277100 * PI_};
}

// The example gives inertial axes and the sidereal time that turns them: S0 = 6.02401539573 at 03:00 in
// Moscow. Angles are printed to 1e-9 semicircles (8 cm), velocities to 1 mm/s.
static void icd_example_is_met(void **state)
{
    (void)state;
    const orr_glonass_almanac a = example();
    orr_vec3 r, v;
    assert_int_equal(orr_glonass_almanac_eval(&a, utc(2001, 9, 6, 6, 15, 0), &r, &v), ORR_OK);
    orr_mat3 back = orr_mat3_rot3(-(6.02401539573 + 7.292115e-5 * (33300 - 10800)));
    v = orr_vec3_add(v, orr_vec3_cross(orr_vec3_make(0, 0, 7.292115e-5), r));
    r = orr_mat3_apply(&back, r), v = orr_mat3_apply(&back, v);
    ASSERT_NEAR(r.x, 10947021.572, 0.2);
    ASSERT_NEAR(r.y, 13078978.287, 0.2);
    ASSERT_NEAR(r.z, 18922063.362, 0.2);
    ASSERT_NEAR(v.x, -3375.497, 1.1e-3);
    ASSERT_NEAR(v.y, -161.453, 1.1e-3);
    ASSERT_NEAR(v.z, 2060.844, 1.1e-3);
}

// At t_lambda and whole revolutions after it the satellite is at its node, on the longitude that the words
// say.
static void nodes_are_where_the_words_say(void **state)
{
    (void)state;
    const orr_glonass_almanac a = example();
    const double period = 43200 + a.delta_t_s;
    orr_vec3 r, v;
    for (int w = -3; w <= 20; w++) {
        double t_s = a.t_lambda_s + w * period + a.delta_t_rate * w * w;
        assert_int_equal(orr_glonass_almanac_eval(&a, orr_time_add_s(a.day, t_s + 1e-3), &r, &v), ORR_OK);
        ASSERT_NEAR(r.z, 0, 10); // 1 ms of 3.6 km/s, and floor() of the revolutions leaves delta T' to tau
        assert_true(v.z > 3000);
        if (w == 0) ASSERT_NEAR(atan2(r.y, r.x), a.lambda_rad, 1e-6);
    }
}

// The velocity is the osculating ellipse's, the positions are not exactly one: the derivative agrees to 0.4
// m/s. At each node the algorithm's secular terms of 2.8e-5 of the revolution are taken back.
static void velocity_and_jump_are_as_documented(void **state)
{
    (void)state;
    const orr_glonass_almanac a = example();
    orr_time start = orr_time_add_s(a.day, a.t_lambda_s);
    double worst = 0;
    orr_vec3 r, v, before, after;
    for (int k = 1; k < 80; k++) {
        orr_time t = orr_time_add_s(start, 500.0 * k);
        assert_int_equal(orr_glonass_almanac_eval(&a, t, &r, &v), ORR_OK);
        assert_int_equal(orr_glonass_almanac_eval(&a, orr_time_add_s(t, -1), &before, &v), ORR_OK);
        assert_int_equal(orr_glonass_almanac_eval(&a, orr_time_add_s(t, 1), &after, &v), ORR_OK);
        assert_int_equal(orr_glonass_almanac_eval(&a, t, &r, &v), ORR_OK);
        double d = orr_vec3_norm(orr_vec3_sub(orr_vec3_scale(0.5, orr_vec3_sub(after, before)), v));
        if (d > worst) worst = d;
    }
    print_message("velocity against the positions' derivative: %.3f m/s at most\n", worst);
    ASSERT_NEAR(worst, 0, 0.2);
    orr_time node = orr_time_add_s(start, 43200 + a.delta_t_s);
    assert_int_equal(orr_glonass_almanac_eval(&a, orr_time_add_s(node, -1e-3), &before, &v), ORR_OK);
    assert_int_equal(orr_glonass_almanac_eval(&a, orr_time_add_s(node, 1e-3), &after, &v), ORR_OK);
    double jump = orr_vec3_norm(orr_vec3_sub(after, before));
    print_message("jump at the node: %.0f m\n", jump);
    ASSERT_NEAR(jump, 4780, 100);
}

static void elements_that_are_no_orbit_are_refused(void **state)
{
    (void)state;
    orr_glonass_almanac a = example();
    orr_vec3 r, v;
    a.delta_t_s = -43200;
    assert_int_equal(orr_glonass_almanac_eval(&a, a.day, &r, &v), ORR_E_NUMERIC);
    a = example(), a.e = (double)NAN;
    assert_int_equal(orr_glonass_almanac_eval(&a, a.day, &r, &v), ORR_E_NUMERIC);
    a = example(), a.delta_i_rad = (double)INFINITY;
    assert_int_equal(orr_glonass_almanac_eval(&a, a.day, &r, &v), ORR_E_NUMERIC);
}

// A made orbit: an almanac's own, with positions missing before `from` and after `to`.
typedef struct made {
    orr_glonass_almanac almanac;
    orr_time from, to;
} made;

static orr_status made_position(void *user, orr_time t, orr_vec3 *pos)
{
    const made *m = user;
    orr_vec3 v;
    if (t < m->from || t > m->to) return ORR_E_RANGE;
    return orr_glonass_almanac_eval(&m->almanac, t, pos, &v);
}

static double lattice(double value, double lsb) { return lsb * round(value / lsb); }

static made made_orbit(uint64_t n)
{
#define U(k) orr_rng_uniform(23, (k), n)
#define S(k) (2 * U(k) - 1)
    made m = {
        .almanac = {.number = (int)(n % 24) + 1,
                    .day = orr_glonass_day(utc(2024, 2, 4, 12, 0, 0), NULL),
                    .lambda_rad = lattice(PI_ * S(1), ORR_GLONASS_ALM_ANGLE_LSB_RAD),
                    .t_lambda_s = lattice(40500 * U(2), ORR_GLONASS_ALM_T_LAMBDA_LSB_S),
                    .delta_i_rad = lattice((1.8 + S(3)) * ORR_RAD_PER_DEG, ORR_GLONASS_ALM_ANGLE_LSB_RAD),
                    .delta_t_s = lattice(-2656 + 2 * S(4), ORR_GLONASS_ALM_DELTA_T_LSB_S),
                    .e = lattice(0.0005 + 0.004 * U(5), ORR_GLONASS_ALM_E_LSB),
                    .omega_rad = lattice(PI_ * S(6), ORR_GLONASS_ALM_OMEGA_LSB_RAD)}};
    m.from = m.almanac.day, m.to = orr_time_add_s(m.almanac.day, 86400);
    return m;
}

// An orbit that the model describes is found again: every word to two LSBs (the rounding of one is made up
// for by others), omega, which is worth metres, to what a metre is. Positions to a tenth of what one LSB of
// lambda moves.
static void made_orbits_are_found_again(void **state)
{
    (void)state;
    for (uint64_t n = 0; n < 60; n++) {
        made m = made_orbit(n);
        if (n % 3 == 1) m.from = orr_time_add_s(m.from, 3 * 3600); // a product that begins at 00:00 UTC
        if (n % 3 == 2) m.to = orr_time_add_s(m.to, -10 * 3600);
        orr_glonass_almanac a;
        orr_navfit_report r;
        orr_diag d = {0};
        ASSERT_OK(orr_glonass_almanac_fit(orr_sat_make('R', m.almanac.number), utc(2024, 2, 4, 12, 0, 0),
                                          NULL, made_position, &m, &a, &r, &d),
                  d);
        assert_int_equal(a.number, m.almanac.number);
        assert_true(a.operational && a.day == m.almanac.day);
        assert_int_equal(r.n, n % 3 == 0 ? 97 : n % 3 == 1 ? 85 : 57);
        ASSERT_NEAR(r.fit_rms_m, 0, 1);
        ASSERT_NEAR(r.rms_m, 0, 100);
        ASSERT_NEAR(a.t_lambda_s, m.almanac.t_lambda_s, 2.01 * ORR_GLONASS_ALM_T_LAMBDA_LSB_S);
        ASSERT_NEAR(remainder(a.lambda_rad - m.almanac.lambda_rad, 2 * PI_), 0,
                    2.01 * ORR_GLONASS_ALM_ANGLE_LSB_RAD);
        ASSERT_NEAR(a.delta_i_rad, m.almanac.delta_i_rad, 2.01 * ORR_GLONASS_ALM_ANGLE_LSB_RAD);
        ASSERT_NEAR(a.delta_t_s, m.almanac.delta_t_s, 2.01 * ORR_GLONASS_ALM_DELTA_T_LSB_S);
        ASSERT_NEAR(a.e, m.almanac.e, 2.01 * ORR_GLONASS_ALM_E_LSB);
        ASSERT_NEAR(remainder(a.omega_rad - m.almanac.omega_rad, 2 * PI_) * m.almanac.e, 0, 2e-6);
    }
}

// A node within a moment of midnight: the words stay within the day.
static void nodes_at_midnight_stay_in_the_day(void **state)
{
    (void)state;
    for (int k = -8; k <= 8; k++) {
        made m = made_orbit(5);
        m.almanac.t_lambda_s = 0.03125 * k;
        orr_glonass_almanac a;
        orr_navfit_report r;
        orr_diag d = {0};
        ASSERT_OK(
            orr_glonass_almanac_fit(orr_sat_make('R', 6), m.almanac.day, NULL, made_position, &m, &a, &r, &d),
            d);
        assert_true(a.t_lambda_s >= 0 && a.t_lambda_s < 44100);
        ASSERT_NEAR(r.rms_m, 0, 150);
    }
}

static void what_cannot_be_fitted_is_refused(void **state)
{
    (void)state;
    made m = made_orbit(7);
    orr_glonass_almanac a;
    orr_navfit_report r;
    orr_diag d = {0};
    assert_int_equal(
        orr_glonass_almanac_fit(orr_sat_make('G', 6), m.from, NULL, made_position, &m, &a, &r, &d),
        ORR_E_ARG);
    assert_int_equal(
        orr_glonass_almanac_fit(orr_sat_make('R', 25), m.from, NULL, made_position, &m, &a, &r, &d),
        ORR_E_ARG);
    m.to = orr_time_add_s(m.from, 11 * 3600);
    assert_int_equal(
        orr_glonass_almanac_fit(orr_sat_make('R', 6), m.from, NULL, made_position, &m, &a, &r, &d),
        ORR_E_NODATA);
    m = made_orbit(7), m.almanac.e = 0.04; // 0.031 is the most that 15 bits hold
    assert_int_equal(
        orr_glonass_almanac_fit(orr_sat_make('R', 6), m.from, NULL, made_position, &m, &a, &r, &d),
        ORR_E_RANGE);
    assert_non_null(strstr(d.text, "epsilon_n"));
}

// 2016-12-31: the leap second is at 03:00 of 2017-01-01 in Moscow. From there on the clock's label, not the
// time that has passed since midnight, is what t_lambda is compared with.
static void leap_second_does_not_move_the_satellite(void **state)
{
    (void)state;
    orr_glonass_almanac plain = example(), leap = example();
    plain.day = orr_glonass_day(utc(2016, 1, 1, 12, 0, 0), NULL),
    leap.day = orr_glonass_day(utc(2017, 1, 1, 12, 0, 0), NULL);
    for (int hour = 3; hour < 21; hour++) {
        orr_vec3 a, b, v;
        assert_int_equal(orr_glonass_almanac_eval(&plain, utc(2016, 1, 1, hour, 0, 0), &a, &v), ORR_OK);
        assert_int_equal(orr_glonass_almanac_eval(&leap, utc(2017, 1, 1, hour, 0, 0), &b, &v), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(a, b)), 0, 1e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(icd_example_is_met),
        cmocka_unit_test(nodes_are_where_the_words_say),
        cmocka_unit_test(velocity_and_jump_are_as_documented),
        cmocka_unit_test(elements_that_are_no_orbit_are_refused),
        cmocka_unit_test(made_orbits_are_found_again),
        cmocka_unit_test(nodes_at_midnight_stay_in_the_day),
        cmocka_unit_test(what_cannot_be_fitted_is_refused),
        cmocka_unit_test(leap_second_does_not_move_the_satellite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
