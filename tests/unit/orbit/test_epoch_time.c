// SPDX-License-Identifier: GPL-3.0-or-later
// The times of a file's epochs from what its satellites tell alike: made ones, as CODE's files of 2008 and 2011 have them, with
// noise of a millimetre's rounding and slow errors of each orbit.
#include "testing.h"

#include "core/rng.h"
#include "orbit/dynamics/epoch_time.h"

enum { SATS = 24, EPOCHS = 96, N = SATS * EPOCHS };
#define UNIT_S (86400 / 137438953472.0 / 3) // a third of the last bit of MJD in a double, 2^-37 days

// In units of it, by quarter of an hour: what the sum of steps of 1/96 day is off.
static double pattern_s(int k)
{
    static const int unit[12] = {0, 1, -1, 0, 1, -2, -1, 0, -2, 1, 2, 0};
    return unit[k % 12] * UNIT_S;
}

static double noise(int i) { return orr_rng_uniform(17, 0, (uint64_t)i) - 0.5; }

// Readings of `step` seconds; off: whether the epochs are; several files are one after the other.
static size_t make(double step_s, bool off, orr_time_reading *r)
{
    size_t n = 0;
    for (int s = 0; s < SATS; s++)
        for (int k = 0; k < EPOCHS && k * step_s <= 86400; k++) {
            const double t_s = k * step_s, slow = 2e-6 * sin(2 * 3.14159 * t_s / 43200 + s) + 1e-6 * s;
            const double kink =
                t_s > 43200 ? 2e-6 * (s - 12) / 4000 * (t_s - 43200) : 0; // steps of velocity at noon
            r[n] = (orr_time_reading){.t = orr_time_add_s(0, t_s),
                                      .sat = (uint16_t)s,
                                      .late_s = slow + kink + 0.26e-6 * noise((int)n) +
                                                (off ? pattern_s((int)lround(t_s / 900)) : 0)};
            n++;
        }
    return n;
}

static void found_at_any_step(void **state)
{
    (void)state;
    static const double step_s[] = {900, 1800, 3600};
    orr_time_reading *r = malloc(N * sizeof *r);
    assert_non_null(r);
    for (int i = 0; i < 3; i++) {
        orr_epoch_times x;
        const size_t n = make(step_s[i], true, r);
        assert_int_equal(orr_epoch_times_find(r, n, &x), ORR_OK);
        assert_int_equal(x.n, n / SATS);
        double left2 = 0, all2 = 0, mean = 0;
        for (size_t k = 0; k < x.n; k++)
            mean += (pattern_s((int)lround((double)k * step_s[i] / 900)) - x.item[k].late_s) / (double)x.n;
        for (size_t k = 0; k < x.n; k++) {
            const double truth = pattern_s((int)lround((double)k * step_s[i] / 900));
            left2 += pow(truth - x.item[k].late_s - mean, 2);
            all2 += truth * truth;
            assert_true(orr_epoch_late_s(&x, 0, x.item[k].t) == x.item[k].late_s);
        }
        print_message("%g s: %.3f us RMS of %.3f are left\n", step_s[i], 1e6 * sqrt(left2 / (double)x.n),
                      1e6 * sqrt(all2 / (double)x.n));
        assert_true(left2 < 0.16 * all2);
        assert_true(orr_epoch_late_s(&x, 1, x.item[0].t) == 0);
        orr_epoch_times_free(&x);
    }
    free(r);
}

// Neither rounding, slow errors and corners of orbits make times of epochs, nor do seven satellites.
static void nothing_is_found_where_nothing_is(void **state)
{
    (void)state;
    orr_time_reading *r = malloc(N * sizeof *r);
    assert_non_null(r);
    for (int i = 0; i < 2; i++) {
        orr_epoch_times x;
        size_t n = make(900, i == 1, r);
        if (i == 1) n = 7 * EPOCHS; // ascending by satellite
        assert_int_equal(orr_epoch_times_find(r, n, &x), ORR_OK);
        assert_int_equal(x.n, 0);
        orr_epoch_times_free(&x);
    }
    orr_epoch_times none;
    assert_int_equal(orr_epoch_times_find(r, 0, &none), ORR_OK);
    assert_int_equal(none.n, 0);
    free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(found_at_any_step),
        cmocka_unit_test(nothing_is_found_where_nothing_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
