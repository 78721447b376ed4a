// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of broadcast data: health, displaced orbits, stale sets and inverted bits, each against the scenario without it.
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "navdata: {window: 2h}\nsignals: [G, R, E]\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

static orr_sat sat_of(const char *name) { return orr_sat_parse(name); }

// What a satellite sends at t on its first stream, and its set.
static orr_navset_item sent(const char *sat, orr_time t, bool coded, orr_navframe *frame)
{
    const orr_nav_stream *stream[ORR_NAVSET_STREAMS];
    const orr_navset_item *item;
    assert_true(orr_engine_navdata_streams(engine, sat_of(sat), 0, stream) > 0);
    assert_int_equal(orr_engine_navdata(engine, t, sat_of(sat), stream[0], coded, &item, frame),
                     ORR_ANSWER_OK);
    return *item;
}

// orbit/navdata's own tests (test_navset.c) tell of health, stale sets and GLONASS.
static void a_message_of_a_displaced_orbit(void **state)
{
    (void)state;
    static orr_navframe frame;
    open_with(SKY "faults: {orbit: [{sats: 'G01,E01', wrong: message, from: 2024-02-04T01:20:00, to: "
                  "2024-02-04T02:40:00, radial: 200, along: -500, cross: 300}]}\n");
    static const char *const sats[] = {"G01", "E01"};
    for (size_t k = 0; k < sizeof sats / sizeof *sats; k++)
        for (double t_s = 4830; t_s < 9600; t_s += 300) {
            const orr_navset_item item = sent(sats[k], at(t_s), false, &frame);
            orr_broadcast_state b;
            orr_sat_state s;
            assert_int_equal(orr_broadcast_eval(&item.eph, at(t_s), &b), ORR_OK);
            assert_int_equal(orr_ephemeris_eval(orr_engine_ephemeris(engine), sat_of(sats[k]), at(t_s), &s),
                             ORR_OK);
            const orr_mat3 axes = orr_orbit_axes(s.pos_m, orr_velocity_inertial(s.pos_m, s.vel_mps));
            const orr_vec3 rac = orr_mat3_apply_t(&axes, orr_vec3_sub(b.pos_m, s.pos_m));
            // What elements cannot say of a displacement that turns with the orbit over two hours.
            ASSERT_NEAR(rac.x, 200, 10);
            ASSERT_NEAR(rac.y, -500, 10);
            ASSERT_NEAR(rac.z, 300, 10);
        }
    // The channels stay with the true orbit.
    orr_channel x[ROOM];
    const size_t n = all_at(at(6000), 0, x);
    assert_true(n > 0);
    for (size_t k = 0; k < n; k++) assert_true(x[k].term_m[ORR_TERM_FAULT_ORBIT] == 0);
}

// Bits of a piece that differ, and the first and last of them.
static int differ(const orr_navframe_piece *a, const orr_navframe_piece *b, int *first, int *last)
{
    int n = 0;
    for (int k = 0; k < a->bits; k++) {
        if (((a->data[k / 8] ^ b->data[k / 8]) >> (7 - k % 8) & 1) == 0) continue;
        if (n++ == 0) *first = k;
        *last = k;
    }
    return n;
}

static void bits_are_inverted_and_no_others(void **state)
{
    (void)state;
    static orr_navframe clean[3], wrong;
    static const char *const sats[3] = {"G01", "E01", "G02"};
    open_with(SKY);
    for (int k = 0; k < 3; k++) (void)sent(sats[k], at(3700), k == 1, &clean[k]);
    tear_down(NULL);
    // The third word of subframe 2; and bits 100 to 109 of 120 a half page of I/NAV has: 250 symbols a second.
    open_with(SKY "faults: {bits: [{sats: G01, message: LNAV, piece: 2, bit: [61, 90], from: "
                  "2024-02-04T01:00:00, to: 2024-02-04T02:00:00}, {sats: E01, message: INAV, bit: 100, from: "
                  "2024-02-04T01:00:00}]}\n");
    int first = -1, last = -1, pieces = 0;
    (void)sent("G01", at(3700), false, &wrong);
    for (int i = 0; i < wrong.n; i++) {
        const int n = differ(&clean[0].piece[i], &wrong.piece[i], &first, &last);
        assert_int_equal(n, wrong.piece[i].number == 2 ? 30 : 0);
        pieces += n > 0;
    }
    assert_int_equal(pieces, 1);
    assert_int_equal(first, 60);
    assert_int_equal(last, 89);
    (void)sent("E01", at(3700), true, &wrong);
    for (int i = 0; i < wrong.n; i++) {
        const int n = differ(&clean[1].piece[i], &wrong.piece[i], &first, &last);
        assert_in_range(n, 1, 3); // the symbols sent in the time of one bit
    }
    (void)sent("G02", at(3700), false, &wrong);
    for (int i = 0; i < wrong.n; i++)
        assert_int_equal(differ(&clean[2].piece[i], &wrong.piece[i], &first, &last), 0);
}

static void what_no_message_has_is_refused(void **state)
{
    (void)state;
#define BITS(rest) SKY "faults:\n  bits:\n  - {sats: G01, from: 2024-02-04T01:00:00, " rest "}\n"
    refused_with(BITS("message: XNAV, bit: 1"), "faults.bits[0].message: there is no message 'XNAV'");
    refused_with(BITS("message: LNAV, bit: 301"), "faults.bits[0].bit: such a piece has 300 bits");
    refused_with(BITS("message: LNAV, piece: 7, bit: 3"), "faults.bits[0].piece: no satellite named sends");
    refused_with(BITS("bit: [9, 3]"), "whole numbers, the first not after the last");
    refused_with(SKY "faults:\n  stale:\n  - {sats: G, from: 2024-02-04T01:00:00}\n  - {sats: G01, from: "
                     "2024-02-04T02:00:00}\n",
                 "faults.stale[1]: G01 has the same fault by faults.stale[0]");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(a_message_of_a_displaced_orbit, tear_down),
        cmocka_unit_test_teardown(bits_are_inverted_and_no_others, tear_down),
        cmocka_unit_test_teardown(what_no_message_has_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
