// SPDX-License-Identifier: GPL-3.0-or-later
// Faults: against the same scenario without them, by closed forms, statistics and geometry; at blocks' edges; refusals.
#include "block_at.h"
#include "core/constants.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"
#define FLIES                                                                                                \
    "trajectory:\n  kind: waypoints\n  start: 2024-02-04T00:10:00\n  waypoints: [{lat: 52, lon: 17, "        \
    "height: 1000, speed: 60}, {lat: 52.3, lon: 17.2, height: 1000, speed: 60}]\n"
// Midnight of the made day is 2024-02-04T00:00:00 of GPS time.
static orr_time day(int minutes, double s) { return at(60.0 * minutes + s); }

static double term(orr_time t, int which) { return one_at(t, "G01", "L1CA").term_m[which]; }

static void steps_and_ramps_are_as_told(void **state)
{
    (void)state;
    open_with(SKY "faults:\n  range: [{sats: G01, signals: 'G:L1CA', from: 2024-02-04T01:00:00.250, hold: "
                  "2024-02-04T01:00:10, to: 2024-02-04T01:01:00, step: 5, rate: 0.5}]\n"
                  "  clock: [{sats: G01, from: 2024-02-04T02:00:00, rate: 1e-9}]\n"
                  "  divergence: [{sats: G01, from: 2024-02-04T03:00:00, rate: 0.018}]\n"
                  "  power: [{sats: G01, from: 2024-02-04T03:00:00, step: -3, rate: -0.5, hold: "
                  "2024-02-04T03:00:10}]\n");
    const int range = ORR_TERM_FAULT_RANGE;
    assert_true(term(day(60, 0.249), range) == 0);
    ASSERT_NEAR(term(day(60, 0.250), range), 5, 0);
    ASSERT_NEAR(term(day(60, 4.250), range), 7, 1e-12);
    ASSERT_NEAR(term(day(60, 10), range), 5 + 0.5 * 9.75, 1e-12);
    ASSERT_NEAR(term(day(60, 59.9), range), 5 + 0.5 * 9.75, 1e-12);
    assert_true(term(day(61, 0), range) == 0);
    assert_true(one_at(day(60, 5), "G01", "L5").term_m[range] == 0);
    assert_true((one_at(day(60, 5), "G01", "L1CA").flags & ORR_CHANNEL_FAULT) != 0);
    assert_true((one_at(day(60, 5), "G01", "L5").flags & ORR_CHANNEL_FAULT) == 0);
    // A clock that runs fast makes ranges shorter.
    ASSERT_NEAR(term(day(120, 100), ORR_TERM_FAULT_CLOCK), -ORR_LIGHT_MPS * 1e-7, 1e-9);
    const orr_channel x = one_at(day(180, 100), "G01", "L1CA");
    ASSERT_NEAR(x.term_m[ORR_TERM_FAULT_DIVERGENCE], 1.8, 1e-12);
    ASSERT_NEAR(x.rate_mps[ORR_TERM_FAULT_DIVERGENCE], 0.018, 1e-15);
    tear_down(NULL);
    open_with(SKY);
    const orr_channel clean = one_at(day(180, 100), "G01", "L1CA");
    ASSERT_NEAR(x.power_dbw, clean.power_dbw - 8, 1e-12);
    // The divergence is of the code alone; the clock's ramp of an hour and 100 s is in both.
    const double clock_m = -ORR_LIGHT_MPS * 3.7e-6;
    ASSERT_NEAR(x.code_m - clean.code_m, clock_m + 1.8, 1e-7);
    ASSERT_NEAR(
        ((double)(x.carrier_cycles - clean.carrier_cycles) + x.carrier_fraction - clean.carrier_fraction) *
            ORR_LIGHT_MPS / x.carrier_hz,
        clock_m, 1e-7);
}

