// SPDX-License-Identifier: GPL-3.0-or-later
// Noise of clocks: the Allan deviation of what is made returns each power law; satellites' clocks keep their nodes; observations have the
// receiver's oscillator and channels do not.
#include "core/constants.h"
#include "inertial/sense/allan.h"
#include "src/scenario/effect/clock_noise.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

enum { N = 20000, CLOCKS = 8 };

// Allan deviation, of several clocks of one law together, at the averaging times that come first from those told on, which take
// their places.
static void deviations(orr_scenario_clock law, double *tau_s, size_t n, double *out)
{
    static double increment[N];
    for (size_t j = 0; j < n; j++) out[j] = 0;
    for (uint64_t clock = 0; clock < CLOCKS; clock++) {
        orr_series s;
        orr_diag diag = {0};
        orr_allan a;
        size_t spare = ORR_SERIES_NODES;
        assert_int_equal(orr_clock_noise_make(&law, clock, made_midnight, at(N), &spare, &s), ORR_OK);
        assert_int_equal(spare, ORR_SERIES_NODES - s.n);
        for (size_t k = 0; k < N; k++) increment[k] = s.node[k + 1] - s.node[k];
        ASSERT_OK(orr_allan_deviation(increment, N, 1, &a, &diag), diag);
        for (size_t j = 0; j < n; j++) {
            size_t k = 0;
            while (k + 1 < a.n && a.point[k].tau_s < 0.999 * tau_s[j]) k++;
            assert_true(a.point[k].tau_s < 1.4 * tau_s[j]);
            tau_s[j] = a.point[k].tau_s;
            out[j] += a.point[k].deviation * a.point[k].deviation / CLOCKS;
        }
        orr_series_free(&s);
    }
    for (size_t j = 0; j < n; j++) out[j] = sqrt(out[j]);
}

// What one clock shows of its law at long averaging times is luck: a day has 86 values at 1000 s, and flicker's and a walk's
// deviation 8 % there. These are eight clocks, 160 values; bounds are twice what they leave.
static void allan_deviations_return_the_five_laws(void **state)
{
    (void)state;
    double d[4], tau_s[] = {1, 8, 120, 1000};
    static const double within[] = {0.01, 0.015, 0.04, 0.1};
    deviations((orr_scenario_clock){.white_phase = 1e-10, .seed = 1}, tau_s, 4, d);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(d[k] / (1e-10 / tau_s[k]), 1, 0.01);
    deviations((orr_scenario_clock){.white_frequency = 1e-11, .seed = 2}, tau_s, 4, d);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(d[k] / (1e-11 / sqrt(tau_s[k])), 1, within[k]);
    deviations((orr_scenario_clock){.flicker_frequency = 1e-12, .seed = 3}, tau_s, 4, d);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(d[k] / 1e-12, 1, within[k]);
    deviations((orr_scenario_clock){.random_walk_frequency = 1e-14, .seed = 4}, tau_s, 4, d);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(d[k] / (1e-14 * sqrt(tau_s[k])), 1, within[k]);
    deviations((orr_scenario_clock){.flicker_phase = 1e-10, .seed = 5}, tau_s, 4, d);
    for (int k = 0; k < 4; k++) {
        const double law = sqrt((1.038 + 3 * log(ORR_PI * tau_s[k])) / (1.038 + 3 * log(ORR_PI))) / tau_s[k];
        ASSERT_NEAR(d[k] / (1e-10 * law), 1, within[k]);
    }
}

static void a_sum_is_the_sum_of_its_laws(void **state)
{
    (void)state;
    double d[3], tau_s[] = {1, 120, 1000};
    // A rubidium: white phase below, then white frequency, then the walk.
    deviations(
        (orr_scenario_clock){
            .white_phase = 3e-11, .white_frequency = 3e-12, .random_walk_frequency = 3e-14, .seed = 6},
        tau_s, 3, d);
    for (int k = 0; k < 3; k++) {
        const double root = sqrt(tau_s[k]);
        ASSERT_NEAR(d[k] / hypot(3e-11 / tau_s[k], hypot(3e-12 / root, 3e-14 * root)), 1,
                    k == 2 ? 0.1 : 0.04);
    }
}

