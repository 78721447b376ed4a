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
    assert_int_equal(orr_attitude_by_law(law, r, v, sun, &a), ORR_OK);
    return a;
}

static const struct {
    orr_attitude_law law;
    double
        rate; // deg/s that it may reach near noon and midnight: its limit, or n / tan(beta) of the least beta that it leaves nominal
} laws[] = {
    {ORR_LAW_RATE, 0.2002},      {ORR_LAW_IIF, 0.1101},        {ORR_LAW_GLONASS_M, 0.2503},
    {ORR_LAW_GALILEO_IOV, 0.24}, {ORR_LAW_GALILEO_FOC, 0.118}, {ORR_LAW_BEIDOU_3, 0.18},
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
            ASSERT_NEAR(whole, 0, 1e-6); // what is turned at noon is turned back at midnight
        }
}

// The Sun above and below the plane are mirror images.
static void both_sides_are_alike(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
        for (double mu = -179; mu < 180; mu += 0.7) {
            const double up = at(laws[k].law, mu * DEG, 1.3 * DEG).yaw_rad,
                         down = at(laws[k].law, mu * DEG, -1.3 * DEG).yaw_rad;
            ASSERT_NEAR(remainder(up + down, 2 * ORR_PI), 0, 1e-9);
        }
}

static void blocks_have_their_laws(void **state)
{
    (void)state;
    static const struct {
        const char *type;
        orr_attitude_law law;
    } want[] = {{"BLOCK IIF", ORR_LAW_IIF},         {"BLOCK IIR-M", ORR_LAW_RATE},
                {"BLOCK IIR-A", ORR_LAW_RATE},      {"BLOCK IIA", ORR_LAW_NOMINAL},
                {"BLOCK IIIA", ORR_LAW_NOMINAL},    {"GLONASS-M", ORR_LAW_GLONASS_M},
                {"GLONASS", ORR_LAW_NOMINAL},       {"GALILEO-2", ORR_LAW_GALILEO_FOC},
                {"GALILEO-1", ORR_LAW_GALILEO_IOV}, {"BEIDOU-3M-CAST", ORR_LAW_BEIDOU_3},
                {"BEIDOU-2M", ORR_LAW_NOMINAL},     {"QZSS", ORR_LAW_NOMINAL}};
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
        cmocka_unit_test(blocks_have_their_laws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