// Code of G01 L1CA in the blocks that hold t, at t; their length.
static double in_block(orr_time t, int64_t *length_ns)
{
    static orr_block block[ROOM];
    orr_blocks b;
    size_t n;
    const orr_signal *all = orr_signals(&(size_t){0});
    assert_int_equal(orr_blocks_at(orr_engine_channels(engine), 0, work, t, UINT64_MAX, &b, block, &n),
                     ORR_ANSWER_OK);
    *length_ns = b.length_ns;
    for (size_t k = 0; k < n; k++)
        if (block[k].at.sat == orr_sat_parse("G01") && strcmp(all[block[k].at.signal].name, "L1CA") == 0)
            return block_code_m(&block[k], orr_time_diff_s(t, b.t0));
    return (double)NAN;
}

static void a_fault_begins_at_the_edge_of_a_block(void **state)
{
    (void)state;
    open_with(SKY "faults: {range: [{sats: G01, from: 2024-02-04T01:00:03.250, to: 2024-02-04T01:00:07.5, "
                  "step: 100}], off: [{sats: G01, from: 2024-02-04T01:00:20, to: 2024-02-04T01:00:21}]}\n");
    for (int ms = 0; ms < 30000; ms += 25) { // one block after the other
        int64_t length;
        const orr_time t = day(60, 0) + (int64_t)ms * 1000000;
        const double code = in_block(t, &length);
        if (ms < 10000)
            assert_int_equal(length, 50000000); // 3.25 and 7.5 s are multiples of it, not of 100 ms
        else
            assert_int_equal(length, ORR_NS_PER_S);
        if (ms >= 20000 && ms < 21000) {
            assert_true(isnan(code));
        } else {
            orr_channel x = one_at(t, "G01", "L1CA");
            assert_true(x.term_m[ORR_TERM_FAULT_RANGE] == (ms >= 3250 && ms < 7500 ? 100 : 0));
            ASSERT_NEAR(code, x.code_m, 3e-8);
        }
    }
    // Whoever asks for one block alone gets the same.
    int64_t length;
    const double after = in_block(day(60, 3.26), &length);
    tear_down(NULL);
    open_with(SKY "faults: {range: [{sats: G01, from: 2024-02-04T01:00:03.250, to: 2024-02-04T01:00:07.5, "
                  "step: 100}]}\n");
    assert_true(in_block(day(60, 3.26), &length) == after);
}

static void noise_has_its_sigma_and_its_time(void **state)
{
    (void)state;
    open_with(SKY "faults: {seed: 5, noise: [{sats: 'G,E', from: 2024-02-04T00:00:01, sigma: [2, 0.5], "
                  "time: [60, 4]}]}\n");
    // Covariance at lags over satellites and hours: 4 exp(-t/60) + 0.25 exp(-t/4).
    enum { STEP_S = 4, N = 2500, SATS = 6 };
    static const char *const sats[SATS] = {"G01", "G02", "G03", "E01", "E02", "E03"};
    static double x[SATS][N];
    static const size_t lag[3] = {0, 1, 15};
    double sum[3] = {0, 0, 0};
    size_t used = 0;
    for (size_t k = 0; k < N; k++) {
        orr_channel all[ROOM];
        const size_t m = all_at(day(0, 60 + STEP_S * (double)k), 0, all);
        for (size_t s = 0; s < SATS; s++) {
            x[s][k] = (double)NAN;
            for (size_t j = 0; j < m; j++)
                if (all[j].sat == orr_sat_parse(sats[s])) x[s][k] = all[j].term_m[ORR_TERM_FAULT_NOISE];
        }
    }
    for (size_t s = 0; s < SATS; s++)
        for (size_t k = 0; k + 15 < N; k++) {
            if (isnan(x[s][k]) || isnan(x[s][k + 1]) || isnan(x[s][k + 15])) continue;
            used++;
            for (size_t j = 0; j < 3; j++) sum[j] += x[s][k] * x[s][k + lag[j]];
        }
    assert_true(used > 4000);
    // Some 300 independent values of the longer time: its variance is known to 9 %.
    ASSERT_NEAR(sum[0] / (double)used / 4.25, 1, 0.15);
    ASSERT_NEAR(sum[1] / sum[0], (4 * exp(-4.0 / 60) + 0.25 * exp(-1)) / 4.25, 0.03);
    ASSERT_NEAR(sum[2] / sum[0], (4 * exp(-1) + 0.25 * exp(-15)) / 4.25, 0.12);
}

