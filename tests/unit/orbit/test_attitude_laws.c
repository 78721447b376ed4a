// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of turning: nominal away from noon and midnight, continuous, symmetric, never faster than the block can.
#include "orbit/spacecraft/attitude_laws.h"

#include "testing.h"

#define DEG ORR_RAD_PER_DEG
static const double N = 3874 / 2.656e7;

static orr_attitude at(orr_attitude_law law, double mu, double beta)
{
    const orr_vec3 r = {-2.656e7 * cos(mu), -2.656e7 * sin(mu), 0}, v = {3874 * sin(mu), -3874 * cos(mu), 0};
    const orr_vec3 sun = {1.496e11 * cos(beta), 0, 1.496e11 * sin(beta)};
    orr_attitude a;
    assert_int_equal(orr_attitude_by_law(law, 0, r, v, sun, &a), ORR_OK);
    return a;
}

static const struct {
    orr_attitude_law law;
    double
        rate; // deg/s that it may reach near noon and midnight: its limit, or n / tan(beta) of the least beta that it leaves nominal
} laws[] = {
    {ORR_LAW_RATE, 0.2002},      {ORR_LAW_IIF, 0.1101},        {ORR_LAW_GLONASS_M, 0.2503},
    {ORR_LAW_GALILEO_IOV, 0.24}, {ORR_LAW_GALILEO_FOC, 0.118}, {ORR_LAW_BEIDOU_3, 0.18},
    {ORR_LAW_III, 0.09}, // Montenbruck et al. (2026) tell the same
    {ORR_LAW_IIA, 0.144}, // 0.12, and what nominal yaw turns at the shadow's end, where the satellite comes back to it
};

static void far_from_the_sun_s_line_all_are_nominal(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
        for (double beta = -60; beta <= 60; beta += 7)
            for (double mu = 40; mu <= 140; mu += 10) {
                const orr_attitude a = at(laws[k].law, mu * DEG, beta * DEG),
                                   b = at(ORR_LAW_NOMINAL, mu * DEG, beta * DEG);
                // BeiDou's blend leaves 3 deg / (1 + 80000 sin^4) there.
                ASSERT_NEAR(remainder(a.yaw_rad - b.yaw_rad, 2 * ORR_PI), 0, 1e-5);
            }
}

static void yaw_goes_on_and_not_too_fast(void **state)
{
    (void)state;
    static const double betas[] = {-12, -5, -3.5, -2.1, -1, -0.2, 0.1, 0.4, 1.5, 2.5, 3, 4, 4.5, 9, 13};
    const double step = 0.02 * DEG;
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
        for (size_t j = 0; j < sizeof betas / sizeof *betas; j++) {
            double last = at(laws[k].law, -ORR_PI, betas[j] * DEG).yaw_rad, whole = 0;
            for (double mu = -ORR_PI + step; mu <= ORR_PI + step / 2; mu += step) {
                const orr_attitude a = at(laws[k].law, mu, betas[j] * DEG);
                const double turn = remainder(a.yaw_rad - last, 2 * ORR_PI);
                // deg/s; a turn of 180 deg that takes the other way round, or a jump, would show as far more.
                if (!(fabs(turn / step * N) < laws[k].rate * DEG))
                    fail_msg("law %d, beta %g, mu %g: %g deg/s", (int)laws[k].law, betas[j], mu / DEG,
                             turn / step * N / DEG);
                whole += turn;
                last = a.yaw_rad;
                ASSERT_NEAR(orr_vec3_norm((orr_vec3){a.body.m[0][0], a.body.m[0][1], a.body.m[0][2]}), 1,
                            1e-12);
            }
            // What is turned at noon is turned back at midnight; a IIA turns one way in the shadow.
            ASSERT_NEAR(laws[k].law == ORR_LAW_IIA ? remainder(whole, 2 * ORR_PI) : whole, 0, 1e-6);
        }
}

