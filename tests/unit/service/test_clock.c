// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario's clock against a host's clock made of numbers.
#include "src/service/live/clock.h"

#include "testing.h"

static void it_shows_the_same_both_ways(void **state)
{
    (void)state;
    const double drifts[] = {0, 50e-6, -50e-6, 1e-9};
    for (int k = 0; k < 4; k++) {
        orr_clock c = {.drift = drifts[k]};
        orr_clock_start(&c, 7000000000, 1391040900 * ORR_NS_PER_S);
        for (int64_t d = -ORR_NS_PER_S; d < 100000 * ORR_NS_PER_S; d = 3 * d + 7 * ORR_NS_PER_S / 3) {
            const orr_time t = orr_clock_at(&c, 7000000000 + d);
            // t - t0 = d (1 + drift), to a nanosecond of rounding
            assert_true(llabs(t - 1391040900 * ORR_NS_PER_S - d - (int64_t)((double)d * drifts[k])) <= 1);
            assert_true(llabs(orr_clock_when(&c, t) - (7000000000 + d)) <= 1);
        }
    }
}

static void it_stands_and_goes_on(void **state)
{
    (void)state;
    orr_clock c = {.state = ORR_CLOCK_STOPPED, .t = 100};
    assert_int_equal(orr_clock_at(&c, 12345), 100);
    assert_int_equal(orr_clock_when(&c, 200), INT64_MAX);
    orr_clock_start(&c, 1000, 100);
    assert_int_equal(orr_clock_at(&c, 1500), 600);
    assert_int_equal(orr_clock_at(&c, 400), -500); // it counts down to its start
    orr_clock_pause(&c, 1700);
    assert_int_equal(orr_clock_at(&c, 999999), 800);
    assert_int_equal(orr_clock_when(&c, 801), INT64_MAX);
    orr_clock_start(&c, 5000, c.t);
    assert_int_equal(orr_clock_at(&c, 5001), 801);
}

static void ends_of_the_axis(void **state)
{
    (void)state;
    orr_clock c = {.drift = 1e-6};
    orr_clock_start(&c, 1000, 0);
    assert_true(orr_clock_when(&c, INT64_MAX) > INT64_MAX / 2);
    assert_true(orr_clock_when(&c, -INT64_MAX) < -INT64_MAX / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_shows_the_same_both_ways),
        cmocka_unit_test(it_stands_and_goes_on),
        cmocka_unit_test(ends_of_the_axis),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
