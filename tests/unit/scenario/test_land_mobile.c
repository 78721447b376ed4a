// SPDX-License-Identifier: GPL-3.0-or-later
// Lutz' two states: shares and lengths of stretches, Rice and Rayleigh by their moments, the shadow's lognormal, blocks and edges.
#include "block_at.h"
#include "core/constants.h"
#include "src/scenario/effect/land_mobile.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"
static const double L1_HZ = 1575.42e6;

static void states_and_their_statistics_are_as_told(void **state)
{
    (void)state;
    orr_scenario s;
    orr_diag diag = {0};
    orr_land_mobile *x;
    const char *text =
        "orbit: {product: " MADE_PRODUCT "}\n" SKY
        "land_mobile: [{speed: 10, good: 60, bad: 30, rice: 7, shadow: -12, shadow_sigma: 4, seed: 2}]\n";
    ASSERT_OK(orr_scenario_parse("test", text, strlen(text), NULL, NULL, &s, &diag), diag);
    const orr_sat sats[2] = {orr_sat_parse("G01"), orr_sat_parse("G02")};
    const orr_span span = {at(0), at(20000)};
    ASSERT_OK(orr_land_mobile_open(&s, sats, 2, span, &x, &diag), diag);
    // 20000 s of stretches of 6 and 3 s: 2200 of each. Power at instants 0.2 s apart, 20 beats of a wavelength.
    double bad_s = 0, good[3] = {0}, fading = 0, db = 0, db2 = 0;
    int changes = 0, n_good = 0, n_stretch = 0, alike = 0;
    double sum = 0, sum2 = 0;
    int in_stretch = 0;
    bool before = orr_land_mobile_at(x, 0, at(0), at(0), L1_HZ).shadow;
    for (int k = 0; k < 100000; k++) {
        const orr_time t = at(0.2 * k + 0.0037);
        const orr_land_mobile_now now = orr_land_mobile_at(x, 0, t, t, L1_HZ);
        const double power = pow(10, now.power_db / 10);
        alike += now.shadow == orr_land_mobile_at(x, 1, t, t, L1_HZ).shadow;
        if (now.shadow != before) {
            changes++;
            if (before &&
                in_stretch >= 10) { // a shadow of 2 s and more tells its mean and its Rayleigh fading
                // The logarithm of the mean of n exponential powers is low by psi(n) - ln n = -1/(2 n) - 1/(12 n^2).
                const double stretch = in_stretch, low = 1 / (2 * stretch) + 1 / (12 * stretch * stretch),
                             told = 10 * log10(sum / stretch) + 10 / log(10) * low;
                db += told;
                db2 += told * told;
                fading += sum2 / in_stretch / pow(sum / in_stretch, 2);
                n_stretch++;
            }
            sum = sum2 = 0;
            in_stretch = 0;
        }
        before = now.shadow;
        if (now.shadow) {
            bad_s += 0.2;
            sum += power;
            sum2 += power * power;
            in_stretch++;
        } else {
            good[0] += power;
            good[1] += power * power;
            n_good++;
        }
    }
    ASSERT_NEAR(bad_s / 20000 / (30.0 / 90), 1, 0.1);
    ASSERT_NEAR(20000 / (changes / 2.0) / 9, 1, 0.1); // a cycle of 90 m at 10 m/s
    // Rice: E = 1 + 1/K, E2 - E^2 = (2 K + 1)/K^2 of a direct ray of 1.
    const double K = pow(10, 0.7), mean = good[0] / n_good;
    ASSERT_NEAR(mean / (1 + 1 / K), 1, 0.05);
    ASSERT_NEAR((good[1] / n_good - mean * mean) / ((2 * K + 1) / (K * K)), 1, 0.1);
    // Means over ten and more samples of Rayleigh power spread by 1.4 dB or less. 10 % of power is 0.41 dB: twice what these
    // stretches leave of a spread of 4 dB.
    assert_true(n_stretch > 500);
    const double shadow = db / n_stretch, sigma = sqrt(db2 / n_stretch - shadow * shadow);
    ASSERT_NEAR(pow(10, (shadow + 12) / 10), 1, 0.1);
    ASSERT_NEAR(sigma / hypot(4, 1.0), 1, 0.1);
    assert_true(fading / n_stretch > 1.6 && fading / n_stretch < 2.05); // 2 of many samples, 2 n/(n + 1) of n
    ASSERT_NEAR(alike / 100000.0 / (5.0 / 9), 1, 0.1); // satellites are independent: 1/9 + 4/9
    orr_land_mobile_close(x);
    orr_scenario_free(&s);
}

static void channels_fade_within_their_blocks(void **state)
{
    (void)state;
    open_with(SKY "land_mobile: [{sats: G, speed: 2, good: 20, bad: 10}]\n");
    static orr_block block[ROOM];
    orr_blocks b;
    size_t n;
    double worst = 0;
    int seen = 0;
    for (int ms = 0; ms < 2000; ms++) {
        const orr_time t = at(4000 + ms * 1e-3);
        assert_int_equal(orr_blocks_at(orr_engine_channels(engine), 0, work, t, UINT64_MAX, &b, block, &n),
                         ORR_ANSWER_OK);
        assert_int_equal(b.length_ns, 2000000); // 0.19 m at 2 m/s, a twentieth: 4.75 ms
        const orr_channel x = one_at(t, "G01", "L1CA");
        for (size_t k = 0; k < n; k++)
            if (block[k].at.sat == x.sat && block[k].at.signal == x.signal) {
                const double off = (double)(block[k].carrier_cycles - x.carrier_cycles) +
                                   block_cubic(block[k].carrier, orr_time_diff_s(t, b.t0)) -
                                   x.carrier_fraction;
                worst = fmax(worst, fabs(off - nearbyint(off)));
                seen++;
            }
    }
    assert_int_equal(seen, 2000);
    ASSERT_NEAR(worst, 0, 0.01);
    assert_true(one_at(at(4000), "E01", "E1").term_m[ORR_TERM_LAND_MOBILE] == 0);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SKY "land_mobile: [{speed: 10, good: 60}]\n", "bad");
    refused_with(SKY "land_mobile: [{speed: 10, good: 60, bad: 10, shadow: 3}]\n", "shadow");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(states_and_their_statistics_are_as_told),
        cmocka_unit_test_teardown(channels_fade_within_their_blocks, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
