// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers in space: what elements become is the orbit that a finer integration gives, precesses as J2 makes it, and looks at the
// Earth; a satellite of a product is where the product has it.
#include "src/make/moving.h"

#include <stdio.h>
#include <unistd.h>

#include "core/astro.h"
#include "orbit/force/kepler.h"
#include "testing.h"

static orr_status open_text(const char *text, orr_moving *v, orr_diag *diag)
{
    orr_scenario s;
    const orr_status read = orr_scenario_parse("s.yaml", text, strlen(text), ORR_BINARY_DIR, NULL, &s, diag);
    if (read != ORR_OK) return read;
    const orr_status status = orr_moving_open(&s.motion, orr_moving_fallback_start(), NULL, NULL, v, diag);
    orr_scenario_free(&s);
    return status;
}

static orr_motion motion_at(const orr_moving *v, double t_s)
{
    orr_motion m;
    v->trajectory.evaluate(v->trajectory.self, t_s, &m);
    return m;
}

// Osculating elements in the true equator of date. The Earth's rotation is that of the scenario without a file: the secular pole.
static orr_kepler elements_at(const orr_moving *v, double t_s)
{
    const orr_motion m = motion_at(v, t_s);
    const orr_time t = orr_time_add_s(v->trajectory.t0, t_s);
    orr_mat3 R, dR, date;
    orr_kepler k;
    const orr_eop eop = orr_eop_at(NULL, t, NULL, NULL);
    orr_astro_gcrs_to_itrs(t, &eop, NULL, &R, &dR);
    orr_astro_gcrs_to_tod(t, &date);
    const orr_vec3 r = orr_mat3_apply_t(&R, m.r_m),
                   v_i = orr_mat3_apply_t(&R, orr_vec3_sub(m.v_mps, orr_mat3_apply(&dR, r)));
    assert_int_equal(
        orr_kepler_from_state(orr_mat3_apply(&date, r), orr_mat3_apply(&date, v_i), ORR_EGM96_GM, &k),
        ORR_OK);
    return k;
}

#define LEO(more)                                                                                            \
    "trajectory: {kind: orbit, " more "elements: {semimajor_axis: 6878137, eccentricity: 0.002, "            \
    "inclination: 97.4, node: 30, perigee: 70, mean_anomaly: 10}}\n"

static void elements_are_those_of_the_start(void **state)
{
    (void)state;
    orr_moving v;
    orr_diag d = {0};
    ASSERT_OK(open_text(LEO("duration: 1d, "), &v, &d), d);
    const orr_kepler k = elements_at(&v, 0);
    ASSERT_NEAR(k.a_m, 6878137, 1e-3); // velocities to 1e-7 m/s
    ASSERT_NEAR(k.e, 0.002, 1e-9);
    ASSERT_NEAR(k.i_rad * ORR_DEG_PER_RAD, 97.4, 1e-8);
    ASSERT_NEAR(k.raan_rad * ORR_DEG_PER_RAD, 30, 1e-8);
    ASSERT_NEAR((k.argp_rad + k.m_rad) * ORR_DEG_PER_RAD, 80, 1e-6);
    // The node goes on by J2 as the Sun does, 0.986 deg a day: -3/2 J2 (R/p)^2 n cos i. Short periods are 0.01 deg.
    const double n = sqrt(ORR_EGM96_GM / pow(6878137, 3)), part = 6378137 / (6878137 * (1 - 0.002 * 0.002)),
                 rate = -1.5 * 1.08262668e-3 * part * part * n * cos(97.4 * ORR_RAD_PER_DEG);
    ASSERT_NEAR((elements_at(&v, 86400).raan_rad - k.raan_rad) * ORR_DEG_PER_RAD,
                rate * 86400 * ORR_DEG_PER_RAD, 0.02);
    ASSERT_NEAR(rate * 86400 * ORR_DEG_PER_RAD, 0.98, 0.02);
    orr_moving_free(&v);
}

