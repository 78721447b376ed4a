// SPDX-License-Identifier: GPL-3.0-or-later
// Walls hide what is behind them, tunnels everything, by time and by place; jammers by geometry and free space.
#include "core/constants.h"
#include "src/scenario/channel/block.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, R, E]\nmask: {elevation: 0}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"
static const double DEGREE_M = 111270; // of latitude at 52 degrees

static void a_wall_hides_what_is_behind_it(void **state)
{
    (void)state;
    static orr_channel open[ROOM], hidden[ROOM];
    size_t behind = 0, beside = 0;
    for (int k = 0; k < 40; k++) {
        const orr_time t = at(300 + 500 * k);
        open_with(SKY);
        const size_t n = all_at(t, 0, open);
        tear_down(NULL);
        // 200 m South of the antenna, from 400 m West to 400 m East, 150 m above it.
        char text[400];
        snprintf(text, sizeof text,
                 SKY "obstacles: {walls: [{from: [%.9f, %.9f], to: [%.9f, %.9f], top: 274}]}\n",
                 52 - 200 / DEGREE_M, 17 - 400 / 68680.0, 52 - 200 / DEGREE_M, 17 + 400 / 68680.0);
        open_with(text);
        const size_t m = all_at(t, 0, hidden);
        size_t j = 0;
        for (size_t i = 0; i < n; i++) {
            const bool there = j < m && hidden[j].sat == open[i].sat && hidden[j].signal == open[i].signal;
            if (there) j++;
            const double south = -cos(open[i].az_rad), east = sin(open[i].az_rad);
            const double reach = south > 0 ? 200 / south : 0, up = reach * tan(open[i].el_rad);
            if (south > 0 && fabs(reach * east) < 395 && up < 145) {
                assert_false(there);
                behind++;
            } else if (!(south > 0) || fabs(reach * east) > 405 || up > 155) {
                assert_true(there);
                beside++;
            }
        }
        assert_int_equal(j, m);
        tear_down(NULL);
    }
    assert_true(behind > 3 && beside > 30);
}

static void a_tunnel_by_time_has_its_edges(void **state)
{
    (void)state;
    static orr_channel x[ROOM];
    static orr_block block[ROOM];
    orr_blocks b;
    size_t n;
    open_with(SKY "obstacles: {tunnels: [{during: 2024-02-04T01:00:02.4/2024-02-04T01:00:05}]}\n");
    const size_t before = all_at(at(3602.399), 0, x);
    assert_true(before > 0);
    assert_int_equal(all_at(at(3602.4), 0, x), 0);
    assert_int_equal(all_at(at(3604.999), 0, x), 0);
    assert_int_equal(all_at(at(3605), 0, x), before);
    const orr_channels *c = orr_engine_channels(engine);
    for (int ms = 2000; ms < 5500; ms += 50) { // one block after the other
        assert_int_equal(orr_blocks_at(c, 0, work, at(3600 + ms * 1e-3), UINT64_MAX, &b, block, &n),
                         ORR_ANSWER_OK);
        assert_int_equal(b.length_ns, 100000000);
        assert_int_equal(n, ms >= 2400 && ms < 5000 ? 0 : before);
    }
}

static void a_tunnel_by_place_is_driven_through(void **state)
{
    (void)state;
    static orr_channel x[ROOM];
    open_with("signals: [G, R, E]\nmask: {elevation: 0}\ntrajectory:\n  kind: waypoints\n  start: "
              "2024-02-04T01:00:00\n"
              "  waypoints: [{lat: 52, lon: 17, height: 100, speed: 20}, {lat: 52.02, lon: 17, height: 100, "
              "speed: 20}]\n"
              "obstacles: {tunnels: [{from: [52.008, 17], to: [52.012, 17], width: 10}]}\n");
    const orr_antenna *a = orr_channels_antenna(orr_engine_channels(engine), 0);
    int inside = 0, outside = 0;
    for (int s = 10; s < 100; s++) {
        orr_antenna_state where;
        const orr_time t = at(3600 + s);
        if (orr_antenna_at(a, t, &where) != ORR_ANSWER_OK) break;
        const double lat = orr_earth_from_ecef(where.r_m).lat_rad * ORR_DEG_PER_RAD;
        const bool in = lat > 52.008 && lat < 52.012;
        const size_t n = all_at(t, 0, x);
        assert_true((n == 0) == in);
        *(in ? &inside : &outside) += 1;
    }
    assert_true(inside > 10 && outside > 30);
}