// The Sun above and below the plane are mirror images.
static void both_sides_are_alike(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
        for (double mu = -179; mu < 180 && laws[k].law != ORR_LAW_IIA; mu += 0.7) {
            const double up = at(laws[k].law, mu * DEG, 1.3 * DEG).yaw_rad,
                         down = at(laws[k].law, mu * DEG, -1.3 * DEG).yaw_rad;
            ASSERT_NEAR(remainder(up + down, 2 * ORR_PI), 0, 1e-9);
        }
}

// A IIA leaves the nominal yaw where the shadow begins, turns by its rate to the positive side on either side of the Sun, and half
// an hour after the shadow is nominal again.
static void a_iia_turns_one_way_in_the_shadow(void **state)
{
    (void)state;
    const double half = 13 * DEG;
    for (double beta = -3; beta <= 3; beta += 1.5) {
        if (beta == 0) continue;
        const double a = at(ORR_LAW_IIA, -half / 2, beta * DEG).yaw_rad,
                     b = at(ORR_LAW_IIA, half / 2, beta * DEG).yaw_rad;
        ASSERT_NEAR(remainder(b - a - 0.12 * DEG * half / N, 2 * ORR_PI), 0, 1e-9);
        for (double mu = -40; mu < 40; mu++) {
            if (mu > -14 && mu < 14 + 1800 * N / DEG) continue;
            ASSERT_NEAR(remainder(at(ORR_LAW_IIA, mu * DEG, beta * DEG).yaw_rad -
                                      at(ORR_LAW_NOMINAL, mu * DEG, beta * DEG).yaw_rad,
                                  2 * ORR_PI),
                        0, 1e-12);
        }
    }
}

// A year of BeiDou's satellites and of QZS-1: round orbits, the Sun along the ecliptic, every 40 s. Yaw goes on without jumps, at no
// more than nominal steering at the least beta that is steered and 0.1 deg/s; it is 0 while beta is small, and a change of the way of
// flying begins where the satellite passes 90 deg from midnight.
static void satellites_that_fly_orbit_normal(void **state)
{
    (void)state;
    static const struct {
        orr_attitude_law law;
        double radius_m, inclination_deg, node_deg, least_deg;
    } kinds[] = {{ORR_LAW_BEIDOU_2, 2.79e7, 55, 200, 4},
                 {ORR_LAW_BEIDOU_2, 4.2164e7, 55, 30, 4},
                 {ORR_LAW_QZS_1, 4.2164e7, 41, 130, 20}};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        const double n = sqrt(3.986004418e14 / pow(kinds[k].radius_m, 3)), i = kinds[k].inclination_deg * DEG,
                     node = kinds[k].node_deg * DEG, step_s = 40;
        double last = 0, fastest = 0;
        size_t normal = 0, steered = 0, changes = 0;
        bool was = false, first = true;
        for (double t_s = 0; t_s < 366 * 86400.0; t_s += step_s) {
            // Only days about the changes of either way, which beta tells, are looked at closely.
            const double u = n * t_s, day = t_s / 86400,
                         g = (357.528 + 0.9856003 * (day + 8766)) * DEG; // 2024-01-01
            const double lon = (280.460 + 0.9856474 * (day + 8765.5)) * DEG + 1.915 * DEG * sin(g),
                         e = 23.44 * DEG;
            const orr_vec3 sun = {1.496e11 * cos(lon), 1.496e11 * sin(lon) * cos(e),
                                  1.496e11 * sin(lon) * sin(e)};
            const orr_vec3 w = {sin(i) * sin(node), -sin(i) * cos(node), cos(i)};
            const double beta = asin(orr_vec3_dot(w, orr_vec3_unit(sun))) / DEG;
            if (fabs(fabs(beta) - kinds[k].least_deg) > 3) {
                first = true;
                continue;
            }
            const orr_vec3 p = {cos(node), sin(node), 0}, q = orr_vec3_cross(w, p);
            const orr_vec3 r =
                orr_vec3_scale(kinds[k].radius_m, orr_vec3_axpy(cos(u), p, orr_vec3_scale(sin(u), q)));
            const orr_vec3 v =
                orr_vec3_scale(kinds[k].radius_m * n, orr_vec3_axpy(cos(u), q, orr_vec3_scale(-sin(u), p)));
            orr_attitude a, b;
            const orr_time t = orr_time_add_s(orr_time_from_mjd(60310, 0, ORR_SCALE_GPS, NULL), t_s);
            assert_int_equal(orr_attitude_by_law(kinds[k].law, t, r, v, sun, &a), ORR_OK);
            assert_int_equal(orr_attitude_nominal(r, v, sun, &b), ORR_OK);
            if (!first) fastest = fmax(fastest, fabs(remainder(a.yaw_rad - last, 2 * ORR_PI)) / step_s / DEG);
            last = a.yaw_rad;
            const bool flies_normal = fabs(a.yaw_rad) < 1e-4,
                       is_nominal = fabs(remainder(a.yaw_rad - b.yaw_rad, 2 * ORR_PI)) < 1e-4;
            normal += flies_normal;
            steered += is_nominal;
            if (!first && flies_normal != was && (flies_normal || is_nominal)) changes++;
            was = flies_normal;
            first = false;
            if (fabs(beta) > kinds[k].least_deg + 1.1)
                assert_true(is_nominal); // beta moves by a degree in a revolution of a day
            if (fabs(beta) < kinds[k].least_deg - 1.1) assert_true(flies_normal);
        }
        print_message("law %d: orbit-normal in %zu of %zu samples about the changes, fastest %.3f deg/s\n",
                      (int)kinds[k].law, normal, normal + steered, fastest);
        assert_true(normal > 1000 && steered > 1000 && changes > 0);
        assert_true(fastest < 0.1 + n / tan(kinds[k].least_deg * DEG) / DEG);
    }
}

