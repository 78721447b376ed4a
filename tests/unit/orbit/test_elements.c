// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements of a product: they give back the state that they came from, and the means are the means.
#include "testing.h"

#include "elements_at.h"
#include "orbit/elements/elements.h"
#include "unit/orbit/made_orbit.h"

static orr_ephemeris *day(void)
{
    orr_orbit_solution s = made_solution(6, 24, 900, 6);
    orr_ephemeris *e = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_ephemeris_build(&s, &e, &diag), diag);
    made_solution_free(&s);
    return e;
}

static orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

// Elements to position and velocity by the two-body formulas, back to ecef by the Earth's rotation: the
// product's own state, whatever the frame. Angles of 1e-15 rad at 2.6e7 m and 4e3 m/s are 3e-8 m and 4e-12
// m/s; there are a few of them.
static void state_is_given_back(void **state)
{
    (void)state;
    orr_ephemeris *e = day();
    for (int f = ORR_ELEMENTS_DATE; f <= ORR_ELEMENTS_ECEF; f++)
        for (size_t k = 0; k < 6; k++) {
            const orr_elements_options o = {.frame = (orr_elements_frame)f};
            orr_time t = at(40000.25 + 1234.5 * (double)k);
            orr_kepler el;
            orr_sat_state s;
            orr_sat sat = made_satellite_at(k).sat;
            assert_int_equal(elements_at(e, sat, t, &o, &el), ORR_OK);
            assert_int_equal(orr_ephemeris_eval(e, sat, t, &s), ORR_OK);
            orr_vec3 r, v;
            orr_kepler_to_state(&el, ORR_EGM96_GM, &r, &v);
            orr_mat3 R, dR, wanted = orr_mat3_identity();
            orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
            orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, &dR);
            if (f == ORR_ELEMENTS_DATE) orr_astro_gcrs_to_tod(t, &wanted);
            if (f == ORR_ELEMENTS_ECEF) wanted = R;
            orr_vec3 rg = orr_mat3_apply_t(&wanted, r), vg = orr_mat3_apply_t(&wanted, v);
            orr_vec3 pos = orr_mat3_apply(&R, rg);
            orr_vec3 vel = orr_vec3_add(orr_mat3_apply(&R, vg), orr_mat3_apply(&dR, rg));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(pos, s.pos_m)), 0, 1e-6);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(vel, s.vel_mps)), 0, 1e-10);
        }
    orr_ephemeris_free(e);
}

// A satellite that stands next to the Earth's centre, as a damaged product may have it: its ellipses are next
// to straight lines, the mean eccentricity rounds to 1 and beyond, and there is no anomaly. Refused, or
// numbers.
static void a_fall_to_the_centre_has_no_elements_that_are_no_numbers(void **state)
{
    (void)state;
    int taken[3] = {0}, refused[3] = {0};
    for (int n = 0; n < 60; n++) {
        orr_orbit_solution s = made_solution(1, 1, 900, 6);
        orr_ephemeris *e = NULL;
        orr_diag diag = {0};
        const double r = pow(10, -11 + 0.2 * n), z = 1 + 0.1 * (n % 7);
        for (size_t k = 0; k < s.sat[0].arc[0].n; k++) {
            orr_orbit_sample *p = &s.sat[0].arc[0].sample[k];
            p->pos_m = (orr_vec3){r, r, z * r};
            p->vel_mps = p->acc_mps2 = (orr_vec3){0, 0, 0};
        }
        ASSERT_OK(orr_ephemeris_build(&s, &e, &diag), diag);
        for (int m = ORR_ELEMENTS_STATE; m <= ORR_ELEMENTS_MEAN; m++) {
            const orr_elements_options o = {.method = (orr_elements_method)m};
            orr_kepler k;
            const bool good = elements_at(e, s.sat[0].sat, at(1800.5), &o, &k) == ORR_OK;
            taken[m] += good;
            refused[m] += !good;
            if (good) assert_true(k.e < 1 && isfinite(k.m_rad) && isfinite(k.u_rad) && isfinite(k.argp_rad));
        }
        orr_ephemeris_free(e);
        made_solution_free(&s);
    }
    assert_true(taken[ORR_ELEMENTS_MEAN] > 0 && refused[ORR_ELEMENTS_MEAN] > 0);
}

