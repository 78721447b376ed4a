// SPDX-License-Identifier: GPL-3.0-or-later
// The frames that are made of sets: the same for every instant that they hold, one after the other without a seam, with the weeks and
// leap seconds of their day.
#include "testing.h"

#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/navframe.h"
#include "orbit/navdata/navset_private.h"
#include "unit/orbit/navset_made.h"

// Bits first..first + n - 1 of a subframe, all of one word, as a receiver has them: turned back by D30*.
static unsigned received(const orr_navframe_piece *p, int first, int n)
{
#define BIT(k) (p->data[((k)-1) / 8] >> (7 - ((k)-1) % 8) & 1u)
    const int word = (first - 1) / 30;
    const unsigned turned = word > 0 ? BIT(30 * word) : 0;
    unsigned value = 0;
    for (int k = first; k < first + n; k++) value = value << 1 | (BIT(k) ^ turned);
    return value;
#undef BIT
}

// IS-GPS-200N 20.3.3.5.2.4: what a receiver makes of page 18, from eight bits of WN_LSF. Leap seconds since
// 1980 as bulletins C tell them.
static void receivers_have_the_leap_seconds_of_their_day(void **state)
{
    (void)state;
    static const struct {
        const char *from;
        int now, future; // the future one has been announced, or is past
    } day[] = {
        {"2009-04-01T00:00:00", 15, 15}, // the next one is 170 weeks ahead, which eight bits cannot tell
        {"2011-08-28T00:00:00", 15, 15}, // nobody knew of 2012's before January
        {"2012-06-27T00:00:00", 15, 16}, {"2016-09-01T00:00:00", 17, 18}, {"2024-02-04T00:00:00", 18, 18},
    };
    for (size_t i = 0; i < sizeof day / sizeof day[0]; i++) {
        orr_ephemeris *e = product(day[i].from, 3, nothing);
        orr_navset_options o = orr_navset_defaults();
        orr_navset *set = build(e, &o);
        int32_t week;
        int64_t ns;
        orr_time_week(when(day[i].from), &week, &ns);
        orr_time t =
            orr_time_from_week(week, ns - ns % (750 * ORR_NS_PER_S) + (750 + 17 * 30) * ORR_NS_PER_S);
        orr_navframe f;
        orr_diag d = {0};
        ASSERT_OK(orr_navframe_at(set, set->sat[0], NULL, t, false, &f, &d), d);
        const orr_navframe_piece *page = &f.piece[3];
        assert_int_equal(page->page, 18);
        assert_int_equal(received(page, 241, 8), day[i].now);
        assert_int_equal(received(page, 271, 8), day[i].future);
        if (day[i].now != day[i].future) { // then WN_LSF has to be told from eight bits, and lies ahead
            const int ahead = (int8_t)(received(page, 249, 8) - (unsigned)week);
            assert_in_range(ahead, 0, 26);
        }
        orr_navset_free(set);
        orr_ephemeris_free(e);
    }
}

// The built-in table and one that tells of a leap second at the end of 2026, as a file of 2026-07 might.
static orr_leap_table of_2027(orr_leap_entry entry[64])
{
    const orr_leap_table *known = orr_leap_builtin();
    memcpy(entry, known->entry, known->n * sizeof *entry);
    entry[known->n] = (orr_leap_entry){61406, 38}; // 2027-01-01
    return (orr_leap_table){.n = known->n + 1, .entry = entry, .expires_mjd = 61583};
}

