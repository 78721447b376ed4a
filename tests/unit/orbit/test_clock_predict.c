// SPDX-License-Identifier: GPL-3.0-or-later
// Predicted clocks against closed forms: curves that the models hold, variances of two nodes, the common part
// of a system's clocks.
#include "testing.h"

#include "core/constants.h"
#include "orbit/clock/clock_common.h"
#include "orbit/clock/clock_predict.h"

enum { N = 193 }; // two days and a node, a quarter of an hour apart
static orr_time at(double t_s) { return (orr_time)llround(t_s * 1e9); }

static double curve(double t_s, double bend, double swing)
{
    const double turn = 2 * ORR_PI / ORR_CLOCK_HARMONIC_S;
    return 1e-4 + 3e-11 * t_s + bend * t_s * t_s + swing * sin(turn * t_s + 0.7);
}

static void curves_are_carried_on(void **state)
{
    (void)state;
    static const struct {
        orr_clock_model m;
        double bend, swing;
    } c[] = {{{1, false, 86400}, 0, 0},
             {{2, false, 172800}, 2e-20, 0},
             {{1, true, 86400}, 0, 2e-9},
             {{2, true, 172800}, 2e-20, 2e-9}};
    const orr_clock_noise none = {0};
    for (size_t k = 0; k < sizeof c / sizeof *c; k++) {
        orr_clock_node node[N];
        orr_clock_predictor *p;
        for (int i = 0; i < N; i++)
            node[i] =
                (orr_clock_node){.t = at(900.0 * i), .clock_s = curve(900.0 * i, c[k].bend, c[k].swing)};
        assert_int_equal(orr_clock_predictor_init(node, N, &c[k].m, &none, &p), ORR_OK);
        for (double h = 0; h <= 24; h += 3) {
            const double t_s = 900.0 * (N - 1) + 3600 * h;
            const orr_clock_prediction x = orr_clock_predictor_at(p, at(t_s));
            ASSERT_NEAR(x.clock_s, curve(t_s, c[k].bend, c[k].swing), 1e-16); // rounding of 1e-4 s: 1e-20
            const double rate =
                (curve(t_s + 10, c[k].bend, c[k].swing) - curve(t_s - 10, c[k].bend, c[k].swing)) / 20;
            ASSERT_NEAR(x.rate_sps, rate, 1e-18); // a second of 2e-9 s at half-day: 7e-21 by the difference
        }
        orr_clock_predictor_free(p);
    }
}

// A line through two nodes T apart, tau beyond the last one. White noise w: w ((1 + r)^2 + r^2) with r = tau
// / T; a random walk: q tau (1 + r); a random walk of frequency: q tau^2 (tau + T) / 3.
static void variances_of_two_nodes(void **state)
{
    (void)state;
    const double T = 3600, tau = 7200, r = tau / T;
    const orr_clock_node node[2] = {{.t = at(0), .clock_s = 1e-6}, {.t = at(T), .clock_s = 2e-6}};
    const orr_clock_model line = {1, false, 86400};
    const struct {
        orr_clock_noise n;
        double variance;
    } c[] = {{{1e-18, 0, 0}, 1e-18 * ((1 + r) * (1 + r) + r * r)},
             {{0, 1e-22, 0}, 1e-22 * tau * (1 + r)},
             {{0, 0, 1e-30}, 1e-30 * tau * tau * (tau + T) / 3}};
    orr_clock_predictor *p;
    const orr_clock_noise none = {0};
    assert_int_equal(orr_clock_predictor_init(node, 2, &line, &none, &p), ORR_OK);
    const double least = orr_clock_predictor_at(p, at(T + tau)).sigma_s; // what two solutions differ by
    ASSERT_NEAR(orr_clock_predictor_at(p, at(T + tau)).clock_s, 4e-6, 1e-15);
    orr_clock_predictor_free(p);
    for (size_t k = 0; k < sizeof c / sizeof *c; k++) {
        assert_int_equal(orr_clock_predictor_init(node, 2, &line, &c[k].n, &p), ORR_OK);
        const double sigma = orr_clock_predictor_at(p, at(T + tau)).sigma_s;
        ASSERT_NEAR(sigma * sigma - least * least, c[k].variance, 1e-9 * sigma * sigma);
        orr_clock_predictor_free(p);
    }
    assert_int_equal(orr_clock_predictor_init(node, 1, &line, &none, &p), ORR_E_NODATA);
}

// A made random walk is found again, and no other noise. 192 steps tell their variance to a tenth
// (1/sqrt(96)), lags of half a day to a half; the mean of the eight lags to a quarter.
static void walk_is_found(void **state)
{
    (void)state;
    orr_clock_node node[N];
    uint64_t seed = 12345;
    double c = 0, sum = 0;
    enum { RUNS = 40 };
    for (int run = 0; run < RUNS; run++) {
        orr_clock_noise n;
        for (int i = 0; i < N; i++) {
            double u = -6; // twelve uniform numbers less six: variance 1
            for (int k = 0; k < 12; k++) {
                seed = seed * 6364136223846793005u + 1442695040888963407u;
                u += (double)(seed >> 11) * 0x1p-53;
            }
            c += 1e-10 * u;
            node[i] = (orr_clock_node){.t = at(900.0 * i), .clock_s = c};
        }
        assert_int_equal(orr_clock_noise_fit(node, N, &n), ORR_OK);
        sum += n.wfm_s2ps * 900 + n.rwfm_s2ps3 * 900 * 900 * 900 / 3 + n.white_s2;
    }
    // The parabola and the harmonic take a part of the long lags.
    assert_true(sum / RUNS > 0.6e-20 && sum / RUNS < 1.2e-20);
    assert_int_equal(orr_clock_noise_fit(node, 10, &(orr_clock_noise){0}), ORR_E_NODATA);
}