static void satellites_keep_their_nodes(void **state)
{
    (void)state;
    open_with(SKY "clocks: {satellites: [{sats: G, white_frequency: 1e-11, seed: 3}]}\n");
    const orr_channels *c = orr_engine_channels(engine);
    assert_non_null(c);
    double worst = 0, middle = 0;
    int n = 0;
    for (int k = 1; k < 40; k++) {
        // Received so that it was sent at a node: the light takes 65 to 100 ms.
        for (int half = 0; half < 2; half++) {
            const double node_s = 300.0 * k + 150 * half;
            orr_channel x = one_at(at(node_s + 0.08), "G01", "L1CA");
            const double tau = (x.term_m[ORR_TERM_DISTANCE] + x.term_m[ORR_TERM_SAGNAC]) / ORR_LIGHT_MPS;
            x = one_at(at(node_s + tau), "G01", "L1CA");
            const double noise = x.term_m[ORR_TERM_CLOCK_NOISE] / ORR_LIGHT_MPS;
            if (half == 0)
                worst = fmax(worst, fabs(noise));
            else
                middle += noise * noise, n++;
        }
    }
    ASSERT_NEAR(worst, 0, 1e-14);
    // A bridge of 300 s: variance q t (T - t)/T, 75 q in the middle; 39 of them: 23 % of the variance.
    ASSERT_NEAR(middle / n / (1e-22 * 75), 1, 0.6);
    const orr_channel a = one_at(at(4000), "G01", "L1CA"), b = one_at(at(4000.001), "G01", "L1CA");
    ASSERT_NEAR((b.term_m[ORR_TERM_CLOCK_NOISE] - a.term_m[ORR_TERM_CLOCK_NOISE]) / 0.001,
                a.rate_mps[ORR_TERM_CLOCK_NOISE], 1e-5);
    assert_true(one_at(at(4000), "E01", "E1").term_m[ORR_TERM_CLOCK_NOISE] == 0);
}

static void oscillators_are_in_observations_alone(void **state)
{
    (void)state;
    open_with(SKY "clocks: {receiver: {white_frequency: 1e-9, random_walk_frequency: 1e-10, seed: 3}}\n");
    const orr_channels *c = orr_engine_channels(engine);
    const orr_channel with = one_at(at(5000), "G01", "L1CA");
    double rate, later;
    const double x = orr_channels_oscillator(c, 0, at(5000), &rate);
    ASSERT_NEAR(rate, (orr_channels_oscillator(c, 0, at(5000.5), &later) - x) / 0.5, 5e-9);
    assert_true(fabs(x) > 1e-9);
    tear_down(NULL);
    open_with(SKY);
    const orr_channel without = one_at(at(5000), "G01", "L1CA");
    assert_true(with.code_m == without.code_m && with.carrier_fraction == without.carrier_fraction);
    assert_true(orr_channels_oscillator(orr_engine_channels(engine), 0, at(5000), &rate) == 0);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    refused_with(SKY "clocks: {receiver: {seed: 4}}\n",
                 "clocks.receiver: has no effect without one of the five");
    refused_with(SKY "clocks: {satellites: [{sats: G}]}\n", "has no effect without one of the five");
    refused_with(SKY "clocks: {receiver: {white_frequency: 1}}\n", "white_frequency");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(allan_deviations_return_the_five_laws),
        cmocka_unit_test(a_sum_is_the_sum_of_its_laws),
        cmocka_unit_test_teardown(satellites_keep_their_nodes, tear_down),
        cmocka_unit_test_teardown(oscillators_are_in_observations_alone, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
