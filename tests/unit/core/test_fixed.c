// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed decimals against the C library's own.
#include "testing.h"

#include "core/fixed.h"
#include "core/nan.h"
#include "core/rng.h"

static void same(double v, int decimals)
{
    char mine[ORR_FIXED_TEXT], theirs[ORR_FIXED_TEXT];
    size_t n = orr_fixed(v, decimals, mine);
    assert_int_equal(n, strlen(mine));
    snprintf(theirs, sizeof theirs, "%.*f", decimals, v);
    if (strcmp(mine, theirs) == 0) return;
    // v * 10^decimals is rounded once before it is rounded to a whole number, so the last digit may be off by
    // one where printf sees a near tie; a zero has no sign here.
    double last = pow(10, -decimals);
    if (!(fabs(strtod(mine, NULL) - strtod(theirs, NULL)) <= 1.001 * last + 4e-16 * fabs(v)) ||
        strlen(mine) > strlen(theirs))
        fail_msg("%.17g with %d decimals: '%s', printf has '%s'", v, decimals, mine, theirs);
    ASSERT_NEAR(strtod(mine, NULL), v, 0.5001 * last + 4e-16 * fabs(v));
}

static void test_random(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 200000; k++) {
        double u = 2 * orr_rng_uniform(1, 0, 3 * k) - 1;
        int decimals = (int)(16 * orr_rng_uniform(1, 0, 3 * k + 1)),
            power = (int)(24 * orr_rng_uniform(1, 0, 3 * k + 2)) - 14;
        same(u * pow(10, power), decimals);
    }
}

static void test_special(void **state)
{
    (void)state;
    char buf[ORR_FIXED_TEXT];
    static const double v[] = {
        0, 1, -1, 0.5, -0.5, 9.995, 1e15, -1e16, 1e300, 26560123.456789, -4e-12, 0.1, 999999.9999996};
    for (size_t i = 0; i < sizeof v / sizeof v[0]; i++)
        for (int d = 0; d <= 15; d++) same(v[i], d);
    orr_fixed(-0.0000001, 6, buf);
    assert_string_equal(buf, "0.000000");
    orr_fixed(-0.000001, 6, buf);
    assert_string_equal(buf, "-0.000001");
    orr_fixed(0.07, 2, buf);
    assert_string_equal(buf, "0.07");
    orr_fixed(123.0, 0, buf);
    assert_string_equal(buf, "123");
    orr_fixed(ORR_NAN, 3, buf);
    assert_string_equal(buf, "nan");
    orr_fixed(-(double)INFINITY, 3, buf);
    assert_string_equal(buf, "-inf");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random), cmocka_unit_test(test_special)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
