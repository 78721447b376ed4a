// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks judged: planted differences come back, what all satellites share does not, sigma is held to them.
#include "testing.h"

#include "orbit/judge/compare_clocks.h"
#include "unit/orbit/made_orbit.h"

enum {
    SATS = 15,
    EPOCHS = 48,
    STEP = 150
}; // five satellites of each of three systems; clock nodes every 300 s

static const double planted_s[5] = {-2e-9, -1e-9, 0, 1e-9, 2e-9}; // their median is zero
#define COMMON_S 7e-6

static void planted_differences_come_back(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(SATS, 4, 900, 6);
    size_t of_gps = 0;
    for (size_t i = 0; i < SATS; i++) {
        s.sat[i].clock_noise = (orr_clock_noise){0, 4e-18 / 75, 0}; // 2 ns between nodes
        of_gps += orr_sat_system(s.sat[i].sat) == 'G';
    }
    assert_int_equal(of_gps, 5);
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_sp3 f;
    ASSERT_OK(orr_sp3_alloc(SATS, EPOCHS, &f, &d), d);
    for (size_t i = 0, k = 0; i < SATS; i++) {
        f.sat[i] = s.sat[i].sat;
        const bool gps = orr_sat_system(f.sat[i]) == 'G';
        for (size_t n = 0; n < EPOCHS; n++) {
            orr_sat_state at;
            f.epoch[n] = made_midnight + (int64_t)(STEP * n) * ORR_NS_PER_S;
            assert_int_equal(orr_ephemeris_eval(e, f.sat[i], f.epoch[n], &at), ORR_OK);
            if ((at.flags & ORR_EPH_CLOCK_VALID) == 0 || !gps) continue;
            f.record[n * SATS + i].clock_s = at.clock_s - planted_s[k] - COMMON_S * (double)(n % 3);
        }
        k += gps;
    }
    for (int with = 0; with < 2; with++) {
        orr_clock_comparison x;
        ASSERT_OK(orr_compare_clocks(e, &f, 1, NULL, with, &x, &d), d);
        assert_int_equal(x.n_systems, 1);
        assert_int_equal(x.system[0].system, 'G');
        assert_int_equal(x.system[0].satellites, 5);
        assert_int_equal(x.system[0].n, 5 * (with ? EPOCHS : EPOCHS / 2));
        assert_int_equal(x.inputs, 5 * EPOCHS / 2);
        ASSERT_NEAR(x.system[0].rms_s, sqrt(2) * 1e-9, 1e-15); // mean square of 4, 1, 0, 1, 4
        ASSERT_NEAR(x.system[0].max_s, 2e-9, 1e-15);
        if (!with) ASSERT_NEAR(x.system[0].ratio, sqrt(2) / 2, 1e-4);
        assert_int_equal(x.n_sats, 5);
        ASSERT_NEAR(x.sat[0].rms_s, 2e-9, 1e-15);
        ASSERT_NEAR(x.sat[4].rms_s, 0, 1e-15);
        orr_clock_comparison_free(&x);
    }
    orr_sat_set three = {0}; // too few for a median that is not their own
    for (size_t i = 0, k = 0; i < SATS && k < 3; i++)
        if (orr_sat_system(s.sat[i].sat) == 'G') {
            orr_sat_set_add(&three, s.sat[i].sat);
            k++;
        }
    orr_clock_comparison x;
    ASSERT_OK(orr_compare_clocks(e, &f, 1, &three, false, &x, &d), d);
    assert_int_equal(x.n_systems, 0);
    assert_int_equal(x.few, 3 * EPOCHS / 2);
    orr_clock_comparison_free(&x);
    orr_sp3_free(&f);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(planted_differences_come_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