static void noise_and_sines_join_from_block_to_block(void **state)
{
    (void)state;
    open_with(SKY "faults: {noise: [{sats: G01, from: 2024-02-04T01:00:00, sigma: 3, time: 20}], sine: "
                  "[{sats: G01, from: 2024-02-04T01:00:00, amplitude: 10, period: 30, phase: 90}]}\n");
    ASSERT_NEAR(one_at(day(60, 15), "G01", "L1CA").rate_mps[ORR_TERM_FAULT_NOISE] -
                    (one_at(day(60, 15.0001), "G01", "L1CA").term_m[ORR_TERM_FAULT_NOISE] -
                     one_at(day(60, 14.9999), "G01", "L1CA").term_m[ORR_TERM_FAULT_NOISE]) /
                        0.0002,
                0, 1e-3);
    for (int k = 0; k < 400;
         k++) { // within blocks the cubic is the fault: 1e-6 m of a sine, the motion's 3e-8
        int64_t length;
        const orr_time t = day(60, 30 + 0.037 * k);
        ASSERT_NEAR(in_block(t, &length), one_at(t, "G01", "L1CA").code_m, 2e-6);
    }
    tear_down(NULL);
    open_with(SKY "faults: {sine: [{sats: G01, from: 2024-02-04T01:00:00, amplitude: 10, period: 30, phase: "
                  "90}]}\n");
    ASSERT_NEAR(term(day(60, 10), ORR_TERM_FAULT_NOISE), 10 * cos(2 * ORR_PI / 3), 1e-9);
}

static void a_displaced_orbit_changes_the_range_by_its_projection(void **state)
{
    (void)state;
    open_with(SKY "faults: {orbit: [{sats: G01, wrong: orbit, from: 2024-02-04T01:00:00, radial: 300, along: "
                  "-1000, cross: 700}]}\n");
    orr_channel all[ROOM];
    assert_true(all_at(day(60, 100), 0, all) > 0);
    const orr_channel x = one_at(day(60, 100), "G01", "L1CA");
    const double tau_s = (x.term_m[ORR_TERM_DISTANCE] + x.term_m[ORR_TERM_SAGNAC]) / ORR_LIGHT_MPS;
    made_satellite m = made_satellite_at(0);
    for (size_t k = 0; m.sat != orr_sat_parse("G01"); m = made_satellite_at(++k)) assert_true(k < 9);
    orr_vec3 r, v, a;
    made_state(&m, 3700 - tau_s, &r, &v, &a);
    // Into axes that stood still at reception, by the made orbit alone.
    const double w = ORR_EARTH_RATE_RADPS, turn = -w * tau_s;
    const orr_vec3 vi = {v.x - w * r.y, v.y + w * r.x, v.z};
    const orr_vec3 s = {cos(turn) * r.x - sin(turn) * r.y, sin(turn) * r.x + cos(turn) * r.y, r.z},
                   u = {cos(turn) * vi.x - sin(turn) * vi.y, sin(turn) * vi.x + cos(turn) * vi.y, vi.z};
    const orr_vec3 radial = orr_vec3_unit(s), cross = orr_vec3_unit(orr_vec3_cross(s, u)),
                   along = orr_vec3_cross(cross, radial);
    const orr_vec3 moved =
        orr_vec3_axpy(300, radial, orr_vec3_axpy(-1000, along, orr_vec3_axpy(700, cross, s)));
    const orr_vec3 antenna = orr_channels_antenna(orr_engine_channels(engine), 0)->fixed.r_m;
    const double longer =
        orr_vec3_norm(orr_vec3_sub(moved, antenna)) - orr_vec3_norm(orr_vec3_sub(s, antenna));
    ASSERT_NEAR(x.term_m[ORR_TERM_FAULT_ORBIT], longer, 1e-5); // ellipses of the product: 1e-3 m of 1e7
    ASSERT_NEAR(x.rate_mps[ORR_TERM_FAULT_ORBIT],
                (term(day(60, 101), ORR_TERM_FAULT_ORBIT) - term(day(60, 99), ORR_TERM_FAULT_ORBIT)) / 2,
                1e-6); // u's rate is right to v/c, 3e-6, of 0.1 m/s
}