static void blocks_have_their_laws(void **state)
{
    (void)state;
    static const struct {
        const char *type;
        orr_attitude_law law;
    } want[] = {{"BLOCK IIF", ORR_LAW_IIF},
                {"BLOCK IIR-M", ORR_LAW_RATE},
                {"BLOCK IIR-A", ORR_LAW_RATE},
                {"BLOCK IIA", ORR_LAW_IIA},
                {"BLOCK IIIA", ORR_LAW_III},
                {"BLOCK II", ORR_LAW_IIA},
                {"BLOCK I", ORR_LAW_NOMINAL},
                {"GLONASS-M", ORR_LAW_GLONASS_M},
                {"GLONASS", ORR_LAW_NOMINAL},
                {"GALILEO-2", ORR_LAW_GALILEO_FOC},
                {"GALILEO-1", ORR_LAW_GALILEO_IOV},
                {"BEIDOU-3M-CAST", ORR_LAW_BEIDOU_3},
                {"BEIDOU-2M", ORR_LAW_BEIDOU_2},
                {"BEIDOU-2I", ORR_LAW_BEIDOU_2},
                {"QZSS", ORR_LAW_QZS_1},
                {"QZSS-2I", ORR_LAW_NOMINAL}};
    assert_int_equal(orr_attitude_law_of(NULL), ORR_LAW_NOMINAL);
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        orr_antex_antenna a = {.n_frequencies = 0};
        snprintf(a.type, sizeof a.type, "%s", want[k].type);
        assert_int_equal(orr_attitude_law_of(&a), want[k].law);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_from_the_sun_s_line_all_are_nominal),
        cmocka_unit_test(yaw_goes_on_and_not_too_fast),
        cmocka_unit_test(both_sides_are_alike),
        cmocka_unit_test(a_iia_turns_one_way_in_the_shadow),
        cmocka_unit_test(satellites_that_fly_orbit_normal),
        cmocka_unit_test(blocks_have_their_laws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
