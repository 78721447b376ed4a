// SPDX-License-Identifier: GPL-3.0-or-later
// Which set is on the air when: schedules over week ends and leap seconds, ends of a product, satellites
// without clocks, manoeuvres; and frames that are the same for every instant that they hold.
#include "testing.h"

#include "core/nan.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"
#include "orbit/navdata/navframe.h"
#include "orbit/navdata/navset_private.h"
#include "orbit/smooth/smoother.h"
#include "unit/orbit/made_orbit.h"
#include "unit/orbit/made_sp3.h"

static orr_time when(const char *text)
{
    orr_time t;
    orr_diag d = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &d), d);
    return t;
}

enum { N_GPS = 3, N_GLONASS = 3, N_SATS = 7 }; // and a Galileo satellite

typedef struct spoil {
    double push_s;  // a burn of G01 so long after the begin; negative for none
    bool no_clock;  // of G01
    double fast_s;  // by so much the clocks of G01 and R01 are fast,
    double reset_s; // from so long after the begin on
    double after_s; // of G02 nothing is known before, and of G03 nothing after
    double apart_m; // two files, which meet in the middle; of G02 and R02 they are so far apart
} spoil;

// A product of so many hours from `from` on: GPS and GLONASS orbits integrated with the project's forces.
static orr_ephemeris *product(const char *from, double hours, spoil x)
{
    static made_truth truth[N_SATS];
    const made_truth *all[N_SATS];
    made_sky sky;
    made_sky_init(&sky, from, hours / 24);
    for (int k = 0; k < N_SATS; k++) {
        const bool gps = k < N_GPS, glonass = !gps && k < N_GPS + N_GLONASS;
        const int number = gps ? k + 1 : glonass ? k - N_GPS + 1 : 14;
        const orr_sat sat = orr_sat_make(gps ? 'G' : glonass ? 'R' : 'E', number);
        made_orbit(&sky, sat,
                   gps       ? 2.656e7
                   : glonass ? 2.551e7
                             : 2.96e7,
                   gps ? 0.01 : 0.001, glonass ? 1.13 : 0.96, 0.9 * k, 0.4 + 1.7 * k, 2e-8,
                   k == 0 ? x.push_s : -1, 0.5, &truth[k]);
        all[k] = &truth[k];
    }
    const size_t end = (size_t)(hours * 12), joint = x.apart_m > 0 ? end / 6 * 3 : end + 3;
    orr_sp3 f, g = {0};
    made_sp3(&sky, all, N_SATS, 0, joint - 3, 3, &f);
    if (x.apart_m > 0) made_sp3(&sky, all, N_SATS, joint, end, 3, &g);
    for (size_t i = 0; i < g.n_epochs; i++) {
        made_record(&g, orr_sat_parse("G02"), g.epoch[i])->pos_m[0] += x.apart_m;
        made_record(&g, orr_sat_parse("R02"), g.epoch[i])->pos_m[0] += x.apart_m;
    }
    for (size_t i = 0; x.no_clock && i <= end; i += 3)
        made_record(&f, orr_sat_parse("G01"), orr_time_add_s(sky.t0, 300.0 * (double)i))->clock_s =
            (double)NAN;
    for (size_t i = 0; i < joint && i <= end; i += 3) {
        const orr_time t = orr_time_add_s(sky.t0, 300.0 * (double)i);
        if (300.0 * (double)i >= x.reset_s) {
            made_record(&f, orr_sat_parse("G01"), t)->clock_s += x.fast_s;
            made_record(&f, orr_sat_parse("R01"), t)->clock_s += x.fast_s;
        }
        for (int k = 0; x.after_s > 0 && k < 3; k++) {
            if (300.0 * (double)i < x.after_s) made_record(&f, orr_sat_parse("G02"), t)->pos_m[k] = ORR_NAN;
            if (300.0 * (double)i > x.after_s) made_record(&f, orr_sat_parse("G03"), t)->pos_m[k] = ORR_NAN;
        }
    }
    const orr_smoother_input in[2] = {{.sp3 = &f, .name = "made.sp3"}, {.sp3 = &g, .name = "later.sp3"}};
    const orr_smoother_options o = orr_smoother_defaults();
    orr_orbit_solution s;
    orr_ephemeris *e = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_smoother_run(in, x.apart_m > 0 ? 2 : 1, &o, NULL, NULL, &s, NULL, NULL, &d), d);
    ASSERT_OK(orr_ephemeris_build(&s, &e, &d), d);
    orr_orbit_solution_free(&s);
    made_sp3_free(&f);
    if (x.apart_m > 0) made_sp3_free(&g);
    made_sky_free(&sky);
    return e;
}
static const spoil nothing = {.push_s = -1};

static orr_navset *build(const orr_ephemeris *e, const orr_navset_options *o)
{
    orr_navset *set = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_navset_build(e, o, &set, NULL, &d), d);
    return set;
}

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
