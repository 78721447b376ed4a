// SPDX-License-Identifier: GPL-3.0-or-later
// Calendar, scales, leap seconds, weeks.
#include "testing.h"

#include "core/nan.h"
#include "core/rng.h"
#include "core/time.h"

static orr_time at(int y, int mo, int d, int h, int mi, int s, orr_scale scale)
{
    orr_time t = ORR_TIME_NONE;
    assert_int_equal(orr_time_from_civil(&(orr_civil){y, mo, d, h, mi, s, 0}, scale, NULL, &t), ORR_OK);
    return t;
}

static void assert_civil(orr_time t, orr_scale scale, int y, int mo, int d, int h, int mi, int s)
{
    orr_civil c;
    orr_time_to_civil(t, scale, NULL, &c);
    assert_int_equal(c.year, y);
    assert_int_equal(c.month, mo);
    assert_int_equal(c.day, d);
    assert_int_equal(c.hour, h);
    assert_int_equal(c.minute, mi);
    assert_int_equal(c.second, s);
}

// ---- calendar ----

static void days_of_the_textbooks(void **state)
{
    (void)state;
    // Meeus, Astronomical Algorithms, ch. 7, and the epochs in use (MJD = JD - 2400000.5)
    assert_int_equal(orr_mjd_from_date(2000, 1, 1), 51544);
    assert_int_equal(orr_mjd_from_date(1858, 11, 17), 0);
    assert_int_equal(orr_mjd_from_date(1980, 1, 6), 44244);
    assert_int_equal(orr_mjd_from_date(1900, 1, 1), 15020);
    assert_int_equal(orr_mjd_from_date(1987, 6, 19), 46965);
    assert_int_equal(orr_mjd_from_date(1600, 12, 31), -94188); // JD 2305812.5
    assert_int_equal(orr_mjd_from_date(-4713, 11, 24),
                     -2400001); // JD -0.5: noon of it is JD 0, proleptic Gregorian
    assert_true(orr_is_leap_year(2000));
    assert_true(orr_is_leap_year(2024));
    assert_false(orr_is_leap_year(1900));
    assert_false(orr_is_leap_year(2100));
    assert_false(orr_is_leap_year(2023));
    assert_int_equal(orr_mjd_from_date(1900, 3, 1) - orr_mjd_from_date(1900, 2, 28), 1);
    assert_int_equal(orr_mjd_from_date(2000, 3, 1) - orr_mjd_from_date(2000, 2, 28), 2);
    assert_int_equal(orr_mjd_from_date(2100, 3, 1) - orr_mjd_from_date(2100, 2, 28), 1);
    assert_int_equal(orr_day_of_year(2024, 2, 4), 35);
    assert_int_equal(orr_day_of_year(2024, 12, 31), 366);
    assert_int_equal(orr_day_of_year(2023, 12, 31), 365);
    assert_int_equal(orr_day_of_year(1978, 11, 14), 318); // Meeus, example 7.f
    assert_int_equal(orr_day_of_year(1988, 4, 22), 113);  // Meeus, example 7.g
}

