// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements: round trips over the whole range, limits, and the source's three positions on two-body
// motion.
#include "testing.h"

#include "core/rng.h"
#include "orbit/force/kepler.h"

static double wrap(double a) { return remainder(a, 2 * ORR_PI); }

static void elements_and_state_round_trip(void **state)
{
    (void)state;
    for (uint64_t n = 0; n < 2000; n++) {
        orr_kepler k = {.a_m = 7e6 + 4e7 * orr_rng_uniform(1, 0, n),
                        .e = 0.9 * orr_rng_uniform(1, 1, n),
                        .i_rad = 0.01 + 3.1 * orr_rng_uniform(1, 2, n),
                        .raan_rad = 6.28 * orr_rng_uniform(1, 3, n),
                        .argp_rad = 6.28 * orr_rng_uniform(1, 4, n),
                        .m_rad = 6.28 * orr_rng_uniform(1, 5, n)};
        orr_kepler q;
        orr_vec3 r, v, r2, v2;
        orr_kepler_to_state(&k, ORR_EGM96_GM, &r, &v);
        assert_int_equal(orr_kepler_from_state(r, v, ORR_EGM96_GM, &q), ORR_OK);
        ASSERT_NEAR(q.a_m / k.a_m, 1, 1e-13);
        ASSERT_NEAR(q.e, k.e, 1e-13);
        ASSERT_NEAR(q.i_rad, k.i_rad, 1e-13);
        ASSERT_NEAR(wrap(q.raan_rad - k.raan_rad), 0, 1e-12); // i of 0.01 costs two digits
        if (k.e > 1e-3) {
            ASSERT_NEAR(wrap(q.argp_rad - k.argp_rad), 0, 1e-11 / k.e);
            ASSERT_NEAR(wrap(q.m_rad - k.m_rad), 0, 1e-11 / k.e);
        }
        orr_kepler_to_state(&q, ORR_EGM96_GM, &r2, &v2);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(r, r2)) / k.a_m, 0, 1e-13);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(v, v2)) / orr_vec3_norm(v), 0, 2e-12); // perigee at e = 0.9
        // u is argp + true anomaly: the angle from the node, whatever the split.
        orr_vec3 node = {cos(q.raan_rad), sin(q.raan_rad), 0};
        ASSERT_NEAR(cos(q.u_rad), orr_vec3_dot(orr_vec3_unit(r), node), 1e-12);
    }
}

static void keplers_equation_is_solved(void **state)
{
    (void)state;
    for (double e = 0; e < 0.999; e += 0.037)
        for (double m = -7; m < 7; m += 0.05) {
            double E = orr_kepler_solve(m, e);
            ASSERT_NEAR(wrap(E - e * sin(E) - m), 0, 4e-15);
        }
}

static void circular_and_equatorial_orbits_keep_their_conventions(void **state)
{
    (void)state;
    double r = 2.6e7, v = sqrt(ORR_EGM96_GM / r);
    orr_kepler k;
    assert_int_equal(orr_kepler_from_state((orr_vec3){0, r, 0}, (orr_vec3){-v, 0, 0}, ORR_EGM96_GM, &k),
                     ORR_OK);
    ASSERT_NEAR(k.i_rad, 0, 1e-15);
    ASSERT_NEAR(k.raan_rad, 0, 0);
    ASSERT_NEAR(k.u_rad, ORR_PI / 2, 1e-15);
    assert_true(k.e < 1e-14);
    // Retrograde equatorial.
    assert_int_equal(orr_kepler_from_state((orr_vec3){0, r, 0}, (orr_vec3){v, 0, 0}, ORR_EGM96_GM, &k),
                     ORR_OK);
    ASSERT_NEAR(k.i_rad, ORR_PI, 1e-15);
}

