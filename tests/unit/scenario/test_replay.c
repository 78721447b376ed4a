// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded day evaluated: the recorded epochs have the recorded values, between them cubics join in value and rate, gaps have no
// channel, arcs do not run into each other.
#include "src/scenario/effect/replay.h"
#include "src/scenario/replay/record.h"
#include "testing.h"

enum { EPOCHS = 12, GAP = 6 };
static const orr_time BEGIN = (orr_time)1391000000 * ORR_NS_PER_S;

static orr_time instant(double s) { return orr_time_add_s(BEGIN, s); }

// A track of 30-s epochs without the sixth, whose carrier begins another arc at the ninth; residuals are a cubic of time.
static orr_replay *made(void)
{
    orr_replay *r = calloc(1, sizeof *r);
    r->n_epochs = EPOCHS;
    r->tag = calloc(EPOCHS, sizeof *r->tag);
    r->t = calloc(EPOCHS, sizeof *r->t);
    r->clock_s = calloc(EPOCHS, sizeof *r->clock_s);
    r->held_s = calloc(EPOCHS, sizeof *r->held_s);
    r->steps = calloc(EPOCHS, sizeof *r->steps);
    r->interval_s = 30;
    r->n_sats = r->n_tracks = 1;
    r->sat = calloc(1, sizeof *r->sat);
    r->sat[0] = (orr_replay_sat){.sat = orr_sat_make('G', 5), .pair = {-1, -1}};
    r->track = calloc(1, sizeof *r->track);
    orr_replay_track *x = &r->track[0];
    x->n_arcs = 2;
    x->arc = calloc(2, sizeof *x->arc);
    x->arc[0] = (orr_replay_arc){.start = 100, .bias_m = 0.01};
    x->arc[1] = (orr_replay_arc){.start = 7, .bias_m = 0.02};
    x->node = calloc(EPOCHS, sizeof *x->node);
    r->sat[0].sight = calloc(EPOCHS, sizeof *r->sat[0].sight);
    for (size_t e = 0; e < EPOCHS; e++) {
        r->tag[e] = instant(30 * (double)e);
        r->clock_s[e] = 1e-4 + 1e-6 * (double)e + (e >= 4 ? 1e-3 : 0);
        r->steps[e] = e == 4;
        r->held_s[e] = e >= 4 ? 1e-3 : 0;
        r->t[e] = orr_time_add_s(r->tag[e], -r->clock_s[e]);
        r->sat[0].sight[r->sat[0].n++] = (orr_replay_sight){.epoch = (uint32_t)e,
                                                            .begins = e == 0 || e == GAP + 1,
                                                            .more_tecu = 0.1 * (double)e,
                                                            .clock_m = -0.01 * (double)e};
        if (e == GAP) continue;
        x->node[x->n++] = (orr_replay_node){.epoch = (uint32_t)e,
                                            .arc = e >= 9,
                                            .code_m = 0.02 * (double)e,
                                            .carrier_m = 0.001 * (double)(e * e),
                                            .cn0_dbhz = 40,
                                            .begins = e == 0 || e == GAP + 1};
    }
    orr_diag diag = {0};
    ASSERT_OK(orr_replay_seal(r, true, &diag), diag);
    return r;
}

static void recorded_epochs_have_the_recorded_values(void **state)
{
    (void)state;
    orr_replay *r = made();
    const orr_replay_track *x = orr_replay_track_of(r, orr_sat_make('G', 5), 0);
    assert_non_null(x);
    assert_null(orr_replay_track_of(r, orr_sat_make('G', 5), 1));
    assert_null(orr_replay_track_of(r, orr_sat_make('G', 6), 0));
    for (size_t e = 0; e < EPOCHS; e++) {
        orr_replay_now now;
        double rate, held;
        assert_int_equal(orr_replay_at(r, x, r->t[e], r->t[e], &now), e != GAP);
        ASSERT_NEAR(orr_replay_clock_s(r, r->tag[e], &rate, &held), r->clock_s[e], 0);
        ASSERT_NEAR(held, r->held_s[e], 0);
        assert_true((orr_replay_node_of(x, e) == NULL) == (e == GAP));
        if (e == GAP) continue;
        ASSERT_NEAR(now.code_m, 0.02 * (double)e, 0);
        ASSERT_NEAR(now.carrier_m, 0.001 * (double)(e * e), 0);
        assert_int_equal(now.start, e >= 9 ? 7 : 100);
        ASSERT_NEAR(now.bias_m, e >= 9 ? 0.02 : 0.01, 0);
        ASSERT_NEAR(now.cn0_dbhz, 40, 0);
    }
    orr_replay_free(r);
}