// A day after another, counted by hand over four centuries and past both ends of the time axis.
static void every_day_follows_the_one_before(void **state)
{
    (void)state;
    static const int length[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    int32_t mjd = orr_mjd_from_date(1599, 1, 1);
    for (int y = 1599; y <= 2300; y++) {
        for (int m = 1; m <= 12; m++) {
            int n = length[m - 1] + (m == 2 && orr_is_leap_year(y) ? 1 : 0);
            for (int d = 1; d <= n; d++, mjd++) {
                int yy, mm, dd;
                assert_int_equal(orr_mjd_from_date(y, m, d), mjd);
                orr_date_from_mjd(mjd, &yy, &mm, &dd);
                assert_true(yy == y && mm == m && dd == d);
            }
        }
    }
}

static void fields_out_of_bounds_are_refused(void **state)
{
    (void)state;
    const struct {
        orr_civil c;
        orr_status expected;
    } cases[] = {
        {{2024, 0, 1, 0, 0, 0, 0}, ORR_E_ARG},
        {{2024, 13, 1, 0, 0, 0, 0}, ORR_E_ARG},
        {{2024, 2, 30, 0, 0, 0, 0}, ORR_E_ARG},
        {{2023, 2, 29, 0, 0, 0, 0}, ORR_E_ARG},
        {{2100, 2, 29, 0, 0, 0, 0}, ORR_E_ARG},
        {{2000, 2, 29, 0, 0, 0, 0}, ORR_OK},
        {{2024, 4, 31, 0, 0, 0, 0}, ORR_E_ARG},
        {{2024, 1, 0, 0, 0, 0, 0}, ORR_E_ARG},
        {{2024, 1, 1, -1, 0, 0, 0}, ORR_E_ARG},
        {{2024, 1, 1, 25, 0, 0, 0}, ORR_E_ARG},
        {{2024, 1, 1, 24, 0, 0, 0}, ORR_OK},
        {{2024, 1, 1, 24, 0, 0, 1}, ORR_E_ARG},
        {{2024, 1, 1, 24, 1, 0, 0}, ORR_E_ARG},
        {{2024, 1, 1, 0, 60, 0, 0}, ORR_E_ARG},
        {{2024, 1, 1, 0, 0, 60, 0}, ORR_E_ARG},
        {{2016, 12, 31, 23, 59, 60, 0}, ORR_E_ARG}, // GPS has none
        {{2024, 1, 1, 0, 0, 61, 0}, ORR_E_ARG},
        {{2024, 1, 1, 0, 0, 0, -1}, ORR_E_ARG},
        {{2024, 1, 1, 0, 0, 0, 1000000000}, ORR_E_ARG},
        {{1899, 12, 31, 0, 0, 0, 0}, ORR_E_RANGE},
        {{2251, 1, 1, 0, 0, 0, 0}, ORR_E_RANGE},
        {{1959, 12, 31, 23, 59, 59, 999999999}, ORR_E_RANGE},
        {{1960, 1, 1, 0, 0, 0, 0}, ORR_OK},
        {{2250, 12, 31, 23, 59, 59, 999999999}, ORR_OK},
        {{INT32_MAX, 1, 1, 0, 0, 0, 0}, ORR_E_RANGE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_time t;
        if (orr_time_from_civil(&cases[i].c, ORR_SCALE_GPS, NULL, &t) != cases[i].expected)
            fail_msg("case %zu", i);
    }
    assert_int_equal(at(2024, 1, 31, 24, 0, 0, ORR_SCALE_GPS), at(2024, 2, 1, 0, 0, 0, ORR_SCALE_GPS));
}

// ---- scales ----

static void scales_at_their_published_offsets(void **state)
{
    (void)state;
    assert_int_equal(at(1980, 1, 6, 0, 0, 0, ORR_SCALE_GPS), 0);
    assert_int_equal(at(1980, 1, 6, 0, 0, 0, ORR_SCALE_UTC), 0); // GPS began on UTC
    assert_int_equal(at(1980, 1, 6, 0, 0, 19, ORR_SCALE_TAI), 0);
    assert_int_equal(at(2006, 1, 1, 0, 0, 14, ORR_SCALE_GPS),
                     at(2006, 1, 1, 0, 0, 0, ORR_SCALE_BDT)); // BDT began
    assert_int_equal(at(2006, 1, 1, 0, 0, 0, ORR_SCALE_UTC),
                     at(2006, 1, 1, 0, 0, 0, ORR_SCALE_BDT)); // on UTC
    assert_int_equal(at(2024, 2, 4, 0, 0, 18, ORR_SCALE_GPS), at(2024, 2, 4, 0, 0, 0, ORR_SCALE_UTC));
    assert_int_equal(at(2024, 2, 4, 0, 0, 18, ORR_SCALE_GPS), at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GLO));
    for (orr_scale s = ORR_SCALE_GPS; s <= ORR_SCALE_IRN; s++) {
        if (s == ORR_SCALE_GAL || s == ORR_SCALE_QZS || s == ORR_SCALE_IRN)
            assert_int_equal(at(2024, 2, 4, 1, 2, 3, s), at(2024, 2, 4, 1, 2, 3, ORR_SCALE_GPS));
        orr_scale back;
        assert_int_equal(orr_scale_parse(orr_scale_name(s), 3, &back), ORR_OK);
        assert_int_equal(back, s);
    }
    // TT = TAI + 32.184 s
    orr_civil c;
    orr_time_to_civil(at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GPS), ORR_SCALE_TT, NULL, &c);
    assert_int_equal(c.second, 51);
    assert_int_equal(c.ns, 184000000);
    orr_scale s;
    assert_int_equal(orr_scale_parse("bds", 3, &s), ORR_OK);
    assert_int_equal(s, ORR_SCALE_BDT);
    assert_int_equal(orr_scale_parse("QZSS", 4, &s), ORR_OK);
    assert_int_equal(orr_scale_parse("UT1", 3, &s), ORR_E_ARG);
    assert_int_equal(orr_scale_parse("", 0, &s), ORR_E_ARG);
}

