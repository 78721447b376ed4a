// SPDX-License-Identifier: GPL-3.0-or-later
// Which set is on the air when: schedules over week ends and leap seconds, ends of a product, satellites
// without clocks, manoeuvres.
#include "testing.h"

#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/navframe.h"
#include "orbit/navdata/navset_private.h"
#include "unit/orbit/made_orbit.h"
#include "unit/orbit/navset_made.h"

// IS-GPS-200N 20.3.4.4: no IODC again within seven days after its end, and below 240 for fit intervals of four
// hours.
static void issues_do_not_repeat_for_weeks(void **state)
{
    (void)state;
    navset_schedule s;
    orr_time from = when("2024-02-01T00:00:00");
    const orr_navset_options o = orr_navset_defaults();
    assert_int_equal(navset_schedule_of(orr_sat_make('G', 1), ORR_NAV_LNAV, from,
                                        from + 79 * 86400 * ORR_NS_PER_S, &o, false, &s),
                     ORR_OK);
    orr_time last[240] = {0};
    for (size_t k = 0; k < s.n; k++) {
        const int32_t issue = (int32_t)(s.slot[k].number % 240);
        assert_in_range(issue, 0, 239); // what IODE's eight bits hold: receivers compare all of IODC with it
        if (last[issue] != 0) assert_true(s.slot[k].from - last[issue] >= 7 * 86400 * ORR_NS_PER_S);
        last[issue] = s.slot[k].to;
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
    const orr_navset_options o = orr_navset_defaults();
    assert_int_equal(navset_schedule_of(orr_sat_make('R', 1), ORR_NAV_FDMA, from, to, &o, false, &s), ORR_OK);
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
    orr_ephemeris *e = product("2024-02-03T21:10:00", 6, nothing); // over the end of week 2299
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    orr_time from, to;
    orr_ephemeris_span(e, &from, &to);
    const orr_sat *sat;
    size_t n = orr_navset_satellites(set, &sat);
    assert_int_equal(n, N_SATS);
    for (size_t i = 0; i < n; i++) {
        for (orr_time t = from; t <= to; t += 37 * ORR_NS_PER_S) {
            const orr_navset_item *item = orr_navset_at(set, sat[i], ORR_NAV_NONE, t);
            assert_non_null(item);
            assert_true(item->from <= t && t < item->to);
        }
        assert_non_null(orr_navset_at(set, sat[i], ORR_NAV_NONE, to));
        assert_null(orr_navset_at(set, sat[i], ORR_NAV_NONE, to + 1));
        assert_null(orr_navset_at(set, sat[i], ORR_NAV_NONE, from - 1));
        const orr_navset_item *list;
        size_t sets = orr_navset_items(set, sat[i], ORR_NAV_NONE, &list);
        assert_true((list[0].notes & ORR_NAVSET_SHIFTED) != 0); // begins within its window
        for (size_t k = 0; k < sets; k++) {
            assert_int_equal(list[k].eph.health, 0);
            double step_m, clock_step_s;
            if (k >
                0) { // between the instants that a set was judged at it may be off by a little more than it says
                assert_true(orr_navset_step(&list[k - 1], &list[k], &step_m, &clock_step_s));
                assert_true(step_m > 0);
                ASSERT_NEAR(step_m, 0, 1.1 * (list[k - 1].report.max_m + list[k].report.max_m) + 0.005);
                // Clocks of this product are straight lines: half an LSB each of both sets, most GLONASS', 2^-30 s and 900 s of 2^-40.
                ASSERT_NEAR(clock_step_s, 0, 1.8e-9);
            }
            if (orr_sat_system(sat[i]) != 'G') continue;
            ASSERT_NEAR(list[k].report.rms_m, 0, 0.05); // the bar of two-hour windows
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
    orr_ephemeris *e = product("2024-02-04T00:00:00", 8, (spoil){.push_s = 12900});
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    const orr_navset_item *item;
    const orr_sat pushed = orr_sat_parse("G01");
    size_t out = 0, n = orr_navset_items(set, pushed, ORR_NAV_NONE, &item);
    const orr_time burn = orr_time_add_s(when("2024-02-04T00:00:00"), 12900);
    for (size_t k = 0; k < n; k++) {
        const bool touched =
            item[k].eph.toe - 3600 * ORR_NS_PER_S <= burn && burn < item[k].eph.toe + 3600 * ORR_NS_PER_S;
        if (touched) assert_true(item[k].eph.health != 0 && (item[k].notes & ORR_NAVSET_MANOEUVRE));
        out += item[k].eph.health != 0;
        // Before and after it the orbit is as good as any: nothing is fitted across.
        if (!touched) ASSERT_NEAR(item[k].report.rms_m, 0, 0.05);
    }
    assert_in_range(
        out, 1, 2); // the burn is known to a quarter of an hour, which may touch the window before or after
    n = orr_navset_items(set, orr_sat_parse("G02"), ORR_NAV_NONE, &item);
    for (size_t k = 0; k < n; k++) assert_int_equal(item[k].eph.health, 0);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// Whom the caller marks is unhealthy in all his sets, and in the others' almanacs; nobody else is, and nothing else changes.
static void marked_satellites_are_unhealthy_and_no_others(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 5, (spoil){.push_s = -1});
    orr_sat_set marked = {0};
    const orr_sat bad = orr_sat_parse("G02");
    orr_sat_set_add(&marked, bad);
    orr_navset_options o = orr_navset_defaults();
    orr_navset *plain = build(e, &o);
    o.unhealthy = &marked;
    orr_navset *set = build(e, &o);
    const orr_sat *sat;
    const size_t n = orr_navset_satellites(set, &sat);
    size_t seen = 0;
    for (size_t i = 0; i < n; i++) {
        const orr_nav_stream *stream[ORR_NAVSET_STREAMS];
        const size_t streams = orr_navset_streams(set, sat[i], stream);
        for (size_t k = 0; k < streams; k++) {
            const orr_navset_item *a, *b;
            const orr_nav_message message = (orr_nav_message)stream[k]->message;
            const size_t sets = orr_navset_items(set, sat[i], message, &a);
            assert_int_equal(sets, orr_navset_items(plain, sat[i], message, &b));
            for (size_t j = 0; j < sets; j++) {
                assert_int_equal(b[j].eph.health, 0);
                assert_true((a[j].eph.health != 0) == (sat[i] == bad));
                assert_true(a[j].eph.toe == b[j].eph.toe && a[j].notes == b[j].notes);
                seen += sat[i] == bad;
            }
        }
    }
    assert_true(seen > 4);
    orr_navset_free(set);
    orr_navset_free(plain);
    orr_ephemeris_free(e);
}

// The set of a satellite's first message at so many seconds after the product's begin.
static orr_navset_item set_at(const orr_navset *set, const char *sat, orr_time t0, double t_s)
{
    const orr_navset_item *item =
        orr_navset_at(set, orr_sat_parse(sat), ORR_NAV_NONE, orr_time_add_s(t0, t_s));
    if (item == NULL) fail_msg("%s has no set at %g s", sat, t_s);
    return *item;
}

static void faults_change_sets_and_no_others(void **state)
{
    (void)state;
    static const char *const sats[] = {"G01", "R01", "E14"}, *const others[] = {"G02", "R02"};
    const orr_time t0 = when("2024-02-04T00:00:00");
    orr_ephemeris *e = product("2024-02-04T00:00:00", 6, (spoil){.push_s = -1});
    orr_navset_fault fault = {
        .from = orr_time_add_s(t0, 8000), .to = orr_time_add_s(t0, 12000), .displaced_m = {200, -500, 300}};
    for (size_t k = 0; k < 3; k++) orr_sat_set_add(&fault.sats, orr_sat_parse(sats[k]));
    orr_navset_options o = orr_navset_defaults();
    orr_navset *plain = build(e, &o);
    o.fault = &fault;
    o.n_faults = 1;
    for (int kind = 0; kind < 3; kind++) {
        fault.kind = (orr_navset_fault_kind)kind;
        orr_navset *set = build(e, &o);
        for (size_t k = 0; k < 2; k++) {
            const orr_navset_item a = set_at(plain, others[k], t0, 9000),
                                  b = set_at(set, others[k], t0, 9000);
            assert_memory_equal(&a.eph, &b.eph, sizeof a.eph);
            assert_int_equal(b.notes, a.notes);
        }
        for (size_t k = 0; k < 3; k++) {
            const orr_navset_item before = set_at(set, sats[k], t0, 7999),
                                  during = set_at(set, sats[k], t0, 8001),
                                  last = set_at(set, sats[k], t0, 11999),
                                  after = set_at(set, sats[k], t0, 12001),
                                  clean = set_at(plain, sats[k], t0, 8001);
            assert_true((during.notes & ORR_NAVSET_FAULTY) != 0 && (last.notes & ORR_NAVSET_FAULTY) != 0);
            assert_true((after.notes & ORR_NAVSET_FAULTY) == 0);
            assert_true((during.eph.health != 0) == (fault.kind == ORR_NAVSET_FAULT_UNHEALTHY));
            assert_int_equal(after.eph.health, 0);
            if (fault.kind == ORR_NAVSET_FAULT_STALE) {
                assert_true(last.eph.toe == before.eph.toe && after.eph.toe > before.eph.toe);
                continue;
            }
            assert_true(during.eph.toe == clean.eph.toe);
            double step_m, clock_step_s;
            const bool follows = orr_navset_step(&before, &during, &step_m, &clock_step_s);
            assert_int_equal(follows, fault.kind == ORR_NAVSET_FAULT_ORBIT);
            if (follows) ASSERT_NEAR(step_m, sqrt(200 * 200 + 500 * 500 + 300 * 300), 12); // as below
            if (sats[k][0] != 'R') assert_true(during.eph.iode != before.eph.iode);
            if (fault.kind != ORR_NAVSET_FAULT_ORBIT) continue;
            for (double t_s = 8100; t_s < 12000; t_s += 300) {
                const orr_navset_item item = set_at(set, sats[k], t0, t_s),
                                      true_one = set_at(plain, sats[k], t0, t_s);
                orr_broadcast_state b, c;
                orr_sat_state s;
                const orr_time t = orr_time_add_s(t0, t_s);
                assert_int_equal(orr_broadcast_eval(&item.eph, t, &b), ORR_OK);
                assert_int_equal(orr_broadcast_eval(&true_one.eph, t, &c), ORR_OK);
                assert_int_equal(orr_ephemeris_eval(e, orr_sat_parse(sats[k]), t, &s), ORR_OK);
                const orr_mat3 axes = orr_orbit_axes(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps));
                const orr_vec3 rac = orr_mat3_apply_t(&axes, orr_vec3_sub(b.pos_m, c.pos_m));
                // What a message cannot say of a displacement that turns with the orbit: GLONASS' within 15 minutes of tb.
                const double within = sats[k][0] == 'R' ? 12 : 6;
                ASSERT_NEAR(rac.x, 200, within);
                ASSERT_NEAR(rac.y, -500, within);
                ASSERT_NEAR(rac.z, 300, within);
            }
        }
        orr_navset_free(set);
    }
    orr_navset_free(plain);
    orr_ephemeris_free(e);
}

static void without_a_clock_nothing_is_sent_unless_asked(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 5, (spoil){.push_s = -1, .no_clock = true});
    orr_diag d = {0};
    const orr_sat first = orr_sat_parse("G01");
    orr_time noon = when("2024-02-04T02:30:00");
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = NULL;
    orr_warnings w = {0};
    ASSERT_OK(orr_navset_build(e, &o, &set, &w, &d), d);
    assert_null(orr_navset_at(set, first, ORR_NAV_NONE, noon));
    assert_true(w.count > 0);
    orr_warnings_free(&w);
    orr_navset_free(set);
    o.zero_clocks = true;
    set = build(e, &o);
    const orr_navset_item *item = orr_navset_at(set, first, ORR_NAV_NONE, noon);
    assert_non_null(item);
    assert_true((item->notes & ORR_NAVSET_NO_CLOCK) && item->eph.af0_s == 0 && isnan(item->clock_rms_s));
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// Weeks are sent modulo 1024. A product that claims more, as a damaged one may, is refused before anything is
// made for each of its slots.
static void more_weeks_than_are_counted_are_refused(void **state)
{
    (void)state;
    const orr_navset_options o = orr_navset_defaults();
    for (int more = 0; more < 2; more++) {
        orr_orbit_solution s = made_solution(2, 3, 900, 6);
        orr_ephemeris *e = NULL;
        orr_navset *set = NULL;
        orr_warnings w = {0};
        orr_diag d = {0};
        s.sat[1].arc[0].t0 += (1023 + more) * (ORR_S_PER_WEEK * ORR_NS_PER_S);
        ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
        assert_int_equal(orr_navset_build(e, &o, &set, &w, &d), more ? ORR_E_LIMIT : ORR_OK);
        if (more) assert_non_null(strstr(d.text, "1024"));
        orr_navset_free(set);
        orr_warnings_free(&w);
        orr_ephemeris_free(e);
        made_solution_free(&s);
    }
}

// Where an orbit begins or ends on a seam of slots, no set reaches beyond its slot, and none is of a slot
// that the orbit does not touch.
static void sets_stay_in_their_slots(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 10, (spoil){.push_s = -1, .after_s = 4 * 3600.0});
    const orr_time seam = when("2024-02-04T04:00:00");
    orr_navset_options o = orr_navset_defaults();
    o.window_s = 14400; // slots begin at even hours
    orr_navset *set = build(e, &o);
    const orr_navset_item *item;
    size_t n = orr_navset_items(set, orr_sat_parse("G02"), ORR_NAV_NONE, &item);
    assert_true(n > 0 && item[0].from == seam);
    for (size_t k = 0; k < n; k++) {
        assert_true(item[k].from < item[k].to && item[k].to - item[k].from <= 7200 * ORR_NS_PER_S);
        if (k > 0) assert_true(item[k].from == item[k - 1].to);
    }
    n = orr_navset_items(set, orr_sat_parse("G03"), ORR_NAV_NONE, &item);
    assert_true(n > 0 && item[n - 1].to == seam + 1); // the orbit's last instant belongs to it
    for (size_t k = 1; k < n; k++) assert_true(item[k].from == item[k - 1].to);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// A clock that its field cannot hold costs that satellite its sets, with a warning that names both; nobody
// else.
static void clocks_that_do_not_fit_are_left_out(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 5, (spoil){.push_s = -1, .fast_s = -2.5e-3});
    const orr_time t = when("2024-02-04T02:30:00");
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = NULL;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_navset_build(e, &o, &set, &w, &d), d);
    assert_null(orr_navset_at(set, orr_sat_parse("G01"), ORR_NAV_NONE, t));
    assert_null(orr_navset_at(set, orr_sat_parse("R01"), ORR_NAV_NONE, t));
    assert_int_equal(w.count, 4); // LNAV, CNAV and CNAV-2 of G01
    assert_true(strstr(w.item[0].text, "G01") != NULL && strstr(w.item[0].text, "af0") != NULL);
    assert_true(strstr(w.item[1].text, "G01") != NULL && strstr(w.item[1].text, "CNAV") != NULL);
    assert_true(strstr(w.item[2].text, "G01") != NULL && strstr(w.item[2].text, "CNV2") != NULL);
    assert_true(strstr(w.item[3].text, "R01") != NULL && strstr(w.item[3].text, "tau_n") != NULL);
    const orr_sat *sat;
    const size_t n = orr_navset_satellites(set, &sat);
    assert_int_equal(n, N_SATS - 2);
    for (size_t i = 0; i < n; i++)
        ASSERT_OK(orr_navframe_at(set, sat[i], NULL, t, false, &(orr_navframe){0}, &d), d);
    orr_warnings_free(&w);
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// Files that are 100 m apart part the orbit. The set of that slot can stand for one side alone and says that
// it is not to be used; nothing is fitted across.
static void files_that_do_not_meet_make_their_set_unhealthy(void **state)
{
    (void)state;
    orr_ephemeris *e = product("2024-02-04T00:00:00", 8, (spoil){.push_s = -1, .apart_m = 100});
    const orr_time joint = when("2024-02-04T04:00:00");
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    for (int k = 0; k < 4; k++) {
        const orr_sat sat = orr_sat_parse((const char *[]){"G01", "G02", "R01", "R02"}[k]);
        const orr_navset_item *item;
        const size_t n = orr_navset_items(set, sat, ORR_NAV_NONE, &item);
        assert_true(n >= 4);
        for (size_t i = 0; i < n; i++) {
            const bool parted = k % 2 == 1 && item[i].from < joint && joint < item[i].to;
            assert_int_equal(item[i].eph.health != 0, parted);
            // The bars of good orbits; that of G02 is 100 m off what gravity bends.
            ASSERT_NEAR(item[i].report.rms_m, 0, k == 0 ? 0.05 : k == 1 ? 0.1 : 0.5);
            if (k % 2 == 1) assert_true(i == 0 || item[i].from == item[i - 1].to);
        }
    }
    orr_navset_free(set);
    orr_ephemeris_free(e);
}

// A reset asks for a rate that no field holds. The sets around it say that they are not to be used, and their
// frames live; all others are as good as ever.
static void a_reset_makes_its_sets_unhealthy(void **state)
{
    (void)state;
    orr_ephemeris *e =
        product("2024-02-04T00:00:00", 8, (spoil){.push_s = -1, .fast_s = 5e-4, .reset_s = 4 * 3600.0 + 900});
    const orr_time reset = when("2024-02-04T04:15:00");
    orr_navset_options o = orr_navset_defaults();
    orr_navset *set = build(e, &o);
    for (int k = 0; k < 2; k++) {
        const orr_sat sat = orr_sat_parse(k == 0 ? "G01" : "R01");
        const orr_navset_item *item;
        const size_t n = orr_navset_items(set, sat, ORR_NAV_NONE, &item);
        assert_true(n >= 4);
        size_t out = 0;
        for (size_t i = 0; i < n; i++) {
            orr_navframe f;
            orr_diag d = {0};
            ASSERT_OK(orr_navframe_at(set, sat, NULL, item[i].from, false, &f, &d), d);
            const bool held = item[i].from <= reset && reset < item[i].to;
            if (held) assert_true(item[i].eph.health != 0 && (item[i].notes & ORR_NAVSET_CLOCK_JUMP));
            if (item[i].eph.health == 0) ASSERT_NEAR(item[i].clock_rms_s, 0, 1e-9); // made clocks are lines
            out += item[i].eph.health != 0;
        }
        assert_in_range(out, 1, 2); // GLONASS' windows are 18 s off the reset's quarter hours
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
        cmocka_unit_test(marked_satellites_are_unhealthy_and_no_others),
        cmocka_unit_test(faults_change_sets_and_no_others),
        cmocka_unit_test(without_a_clock_nothing_is_sent_unless_asked),
        cmocka_unit_test(more_weeks_than_are_counted_are_refused),
        cmocka_unit_test(sets_stay_in_their_slots),
        cmocka_unit_test(clocks_that_do_not_fit_are_left_out),
        cmocka_unit_test(files_that_do_not_meet_make_their_set_unhealthy),
        cmocka_unit_test(a_reset_makes_its_sets_unhealthy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
