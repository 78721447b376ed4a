// SPDX-License-Identifier: GPL-3.0-or-later
// False signals: those of a receiver at the place told, later by the way from their transmitter.
#include "block_at.h"
#include "core/constants.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SIGNALS "signals: [G, E]\nmask: {elevation: 5}\ntroposphere: {model: saastamoinen}\n"
#define HERE "antennas: [{name: HERE, position: [52, 17, 124]}]\n"
#define THERE "antennas: [{name: THERE, position: [51, 20, 300]}]\n"
#define SPOOFER                                                                                              \
    "spoofers: [{pretends: [51, 20, 300], position: [52.01, 17, 150], velocity: [0, -20, 0], delay: 2e-6, "  \
    "power: "                                                                                                \
    "6, from: 2024-02-04T01:00:00.2, to: 2024-02-04T01:05:00}]\n"

static size_t false_ones(orr_time t, orr_channel out[ROOM])
{
    static orr_channel x[ROOM];
    const size_t n = all_at(t, 0, x);
    size_t m = 0;
    for (size_t k = 0; k < n; k++) {
        if (x[k].echo == ORR_CHANNEL_SPOOFED)
            out[m++] = x[k];
        else
            assert_int_equal(m, 0); // the sky comes first
    }
    return m;
}

static void false_signals_are_of_the_place_told(void **state)
{
    (void)state;
    static orr_channel there[ROOM], told[ROOM];
    const orr_time t = at(3700);
    open_with(SIGNALS THERE);
    const size_t n = all_at(t, 0, there);
    assert_true(n > 3);
    tear_down(NULL);
    open_with(SIGNALS HERE SPOOFER);
    assert_int_equal(false_ones(at(3600.199), told), 0);
    assert_int_equal(false_ones(at(3900), told), 0);
    assert_int_equal(false_ones(t, told), n);
    const orr_vec3 r = orr_channels_antenna(orr_engine_channels(engine), 0)->fixed.r_m;
    const orr_geodetic place = {52.01 * ORR_RAD_PER_DEG, 17 * ORR_RAD_PER_DEG, 150};
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    const orr_vec3 from =
        orr_vec3_add(orr_earth_to_ecef(place), orr_mat3_apply_t(&enu, (orr_vec3){0, -20 * 99.8, 0}));
    const double way_m = orr_vec3_norm(orr_vec3_sub(from, r)), late_m = way_m + 2e-6 * ORR_LIGHT_MPS;
    for (size_t k = 0; k < n; k++) {
        assert_true(told[k].sat == there[k].sat && told[k].signal == there[k].signal);
        ASSERT_NEAR(told[k].term_m[ORR_TERM_SPOOFER], late_m, 1e-6);
        ASSERT_NEAR(told[k].code_m - there[k].code_m, late_m, 1e-6);
        ASSERT_NEAR(((double)(told[k].carrier_cycles - there[k].carrier_cycles) + told[k].carrier_fraction -
                     there[k].carrier_fraction) *
                        ORR_LIGHT_MPS / told[k].carrier_hz,
                    late_m, 1e-6);
        ASSERT_NEAR(told[k].rate_mps[ORR_TERM_SPOOFER], 20,
                    1); // it has passed over the antenna and leaves it
        ASSERT_NEAR(told[k].power_dbw, there[k].power_dbw + 6, 1e-9);
    }
}

static void false_blocks_join_and_begin_at_edges(void **state)
{
    (void)state;
    static orr_block block[ROOM];
    static orr_channel told[ROOM];
    orr_blocks b;
    open_with(SIGNALS HERE SPOOFER);
    const orr_channels *c = orr_engine_channels(engine);
    for (int ms = 0; ms < 1000; ms += 50) {
        size_t n, m = 0;
        const orr_time t = at(3600) + (int64_t)ms * 1000000;
        assert_int_equal(orr_blocks_at(c, 0, work, t, UINT64_MAX, &b, block, &n), ORR_ANSWER_OK);
        const size_t expected = false_ones(t, told);
        for (size_t k = 0; k < n; k++) {
            if (block[k].at.echo != ORR_CHANNEL_SPOOFED) continue;
            ASSERT_NEAR(block_code_m(&block[k], orr_time_diff_s(t, b.t0)), told[m].code_m, 1e-6);
            m++;
        }
        assert_int_equal(m, expected);
        assert_true((m > 0) == (ms >= 200));
    }
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SIGNALS HERE "spoofers: [{pretends: [51, 20, 300], position: [95, 17, 150]}]\n",
                 "latitude 95 is no place");
    refused_with(SIGNALS HERE
                 "spoofers: [{pretends: [51, 20, 300], position: [52, 17, 150], velocity: [1, 0, 0]}]\n",
                 "what moves needs `from`");
    refused_with(SIGNALS HERE "spoofers: [{position: [52, 17, 150]}]\n", "pretends");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(false_signals_are_of_the_place_told, tear_down),
        cmocka_unit_test_teardown(false_blocks_join_and_begin_at_edges, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