static void civil_and_back_in_every_scale_at_random_instants(void **state)
{
    (void)state;
    const orr_time first = at(1972, 1, 1, 0, 0, 0, ORR_SCALE_UTC),
                   last = at(2250, 12, 30, 0, 0, 0, ORR_SCALE_GPS);
    for (uint64_t k = 0; k < 20000; k++) {
        orr_time t = first + (orr_time)(orr_rng_u64(1, 0, k) % (uint64_t)(last - first));
        for (orr_scale s = ORR_SCALE_GPS; s <= ORR_SCALE_IRN; s++) {
            orr_civil c;
            orr_time back;
            orr_time_to_civil(t, s, NULL, &c);
            assert_int_equal(orr_time_from_civil(&c, s, NULL, &back), ORR_OK);
            assert_int_equal(back, t);
        }
    }
}

// ---- leap seconds ----

static void every_leap_second_is_an_instant_of_its_own(void **state)
{
    (void)state;
    const orr_leap_table *leap = orr_leap_builtin();
    assert_int_equal(leap->n, 28); // 27 leap seconds since the start at 10 s
    for (size_t i = 0; i < leap->n; i++) {
        int y, m, d, y0, m0, d0;
        orr_date_from_mjd(leap->entry[i].mjd, &y, &m, &d);
        assert_true((m == 1 || m == 7) && d == 1);
        orr_time midnight = at(y, m, d, 0, 0, 0, ORR_SCALE_UTC);
        assert_int_equal(orr_leap_tai_minus_utc(midnight, NULL), leap->entry[i].tai_minus_utc_s);
        assert_civil(midnight, ORR_SCALE_UTC, y, m, d, 0, 0, 0);
        if (i == 0) continue;
        assert_int_equal(leap->entry[i].tai_minus_utc_s, leap->entry[i - 1].tai_minus_utc_s + 1);
        orr_date_from_mjd(leap->entry[i].mjd - 1, &y0, &m0, &d0);
        orr_time second60 = at(y0, m0, d0, 23, 59, 60, ORR_SCALE_UTC),
                 second59 = at(y0, m0, d0, 23, 59, 59, ORR_SCALE_UTC);
        assert_int_equal(midnight - second60, ORR_NS_PER_S);
        assert_int_equal(second60 - second59, ORR_NS_PER_S);
        assert_civil(second60, ORR_SCALE_UTC, y0, m0, d0, 23, 59, 60);
        assert_civil(midnight - 1, ORR_SCALE_GLO, y0, m0, d0, 23, 59, 60);
        assert_int_equal(orr_leap_tai_minus_utc(midnight - 1, NULL), leap->entry[i - 1].tai_minus_utc_s);
        // 24:00:00 is the next day's midnight, after the leap second
        assert_int_equal(at(y0, m0, d0, 24, 0, 0, ORR_SCALE_UTC), midnight);
    }
    orr_time t;
    assert_int_equal(orr_time_from_civil(&(orr_civil){2016, 12, 31, 23, 59, 60, 0}, ORR_SCALE_UTC, NULL, &t),
                     ORR_OK);
    assert_int_equal(t, at(2017, 1, 1, 0, 0, 17, ORR_SCALE_GPS)); // GPS - UTC was still 17 s
    assert_int_equal(orr_time_from_civil(&(orr_civil){2017, 12, 31, 23, 59, 60, 0}, ORR_SCALE_UTC, NULL, &t),
                     ORR_E_ARG);
    assert_int_equal(orr_time_from_civil(&(orr_civil){2016, 12, 31, 22, 59, 60, 0}, ORR_SCALE_UTC, NULL, &t),
                     ORR_E_ARG);
}

static void before_1972_utc_is_refused_and_the_table_expires(void **state)
{
    (void)state;
    orr_time t;
    orr_civil c = {1971, 12, 31, 23, 59, 59, 0};
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_UTC, NULL, &t), ORR_E_RANGE);
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_TAI, NULL, &t), ORR_OK);
    assert_int_equal(orr_leap_tai_minus_utc(t, NULL), 10); // the first entry is held
    assert_civil(t, ORR_SCALE_UTC, 1971, 12, 31, 23, 59, 49);
    assert_false(orr_leap_expired(at(2026, 12, 27, 23, 59, 59, ORR_SCALE_UTC), NULL));
    assert_true(orr_leap_expired(at(2026, 12, 28, 0, 0, 0, ORR_SCALE_UTC), NULL));
}