static void models_by_block_and_noise(void **state)
{
    (void)state;
    const orr_sat g = orr_sat_make('G', 5), e = orr_sat_make('E', 5), c = orr_sat_make('C', 25);
    const orr_clock_noise quiet = {0, 1e-24, 0}, white = {1.6e-20, 5e-24, 0}, caesium = {0, 3e-22, 0};
    assert_int_equal(orr_clock_model_choose(e, NULL, &quiet).degree, 1);
    assert_int_equal(orr_clock_model_choose(c, NULL, &quiet).degree, 2);
    assert_int_equal(orr_clock_model_choose(g, NULL, &quiet).degree, 2);
    assert_int_equal(orr_clock_model_choose(g, "", &white).degree, 1);
    assert_true(orr_clock_model_choose(g, "", &white).harmonic);
    assert_false(orr_clock_model_choose(g, "BLOCK IIIA", &white).harmonic);
    assert_int_equal(orr_clock_model_choose(g, "BLOCK IIF", &white).degree, 2);
    assert_int_equal(orr_clock_model_choose(g, "BLOCK IIR-B", &quiet).degree, 1);
    assert_int_equal(orr_clock_model_choose(g, "BLOCK IIF", &caesium).degree, 1);
}

static void fill(orr_clock_list *l, double rate)
{
    for (size_t i = 0; i < l->n; i++)
        l->node[i] = (orr_clock_node){.t = at(300.0 * (double)i), .clock_s = rate * 300 * (double)i};
}

// Two satellites that take the same ramp share it; what one of them does alone is its own.
static void two_share_what_both_do(void **state)
{
    (void)state;
    enum { M = 40 };
    orr_clock_node a[M], b[M];
    orr_clock_list l[2] = {{orr_sat_make('G', 5), M, a}, {orr_sat_make('G', 7), M, b}};
    fill(&l[0], 1e-11);
    fill(&l[1], -3e-11);
    for (int i = 0; i < M; i++) {
        const double ramp = 62e-9 * (i < 10 ? 0 : i < 15 ? i - 10 : 5);
        a[i].clock_s += ramp + (i == 30 ? 1e-6 : 0);
        b[i].clock_s += ramp;
    }
    orr_clock_common x;
    assert_int_equal(orr_clock_common_find(l, 2, 'G', &x), ORR_OK);
    assert_int_equal(x.n, M);
    ASSERT_NEAR(x.epoch[M - 1].value_s, 0, 0);
    ASSERT_NEAR(x.epoch[0].value_s, -5 * 62e-9, 1e-15);
    ASSERT_NEAR(x.epoch[11].step_s, 62e-9, 1e-15);
    for (int i = 16; i < M; i++) ASSERT_NEAR(x.epoch[i].step_s, 0, 1e-15);
    orr_clock_common_apply(&x, -1, &l[1]);
    for (int i = 1; i < M; i++) ASSERT_NEAR(b[i].clock_s - b[i - 1].clock_s, -9e-9, 1e-15);
    orr_clock_common_free(&x);
    assert_int_equal(orr_clock_common_find(l, 1, 'G', &x), ORR_OK); // one alone shares nothing
    for (int i = 0; i < M; i++) ASSERT_NEAR(x.epoch[i].step_s, 0, 0);
    orr_clock_common_free(&x);
    assert_int_equal(orr_clock_common_find(l, 2, 'E', &x), ORR_OK);
    assert_int_equal(x.n, 0);
    orr_clock_common_free(&x);
}

// Where files join, both have a clock for the instant; the step between the two is the centre's.
static void joint_is_a_step(void **state)
{
    (void)state;
    enum { M = 20 };
    orr_clock_node node[3][M];
    orr_clock_list l[3];
    for (int s = 0; s < 3; s++) {
        l[s] = (orr_clock_list){orr_sat_make('E', s + 1), M, node[s]};
        for (int i = 0; i < M; i++) {
            const int slot = i < M / 2 ? i : i - 1;
            node[s][i] = (orr_clock_node){.t = at(300.0 * slot),
                                          .clock_s = 1e-11 * s * 300 * slot + (i < M / 2 ? 0 : 408e-9),
                                          .source = i < M / 2 ? 0 : 1};
        }
    }
    orr_clock_common x;
    assert_int_equal(orr_clock_common_find(l, 3, 'E', &x), ORR_OK);
    assert_int_equal(x.n, M);
    for (int i = 0; i < M; i++) ASSERT_NEAR(x.epoch[i].step_s, i == M / 2 ? 408e-9 : 0, 1e-18);
    orr_clock_common_apply(&x, -1, &l[2]);
    for (int i = 0; i < M; i++)
        ASSERT_NEAR(node[2][i].clock_s, 408e-9 + 2e-11 * 300 * (i < M / 2 ? i : i - 1), 1e-18);
    orr_clock_common_free(&x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_are_carried_on),  cmocka_unit_test(variances_of_two_nodes),
        cmocka_unit_test(walk_is_found),          cmocka_unit_test(models_by_block_and_noise),
        cmocka_unit_test(two_share_what_both_do), cmocka_unit_test(joint_is_a_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