static void off_and_unhealthy(void **state)
{
    (void)state;
    open_with(SKY "faults: {off: [{sats: G01, from: 2024-02-04T01:00:00.5, to: 2024-02-04T01:00:01.5}], "
                  "unhealthy: [{sats: 'G01,E', from: 2024-02-04T01:00:01, to: 2024-02-04T01:00:02}]}\n");
    orr_channel x[ROOM];
    const size_t before = all_at(day(60, 0.499), 0, x), during = all_at(day(60, 0.5), 0, x);
    assert_true(during < before);
    for (size_t k = 0; k < during; k++) assert_true(x[k].sat != orr_sat_parse("G01"));
    assert_int_equal(all_at(day(60, 1.5), 0, x), before);
    assert_true((one_at(day(60, 1.5), "G01", "L1CA").flags & ORR_CHANNEL_UNHEALTHY) != 0);
    assert_true((one_at(day(60, 2), "G01", "L1CA").flags & ORR_CHANNEL_UNHEALTHY) == 0);
}

#define RANGE(rest) SKY "faults:\n  range:\n  - {sats: G01, step: 1, from: 2024-02-04T01:00:00" rest "}\n"
static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(RANGE(".0001"), "faults.range[0].from: a fault begins and ends on a whole millisecond");
    refused_with(RANGE(", to: 2024-02-04T00:59:00"), "faults.range[0].to: the fault ends before it begins");
    refused_with(RANGE(", rate: 1, to: 2024-02-04T01:10:00, hold: 2024-02-04T01:11:00"),
                 "faults.range[0].hold: a ramp ends");
    refused_with(RANGE(", hold: 2024-02-04T01:11:00"),
                 "faults.range[0].hold: has no effect without faults.range[0].rate");
    refused_with(RANGE("}\n  - {sats: 'G', step: 2, from: 2024-02-04T02:00:00"),
                 "faults.range[1]: G01 has the same fault by faults.range[0] at the same time");
    refused_with(RANGE("}\n  off:\n  - {sats: G01, from: 2024-02-04T00:30:00"),
                 "faults.range[0]: the fault is never seen: G01 is off all the time by faults.off[0]");
    refused_with(SKY "faults: {off: [{sats: R, from: 2024-02-04T01:00:00}]}\n",
                 "faults.off[0].sats: the scenario sends nothing of these satellites");
    refused_with(SKY "faults: {off: [{sats: G, from: 2024-02-05T01:00:00}]}\n",
                 "faults.off[0].from: the fault is never seen: the channels reach");
    refused_with(SKY "faults: {range: [{sats: G, from: 2024-02-04T01:00:00}]}\n",
                 "has no effect without a step or a rate");
    refused_with(SKY "faults: {noise: [{sats: G, from: 2024-02-04T01:00:00, sigma: [1, 2], time: 5}]}\n",
                 "1 correlation times for 2 standard deviations");
    // Of other signals, of other times, and beside each other it can.
    open_with(
        RANGE(", signals: 'G:L1CA'}\n  - {sats: G, step: 2, signals: 'G:L5', from: 2024-02-04T01:00:00"));
}

static void faults_on_a_moving_antenna_shorten_blocks(void **state)
{
    (void)state;
    open_with("signals: [G]\nmask: {elevation: -10}\n" FLIES
              "faults: {range: [{sats: G, from: 2024-02-04T00:12:00.002, step: 1}]}\n");
    int64_t length;
    (void)in_block(day(12, 5), &length);
    assert_int_equal(length, 2000000);
    (void)in_block(day(12, 15), &length);
    assert_true(length >= 20000000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(steps_and_ramps_are_as_told, tear_down),
        cmocka_unit_test_teardown(a_fault_begins_at_the_edge_of_a_block, tear_down),
        cmocka_unit_test_teardown(noise_has_its_sigma_and_its_time, tear_down),
        cmocka_unit_test_teardown(noise_and_sines_join_from_block_to_block, tear_down),
        cmocka_unit_test_teardown(a_displaced_orbit_changes_the_range_by_its_projection, tear_down),
        cmocka_unit_test_teardown(off_and_unhealthy, tear_down),
        cmocka_unit_test_teardown(faults_on_a_moving_antenna_shorten_blocks, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
