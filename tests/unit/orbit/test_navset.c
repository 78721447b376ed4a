// SPDX-License-Identifier: GPL-3.0-or-later
// Which set is on the air when: schedules over week ends and leap seconds, ends of a product, satellites
// without clocks, manoeuvres; and frames that are the same for every instant that they hold.
#include "testing.h"

#include "orbit/navframe.h"
#include "orbit/navset_impl.h"
#include "unit/orbit/made_orbit.h"

static orr_time when(const char *text)
{
    orr_time t;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}

static void shift(orr_orbit_solution *s, int64_t ns)
{
    s->from += ns;
    s->to += ns;
    for (size_t i = 0; i < s->n_sats; i++) {
        orr_orbit_sat *sat = &s->sat[i];
        for (size_t k = 0; k < sat->n_arcs; k++) sat->arc[k].t0 += ns;
        for (size_t k = 0; k < sat->n_clocks; k++) sat->clock[k].t += ns;
        for (size_t k = 0; k < sat->n_nodes; k++) sat->node[k].t += ns;
        for (size_t k = 0; k < sat->n_events; k++) sat->event[k].t0 += ns, sat->event[k].t1 += ns;
    }
}

// A made product of so many hours that begins at `from`; without the made manoeuvres.
static orr_ephemeris *product(const char *from, double hours, bool manoeuvres)
{
    orr_orbit_solution s = made_solution(9, hours, 900, 6);
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    shift(&s, when(from) - made_midnight);
    for (size_t i = 0; i < s.n_sats && !manoeuvres; i++)
        for (size_t k = 0; k < s.sat[i].n_events; k++)
            if (s.sat[i].event[k].kind == ORR_EVENT_MANOEUVRE) s.sat[i].event[k].kind = ORR_EVENT_GAP;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    made_solution_free(&s);
    return e;
}

static orr_navset *build(const orr_ephemeris *e, const orr_navset_options *o)
{
    orr_navset *set = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_navset_build(e, o, &set, NULL, &d), d);
    return set;
}

// IS-GPS-200N 20.3.4.4: no IODC again within seven days, IODE the lower part and below 240 for fit intervals
// of four hours.
static void issues_do_not_repeat_for_weeks(void **state)
{
    (void)state;
    navset_schedule s;
    orr_time from = when("2024-02-01T00:00:00");
    assert_int_equal(navset_schedule_gps(from, from + 79 * 86400 * ORR_NS_PER_S, 7200, &s), ORR_OK);
    bool seen[1024] = {false};
    for (size_t k = 0; k < s.n; k++) {
        assert_true(s.slot[k].iodc >= 0 && s.slot[k].iodc < 1024 && s.slot[k].iodc % 256 < 240);
        assert_false(seen[s.slot[k].iodc]);
        seen[s.slot[k].iodc] = true;
        assert_int_equal(s.slot[k].reference % (7200 * ORR_NS_PER_S), 0);
        if (k > 0) assert_int_equal(s.slot[k].from, s.slot[k - 1].to);
    }
    assert_true(s.slot[0].from <= from && s.slot[0].to > from);
    free(s.slot);
}

static void glonass_half_hours_are_those_of_utc(void **state)
{
    (void)state;
    navset_schedule s;
    orr_time from = when("2016-12-31T20:00:00"), to = when("2017-01-01T03:00:00");
    assert_int_equal(navset_schedule_glonass(from, to, &s), ORR_OK);
    size_t longer = 0;
    for (size_t k = 0; k < s.n; k++) {
        orr_civil c;
        orr_time_to_civil(s.slot[k].reference, ORR_SCALE_UTC, NULL, &c);
        assert_true((c.minute == 15 || c.minute == 45) && c.second == 0 && c.ns == 0);
        if (k > 0) assert_int_equal(s.slot[k].from, s.slot[k - 1].to);
        int64_t length = s.slot[k].to - s.slot[k].from;
        longer += length == 1801 * ORR_NS_PER_S; // the half hour that ends with 23:59:60
        assert_true(length == 1800 * ORR_NS_PER_S || length == 1801 * ORR_NS_PER_S);
    }
    assert_int_equal(longer, 1);
    assert_true(s.slot[0].from <= from && s.slot[s.n - 1].to > to);
    free(s.slot);
}

// Over the whole product and at both its ends exactly one set, none beyond.
static void every_instant_has_one_set(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-03T21:10:00", 6, false); // over the end of week 2299
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat);
    assert_int_equal(n, 6); // the Galileo satellites of the nine are not for these messages
    for (size_t i = 0; i < n; i++) {
        for (orr_time t = from; t <= to; t += 37 * ORR_NS_PER_S) {
            const orr_navset_item *item = orr_navset_at(set, sat[i], t);
            assert_non_null(item);
            assert_true(item->from <= t && t < item->to);
        }
        assert_non_null(orr_navset_at(set, sat[i], to));
        assert_null(orr_navset_at(set, sat[i], to + 1));
        assert_null(orr_navset_at(set, sat[i], from - 1));
        const orr_navset_item *list;
        size_t sets = orr_navset_items(set, sat[i], &list);
        assert_true((list[0].notes & ORR_NAVSET_SHIFTED) != 0); // begins within its window
        for (size_t k = 0; k < sets; k++) {
            assert_int_equal(list[k].eph.health, 0);
            if (orr_sat_system(sat[i]) != 'G') continue;
            // Kepler ellipses are what LNAV describes: what is left is rounding, some centimetres (the bar is
            // for orbits that are none).
            ASSERT_NEAR(list[k].report.max_m, 0, 0.15);
            int32_t week;
            int64_t ns;
            orr_time_week(list[k].eph.toe, &week, &ns);
            assert_int_equal(list[k].eph.week, week);
        }
    }
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

