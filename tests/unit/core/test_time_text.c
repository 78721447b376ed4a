// SPDX-License-Identifier: GPL-3.0-or-later
// Instants and lengths of time as texts.
#include "testing.h"

#include "core/rng.h"
#include "core/time.h"

static orr_time parsed(const char *text)
{
    orr_time t = ORR_TIME_NONE;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}

static void what_the_command_line_accepts(void **state)
{
    (void)state;
    const orr_time t = parsed("2024-02-04T00:15:00");
    const char *same[] = {
        "2024-02-04T00:15",
        "2024-02-04 00:15:00",
        "2024-02-04T00:15:00 GPS",
        "2024-02-04T00:15:00.000000000",
        "2024-02-04T00:14:42Z",
        "2024-02-04T00:14:42 UTC",
        "2024-02-04 00:14:42 utc",
        "2024-02-04T00:14:42GLO",
        "2024-02-04T00:15:19 TAI",
        "2024-02-04T00:15:51.184 TT",
        "2024-02-04T00:14:46 BDT",
        "2024-02-04T00:14:46 BDS",
        "2024-02-04T00:15:00 GAL",
        "2024-035T00:15",
        "2024-035T00:15:00",
        "2024:035:00900",
        "24:035:00900",
        "2024:035:00882 UTC",
        "2024 2 4 0 15 0",
        "2024  2  4  0 15  0.00000000",
        "2024 02 04 00 15",
        "2024 2 4 0 14 42 UTC",
        "2024-02-04T00:14:42+00:00",
        "2024-02-04T01:14:42+01:00",
        "2024-02-03 20:44:42-0330",
        "MJD60344.01041666666667",
        "mjd 60344.01041666666667 GPS",
        "2300:900",
        "2300:900.000",
        "2024-2-4T0:15",
        "2024-02-04t00:15:00",
        "2024-02-04T00:15:00,0",
    };
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++)
        if (parsed(same[i]) != t) fail_msg("%s", same[i]);
    assert_int_equal(parsed("2024-02-04"), t - 900 * ORR_NS_PER_S);
    assert_int_equal(parsed("2024-035"), t - 900 * ORR_NS_PER_S);
    assert_int_equal(parsed("2024-035 GPS"), t - 900 * ORR_NS_PER_S);
    assert_int_equal(parsed("2024-02-03T24:00:00"), t - 900 * ORR_NS_PER_S);
    assert_int_equal(parsed("2024-02-04T06"), parsed("2024-02-04T06:00:00"));
    assert_int_equal(parsed("2024-02-04 06Z"), parsed("2024-02-04T06:00:00Z"));
    assert_int_equal(parsed("1980-01-06"), 0);
    assert_int_equal(parsed("0:0"), 0);
    assert_int_equal(parsed("1980-01-06T00:00:00.000000001"), 1);
    assert_int_equal(parsed("2024-366") - parsed("2024-12-31"), 0);
    assert_int_equal(parsed("2016-12-31T23:59:60Z") + ORR_NS_PER_S, parsed("2017-01-01T00:00:00Z"));
}

static void what_is_no_time_is_refused_with_its_reason(void **state)
{
    (void)state;
    const struct {
        const char *text, *reason;
        orr_status status;
    } bad[] = {
        {"", "use 2024", ORR_E_ARG},
        {"now", "use 2024", ORR_E_ARG},
        {"2024", "use 2024", ORR_E_ARG},
        {"2024-02", "use 2024", ORR_E_ARG},
        {"2024-02-30", "no such date", ORR_E_ARG},
        {"2024-13-01", "no such date", ORR_E_ARG},
        {"2024-02-04T25:00", "no such date", ORR_E_ARG},
        {"2024-02-04T00:60", "no such date", ORR_E_ARG},
        {"2024-02-04T00:15:60", "no leap second", ORR_E_ARG},
        {"2016-12-31T23:59:60", "no leap second", ORR_E_ARG}, // GPS scale
        {"2024-02-04T", "use 2024", ORR_E_ARG},
        {"2024-02-04T1", "use 2024", ORR_E_ARG},
        {"2024-02-04T00:15:00.1234567890", "use 2024", ORR_E_ARG}, // finer than a nanosecond
        {"2024-02-04T00:15:00.", "use 2024", ORR_E_ARG},
        {"2024-02-04T00:15:00 XYZ", "use 2024", ORR_E_ARG},
        {"2024-02-04T00:15:00Zz", "use 2024", ORR_E_ARG},
        {"2024-02-04T00:15:00+15:00", "use 2024", ORR_E_ARG},
        {"2024-02-04T00:15:00+1", "use 2024", ORR_E_ARG},
        {"2024:366:86401", "use 2024", ORR_E_ARG},
        {"2023:366:00000", "no such day", ORR_E_ARG},
        {"2024:35:00900", "use 2024", ORR_E_ARG},
        {"2024 2", "use 2024", ORR_E_ARG},
        {"2024 2 30", "no such date", ORR_E_ARG},
        {"2024 2 4 0 15 0 0", "use 2024", ORR_E_ARG},
        {"MJD", "use 2024", ORR_E_ARG},
        {"MJD60344x", "use 2024", ORR_E_ARG},
        {"60344.5", "use 2024", ORR_E_ARG},
        {"2023-366", "no such day", ORR_E_ARG},
        {"2024-000", "no such day", ORR_E_ARG},
        {"2024-0355", "use 2024", ORR_E_ARG},
        {"2300:604800", "604800 seconds", ORR_E_ARG},
        {"2300:", "use 2024", ORR_E_ARG},
        {"2300:-5", "use 2024", ORR_E_ARG},
        {"99999:0", "1960 to 2250", ORR_E_RANGE},
        {"1600-01-01", "1960 to 2250", ORR_E_RANGE},
        {"9999-12-31", "1960 to 2250", ORR_E_RANGE},
        {"1970-01-01T00:00:00Z", "1972", ORR_E_RANGE},
        {"99999999999999999999999999999999999999999999999999999999999999999999999999999999999999999-01-01",
         "use", ORR_E_ARG},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        orr_time t;
        orr_diag d = {0};
        orr_status s = orr_time_parse(bad[i].text, NULL, &t, &d);
        if (s != bad[i].status || strstr(d.text, bad[i].reason) == NULL)
            fail_msg("\"%s\": %s (%s)", bad[i].text, orr_status_name(s), d.text);
    }
}