// A made table with a negative leap second at the end of 2030-06-30: that day has no 23:59:59.
static void a_negative_leap_second(void **state)
{
    (void)state;
    const orr_leap_entry entry[] = {{57754, 37}, {orr_mjd_from_date(2030, 7, 1), 36}};
    const orr_leap_table leap = {2, entry, 70000};
    orr_time a, b;
    orr_civil c = {2030, 6, 30, 23, 59, 59, 0};
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_UTC, &leap, &a), ORR_E_ARG);
    c.second = 58;
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_UTC, &leap, &a), ORR_OK);
    c = (orr_civil){2030, 7, 1, 0, 0, 0, 0};
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_UTC, &leap, &b), ORR_OK);
    assert_int_equal(b - a, ORR_NS_PER_S);
    orr_time_to_civil(b - 1, ORR_SCALE_UTC, &leap, &c);
    assert_true(c.hour == 23 && c.minute == 59 && c.second == 58 && c.ns == 999999999);
    orr_time_to_civil(b, ORR_SCALE_UTC, &leap, &c);
    assert_true(c.month == 7 && c.day == 1 && c.second == 0);
}

static orr_status read_text(const char *text, orr_leap_table *t, orr_diag *d)
{
    char path[] = "leap-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    FILE *f = fdopen(fd, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    orr_status s = orr_leap_read(path, t, d);
    remove(path);
    return s;
}

// Without a file the table is the system's or the built-in one, whichever is certain for longer; an instant beyond it is
// warned of, and one within it is not.
static void the_longer_table_is_chosen(void **state)
{
    (void)state;
    orr_leap_table t;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_leap_choose(NULL, &t, &d), d);
    assert_true(t.expires_mjd >= orr_leap_builtin()->expires_mjd);
    orr_leap_free(&t);
    assert_int_equal(orr_leap_choose("no such file", &t, &d), ORR_E_IO);
    const orr_leap_table *const leap = orr_leap_builtin();
    const orr_time end = orr_time_from_mjd(leap->expires_mjd, 0, ORR_SCALE_UTC, leap);
    orr_leap_warn(ORR_TIME_NONE, leap, "made", &w);
    orr_leap_warn(end - 1, leap, "made", &w);
    assert_int_equal(w.count, 0);
    orr_leap_warn(end, NULL, "made", &w);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "--leap-seconds"));
    assert_string_equal(w.item[0].file, "made");
    orr_warnings_free(&w);
}

static void leap_seconds_list_is_read(void **state)
{
    (void)state;
    orr_leap_table t;
    orr_diag d = {0};
    ASSERT_OK(
        read_text(
            "#\tleap seconds\n#$\t3960835200\n#@\t4007404800\n\n2272060800      10      # 1 Jan 1972\r\n"
            "2287785600 11 # 1 Jul 1972\n2303683200\t12\n#h 1 2 3",
            &t, &d),
        d);
    assert_int_equal(t.n, 3);
    assert_int_equal(t.entry[0].mjd, 41317);
    assert_int_equal(t.entry[1].mjd, 41499);
    assert_int_equal(t.entry[2].tai_minus_utc_s, 12);
    assert_int_equal(t.expires_mjd, orr_mjd_from_date(2026, 12, 28));
    orr_leap_free(&t);

    const struct {
        const char *text;
        orr_status expected;
    } bad[] = {
        {"", ORR_E_KIND},
        {"#@ 4007318400\n", ORR_E_KIND},
        {"2272060800 10\n", ORR_E_FORMAT}, // no expiry
        {"#@ x\n2272060800 10\n", ORR_E_FORMAT},
        {"#@ 4007318400\nhello\n", ORR_E_FORMAT},
        {"#@ 4007318400\n2272060801 10\n", ORR_E_FORMAT}, // not midnight
        {"#@ 4007318400\n-86400 10\n", ORR_E_FORMAT},
        {"#@ 4007318400\n99999999999999999999 10\n", ORR_E_FORMAT},
        {"#@ 4007318400\n2272060800 10 11\n", ORR_E_FORMAT},
        {"#@ 4007318400\n2287785600 11\n2272060800 10\n", ORR_E_FORMAT}, // going back
        {"#@ 4007318400\n2272060800 10\n2287785600 13\n", ORR_E_FORMAT}, // two at once
        {"#@ 4007318400\n2272060800 -5\n", ORR_E_FORMAT},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        d = (orr_diag){0};
        if (read_text(bad[i].text, &t, &d) != bad[i].expected) fail_msg("case %zu: %s", i, d.text);
        assert_true(d.text[0] != '\0' && t.entry == NULL);
    }
    char *junk = malloc(5000);
    assert_non_null(junk);
    memset(junk, '7', 4999);
    junk[4999] = '\0';
    assert_int_equal(read_text(junk, &t, &d), ORR_E_KIND);
    free(junk);
    assert_int_equal(orr_leap_read("no/such/file", &t, &d), ORR_E_IO);
}

