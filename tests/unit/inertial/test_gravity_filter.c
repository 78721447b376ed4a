// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of gravimetry by what they pass and what they leave at the ends; crossovers and levelling on made surveys; a flight
// laid over terrain.
#include "testing.h"

#include <stdlib.h>
#include <string.h>

#include "core/rng.h"
#include "inertial/gravimetry/crossovers.h"
#include "inertial/gravimetry/gravity_filter.h"
#include "inertial/motion/analytic.h"
#include "inertial/motion/drape.h"

enum { N = 6000 };
static double x[N], y[N];

static const orr_gravity_filter filters[] = {
    {.kind = ORR_GRAVITY_GAUSSIAN, .length_s = 20},
    {.kind = ORR_GRAVITY_FIR, .length_s = 120},
    {.kind = ORR_GRAVITY_KALMAN, .length_s = 60, .model_mgal = 20, .place_m = 0.02}};

static void apply(const orr_gravity_filter *f, double step_s)
{
    orr_diag diag = {0};
    ASSERT_OK(orr_gravity_filter_apply(f, x, N, step_s, y, &diag), diag);
}

// Amplitude that is left of a sine of this period, inside.
static double passed(const orr_gravity_filter *f, double period_s)
{
    const double step = 0.5, w = 2 * ORR_PI / period_s;
    for (int k = 0; k < N; k++) x[k] = sin(w * step * k);
    apply(f, step);
    double c = 0, s = 0;
    const int whole = (int)(nearbyint(1000.0 / period_s) * period_s / step);
    for (int k = N / 2 - whole / 2; k < N / 2 + whole / 2; k++) {
        s += y[k] * sin(w * step * k) * 2 / whole;
        c += y[k] * cos(w * step * k) * 2 / whole;
    }
    assert_true(fabs(c) < 1e-3); // none of them delays
    return s;
}

// Constants pass whole, to the very ends; long waves pass, short ones do not; at its length the FIR passes half.
static void responses(void **state)
{
    (void)state;
    for (int f = 0; f < 3; f++) {
        for (int k = 0; k < N; k++) x[k] = 37.0;
        apply(&filters[f], 0.5);
        for (int k = 0; k < N; k++) ASSERT_NEAR(y[k], 37.0, 1e-6);
        assert_true(passed(&filters[f], 1000) > 0.97);
        assert_true(fabs(passed(&filters[f], 10)) < 0.01);
    }
    const double w = 2 * ORR_PI / 100.0 * 20.0;
    ASSERT_NEAR(passed(&filters[0], 100), exp(-0.5 * w * w), 1e-3); // the transform of a Gaussian
    ASSERT_NEAR(passed(&filters[1], 120), 0.5, 0.01);
    assert_true(passed(&filters[1], 60) < 0.02);
}

// The smoother is the best there is for what it assumes: on gravity of its model and noisy heights it beats the others at
// lengths of any kind.
static void the_smoother(void **state)
{
    (void)state;
    static double g[N], place[N + 2];
    const double step = 1.0, b = 1.0 / 60, sigma = 20, keep = exp(-b * step), renew = sqrt(1 - keep * keep);
    double u = 0, v = 0, best = 1e9, own = 0;
    for (int k = 0; k < N + 2; k++) place[k] = 0.02 * orr_rng_normal(5, 1, (uint64_t)k);
    for (int k = -1000; k < N; k++) { // two first-order processes in a row are one of second order
        u = keep * u + renew * orr_rng_normal(5, 2, (uint64_t)(k + 1000));
        v = keep * v + (1 - keep) * u;
        if (k < 0) continue;
        g[k] = sigma * sqrt(2.0) * v;
        x[k] = g[k] + (place[k + 2] - 2 * place[k + 1] + place[k]) / (step * step) / 1e-5;
    }
    for (double length = 10; length < 400; length *= 1.15)
        for (int f = 0; f < 2; f++) {
            orr_gravity_filter q = filters[f];
            q.length_s = length;
            apply(&q, step);
            double sum = 0;
            for (int k = 1300; k < N - 1300; k++) sum += (y[k] - g[k]) * (y[k] - g[k]);
            best = fmin(best, sum);
        }
    apply(&filters[2], step);
    for (int k = 1300; k < N - 1300; k++) own += (y[k] - g[k]) * (y[k] - g[k]);
    print_message("smoother %.3f mGal, best of the others %.3f\n", sqrt(own / (N - 2600)),
                  sqrt(best / (N - 2600)));
    assert_true(own < best);
}

static void refused(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_gravity_filter f = filters[0];
    f.length_s = 0;
    assert_int_equal(orr_gravity_filter_apply(&f, x, N, 1, y, &diag), ORR_E_ARG);
    assert_int_equal(orr_gravity_filter_apply(&filters[1], x, 100, 1, y, &diag), ORR_E_ARG);
    f = filters[2];
    f.place_m = 0;
    assert_int_equal(orr_gravity_filter_apply(&f, x, N, 1, y, &diag), ORR_E_ARG);
}