static void formats_with_rounding(void **state)
{
    (void)state;
    char b[ORR_TIME_TEXT];
    const orr_time t = parsed("2024-02-04T00:14:59.987654321");
    assert_string_equal(orr_time_format(t, ORR_SCALE_GPS, 0, NULL, b), "2024-02-04T00:15:00");
    assert_string_equal(orr_time_format(t, ORR_SCALE_GPS, 1, NULL, b), "2024-02-04T00:15:00.0");
    assert_string_equal(orr_time_format(t, ORR_SCALE_GPS, 3, NULL, b), "2024-02-04T00:14:59.988");
    assert_string_equal(orr_time_format(t, ORR_SCALE_GPS, 9, NULL, b), "2024-02-04T00:14:59.987654321");
    assert_string_equal(orr_time_format(t, ORR_SCALE_GPS, 99, NULL, b), "2024-02-04T00:14:59.987654321");
    assert_string_equal(orr_time_format(t, ORR_SCALE_UTC, 0, NULL, b), "2024-02-04T00:14:42Z");
    assert_string_equal(orr_time_format(t, ORR_SCALE_TAI, 2, NULL, b), "2024-02-04T00:15:18.99 TAI");
    assert_string_equal(orr_time_format(t, ORR_SCALE_TT, 0, NULL, b), "2024-02-04T00:15:51 TT");
    assert_string_equal(orr_time_format(parsed("2016-12-31T23:59:60.7Z"), ORR_SCALE_UTC, 0, NULL, b),
                        "2017-01-01T00:00:00Z");
    assert_string_equal(orr_time_format(parsed("2016-12-31T23:59:59.7Z"), ORR_SCALE_UTC, 0, NULL, b),
                        "2016-12-31T23:59:60Z");
    assert_string_equal(orr_time_text(parsed("2024-02-04T00:15"), b), "2024-02-04T00:15:00");
    assert_string_equal(orr_time_text(parsed("2024-02-04T00:15:00.100"), b), "2024-02-04T00:15:00.1");
    assert_string_equal(orr_time_text(-1, b), "1980-01-05T23:59:59.999999999");
}

static void text_and_back_at_random_instants(void **state)
{
    (void)state;
    const orr_time first = parsed("1972-01-02"), last = parsed("2250-12-30");
    const orr_scale scales[] = {ORR_SCALE_GPS, ORR_SCALE_UTC, ORR_SCALE_TAI,
                                ORR_SCALE_TT,  ORR_SCALE_GLO, ORR_SCALE_BDT};
    for (uint64_t k = 0; k < 20000; k++) {
        orr_time t = first + (orr_time)(orr_rng_u64(5, 0, k) % (uint64_t)(last - first));
        char b[ORR_TIME_TEXT];
        assert_int_equal(parsed(orr_time_text(t, b)), t);
        orr_scale s = scales[k % 6];
        assert_int_equal(parsed(orr_time_format(t, s, 9, NULL, b)), t);
        int decimals = (int)(k % 9);
        int64_t half = 500000000;
        for (int i = 0; i < decimals; i++) half /= 10;
        orr_time rounded = parsed(orr_time_format(t, s, decimals, NULL, b));
        assert_true(rounded - t <= half && t - rounded <= half);
    }
}

static void lengths_of_time(void **state)
{
    (void)state;
    const struct {
        const char *text;
        int64_t ns;
    } good[] = {
        {"900", INT64_C(900000000000)},
        {"900s", INT64_C(900000000000)},
        {"15min", INT64_C(900000000000)},
        {"15m", INT64_C(900000000000)},
        {"2h", INT64_C(7200000000000)},
        {"1d", INT64_C(86400000000000)},
        {"0.1", 100000000},
        {".5", 500000000},
        {"1.5 h", INT64_C(5400000000000)},
        {"100ms", 100000000},
        {"0", 0},
        {"0.000000001", 1},
        {"1us", 1000},
        {"7ns", 7},
        {"1.000000001d", INT64_C(86400000086400)},
        {"0.5us", 500},
    };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        int64_t ns = -1;
        orr_diag d = {0};
        ASSERT_OK(orr_duration_parse(good[i].text, &ns, &d), d);
        assert_int_equal(ns, good[i].ns);
    }
    const char *bad[] = {"",      "s",   "-5",         "5x",  "5 5", "1e3", "0.0000000001",
                         "0.5ns", "nan", "9999999999", "5d5", "5.",  "."};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int64_t ns;
        orr_diag d = {0};
        if (orr_duration_parse(bad[i], &ns, &d) != ORR_E_ARG) fail_msg("%s", bad[i]);
        assert_true(d.text[0] != '\0');
    }
    int64_t ns;
    orr_diag d = {0};
    assert_int_equal(orr_duration_parse("200000d", &ns, &d), ORR_E_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_the_command_line_accepts),
        cmocka_unit_test(what_is_no_time_is_refused_with_its_reason),
        cmocka_unit_test(formats_with_rounding),
        cmocka_unit_test(text_and_back_at_random_instants),
        cmocka_unit_test(lengths_of_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