static void curves_join_and_gaps_have_no_channel(void **state)
{
    (void)state;
    orr_replay *r = made();
    const orr_replay_track *x = &r->track[0];
    const orr_replay_sat *sat = &r->sat[0];
    orr_replay_now before, after;
    orr_replay_ray ray[2];
    for (size_t e = 1; e + 1 < EPOCHS; e++) { // value and rate on both sides of a node
        const orr_time t = r->t[e];
        if (e == GAP || e == GAP + 1 || e == 9 || e == 4) continue;
        assert_true(orr_replay_at(r, x, t, t - 1, &before));
        assert_true(orr_replay_at(r, x, t, t, &after));
        ASSERT_NEAR(before.code_m, after.code_m, 1e-12);
        ASSERT_NEAR(before.carrier_m, after.carrier_m, 1e-12);
        if (e + 1 != GAP && e + 1 != 9) ASSERT_NEAR(before.carrier_mps, after.carrier_mps, 1e-12);
        orr_replay_ray_at(r, sat, t, t - 1, &ray[0]);
        orr_replay_ray_at(r, sat, t, t, &ray[1]);
        ASSERT_NEAR(ray[0].tecu, ray[1].tecu, 1e-12);
        ASSERT_NEAR(ray[1].tecu, 0.1 * (double)e, 0);
        ASSERT_NEAR(ray[1].clock_m, -0.01 * (double)e, 0);
    }
    assert_false(orr_replay_at(r, x, r->t[0] - 1, r->t[0] - 1, &after));
    assert_false(orr_replay_at(r, x, r->t[GAP - 1] + 1, r->t[GAP - 1] + 1, &after));
    assert_false(orr_replay_at(r, x, r->t[EPOCHS - 1] + 1, r->t[EPOCHS - 1] + 1, &after));
    // A block that begins at the last instant before the gap holds on to it.
    assert_true(orr_replay_at(r, x, r->t[GAP - 1] + ORR_NS_PER_S, r->t[GAP - 1], &after));
    ASSERT_NEAR(after.code_m, 0.02 * (GAP - 1), 0);
    // The old arc's carrier does not run into the new one's.
    assert_true(orr_replay_at(r, x, r->t[9] - 1, r->t[9] - 1, &before));
    ASSERT_NEAR(before.carrier_m, 0.001 * 64, 0);
    assert_int_equal(before.start, 100);
    assert_true(orr_replay_change(r, r->t[9] - 1, r->t[9]));
    assert_true(orr_replay_change(r, r->t[GAP - 1], r->t[GAP - 1] + ORR_NS_PER_S));
    assert_false(orr_replay_change(r, r->t[2], r->t[3]));
    // Cubics bend at nodes by the carrier's second difference: 2 mm in (30 s)^2.
    assert_true(orr_replay_allow(r, ORR_NS_PER_S, 1e-5));
    assert_false(orr_replay_allow(r, 30 * ORR_NS_PER_S, 1e-9));
    orr_replay_free(r);
}

static void curves_go_through_the_nodes(void **state)
{
    (void)state;
    double node[5] = {1, 2, 3, 4, 5}; // a line is returned as it is
    const orr_replay_curve r = {.from = BEGIN, .step_ns = 3600 * ORR_NS_PER_S, .n = 5, .node = node};
    for (double h = 0; h <= 4; h += 0.125) {
        size_t first;
        double w[4];
        orr_replay_curve_weights(&r, instant(3600 * h), &first, w);
        ASSERT_NEAR(w[0] + w[1] + w[2] + w[3], 1, 1e-14);
        ASSERT_NEAR(orr_replay_curve_at(&r, instant(3600 * h)), 1 + h, 1e-12);
    }
    ASSERT_NEAR(orr_replay_curve_at(&r, instant(-60)), 1, 0);
    ASSERT_NEAR(orr_replay_curve_at(&r, instant(5 * 3600)), 5, 0);
}

static void codes_stand_for_their_signals(void **state)
{
    (void)state;
    static const struct {
        char system;
        const char *code, *name;
        double version;
    } rows[] = {
        {'G', "1C", "L1CA", 3.05}, {'G', "1W", "L1P", 3.05},  {'G', "1L", "L1C", 3.05},
        {'G', "2L", "L2C", 3.05},  {'G', "2W", "L2P", 3.05},  {'G', "5Q", "L5", 3.05},
        {'R', "1P", "L1OF", 3.05}, {'R', "3X", "L3OC", 3.05}, {'E', "1C", "E1", 3.05},
        {'E', "5Q", "E5a", 3.05},  {'E', "7Q", "E5b", 3.05},  {'C', "2I", "B1I", 3.05},
        {'C', "1I", "B1I", 3.02},  {'C', "1X", "B1I", 3.02},  {'C', "1X", "B1C", 3.05},
        {'C', "7D", "B2b", 3.05},  {'C', "6I", "B3I", 3.05},  {'J', "2L", "L2C", 3.05},
        {'S', "5I", "L5", 3.05},
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const int at = orr_record_signal(rows[k].system, rows[k].code, rows[k].version);
        assert_true(at >= 0);
        assert_string_equal(orr_signals(&(size_t){0})[at].name, rows[k].name);
        assert_int_equal(orr_signals(&(size_t){0})[at].system, rows[k].system);
    }
    assert_int_equal(orr_record_signal('C', "7I", 3.05), -1); // B2I: no signal of a scenario
    assert_int_equal(orr_record_signal('E', "8X", 3.05), -1);
    assert_int_equal(orr_record_signal('G', "", 2.11), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(recorded_epochs_have_the_recorded_values),
        cmocka_unit_test(curves_join_and_gaps_have_no_channel),
        cmocka_unit_test(curves_go_through_the_nodes),
        cmocka_unit_test(codes_stand_for_their_signals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
