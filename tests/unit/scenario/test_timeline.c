// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when: rises and sets against direct evaluation on either side of their nanosecond, whole for any partition; arcs,
// manoeuvres and leap seconds against what the orbits were made with.
#include "src/scenario/engine/timeline.h"

#include "testing.h"
#include "unit/orbit/made_orbit.h"

#define PRODUCT ORR_BINARY_DIR "/timeline.nc"
enum { SATS = 9, HOURS = 6, ROOM = 400 };

static orr_engine *engine;
static orr_timeline *timeline;
static orr_leap_entry entry[] = {{41317, 10}, {57754, 37}, {0, 38}};
static orr_leap_table leap = {3, entry, 70000};

static orr_time at(double t_s) { return orr_time_add_s(made_midnight, t_s); }

static int set_up(void **state)
{
    static const char text[] = "orbit: {product: " PRODUCT "}\nnavdata: {window: none}\n"
                               "signals: [G, R, E]\n"
                               "antennas:\n"
                               "  - {name: A, position: [56, 40, 150]}\n"
                               "  - {name: B, position: [-12, 100, 5]}\n"
                               "mask: {elevation: 8}\n";
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(SATS, HOURS, 900, 6);
    orr_ephemeris *e = NULL;
    orr_scenario c;
    ASSERT_OK(orr_ephemeris_build(&s, &e, &diag), diag);
    ASSERT_OK(orr_ephemeris_save(e, PRODUCT, "made for a test", &diag), diag);
    orr_ephemeris_free(e);
    made_solution_free(&s);
    double rest;
    orr_time_mjd(made_midnight, ORR_SCALE_GPS, NULL, &entry[2].mjd, &rest);
    ASSERT_OK(orr_scenario_parse("test", text, strlen(text), NULL, &leap, &c, &diag), diag);
    ASSERT_OK(orr_engine_open(&c, NULL, NULL, NULL, &engine, &diag), diag);
    orr_scenario_free(&c);
    ASSERT_OK(orr_timeline_open(engine, &timeline, &diag), diag);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    orr_timeline_close(timeline);
    orr_engine_close(engine);
    return 0;
}

static size_t all(orr_time from, orr_time to, orr_happening out[ROOM])
{
    size_t n;
    assert_true(orr_timeline_between(timeline, from, to, out, ROOM, &n));
    return n;
}

static bool sees(size_t antenna, orr_sat sat, orr_time t)
{
    const orr_channels *c = orr_engine_channels(engine);
    orr_antenna_state a;
    orr_sat_state s;
    assert_int_equal(orr_antenna_at(orr_channels_antenna(c, antenna), t, &a), ORR_ANSWER_OK);
    return orr_span_holds(orr_channels_span(c), t) &&
           orr_ephemeris_eval(orr_engine_ephemeris(engine), sat, t, &s) == ORR_OK &&
           orr_channels_sees(c, antenna, &a, s.pos_m);
}

static void changes_of_view_to_the_nanosecond(void **state)
{
    (void)state;
    orr_happening h[ROOM];
    const size_t n = all(at(0), at(3600 * HOURS), h);
    size_t passes = 0;
    for (size_t k = 0; k < n; k++) {
        if (h[k].kind != ORR_HAPPENS_RISE && h[k].kind != ORR_HAPPENS_SET) continue;
        assert_int_equal(sees(h[k].antenna, h[k].sat, h[k].t), h[k].kind == ORR_HAPPENS_RISE);
        assert_int_equal(sees(h[k].antenna, h[k].sat, h[k].t - 1), h[k].kind == ORR_HAPPENS_SET);
        passes++;
    }
    assert_true(passes > SATS);
}

static void none_is_missed(void **state)
{
    (void)state;
    const orr_sat *sats;
    const size_t n_sats = orr_engine_satellites(engine, &sats);
    for (size_t a = 0; a < 2; a++)
        for (size_t i = 0; i < n_sats; i++) {
            orr_happening h[ROOM];
            size_t seen = 0, told = 0;
            const size_t n = all(at(1000), at(18997), h);
            for (int t = 1000; t < 18997; t += 7)
                seen += sees(a, sats[i], at(t) - 1) != sees(a, sats[i], at(t + 7) - 1);
            for (size_t k = 0; k < n; k++)
                told += h[k].sat == sats[i] && h[k].antenna == a &&
                        (h[k].kind == ORR_HAPPENS_RISE || h[k].kind == ORR_HAPPENS_SET);
            assert_int_equal(told, seen);
        }
}

static void parts_make_the_whole(void **state)
{
    (void)state;
    orr_happening whole[ROOM], part[ROOM];
    const size_t n = all(at(0), at(3600 * HOURS), whole);
    size_t k = 0;
    for (orr_time t = at(0); t < at(3600 * HOURS);) {
        // Edges on events as well: what happens at an edge belongs to the interval that begins there.
        const orr_time to = k < n && whole[k].t > t ? whole[k].t : t + INT64_C(317000000003);
        const orr_time end = to < at(3600 * HOURS) ? to : at(3600 * HOURS);
        const size_t m = all(t, end, part);
        for (size_t j = 0; j < m; j++, k++) {
            assert_true(k < n);
            assert_true(part[j].t == whole[k].t && part[j].kind == whole[k].kind &&
                        part[j].sat == whole[k].sat && part[j].antenna == whole[k].antenna &&
                        part[j].value == whole[k].value);
            assert_true(part[j].t >= t && part[j].t < end);
        }
        t = end;
    }
    assert_int_equal(k, n);
}

static size_t count(const orr_happening *h, size_t n, orr_happening_kind kind)
{
    size_t found = 0;
    for (size_t k = 0; k < n; k++) found += h[k].kind == kind;
    return found;
}

static void what_has_a_date(void **state)
{
    (void)state;
    orr_happening h[ROOM];
    orr_span span;
    orr_engine_span(engine, &span.from, &span.to);
    const size_t n = all(span.from, span.to + 1, h);
    assert_int_equal(count(h, n, ORR_HAPPENS_ARC_BEGIN), SATS);
    assert_int_equal(count(h, n, ORR_HAPPENS_ARC_END), SATS);
    assert_int_equal(count(h, n, ORR_HAPPENS_ECLIPSE_BEGIN), SATS);
    assert_int_equal(count(h, n, ORR_HAPPENS_MANOEUVRE_BEGIN), SATS);
    assert_int_equal(count(h, n, ORR_HAPPENS_MANOEUVRE_END), SATS);
    // UTC's day begins 38 - 19 s of GPS time after GPS' own.
    assert_int_equal(count(h, n, ORR_HAPPENS_LEAP_SECOND), 1);
    for (size_t k = 0; k < n; k++)
        if (h[k].kind == ORR_HAPPENS_LEAP_SECOND) {
            assert_int_equal(h[k].t, at(19));
            assert_int_equal(h[k].value, 19);
        }
    size_t told;
    assert_false(orr_timeline_between(timeline, span.from, span.to + 1, h, n - 1, &told));
    assert_int_equal(told, n - 1);
    assert_int_equal(all(at(-86400), span.from, h), 0);
    assert_int_equal(all(at(1000), at(1000), h), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_of_view_to_the_nanosecond),
        cmocka_unit_test(none_is_missed),
        cmocka_unit_test(parts_make_the_whole),
        cmocka_unit_test(what_has_a_date),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
