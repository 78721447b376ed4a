// SPDX-License-Identifier: GPL-3.0-or-later
// Wind-up against what it is: turns of antennas; and the signals' constants that the project rests on.
#include "core/nan.h"
#include "iono/phase/signals.h"
#include "iono/phase/windup.h"
#include "testing.h"

static orr_iono_site here(void)
{
    orr_iono_site s;
    orr_diag d = {0};
    ASSERT_OK(orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.9, 0.3, 0}), &s, &d), d);
    return s;
}

// A satellite at the zenith that turns once about the line of sight winds the phase by one turn. Its field
// turns clockwise for who looks along the propagation (downward), and so does x from North by East to South
// seen from above looking down... counter-clockwise: x from North to West adds phase as time does when the
// field is right-handed.
static void test_turning_satellite(void **state)
{
    (void)state;
    orr_iono_site s = here();
    orr_vec3 sat = orr_vec3_axpy(20e6, s.up, s.pos_m);
    for (int sense = -1; sense <= 1; sense += 2) {
        double before = 0, first = ORR_NAN;
        for (int deg = 0; deg <= 720; deg += 5) {
            double a = sense * deg * ORR_RAD_PER_DEG;
            orr_vec3 x =
                orr_vec3_axpy(sin(a), s.east, orr_vec3_scale(cos(a), s.north)); // clockwise from above
            orr_vec3 y = orr_vec3_cross(orr_vec3_scale(-1, s.up), x);
            before = orr_windup_axes(&s, sat, x, y, before);
            if (deg == 0) first = before;
            // Transmitter turned in the field's own sense (clockwise along the ray, which is clockwise from
            // above): the received phase, as receivers count it (growing with range), shrinks.
            ASSERT_NEAR(before - first, -sense * deg / 360.0, 1e-9);
        }
        ASSERT_NEAR(first, 0, 1e-12);
    }
}

// Continuity is the caller's through `before`: whole turns are kept.
static void test_continuation(void **state)
{
    (void)state;
    orr_iono_site s = here();
    orr_vec3 sat = {10e6, 20e6, 12e6}, sun = {1e11, 8e10, -3e10};
    double w = orr_windup_turns(&s, sat, sun, 0);
    assert_true(fabs(w) <= 0.5);
    ASSERT_NEAR(orr_windup_turns(&s, sat, sun, w + 7), w + 7, 1e-12);
    ASSERT_NEAR(orr_windup_turns(&s, sat, sun, w - 3.4), w - 3, 1e-12);
}

static void test_constants(void **state)
{
    (void)state;
    double f1 = orr_signal_frequency_hz('G', "L1C", 0, 3.05),
           f2 = orr_signal_frequency_hz('G', "L2W", 0, 3.05);
    double k = orr_tecu_per_metre(f1, f2);
    ASSERT_NEAR(k, 9.5196, 1e-3);                                      // TECU a metre of L1 - L2
    ASSERT_NEAR(k * ORR_LIGHT_MPS * (1 / f2 - 1 / f1), 0.513, 0.0005); // one turn is one cycle on both
    ASSERT_NEAR(orr_signal_frequency_hz('R', "L1C", -7, 3.05), 1598.0625e6, 0.01);
    ASSERT_NEAR(orr_signal_frequency_hz('R', "L2P", 6, 3.05), 1248.625e6, 0.01);
    ASSERT_NEAR(orr_signal_frequency_hz('C', "L2I", 0, 3.05), 1561.098e6, 0.01);
    ASSERT_NEAR(orr_signal_frequency_hz('C', "L1I", 0, 3.02), 1561.098e6, 0.01);
    ASSERT_NEAR(orr_signal_frequency_hz('C', "L1X", 0, 3.04), 1575.42e6, 0.01);
    ASSERT_NEAR(orr_signal_frequency_hz('E', "L9X", 0, 3.04), 0, 0);
    assert_true(orr_signal_rank('G', '2', 'W') < orr_signal_rank('G', '2', 'X'));
    assert_int_equal(orr_signal_rank('G', '1', '?'), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_turning_satellite),
                                       cmocka_unit_test(test_continuation), cmocka_unit_test(test_constants)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