static void a_manoeuvre_makes_its_sets_unhealthy(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 6, true);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat), out = 0, fine = 0;
    for (size_t i = 0; i < n; i++) {
        const orr_orbit_event *event;
        const orr_navset_item *item;
        size_t events = orr_ephemeris_events(e, sat[i], &event), sets = orr_navset_items(set, sat[i], &item);
        for (size_t k = 0; k < sets; k++) {
            bool touched = false;
            for (size_t m = 0; m < events; m++)
                touched |= event[m].kind == ORR_EVENT_MANOEUVRE && event[m].t1 >= item[k].from &&
                           event[m].t0 < item[k].to;
            if (touched) assert_true(item[k].eph.health != 0 && (item[k].notes & ORR_NAVSET_MANOEUVRE));
            out += item[k].eph.health != 0;
            fine += item[k].eph.health == 0;
        }
    }
    assert_true(out >= n && fine > out);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

static void without_a_clock_nothing_is_sent_unless_asked(void **state)
{
    (void)state;
    orr_orbit_solution s = made_solution(3, 5, 900, 6);
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    size_t clocks = s.sat[0].n_clocks;
    s.sat[0].n_clocks = 0;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    s.sat[0].n_clocks = clocks;
    const orr_sat first = s.sat[0].sat;
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = NULL;
    orr_warnings w = {0};
    ASSERT_OK(orr_navset_build(e, &o, &set, &w, &d), d);
    assert_null(orr_navset_at(set, first, made_midnight));
    assert_true(w.count > 0);
    orr_warnings_free(&w);
    orr_navset_free(set);
    o.zero_clocks = true;
    set = build(e, &o);
    const orr_navset_item *item = orr_navset_at(set, first, made_midnight);
    assert_non_null(item);
    assert_true((item->notes & ORR_NAVSET_NO_CLOCK) && item->eph.af0_s == 0 && isnan(item->clock_rms_s));
    orr_navset_free(set);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static void same_frame(const orr_navframe *a, const orr_navframe *b)
{
    assert_true(a->from == b->from && a->to == b->to && a->n == b->n && a->message == b->message);
    for (int k = 0; k < a->n; k++) {
        assert_true(a->piece[k].t == b->piece[k].t && a->piece[k].number == b->piece[k].number &&
                    a->piece[k].page == b->piece[k].page && a->piece[k].bits == b->piece[k].bits);
        assert_memory_equal(a->piece[k].data, b->piece[k].data, ORR_NAVFRAME_BYTES);
    }
}

// Frame after frame without a seam, the same from its first to its last nanosecond; GLONASS' frame with
// 23:59:60 is 31 s.
static void frames_follow_one_another(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2016-12-31T21:00:00", 6, false);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat);
    for (size_t i = 0; i < n; i++) {
        orr_navframe frame, again;
        orr_diag d = {0};
        size_t frames = 0, long_ones = 0;
        for (orr_time t = from; t <= to; t = frame.to, frames++) {
            const orr_time expected = t;
            ASSERT_OK(orr_navframe_at(set, sat[i], t, &frame, &d), d);
            if (frames > 0) assert_int_equal(frame.from, expected);
            assert_true(frame.from <= t && t < frame.to);
            long_ones += frame.to - frame.from == 31 * ORR_NS_PER_S;
            assert_true(frame.to - frame.from == 30 * ORR_NS_PER_S ||
                        frame.to - frame.from == 31 * ORR_NS_PER_S);
            if (frame.to - 1 <= to) {
                ASSERT_OK(orr_navframe_at(set, sat[i], frame.to - 1, &again, &d), d);
                same_frame(&frame, &again);
            }
            for (int k = 0; k < frame.n; k++) assert_int_equal(frame.piece[k].number, k + 1);
        }
        assert_int_equal(long_ones, orr_sat_system(sat[i]) == 'R' ? 1 : 0);
        assert_int_equal(orr_navframe_at(set, sat[i], to + 60 * ORR_NS_PER_S, &frame, &d), ORR_E_NODATA);
    }
    assert_int_equal(orr_navframe_at(set, orr_sat_parse("E14"), from, &(orr_navframe){0}, NULL),
                     ORR_E_NODATA);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// Page 1 opens the week (IS-GPS-200N 20.3.4.1), and 25 frames later it returns.
static void pages_count_from_the_begin_of_the_week(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-03T22:00:00", 4, false);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    const orr_time week = orr_time_from_week(2300, 0);
    for (int k = -30; k < 60; k++) {
        orr_navframe f;
        orr_diag d = {0};
        ASSERT_OK(orr_navframe_at(set, set->sat[0], week + k * 30 * ORR_NS_PER_S, &f, &d), d);
        // 20160 frames a week leave 10 over a multiple of 25: the last page of a week is 10.
        assert_int_equal(f.piece[3].page, k >= 0 ? k % 25 + 1 : (20160 + k) % 25 + 1);
        assert_int_equal(f.piece[0].page, 0);
    }
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(issues_do_not_repeat_for_weeks),
        cmocka_unit_test(glonass_half_hours_are_those_of_utc),
        cmocka_unit_test(every_instant_has_one_set),
        cmocka_unit_test(a_manoeuvre_makes_its_sets_unhealthy),
        cmocka_unit_test(without_a_clock_nothing_is_sent_unless_asked),
        cmocka_unit_test(frames_follow_one_another),
        cmocka_unit_test(pages_count_from_the_begin_of_the_week),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
