// SPDX-License-Identifier: GPL-3.0-or-later
// Periods of a series by least squares: closed forms, holes, and what cannot be told.
#include "testing.h"

#include "core/constants.h"
#include "orbit/elements/lines.h"

#define N 500

static double t_of(int i) { return 0.5 * i + (i % 7 == 3 ? 0.13 : 0); } // not even

static void a_line_is_found_beside_a_trend(void **state)
{
    (void)state;
    double t[N], y[N], amplitude;
    size_t n = 0;
    for (int i = 0; i < N; i++) {
        if (i > 100 && i < 160) continue; // a month is missing
        const double x = t_of(i) / 250;
        t[n] = t_of(i);
        y[n++] = 55 + 0.3 * x - 2 * x * x + x * x * x + 0.004 * cos(2 * ORR_PI * t_of(i) / 13.66 + 0.7);
    }
    orr_diag d = {0};
    ASSERT_OK(orr_line_amplitude(t, y, n, 13.66, false, &amplitude, NULL, &d), d);
    ASSERT_NEAR(amplitude, 0.004, 1e-12); // exactly what was put in
    for (double period = 2; period < 160; period *= 1.03) {
        ASSERT_OK(orr_line_amplitude(t, y, n, period, false, &amplitude, NULL, &d), d);
        assert_true(amplitude < 0.0041);
        if (fabs(log(period / 13.66)) > 0.25) assert_true(amplitude < 0.001); // leaks through the hole
    }
}

// A strong line that the span holds twice leaks into periods that are not there; with the window a tenth of that is left, and what is there
// keeps its amplitude. Beyond 45 days the strong line's own width in the window begins.
static void a_window_keeps_strong_lines_to_themselves(void **state)
{
    (void)state;
    double t[N], y[N], most[2] = {0, 0}, amplitude;
    for (int i = 0; i < N; i++) {
        t[i] = t_of(i);
        y[i] = 0.03 * cos(2 * ORR_PI * t[i] / 200) + 0.004 * cos(2 * ORR_PI * t[i] / 13.66 + 0.7);
    }
    orr_diag d = {0};
    for (int windowed = 0; windowed <= 1; windowed++) {
        for (double period = 20; period < 45; period *= 1.01) {
            ASSERT_OK(orr_line_amplitude(t, y, N, period, windowed == 1, &amplitude, NULL, &d), d);
            most[windowed] = fmax(most[windowed], amplitude);
        }
        ASSERT_OK(orr_line_amplitude(t, y, N, 13.66, windowed == 1, &amplitude, NULL, &d), d);
        ASSERT_NEAR(amplitude, 0.004, windowed == 1 ? 2e-5 : 5e-4);
    }
    print_message("leaks into 20 to 45 days: %.3g, with the window %.3g\n", most[0], most[1]);
    assert_true(most[1] < 0.2 * most[0]);
}

// Half a year seen for one year, beside a trend that is no cubic: the amplitude beside a cubic grows with the period, since the cubic can
// stand for much of a long wave; what a period explains has its peak at the line, and of a line alone it is its amplitude.
static void what_is_explained_has_its_peak_at_a_long_line(void **state)
{
    (void)state;
    enum { YEAR = 366 };
    double t[YEAR], y[YEAR], best = 0, most = 0, amplitude, explained, of_amplitude = 0, most_amplitude = 0;
    orr_diag d = {0};
    for (int i = 0; i < YEAR; i++) {
        t[i] = i;
        y[i] = 0.5 * cos(2 * ORR_PI * t[i] / 6798 + 1) + 0.02 * cos(2 * ORR_PI * t[i] / 182.6 + 2.5);
    }
    for (double period = 120; period < 244; period *= 1.002) {
        ASSERT_OK(orr_line_amplitude(t, y, YEAR, period, false, &amplitude, &explained, &d), d);
        if (explained > most) most = explained, best = period;
        if (amplitude > most_amplitude) most_amplitude = amplitude, of_amplitude = period;
    }
    print_message("explained: %.1f days, amplitude: %.1f days\n", best, of_amplitude);
    ASSERT_NEAR(best, 182.6, 4);
    assert_true(of_amplitude > 235); // at the end of what is looked through
    for (int i = 0; i < YEAR; i++) y[i] = 0.02 * cos(2 * ORR_PI * t[i] / 10.0);
    ASSERT_OK(orr_line_amplitude(t, y, YEAR, 10, false, &amplitude, &explained, &d), d);
    ASSERT_NEAR(explained, 0.02, 2e-4);
    ASSERT_NEAR(amplitude, 0.02, 1e-12);
    ASSERT_OK(orr_line_amplitude(t, y, YEAR, 13, false, &amplitude, &explained, &d), d);
    assert_true(explained < 1e-3);
}

static void what_cannot_be_told_is_refused(void **state)
{
    (void)state;
    double t[6] = {0, 1, 2, 3, 4, 5}, y[6] = {1, 2, 3, 4, 5, 6}, amplitude;
    orr_diag d = {0};
    assert_int_equal(orr_line_amplitude(t, y, 5, 2, false, &amplitude, NULL, &d), ORR_E_ARG);
    assert_int_equal(orr_line_amplitude(t, y, 6, 0, false, &amplitude, NULL, &d), ORR_E_ARG);
    assert_int_equal(orr_line_amplitude(t, y, 6, 1, false, &amplitude, NULL, &d),
                     ORR_E_NUMERIC); // a sine that is nothing at all instants
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_line_is_found_beside_a_trend),
                                       cmocka_unit_test(a_window_keeps_strong_lines_to_themselves),
                                       cmocka_unit_test(what_is_explained_has_its_peak_at_a_long_line),
                                       cmocka_unit_test(what_cannot_be_told_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