// One table a run: page 18, GLONASS' frames and half hours, its N_T and KP, and the header of a navigation file.
static void the_table_of_the_run_is_that_of_the_messages(void **state)
{
    (void)state;
    orr_leap_entry entry[64];
    const orr_leap_table table = of_2027(entry);
    orr_ephemeris *e = product("2026-12-31T22:30:00", 3, nothing);
    orr_navset_options o = orr_navset_defaults();
    o.leap = &table;
    orr_navset *set = build(e, &o);
    int32_t week;
    int64_t ns;
    orr_time_week(set->from, &week, &ns);
    orr_navframe f;
    orr_diag d = {0};
    ASSERT_OK(orr_navframe_at(
                  set, set->sat[0], NULL,
                  orr_time_from_week(week, ns - ns % (750 * ORR_NS_PER_S) + (750 + 17 * 30) * ORR_NS_PER_S),
                  false, &f, &d),
              d);
    assert_int_equal(f.piece[3].page, 18);
    assert_int_equal(received(&f.piece[3], 241, 8), 18);
    assert_int_equal(received(&f.piece[3], 271, 8), 19);
    // 23:59:60 is in the frame that begins at 23:59:30, and the next half hour begins behind it.
    orr_time last;
    ASSERT_OK(orr_time_parse("2026-12-31T23:59:60Z", &table, &last, &d), d);
    const orr_sat sat = orr_sat_parse("R01");
    ASSERT_OK(orr_navframe_at(set, sat, NULL, last, false, &f, &d), d);
    assert_true(f.to - f.from == 31 * ORR_NS_PER_S && f.to == last + ORR_NS_PER_S);
    assert_true(orr_navset_at(set, sat, ORR_NAV_NONE, last)->to == last + ORR_NS_PER_S);
    int n4, nt, before;
    ASSERT_OK(orr_glonass_calendar(last, &table, &n4, &before, &d), d);
    ASSERT_OK(orr_glonass_calendar(last + ORR_NS_PER_S, &table, &n4, &nt, &d), d);
    assert_int_equal(before, nt); // the day in Moscow began three hours before
    assert_true(orr_glonass_day(last, &table) == last - 10800 * ORR_NS_PER_S);
    orr_nav records;
    ASSERT_OK(orr_navset_records(set, &records, &d), d);
    assert_int_equal(records.leap_s, 18);
    assert_true(records.leap == &table);
    // All systems keep one time: an offset of zero to UTC and, but for GPS itself, to GPS time, for each system that sends.
    const orr_sat *list;
    const size_t sats = orr_navset_satellites(set, &list);
    size_t expected = 0;
    for (size_t i = 0; i < sats; i++)
        if (i == 0 || orr_sat_system(list[i]) != orr_sat_system(list[i - 1]))
            expected += orr_sat_system(list[i]) == 'G' ? 1 : 2;
    assert_int_equal(records.n_sto, expected);
    for (size_t k = 0; k < records.n_sto; k++) {
        assert_true(strcmp(records.sto[k].code + 2, "UT") == 0 || strcmp(records.sto[k].code + 2, "GP") == 0);
        ASSERT_NEAR(records.sto[k].a0_s, 0, 0);
        ASSERT_NEAR(records.sto[k].a1_sps, 0, 0);
    }
    orr_nav_free(&records);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

static void same_frame(const orr_navframe *a, const orr_navframe *b)
{
    assert_true(a->from == b->from && a->to == b->to && a->n == b->n && a->stream == b->stream);
    for (int k = 0; k < a->n; k++) {
        assert_true(a->piece[k].t == b->piece[k].t && a->piece[k].number == b->piece[k].number &&
                    a->piece[k].page == b->piece[k].page && a->piece[k].bits == b->piece[k].bits);
        assert_memory_equal(a->piece[k].data, b->piece[k].data, ORR_NAVFRAME_BYTES);
    }
}

static int seconds_of(const orr_nav_stream *stream)
{
    switch (stream->message) {
    case ORR_NAV_FNAV:
        return 50;
    case ORR_NAV_CNAV:
        return stream->signals[1] == '2' ? 48 : 24;
    case ORR_NAV_CNV2:
        return 18;
    default:
        return 30;
    }
}

static void check_frames(const orr_navset *set, orr_sat sat, const orr_nav_stream *stream, bool coded,
                         orr_time from, orr_time to)
{
    static orr_navframe frame, again;
    orr_diag d = {0};
    size_t frames = 0, long_ones = 0;
    for (orr_time t = from; t <= to; t = frame.to, frames++) {
        const orr_time expected = t;
        ASSERT_OK(orr_navframe_at(set, sat, stream, t, coded, &frame, &d), d);
        if (frames > 0) assert_int_equal(frame.from, expected);
        assert_true(frame.from <= t && t < frame.to);
        const int64_t length = (frame.to - frame.from) / ORR_NS_PER_S;
        long_ones += length == 31;
        assert_int_equal(length, length == 31 && stream->message == ORR_NAV_FDMA ? 31 : seconds_of(stream));
        if (frame.to - 1 <= to) {
            ASSERT_OK(orr_navframe_at(set, sat, stream, frame.to - 1, coded, &again, &d), d);
            same_frame(&frame, &again);
        }
        orr_time next = frame.from;
        for (int k = 0; k < frame.n; k++) {
            const orr_navframe_piece *p = &frame.piece[k];
            assert_int_equal(p->t, next);
            next += p->length;
            if (stream->message == ORR_NAV_FDMA && !coded) next += 3 * ORR_NS_PER_S / 10; // the time mark
            if (stream->message == ORR_NAV_LNAV || stream->message == ORR_NAV_FDMA)
                assert_int_equal(p->number, k + 1);
        }
        if (length != 31) assert_int_equal(next, frame.to);
    }
    if (!coded) assert_int_equal(long_ones, stream->message == ORR_NAV_FDMA ? 1 : 0);
    if (!coded)
        assert_int_equal(orr_navframe_at(set, sat, stream, to + 120 * ORR_NS_PER_S, coded, &frame, &d),
                         ORR_E_NODATA);
}

// Frame after frame without a seam, the same from its first to its last nanosecond; GLONASS' frame with
// 23:59:60 is 31 s.
static void frames_follow_one_another(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2016-12-31T21:00:00", 6, nothing);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat), streams = 0;
    for (size_t i = 0; i < n; i++) {
        const orr_nav_stream *list[ORR_NAVSET_STREAMS];
        const size_t m = orr_navset_streams(set, sat[i], list);
        for (size_t k = 0; k < m; k++, streams++) {
            check_frames(set, sat[i], list[k], false, from, to);
            check_frames(set, sat[i], list[k], true, from, from + (to - from) / 8);
        }
    }
    assert_int_equal(streams, 4 * N_GPS + N_GLONASS + 3);
    assert_int_equal(orr_navframe_at(set, orr_sat_parse("E15"), NULL, from, false, &(orr_navframe){0}, NULL),
                     ORR_E_NODATA);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// IS-GPS-200N 20.3.3.3.1.1: the current week, which a receiver takes its date from; toe may be the next
// week's.
static void the_week_is_that_of_the_frame(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-03T21:00:00", 5, nothing);
    for (int hours = 2; hours <= 4; hours += 2) {
        orr_navset_options o = orr_navset_defaults();
        o.window_s = hours * 3600.0;
        orr_navset *set = build(e, &o);
        for (int k = -240; k < 120; k++) { // from two hours before the end of week 2299 on
            const orr_time t = orr_time_from_week(2300, 0) + k * 30 * ORR_NS_PER_S;
            orr_navframe f;
            orr_diag d = {0};
            ASSERT_OK(orr_navframe_at(set, set->sat[0], NULL, t, false, &f, &d), d);
            assert_int_equal(received(&f.piece[0], 61, 10), (k < 0 ? 2299 : 2300) % 1024);
        }
        orr_navset_free(set);
    }
    orr_ephemeris_free(e);
}

// Page 1 opens the week (IS-GPS-200N 20.3.4.1), and 25 frames later it returns.
static void pages_count_from_the_begin_of_the_week(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-03T22:00:00", 4, nothing);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    const orr_time week = orr_time_from_week(2300, 0);
    for (int k = -30; k < 60; k++) {
        orr_navframe f;
        orr_diag d = {0};
        ASSERT_OK(orr_navframe_at(set, set->sat[0], NULL, week + k * 30 * ORR_NS_PER_S, false, &f, &d), d);
        // 20160 frames a week leave 10 over a multiple of 25: the last page of a week is 10.
        assert_int_equal(f.piece[3].page, k >= 0 ? k % 25 + 1 : (20160 + k) % 25 + 1);
        assert_int_equal(f.piece[0].page, 0);
    }
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// Klobuchar's coefficients in the file that the sets make; false, and zeros, where it has none.
static bool klobuchar_of(const orr_navset *set, double alpha[4], double beta[4])
{
    orr_nav nav;
    orr_diag d = {0};
    ASSERT_OK(orr_navset_records(set, &nav, &d), d);
    memset(alpha, 0, 4 * sizeof *alpha);
    memset(beta, 0, 4 * sizeof *beta);
    bool found = false;
    for (size_t i = 0; i < nav.n_iono && !found; i++) {
        if (nav.iono[i].kind != ORR_NAV_KLOBUCHAR) continue;
        memcpy(alpha, &nav.iono[i].coefficient[0], 4 * sizeof *alpha);
        memcpy(beta, &nav.iono[i].coefficient[4], 4 * sizeof *beta);
        found = true;
    }
    orr_nav_free(&nav);
    return found;
}

// Coefficients that eight bits cannot hold, or that are not known, cost one warning with their name, not the
// frames: page 18 then has zeros, as without any. Those of a later record that fit are taken.
static void coefficients_that_do_not_fit_are_not_sent(void **state)
{
    (void)state;
    static const char *const name[8] = {"alpha0", "alpha1", "alpha2", "alpha3",
                                        "beta0",  "beta1",  "beta2",  "beta3"};
    static const int power[8] = {-30, -27, -24, -24, 11, 14, 16, 16};
    orr_ephemeris *e = product("2024-02-04T00:00:00", 4, nothing);
    orr_navset *none = build(e, &(orr_navset_options){.window_s = 7200, .jobs = 1}), *set;
    orr_time t = orr_time_from_week(2300, 17 * 30 * ORR_NS_PER_S); // page 18
    orr_navframe want, got;
    orr_diag d = {0};
    double alpha[4], beta[4];
    ASSERT_OK(orr_navframe_at(none, none->sat[0], NULL, t, false, &want, &d), d);
    for (int k = 0; k < 8; k++) {
        for (int how = 0; how < 4; how++) { // too large, not known, the largest, the smallest
            orr_nav_iono both[2] = {{.kind = ORR_NAV_KLOBUCHAR, .system = 'G'}};
            for (int i = 0; i < 8; i++) both[0].coefficient[i] = ldexp(i - 3, power[i]);
            both[1] = both[0];
            both[0].coefficient[k] =
                how == 1 ? (double)NAN : ldexp(how == 3 ? -128 : 128 - how / 2, power[k]);
            for (size_t n = 1; n <= 2; n++) {
                const orr_nav nav = {.iono = both, .n_iono = n};
                orr_warnings w = {0};
                orr_navset_options o = orr_navset_defaults();
                o.nav = &nav;
                ASSERT_OK(orr_navset_build(e, &o, &set, &w, &d), d);
                const bool fits = how >= 2, sent = fits || n == 2;
                assert_int_equal(klobuchar_of(set, alpha, beta), sent);
                const double value = k < 4 ? alpha[k] : beta[k - 4];
                assert_true(value == (sent ? both[fits ? 0 : 1].coefficient[k] : 0));
                assert_int_equal(w.count, fits ? 0 : 1);
                if (!fits) assert_non_null(strstr(w.item[0].text, name[k]));
                ASSERT_OK(orr_navframe_at(set, set->sat[0], NULL, t, false, &got, &d), d);
                assert_int_equal(got.piece[3].page, 18);
                if (!sent) same_frame(&got, &want);
                orr_navset_free(set);
                orr_warnings_free(&w);
            }
        }
    }
    orr_navset_free(none);
    orr_ephemeris_free(e);
}

// GPS week 2048 begins within the product: the week of subframe 1 goes from 1023 to 0, that of the almanacs from 255 to 0, each with
// a toa of its own week, nearest to the instant of all that the eight bits allow.
static void almanac_weeks_roll_over(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2019-04-06T12:00:00", 22, nothing);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    const orr_time begin = orr_time_from_week(2048, 0), noon = 43200 * ORR_NS_PER_S;
    for (int k = -1; k <= 1; k += 2) { // page 25 in the quarter of an hour before and after
        const orr_time t = begin + (k < 0 ? -1 : 24) * 30 * ORR_NS_PER_S;
        orr_navframe f;
        orr_diag d = {0};
        // The last frame of a week has page (20159 mod 25) + 1 = 10; page 25 comes 10 frames before it.
        const orr_time of_25 = k < 0 ? t - 10 * 30 * ORR_NS_PER_S : t;
        ASSERT_OK(orr_navframe_at(set, set->sat[0], NULL, of_25, false, &f, &d), d);
        assert_int_equal(f.piece[4].page, 25);
        assert_int_equal(received(&f.piece[0], 61, 10), k < 0 ? 1023 : 0);
        const int32_t toa_s = (int32_t)received(&f.piece[4], 69, 8) * 4096,
                      week = (int32_t)received(&f.piece[4], 77, 8);
        assert_int_equal(week, k < 0 ? 255 : 0);
        const orr_time toa = orr_time_from_week(2048 - 256 + (week == 0 ? 256 : week), toa_s * ORR_NS_PER_S);
        assert_true(llabs(toa - (k < 0 ? begin - noon : begin + noon)) <= 2048 * ORR_NS_PER_S);
    }
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(receivers_have_the_leap_seconds_of_their_day),
        cmocka_unit_test(the_table_of_the_run_is_that_of_the_messages),
        cmocka_unit_test(frames_follow_one_another),
        cmocka_unit_test(the_week_is_that_of_the_frame),
        cmocka_unit_test(almanac_weeks_roll_over),
        cmocka_unit_test(pages_count_from_the_begin_of_the_week),
        cmocka_unit_test(coefficients_that_do_not_fit_are_not_sent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
