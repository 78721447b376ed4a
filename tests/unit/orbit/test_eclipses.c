// SPDX-License-Identifier: GPL-3.0-or-later
// Passages through the Earth's shadow against their closed form, and what else a generator needs of a
// satellite, on made orbits.
#include "testing.h"

#include "made_sp3.h"
#include "orbit/smooth/smoother.h"
#include "orbit/spacecraft/eclipses.h"
#include "orbit/spacecraft/spacecraft.h"

#define DAY 288
static made_sky sky;
static orr_vec3 sun0; // in inertial axes, unit

static int begin(void **state)
{
    (void)state;
    orr_sky_point p;
    made_sky_init(&sky, "2024-03-20", 1); // equinox
    orr_sky_at(sky.sky, 43200, &p);
    sun0 = orr_vec3_unit(p.sun_m);
    return 0;
}
static int end(void **state)
{
    (void)state;
    made_sky_free(&sky);
    return 0;
}

// A product of one circular orbit whose plane the Sun is above by beta; u0 is counted from the node.
static orr_ephemeris *product(orr_sat sat, double a, double incl, double beta, double u0,
                              const orr_interval *without)
{
    static made_truth truth;
    const made_truth *const all[] = {&truth};
    // sin(beta) = normal . sun, normal = (sin(raan) sin(i), -cos(raan) sin(i), cos(i)).
    const double ra = atan2(sun0.y, sun0.x), level = hypot(sun0.x, sun0.y);
    const double x = (sin(beta) - sun0.z * cos(incl)) / (sin(incl) * level); // sin(raan - ra)
    assert_true(fabs(x) <= 1);
    made_orbit(&sky, sat, a, 1e-4, incl, ra + asin(x), u0, 2e-8, -1, 0, &truth);
    orr_sp3 f;
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    orr_smoother_options o = orr_smoother_defaults();
    if (without != NULL) {
        o.exclude = without;
        o.n_exclude = 1;
    }
    made_sp3(&sky, all, 1, 0, DAY, 3, &f);
    orr_smoother_input in = {.sp3 = &f, .name = "made.sp3"};
    ASSERT_OK(orr_smoother_run(&in, 1, &o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    return e;
}

// Seconds that a circular orbit is further than `limb` of the Sun's radii inside the Earth's limb: gamma from
// the shadow's axis, cos(gamma) = cos(beta) cos(u); at the border asin(Re/r) + limb asin(Rs/d) is the Sun's
// separation from the Earth's centre.
static double seconds_in_shadow(double r, double beta, double limb)
{
    const double d = 1.4897e11 + r; // 2024-03-20
    const double gamma = asin(6378136.6 / r) + limb * asin(6.957e8 / d);
    if (gamma <= fabs(beta)) return 0;
    const double half = acos(cos(gamma) / cos(beta)), n = sqrt(3.986004415e14 / (r * r * r));
    return 2 * half / (n - 1.99e-7); // the axis follows the Sun
}

static double seconds(orr_time to, orr_time from) { return orr_time_diff_s(to, from); }

static void lengths_are_the_closed_forms(void **state)
{
    (void)state;
    const struct {
        char system;
        double a, incl, beta_deg;
        double umbra_min; // what everybody knows; 0: none
    } k[] = {{'G', 2.656e7, 0.96, 0, 54.5},  {'G', 2.656e7, 0.96, 10, 38},    {'G', 2.656e7, 0.96, 13.8, 0},
             {'G', 2.656e7, 0.96, 20, 0},    {'R', 2.551e7, 1.13, 0, 53.5},   {'E', 2.960e7, 0.98, -3, 55.5},
             {'C', 4.2164e7, 0.96, 1, 67.5}, {'C', 2.790e7, 0.96, -12.9, 4.9}};
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        orr_eclipse x[8];
        const double beta = k[i].beta_deg * ORR_RAD_PER_DEG;
        const orr_sat sat = orr_sat_make(k[i].system, 7);
        orr_ephemeris *e = product(sat, k[i].a, k[i].incl, beta, 1.0, NULL);
        const size_t n = orr_eclipses_of(e, sat, x, 8);
        const double shallow = seconds_in_shadow(k[i].a, beta, 1), deep = seconds_in_shadow(k[i].a, beta, -1);
        assert_true(n <= 8);
        assert_int_equal(n == 0, shallow == 0);
        ASSERT_NEAR(deep / 60, k[i].umbra_min, 1);
        for (size_t m = 0; m < n; m++) {
            if (x[m].penumbra_from == ORR_TIME_NONE || x[m].penumbra_to == ORR_TIME_NONE) continue;
            // The states say the same: flagged and dark inside, lit outside.
            const orr_spacecraft_sources src = {.orbit = e};
            const orr_time middle = x[m].from + (x[m].to - x[m].from) / 2, before = x[m].from - ORR_NS_PER_S;
            orr_spacecraft in, out;
            assert_int_equal(orr_spacecraft_at(&src, sat, middle, orr_attitude_sun(middle, NULL), &in),
                             ORR_OK);
            assert_int_equal(orr_spacecraft_at(&src, sat, before, orr_attitude_sun(before, NULL), &out),
                             ORR_OK);
            assert_true((in.state.flags & ORR_EPH_ECLIPSE) != 0 && in.attitude.sunlight < 1);
            assert_true((out.state.flags & ORR_EPH_ECLIPSE) == 0);
            ASSERT_NEAR(out.attitude.sunlight, 1, 1e-6);
            ASSERT_NEAR(in.attitude.beta_rad, beta,
                        0.6 * ORR_RAD_PER_DEG); // the Sun moves by half a degree a day
            // The closed form with the passage's own r and beta. What is left: the orbit is not quite a
            // circle (e of 2e-4 by J2: 0.03 %, 1 s), and the Sun moves within the passage; where it only
            // grazes the length goes as 1/sin.
            const double r = orr_vec3_norm(in.state.pos_m), here = in.attitude.beta_rad;
            const double inner = seconds_in_shadow(r, here, -1), outer = seconds_in_shadow(r, here, 1);
            const double tolerance = fabs(k[i].beta_deg) > 12 ? 20 : 4;
            ASSERT_NEAR(seconds(x[m].penumbra_to, x[m].penumbra_from), outer, tolerance);
            assert_int_equal(x[m].umbra, inner > 0);
            assert_true(x[m].umbra_known);
            if (inner == 0) continue;
            ASSERT_NEAR(in.attitude.sunlight, 0, 0);
            ASSERT_NEAR(seconds(x[m].umbra_to, x[m].umbra_from), inner, tolerance);
            assert_true(x[m].penumbra_from < x[m].umbra_from && x[m].umbra_to < x[m].penumbra_to);
        }
        orr_ephemeris_free(e);
    }
}

// An orbit that ends inside the shadow does not know the rest.
static void what_the_arc_cuts_is_not_known(void **state)
{
    (void)state;
    const orr_sat sat = orr_sat_make('G', 7);
    orr_ephemeris *whole = product(sat, 2.656e7, 0.96, 0.01, 1.0, NULL);
    orr_eclipse all[8], cut[8];
    size_t n = orr_eclipses_of(whole, sat, all, 8), k = 0;
    while (k < n && (all[k].penumbra_from == ORR_TIME_NONE || all[k].penumbra_to == ORR_TIME_NONE)) k++;
    assert_true(k < n);
    assert_int_equal(orr_eclipses_of(whole, sat, NULL, 0), n);
    // No nodes from the middle of the umbra on, for longer than is bridged.
    const orr_time middle = all[k].umbra_from + (all[k].umbra_to - all[k].umbra_from) / 2;
    const orr_interval without = {middle, middle + 9 * 3600 * ORR_NS_PER_S};
    orr_ephemeris *e = product(sat, 2.656e7, 0.96, 0.01, 1.0, &without);
    n = orr_eclipses_of(e, sat, cut, 8);
    bool found = false;
    for (size_t i = 0; i < n; i++) {
        if (cut[i].from > middle || cut[i].to < all[k].from) continue;
        found = true;
        ASSERT_NEAR(seconds(cut[i].penumbra_from, all[k].penumbra_from), 0, 0.2);
        ASSERT_NEAR(seconds(cut[i].umbra_from, all[k].umbra_from), 0, 0.2);
        assert_true(cut[i].umbra && cut[i].umbra_to == ORR_TIME_NONE && cut[i].penumbra_to == ORR_TIME_NONE);
        assert_true(cut[i].to <= middle);
    }
    assert_true(found);
    orr_ephemeris_free(e);
    orr_ephemeris_free(whole);
}

// An orbit that begins in the penumbra on the way out has not been seen in the umbra, and does not say that
// it was not there.
static void an_umbra_before_the_arc_is_not_denied(void **state)
{
    (void)state;
    const orr_sat sat = orr_sat_make('G', 7);
    const double a = 2.656e7, n = sqrt(3.986004415e14 / (a * a * a));
    orr_ephemeris *e = product(sat, a, 0.96, 0.01, 1.0, NULL);
    orr_eclipse x[8];
    assert_true(orr_eclipses_of(e, sat, x, 8) > 0 && x[0].umbra && x[0].umbra_known);
    const double at_s = seconds(x[0].umbra_to, sky.t0) + 0.5 * seconds(x[0].penumbra_to, x[0].umbra_to);
    orr_ephemeris_free(e);
    e = product(sat, a, 0.96, 0.01, 1.0 + n * at_s, NULL);
    assert_true(orr_eclipses_of(e, sat, x, 8) > 0 && x[0].from == sky.t0);
    assert_true(x[0].penumbra_from == ORR_TIME_NONE && x[0].penumbra_to != ORR_TIME_NONE);
    assert_true(seconds(x[0].to, x[0].from) < 120); // penumbra alone
    assert_false(x[0].umbra);
    assert_false(x[0].umbra_known);
    orr_ephemeris_free(e);
}

static void extras_say_what_they_do_not_know(void **state)
{
    (void)state;
    const orr_sat sat = orr_sat_make('G', 7);
    orr_ephemeris *e = product(sat, 2.656e7, 0.96, 0.3, 1.0, NULL);
    const orr_time t = orr_time_add_s(sky.t0, 30000);
    orr_spacecraft_sources src = {.orbit = e};
    orr_spacecraft x;
    double delay;
    assert_int_equal(orr_spacecraft_at(&src, sat, t, orr_attitude_sun(t, NULL), &x), ORR_OK);
    assert_true(x.has_attitude && x.health == ORR_HEALTH_UNKNOWN);
    assert_true(isnan(x.antenna_body_m[2]) && isnan(x.antenna_ecef_m.x));
    assert_int_equal(orr_spacecraft_delay(&src, sat, "1C", t, &delay), ORR_E_NODATA);
    // Periodic relativity of a Kepler orbit is F e sqrt(a) sin E, below 2.3 ns for e of 1e-3.
    ASSERT_NEAR(x.relativity_s, 0, 3e-9);
    assert_int_equal(orr_spacecraft_at(&src, orr_sat_make('G', 8), t, orr_attitude_sun(t, NULL), &x),
                     ORR_E_NODATA);

    // A record that says 63 is about an unhealthy satellite, and its TGD counts as long as no biases are
    // given.
    orr_nav_eph eph = {
        .sat = sat, .message = ORR_NAV_LNAV, .kind = ORR_NAV_KEPLER, .toe = t, .toc = t, .health = 63};
    eph.delay.tgd_s = 5e-9;
    const orr_nav nav = {.n_eph = 1, .eph = &eph};
    const orr_bias_set bias = {0};
    src.nav = &nav;
    assert_int_equal(orr_spacecraft_at(&src, sat, t, orr_attitude_sun(t, NULL), &x), ORR_OK);
    assert_int_equal(x.health, ORR_HEALTH_BAD);
    eph.health = 0;
    assert_int_equal(orr_spacecraft_at(&src, sat, t, orr_attitude_sun(t, NULL), &x), ORR_OK);
    assert_int_equal(x.health, ORR_HEALTH_OK);
    assert_int_equal(orr_spacecraft_delay(&src, sat, "1C", t, &delay), ORR_OK);
    ASSERT_NEAR(delay, 5e-9, 0);
    src.bias = &bias;
    assert_int_equal(orr_spacecraft_delay(&src, sat, "1C", t, &delay), ORR_E_NODATA);

    // The antenna: body Z looks down.
    orr_antex_frequency f[2] = {{.code = "G01", .offset_m = {0, 0, 1.5}},
                                {.code = "G02", .offset_m = {0, 0, 1.5}}};
    orr_antex_antenna antenna = {.sat = sat,
                                 .n_frequencies = 2,
                                 .frequency = f,
                                 .valid_from = ORR_TIME_NONE,
                                 .valid_until = ORR_TIME_NONE};
    const orr_antex antex = {.n_antennas = 1, .n_satellites = 1, .antenna = &antenna};
    src.antex = &antex;
    assert_int_equal(orr_spacecraft_at(&src, sat, t, orr_attitude_sun(t, NULL), &x), ORR_OK);
    ASSERT_NEAR(x.antenna_body_m[2], 1.5, 1e-12);
    ASSERT_NEAR(orr_vec3_dot(x.antenna_ecef_m, orr_vec3_unit(x.state.pos_m)), -1.5, 1e-12);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_are_the_closed_forms),
        cmocka_unit_test(what_the_arc_cuts_is_not_known),
        cmocka_unit_test(an_umbra_before_the_arc_is_not_denied),
        cmocka_unit_test(extras_say_what_they_do_not_know),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