static void what_is_no_ellipse_is_refused(void **state)
{
    (void)state;
    orr_kepler k;
    double r = 2.6e7, escape = sqrt(2 * ORR_EGM96_GM / r);
    assert_int_equal(
        orr_kepler_from_state((orr_vec3){r, 0, 0}, (orr_vec3){0, 1.01 * escape, 0}, ORR_EGM96_GM, &k),
        ORR_E_NUMERIC);
    assert_int_equal(orr_kepler_from_state((orr_vec3){r, 0, 0}, (orr_vec3){100, 0, 0}, ORR_EGM96_GM, &k),
                     ORR_E_NUMERIC);
    assert_int_equal(orr_kepler_from_positions((orr_vec3){r, 0, 0}, (orr_vec3){r, 0, 0}, (orr_vec3){r, 0, 0},
                                               ORR_EGM96_GM, &k),
                     ORR_E_NUMERIC);
}

// Next to a straight line the eccentricity rounds to 1 and beyond, where the anomaly is no number: refused,
// or numbers.
static void next_to_a_straight_line_nothing_is_no_number(void **state)
{
    (void)state;
    int refused = 0, taken = 0;
    for (uint64_t n = 0; n < 4000; n++) {
        const double angle = 6 * orr_rng_uniform(2, 0, n), speed = 100 + 3000 * orr_rng_uniform(2, 1, n);
        const double aside = pow(10, -8.9 + 4 * orr_rng_uniform(2, 2, n)); // of the velocity
        const orr_vec3 up = {cos(angle), sin(angle), 0.3}, across = {-0.3 * cos(angle), -0.3 * sin(angle), 1};
        orr_kepler k;
        const orr_status s = orr_kepler_from_state(
            orr_vec3_scale(2.6e7, up), orr_vec3_axpy(aside * speed, across, orr_vec3_scale(speed, up)),
            ORR_EGM96_GM, &k);
        refused += s != ORR_OK;
        taken += s == ORR_OK;
        if (s == ORR_OK)
            assert_true(k.e < 1 && isfinite(k.m_rad) && isfinite(k.u_rad) && isfinite(k.argp_rad));
    }
    assert_true(refused > 0 && taken > 0);
}

// On pure two-body motion Gibbs' formulas are exact; r2 pushed out of the plane changes nothing (the
// regularisation).
static void three_positions_recover_two_body_motion(void **state)
{
    (void)state;
    orr_kepler k = {2.656e7, 0.0123, 0.96, 1.2, 2.3, 0.7, 0}, q;
    double n = sqrt(ORR_EGM96_GM / pow(k.a_m, 3));
    orr_vec3 r[3], v;
    for (double dt = 300; dt <= 1800; dt *= 2) {
        for (int j = 0; j < 3; j++) {
            orr_kepler p = k;
            p.m_rad += n * dt * (j - 1);
            orr_kepler_to_state(&p, ORR_EGM96_GM, &r[j], &v);
        }
        double noise =
            1e-15 /
            pow(n * dt, 2); // differences of second order divide the rounding by the square of the angle
        assert_int_equal(orr_kepler_from_positions(r[0], r[1], r[2], ORR_EGM96_GM, &q), ORR_OK);
        ASSERT_NEAR(q.a_m / k.a_m, 1, 20 * noise);
        ASSERT_NEAR(q.i_rad, k.i_rad, 1e-14 / (n * dt)); // rounding over the angle between r1 and r3
        ASSERT_NEAR(wrap(q.m_rad + q.argp_rad - k.m_rad - k.argp_rad), 0, 50 * noise);
        orr_vec3 normal = orr_vec3_unit(orr_vec3_cross(r[0], r[2])), lifted = orr_vec3_axpy(50, normal, r[1]);
        orr_kepler lift;
        assert_int_equal(orr_kepler_from_positions(r[0], lifted, r[2], ORR_EGM96_GM, &lift), ORR_OK);
        ASSERT_NEAR(lift.a_m / q.a_m, 1, 20 * noise);
        ASSERT_NEAR(lift.i_rad, q.i_rad, 1e-14 / (n * dt));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elements_and_state_round_trip),
        cmocka_unit_test(keplers_equation_is_solved),
        cmocka_unit_test(circular_and_equatorial_orbits_keep_their_conventions),
        cmocka_unit_test(what_is_no_ellipse_is_refused),
        cmocka_unit_test(next_to_a_straight_line_nothing_is_no_number),
        cmocka_unit_test(three_positions_recover_two_body_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