// ---- days and weeks ----

static void modified_julian_dates(void **state)
{
    (void)state;
    int32_t mjd;
    double f;
    orr_time_mjd(at(2000, 1, 1, 12, 0, 0, ORR_SCALE_TT), ORR_SCALE_TT, NULL, &mjd, &f);
    assert_int_equal(mjd, 51544);
    assert_true(f == 0.5);
    // ns_of_day / 86400e9 and back: a fraction's last bit is worth 0.01 ns
    for (uint64_t k = 0; k < 20000; k++) {
        orr_time t =
            (orr_time)(orr_rng_u64(2, 0, k) % UINT64_C(4000000000000000000)) - INT64_C(200000000000000000);
        for (orr_scale s = ORR_SCALE_GPS; s <= ORR_SCALE_BDT; s++) {
            orr_time_mjd(t, s, NULL, &mjd, &f);
            assert_true(f >= 0 && f < 1);
            assert_int_equal(orr_time_from_mjd(mjd, f, s, NULL), t);
        }
    }
    // in a leap second the day's end is held
    orr_time_mjd(at(2016, 12, 31, 23, 59, 60, ORR_SCALE_UTC), ORR_SCALE_UTC, NULL, &mjd, &f);
    assert_int_equal(mjd, 57753);
    assert_true(f < 1 && f > 1 - 1e-15);
}

static void weeks_and_their_rollovers(void **state)
{
    (void)state;
    int32_t week;
    int64_t ns;
    const struct {
        int y, m, d, week;
    } cases[] = {
        {1980, 1, 6, 0},      {1999, 8, 22, 1024}, {2019, 4, 7, 2048},
        {2038, 11, 21, 3072}, {2024, 2, 4, 2300},  {2137, 1, 6, 8192}, // 13 bits of CNAV
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_time t = at(cases[i].y, cases[i].m, cases[i].d, 0, 0, 0, ORR_SCALE_GPS);
        orr_time_week(t, &week, &ns);
        assert_int_equal(week, cases[i].week);
        assert_int_equal(ns, 0);
        orr_time_week(t - 1, &week, &ns);
        assert_int_equal(week, cases[i].week - 1);
        assert_int_equal(ns, INT64_C(604800000000000) - 1);
        assert_int_equal(orr_time_from_week(week, ns), t - 1);
    }
}

static void adding_seconds(void **state)
{
    (void)state;
    orr_time t = at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GPS);
    assert_int_equal(orr_time_add_s(t, 0.1) - t, 100000000);
    assert_int_equal(orr_time_add_s(t, -0.1) - t, -100000000);
    assert_int_equal(orr_time_add_s(0, 8.9e9), INT64_C(8900000000000000000));
    assert_int_equal(orr_time_add_s(t, 8.9e9), INT64_MAX);
    assert_int_equal(orr_time_add_s(t, -1e300), -INT64_MAX);
    assert_int_equal(orr_time_add_s(t, HUGE_VAL), INT64_MAX);
    assert_int_not_equal(orr_time_add_s(t, ORR_NAN), ORR_TIME_NONE);
    assert_int_equal(orr_time_add_s(t, -1e-9) - t, -1);
    for (uint64_t k = 0; k < 1000; k++) {
        int64_t ns = (int64_t)(orr_rng_u64(4, 0, k) % UINT64_C(8294400000000000)) -
                     INT64_C(4147200000000000); // 48 days
        assert_int_equal(orr_time_add_s(t, orr_time_diff_s(t + ns, t)), t + ns);
    }
}