// MEAN against osculating elements asked for one by one at the 64 instants, each with the Earth's rotation
// of its own: what it interpolates may not be seen (1e-15 of a rotation is 1e-8 m of a, 1e-15 of e's vector
// and 1e-14 rad of the plane).
static void means_are_means(void **state)
{
    (void)state;
    orr_ephemeris *e = day();
    for (int f = ORR_ELEMENTS_DATE; f <= ORR_ELEMENTS_ECEF; f++) {
        const orr_elements_options mean = {.frame = (orr_elements_frame)f, .method = ORR_ELEMENTS_MEAN},
                                   state_of = {.frame = (orr_elements_frame)f};
        for (size_t k = 0; k < 3; k++) {
            orr_sat sat = made_satellite_at(k).sat;
            orr_time t = at(43000);
            orr_kepler centre, got;
            orr_mat3 R;
            orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
            orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, NULL);
            assert_int_equal(elements_at(e, sat, t, &state_of, &centre), ORR_OK);
            assert_int_equal(elements_at(e, sat, t, &mean, &got), ORR_OK);
            double period = 2 * ORR_PI * sqrt(pow(centre.a_m, 3) / ORR_EGM96_GM), a = 0, h = 0, l = 0, p = 0,
                   q = 0;
            for (int j = 0; j < 64; j++) {
                orr_kepler el;
                orr_time then = orr_time_add_s(t, period * ((j + 0.5) / 64 - 0.5));
                assert_int_equal(elements_at(e, sat, then, &state_of, &el), ORR_OK);
                if (f == ORR_ELEMENTS_ECEF) { // the axes of t: those of `then` have turned on with the Earth
                    const orr_elements_options j2000 = {.frame = ORR_ELEMENTS_J2000};
                    orr_vec3 r, v;
                    assert_int_equal(elements_at(e, sat, then, &j2000, &el), ORR_OK);
                    orr_kepler_to_state(&el, ORR_EGM96_GM, &r, &v);
                    assert_int_equal(orr_kepler_from_state(orr_mat3_apply(&R, r), orr_mat3_apply(&R, v),
                                                           ORR_EGM96_GM, &el),
                                     ORR_OK);
                }
                a += el.a_m / 64;
                h += el.e * sin(el.raan_rad + el.argp_rad) / 64;
                l += el.e * cos(el.raan_rad + el.argp_rad) / 64;
                p += tan(el.i_rad / 2) * sin(el.raan_rad) / 64;
                q += tan(el.i_rad / 2) * cos(el.raan_rad) / 64;
            }
            ASSERT_NEAR(got.a_m, a, 1e-6);
            ASSERT_NEAR(got.e, hypot(h, l), 1e-13);
            ASSERT_NEAR(got.i_rad, 2 * atan(hypot(p, q)), 1e-13);
            ASSERT_NEAR(sin(got.raan_rad - atan2(p, q)), 0, 1e-12);
            ASSERT_NEAR(got.i_rad, centre.i_rad, 1e-4); // the made orbits are ellipses
        }
    }
    orr_ephemeris_free(e);
}

// Axes made once serve every satellite with the bits that each would have had alone.
static void axes_are_shared(void **state)
{
    (void)state;
    orr_ephemeris *e = day();
    for (int m = ORR_ELEMENTS_STATE; m <= ORR_ELEMENTS_MEAN; m++) {
        const orr_elements_options o = {.method = (orr_elements_method)m};
        orr_elements_axes axes;
        orr_elements_axes_at(at(43210), &o, &axes);
        for (size_t k = 0; k < 6; k++) {
            orr_kepler one, other;
            memset(&one, 0, sizeof one);
            memset(&other, 0, sizeof other);
            assert_int_equal(elements_at(e, made_satellite_at(k).sat, at(43210), &o, &one), ORR_OK);
            assert_int_equal(orr_elements_of(e, made_satellite_at(k).sat, &axes, &other), ORR_OK);
            assert_memory_equal(&one, &other, sizeof one);
        }
    }
    orr_ephemeris_free(e);
}

static void where_a_method_lacks_instants(void **state)
{
    (void)state;
    orr_ephemeris *e = day();
    orr_sat sat = made_satellite_at(0).sat;
    const orr_elements_options by_state = {.method = ORR_ELEMENTS_STATE},
                               three = {.method = ORR_ELEMENTS_THREE_POSITIONS},
                               mean = {.method = ORR_ELEMENTS_MEAN};
    orr_kepler k;
    assert_int_equal(elements_at(e, sat, at(60), &by_state, &k), ORR_OK);
    assert_int_equal(elements_at(e, sat, at(60), &three, &k), ORR_E_NODATA);
    assert_int_equal(elements_at(e, sat, at(300), &three, &k), ORR_OK);
    const orr_elements_options quarter = {.method = ORR_ELEMENTS_THREE_POSITIONS, .spacing_s = 10000},
                               too_far = {.method = ORR_ELEMENTS_THREE_POSITIONS, .spacing_s = 12000},
                               round = {.method = ORR_ELEMENTS_THREE_POSITIONS, .spacing_s = 36000};
    assert_int_equal(elements_at(e, sat, at(22000), &quarter, &k), ORR_OK);
    assert_int_equal(elements_at(e, sat, at(22000), &too_far, &k),
                     ORR_E_NUMERIC); // more than 21600 s in all
    assert_int_equal(elements_at(e, sat, at(43200), &round, &k), ORR_E_NUMERIC);
    assert_int_equal(elements_at(e, sat, at(21000), &mean, &k),
                     ORR_E_NODATA); // half of 43200 s is not there
    assert_int_equal(elements_at(e, sat, at(22000), &mean, &k), ORR_OK);
    assert_int_equal(elements_at(e, orr_sat_make('C', 9), at(22000), &by_state, &k), ORR_E_NODATA);
    assert_int_equal(elements_at(e, sat, at(-1), &by_state, &k), ORR_E_RANGE);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(state_is_given_back),
        cmocka_unit_test(a_fall_to_the_centre_has_no_elements_that_are_no_numbers),
        cmocka_unit_test(means_are_means),
        cmocka_unit_test(axes_are_shared),
        cmocka_unit_test(where_a_method_lacks_instants),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
