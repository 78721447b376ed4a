// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a receiver's clock by whole milliseconds: taken out of the ranges where the satellites agree, and nothing else
// is.
#include "core/constants.h"
#include "core/nan.h"
#include "core/rng.h"
#include "iono/phase/clock_steps.h"
#include "testing.h"

enum { SATS = 5, N = 200 };
#define MS (ORR_LIGHT_MPS * 1e-3)

typedef struct sky {
    orr_time epoch[N];
    orr_time t[SATS][N];
    double truth[SATS][N], value[SATS][N][4];
    orr_clock_series s[SATS];
} sky;

// Ranges that change by up to 800 m/s, with a metre of noise; satellites 3 and 4 miss every seventh epoch.
static void make(sky *x)
{
    memset(x, 0, sizeof *x);
    for (int i = 0; i < N; i++) x->epoch[i] = 30 * i * ORR_NS_PER_S;
    for (int k = 0; k < SATS; k++) {
        size_t n = 0;
        for (int i = 0; i < N; i++) {
            if (k >= 3 && i % 7 == 3) continue;
            double range = 2.2e7 + 800 * 30 * i * (k - 2) / 2.0;
            x->t[k][n] = x->epoch[i];
            x->value[k][n][0] = range / 0.19;
            x->value[k][n][1] = range / 0.244;
            for (int r = 2; r < 4; r++)
                x->truth[k][n] = x->value[k][n][r] = range + orr_rng_normal(1, (uint64_t)k, (uint64_t)i);
            n++;
        }
        x->s[k] = (orr_clock_series){n, x->t[k], x->value[k], 0.19};
    }
}

// Puts a step of k milliseconds into the ranges (or with the other sign into the phases) of all satellites but the
// first `without`.
static void step(sky *x, int at, long k, int without, bool phases)
{
    for (int s = without; s < SATS; s++)
        for (size_t i = 0; i < x->s[s].n; i++) {
            if (x->t[s][i] < x->epoch[at]) continue;
            for (int r = 2; r < 4 && !phases; r++) x->value[s][i][r] += (double)k * MS;
            if (phases) {
                x->value[s][i][0] -= (double)k * MS / 0.19;
                x->value[s][i][1] -= (double)k * MS / 0.244;
            }
        }
}

static size_t undo(sky *x)
{
    size_t steps;
    orr_diag d = {0};
    ASSERT_OK(orr_clock_steps_undo(x->s, SATS, x->epoch, N, &steps, &d), d);
    return steps;
}

static void test_undone(void **state)
{
    (void)state;
    static sky x;
    for (int missing = 0; missing < 2; missing++) {
        make(&x);
        for (int i = 20; i < N; i += 40) step(&x, i, i % 3 == 0 ? -2 : 1, 0, false);
        if (missing) x.value[0][50][2] = ORR_NAN; // the other range tells
        assert_int_equal(undo(&x), 5);
        for (int s = 0; s < SATS; s++)
            for (size_t i = 0; i < x.s[s].n; i++) ASSERT_NEAR(x.value[s][i][3] - x.truth[s][i], 0, 1e-3);
    }
    // Phases that step: ranges follow them.
    make(&x);
    step(&x, 100, 1, 0, true);
    assert_int_equal(undo(&x), 1);
    double before = x.value[2][99][2] - 0.19 * x.value[2][99][0],
           after = x.value[2][100][2] - 0.19 * x.value[2][100][0];
    ASSERT_NEAR(after - before, 0, 10);
}

// No step: nothing changes. A jump of one satellite alone, or of no whole number of milliseconds, is not the clock's.
static void test_not_undone(void **state)
{
    (void)state;
    static sky x;
    make(&x);
    assert_int_equal(undo(&x), 0);
    step(&x, 100, 1, SATS - 1, false);
    assert_int_equal(undo(&x), 0);
    make(&x);
    for (int s = 0; s < SATS; s++)
        for (size_t i = 100; i < x.s[s].n; i++) x.value[s][i][2] += 0.4 * MS;
    assert_int_equal(undo(&x), 0);
    for (size_t i = 100; i < x.s[0].n; i++) ASSERT_NEAR(x.value[0][i][2] - x.truth[0][i], 0.4 * MS, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_undone), cmocka_unit_test(test_not_undone)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