// Instants, days and weeks of anyone: whatever does not fit is the end of the axis, and every way out of an
// orr_time holds at its ends (UBSan looks on).
static void nothing_overflows_at_the_ends_of_the_axis(void **state)
{
    (void)state;
    const orr_time end[] = {INT64_MIN, -INT64_MAX, -1, 0, 1, INT64_MAX};
    char text[ORR_TIME_TEXT];
    for (size_t i = 0; i < sizeof end / sizeof end[0]; i++) {
        for (size_t k = 0; k < sizeof end / sizeof end[0]; k++) {
            long double exact = (long double)end[i] - (long double)end[k], sum = (long double)end[i] + end[k];
            long double most = (long double)INT64_MAX;
            int64_t difference = orr_time_sub_ns(end[i], end[k]);
            assert_true((long double)difference == fminl(fmaxl(exact, -most), most));
            assert_true((long double)orr_time_add(end[i], end[k]) == fminl(fmaxl(sum, -most), most));
            assert_true(orr_time_diff_s(end[i], end[k]) == (double)difference / 1e9);
        }
        for (orr_scale s = ORR_SCALE_GPS; s <= ORR_SCALE_IRN; s++) {
            orr_civil c;
            int32_t mjd, week;
            double fraction;
            int64_t ns;
            orr_time_to_civil(end[i], s, NULL, &c);
            assert_true(c.year >= 1687 && c.year <= 2272 && c.ns >= 0);
            orr_time_mjd(end[i], s, NULL, &mjd, &fraction);
            assert_true(fraction >= 0 && fraction < 1);
            orr_time_week(end[i], &week, &ns);
            assert_true(ns >= 0 && ns < INT64_C(604800000000000));
            for (int d = 0; d <= 9; d++) assert_non_null(orr_time_format(end[i], s, d, NULL, text));
        }
        assert_non_null(orr_time_text(end[i], text));
        (void)orr_leap_expired(end[i], NULL);
    }
    assert_int_equal(orr_time_from_week(INT32_MAX, 0), INT64_MAX);
    assert_int_equal(orr_time_from_week(15250, INT64_MAX), INT64_MAX);
    assert_int_equal(orr_time_from_mjd(INT32_MAX, 0.5, ORR_SCALE_UTC, NULL), INT64_MAX);
    assert_int_equal(orr_time_from_mjd(44244 + 106752, 0.99, ORR_SCALE_TT, NULL), INT64_MAX);
    assert_int_equal(orr_time_from_week(INT32_MIN, 0), -INT64_MAX);
    assert_int_equal(orr_time_from_week(-15250, -INT64_MAX), -INT64_MAX);
    assert_int_equal(orr_time_from_mjd(INT32_MIN, 0.5, ORR_SCALE_UTC, NULL), -INT64_MAX);
    assert_int_equal(orr_time_from_mjd(44244 - 106753, 0.01, ORR_SCALE_TT, NULL), -INT64_MAX);
    assert_int_equal(orr_time_from_mjd(44244, ORR_NAN, ORR_SCALE_GPS, NULL), INT64_MAX);
    assert_int_equal(orr_time_from_mjd(44245, 0.25, ORR_SCALE_GPS, NULL), INT64_C(108000000000000));
}

static void whole_seconds_are_whole(void **state)
{
    (void)state;
    for (int64_t s = -100000; s <= 100000; s++)
        assert_true(orr_time_diff_s(5 + s * ORR_NS_PER_S, 5) == (double)s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_overflows_at_the_ends_of_the_axis),
        cmocka_unit_test(whole_seconds_are_whole),
        cmocka_unit_test(days_of_the_textbooks),
        cmocka_unit_test(every_day_follows_the_one_before),
        cmocka_unit_test(fields_out_of_bounds_are_refused),
        cmocka_unit_test(scales_at_their_published_offsets),
        cmocka_unit_test(civil_and_back_in_every_scale_at_random_instants),
        cmocka_unit_test(every_leap_second_is_an_instant_of_its_own),
        cmocka_unit_test(before_1972_utc_is_refused_and_the_table_expires),
        cmocka_unit_test(a_negative_leap_second),
        cmocka_unit_test(leap_seconds_list_is_read),
        cmocka_unit_test(the_longer_table_is_chosen),
        cmocka_unit_test(modified_julian_dates),
        cmocka_unit_test(weeks_and_their_rollovers),
        cmocka_unit_test(adding_seconds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
