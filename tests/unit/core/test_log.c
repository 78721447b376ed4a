// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/log.h"

#include "testing.h"

// A burst at once, then one line an interval, however many want to be said; those left out are counted.
static void a_rate_is_kept(void **state)
{
    (void)state;
    orr_log_rate r = {.burst = 5, .every_ns = 100};
    uint64_t held, said = 0, left_out = 0;
    for (int64_t t = 1000; t < 2000; t++) {
        if (!orr_log_rate_allows(&r, t, &held)) continue;
        said++;
        left_out += held;
        if (t < 1005) assert_int_equal(held, 0);
    }
    assert_int_equal(said, 5 + 9);
    assert_int_equal(left_out + r.held + said, 1000);
    // After a rest the burst is there again, and no more than it.
    for (said = 0; orr_log_rate_allows(&r, 100000, &held); said++) continue;
    assert_int_equal(said, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_rate_is_kept)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