// Four lines North and South, three tie lines across, joined by turns; the lines have constants of their own and noise.
static void crossovers(void **state)
{
    (void)state;
    static double east[N], north[N], value[N];
    static const double constant[7] = {3, -2, 1, 0.5, -1, 2, -3.5};
    size_t n = 0;
    double e = 0, no = 0;
    for (int l = 0; l < 7; l++) {
        const bool tie = l >= 4;
        const double x0 = tie ? -2000 : 3000.0 * l,
                     y0 = tie ? 3000.0 + 4000.0 * (l - 4) : (l % 2 == 0 ? -1000 : 15000);
        const double dx = tie ? 50 : 0, dy = tie ? 0 : (l % 2 == 0 ? 50 : -50);
        for (int k = 0; k < 100; k++, n++) { // on the way, which turns all the time
            const double t = k / 100.0;
            east[n] = e + t * (x0 - e) + 800 * sin(9.5 * t * ORR_PI);
            north[n] = no + t * (y0 - no) + 800 * (1 - cos(9.5 * t * ORR_PI));
        }
        for (int k = 0; k < 320; k++, n++) {
            east[n] = x0 + dx * k;
            north[n] = y0 + dy * k;
            value[n] = 20 * sin(east[n] / 4000) * cos(north[n] / 5000) + constant[l];
        }
        e = east[n - 1];
        no = north[n - 1];
    }
    const orr_survey_series s = {.n = n, .step_s = 1, .east_m = east, .north_m = north, .mgal = value};
    orr_survey_line line[ORR_SURVEY_MOST_LINES];
    orr_crossover *c;
    orr_crossover_report r;
    size_t lines;
    orr_diag diag = {0};
    ASSERT_OK(orr_survey_lines(&s, 0.01, 200, 12, line, &lines, &diag), diag);
    assert_int_equal(lines, 7);
    ASSERT_OK(orr_crossovers(&s, line, lines, &c, &r, &diag), diag);
    assert_int_equal(r.n, 12);
    for (size_t k = 0; k < r.n; k++) {
        ASSERT_NEAR(c[k].difference_mgal, constant[c[k].a] - constant[c[k].b], 1e-3);
        ASSERT_NEAR(c[k].levelled_mgal, 0, 1e-3);
    }
    for (size_t k = 0; k < lines; k++)
        ASSERT_NEAR(line[k].level_mgal - line[0].level_mgal, constant[k] - constant[0], 1e-3);
    ASSERT_NEAR(r.levelled_rms_mgal, 0, 1e-3);
    assert_true(r.rms_mgal > 2);
    free(c);
    // Noise of 1 mGal a line and crossing is sqrt 2 of a difference, levelled or not.
    double sum = 0;
    for (uint64_t seed = 0; seed < 60; seed++) {
        static double noisy[N];
        for (size_t k = 0; k < n; k++) noisy[k] = value[k] + orr_rng_normal(seed, 9, k / 20);
        const orr_survey_series q = {.n = n, .step_s = 1, .east_m = east, .north_m = north, .mgal = noisy};
        ASSERT_OK(orr_crossovers(&q, line, lines, &c, &r, &diag), diag);
        sum += r.levelled_rms_mgal * r.levelled_rms_mgal / 60;
        free(c);
    }
    ASSERT_NEAR(sqrt(sum / 2), 1, 0.1);
    assert_int_equal(orr_survey_lines(&s, 0.01, 2000, 0, line, &lines, &diag), ORR_E_NODATA);
    orr_survey_line parallel[2] = {line[0], line[1]};
    parallel[0].to = parallel[1].to = 0;
    ASSERT_OK(orr_survey_lines(&s, 0.01, 200, 12, line, &lines, &diag), diag);
    memcpy(parallel, line, sizeof parallel);
    assert_int_equal(orr_crossovers(&s, parallel, 2, &c, &r, &diag), ORR_E_NODATA);
}

// A straight flight over a wave: height and vertical acceleration are the wave's, and the nose follows.
static void drape(void **state)
{
    (void)state;
    const orr_analytic_plan plan = {.origin = {0.97, 0.6, 1000},
                                    .n_terms = 1,
                                    .term = {{.kind = ORR_ANALYTIC_STRAIGHT, .velocity_mps = {0, 65, 0}}}};
    const orr_drape_wave wave = {.amplitude_m = 64, .wavelength_m = 880};
    orr_trajectory level, over;
    double vertical[2];
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, 60, &plan, &level, &diag), diag);
    ASSERT_OK(orr_trajectory_drape(&level, plan.origin, &wave, 1, 0.2, &over, vertical, &diag), diag);
    const double w = 2 * ORR_PI * 65 / 880;
    ASSERT_NEAR(vertical[1], 64 * w * w, 0.1); // 13.8 m/s^2: 2.4 g
    for (double t = 5; t < 55; t += 3.7) {
        orr_motion m;
        ASSERT_OK(orr_trajectory_evaluate(&over, t, &m, &diag), diag);
        ASSERT_NEAR(orr_earth_from_ecef(m.r_m).height_m, 1000 + 64 * sin(w * t), 0.01);
        ASSERT_NEAR(orr_motion_angles(&m).pitch_rad, atan(64 * 2 * ORR_PI / 880 * cos(w * t)), 1e-3);
    }
    orr_trajectory_free(&over);
    assert_int_equal(orr_trajectory_drape(&level, plan.origin, &wave, 0, 0.2, &over, NULL, &diag), ORR_E_ARG);
    const orr_drape_wave flat = {.amplitude_m = 1};
    assert_int_equal(orr_trajectory_drape(&level, plan.origin, &flat, 1, 0.2, &over, NULL, &diag), ORR_E_ARG);
    orr_trajectory_free(&level);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(responses), cmocka_unit_test(the_smoother),
                                       cmocka_unit_test(refused), cmocka_unit_test(crossovers),
                                       cmocka_unit_test(drape)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