static void it_falls_freely_and_looks_at_the_earth(void **state)
{
    (void)state;
    orr_moving v;
    orr_diag d = {0};
    ASSERT_OK(open_text(LEO("duration: 3h, "), &v, &d), d);
    for (double t_s = 0; t_s <= 10800; t_s += 333.3) {
        const orr_motion m = motion_at(&v, t_s);
        const orr_mat3 body = orr_mat3_from_quat(m.q_be);
        const orr_vec3 up = orr_mat3_apply(&body, orr_vec3_unit(m.r_m)),
                       way = orr_mat3_apply(&body, orr_velocity_inertial(m.r_m, m.v_mps));
        ASSERT_NEAR(up.z, 1, 1e-15);
        ASSERT_NEAR(way.x, 0, 1e-5); // of 7600 m/s, right of its way
        assert_true(way.y > 7500);
        // Nothing is felt but what normal gravity lacks of EGM96, Sun and Moon: less than 4e-4 m/s^2 at 500 km.
        orr_vec3 rate, force;
        orr_motion_sense(&m, orr_earth_normal_gravitation(m.r_m), &rate, &force);
        ASSERT_NEAR(orr_vec3_norm(force), 0, 4e-4);
        ASSERT_NEAR(rate.x, -orr_vec3_norm(orr_velocity_inertial(m.r_m, m.v_mps)) / orr_vec3_norm(m.r_m),
                    1e-5); // nose down once a revolution
        // Velocity and acceleration are the place's derivatives: over 1 s, to its fourth derivative, 1e-5 m/s^4.
        const orr_motion a = motion_at(&v, fmax(t_s - 1, 0)), b = motion_at(&v, fmin(t_s + 1, 10800));
        const double h = fmin(t_s + 1, 10800) - fmax(t_s - 1, 0);
        if (h == 2) {
            const orr_vec3 mean = orr_vec3_scale(1 / h, orr_vec3_sub(b.r_m, a.r_m));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(mean, m.v_mps)), 0,
                        3e-3); // a third of 1 s^2 times 9e-3 m/s^3, and less
        }
    }
    // The same orbit begun later meets the longer one: 5 s nodes lose nothing on the way.
    orr_moving w;
    ASSERT_OK(open_text(LEO("duration: 300, "), &w, &d), d);
    for (double t_s = 1.7; t_s < 300; t_s += 21.1)
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(motion_at(&v, t_s).r_m, motion_at(&w, t_s).r_m)), 0, 1e-6);
    orr_moving_free(&w);
    orr_moving_free(&v);
}

static void orbits_that_cannot_be_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text, *word;
    } bad[] = {
        {LEO(""), "duration"},
        {LEO("duration: 40d, "), "31 days"},
        {"trajectory: {kind: orbit, duration: 1h}\n", "elements"},
        {"trajectory: {kind: orbit, product: none.nc}\n", "sat"},
        {"trajectory: {kind: orbit, product: none.nc, sat: L05}\n", "none.nc"},
        {"trajectory: {kind: orbit, duration: 1h, elements: {semimajor_axis: 7000000, eccentricity: 0.1, "
         "inclination: 10}}\n",
         "perigee"},
        {"trajectory: {kind: orbit, duration: 1h, elements: {semimajor_axis: 7000000, eccentricity: 1, "
         "inclination: 10}}\n",
         "eccentricity"},
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        orr_moving v;
        orr_diag d = {0};
        assert_int_not_equal(open_text(bad[k].text, &v, &d), ORR_OK);
        if (strstr(d.text, bad[k].word) == NULL && strstr(d.file, bad[k].word) == NULL)
            fail_msg("'%s' does not name '%s'", d.text, bad[k].word);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(elements_are_those_of_the_start),
                                       cmocka_unit_test(it_falls_freely_and_looks_at_the_earth),
                                       cmocka_unit_test(orbits_that_cannot_be_are_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