static void jammers_are_geometry_and_power(void **state)
{
    (void)state;
    open_with(
        SKY
        "jammers:\n  - {waveform: sweep, carrier: 1575.42e6, power: -10, position: [52.01, 17, 124]}\n"
        "  - {waveform: cw, carrier: 1227.6e6, power: 0, position: [52, 17.01, 124], velocity: [-30, 0, 0], "
        "from: 2024-02-04T01:00:00, to: 2024-02-04T01:00:10}\n");
    const orr_channels *c = orr_engine_channels(engine);
    const orr_antenna_state *here = &orr_channels_antenna(c, 0)->fixed;
    orr_jammer j[ORR_MAX_JAMMERS];
    assert_int_equal(orr_channels_jammers(c, here, at(3599), j), 1);
    assert_string_equal(j[0].waveform, "sweep");
    ASSERT_NEAR(j[0].range_m, 0.01 * DEGREE_M, 1);
    ASSERT_NEAR(sin(j[0].az_rad), 0, 1e-4);
    assert_true(j[0].doppler_hz == 0);
    ASSERT_NEAR(j[0].power_dbw, -10 - 20 * log10(4 * ORR_PI * j[0].range_m * 1575.42e6 / ORR_LIGHT_MPS),
                1e-9);
    assert_int_equal(orr_channels_jammers(c, here, at(3605), j), 2);
    ASSERT_NEAR(j[1].az_rad, ORR_PI / 2, 1e-3);
    ASSERT_NEAR(j[1].range_rate_mps, -30, 1e-3); // it comes nearer: its carrier arrives higher
    ASSERT_NEAR(j[1].doppler_hz, 30 * 1227.6e6 / ORR_LIGHT_MPS, 0.01);
    const double then = j[1].range_m;
    assert_int_equal(orr_channels_jammers(c, here, at(3606), j), 2);
    ASSERT_NEAR(then - j[1].range_m, 30, 1e-3);
    assert_int_equal(orr_channels_jammers(c, here, at(3610), j), 1);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SKY "obstacles: {walls: [{from: [52, 17], to: [52, 17.1], bottom: 10, top: 5}]}\n",
                 "the top is not above the bottom");
    refused_with(SKY "obstacles: {walls: [{from: [99, 17], to: [52, 17.1], top: 5}]}\n",
                 "latitude 99 is no place");
    refused_with(SKY "obstacles: {tunnels: [{width: 5}]}\n", "obstacles.tunnels[0]");
    refused_with(SKY "obstacles: {tunnels: [{during: 2024-02-04T01:00:02.0001/2024-02-04T01:00:05}]}\n",
                 "on a whole millisecond");
    refused_with(
        SKY
        "jammers: [{waveform: cw, carrier: 1.5e9, power: 0, position: [52, 17, 0], velocity: [1, 0, 0]}]\n",
        "what moves needs `from`");
    refused_with(SKY "jammers: [{waveform: '', carrier: 1.5e9, power: 0, position: [52, 17, 0]}]\n",
                 "jammers[0].waveform");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(a_wall_hides_what_is_behind_it, tear_down),
        cmocka_unit_test_teardown(a_tunnel_by_time_has_its_edges, tear_down),
        cmocka_unit_test_teardown(a_tunnel_by_place_is_driven_through, tear_down),
        cmocka_unit_test_teardown(jammers_are_geometry_and_power, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
