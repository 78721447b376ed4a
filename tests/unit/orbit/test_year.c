// SPDX-License-Identifier: GPL-3.0-or-later
// Figs 8-9 of the source: the inclination of a satellite over a year swings with half the Moon's and half the
// Sun's period. A year is integrated with the smoother's own forces, read as the product's command reads it
// (true equator of date, mean of a revolution), and searched for its lines by least squares.
#include "testing.h"

#include <gsl/gsl_multifit.h>

#include "orbit/elements/lines.h"
#include "orbit/force/integrate.h"
#include "orbit/force/kepler.h"

#define DAYS 730 // two years: the half-yearly line then has four turns to be told from the trend
#define PER_REVOLUTION 24

// Least-squares amplitude and residual of a cosine and sine of period `period_d` beside those of `others` and
// a cubic.
static double residual_with(const double *t, const double *y, size_t n, const double *period_d,
                            size_t periods)
{
    const size_t p = 4 + 2 * periods;
    gsl_matrix *X = gsl_matrix_alloc(n, p), *cov = gsl_matrix_alloc(p, p);
    gsl_vector *c = gsl_vector_alloc(p), *v = gsl_vector_alloc(n);
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(n, p);
    for (size_t i = 0; i < n; i++) {
        double x = t[i] / DAYS - 0.5;
        gsl_vector_set(v, i, y[i]);
        for (size_t k = 0; k < 4; k++) gsl_matrix_set(X, i, k, pow(x, (double)k));
        for (size_t k = 0; k < periods; k++) {
            gsl_matrix_set(X, i, 4 + 2 * k, cos(2 * ORR_PI * t[i] / period_d[k]));
            gsl_matrix_set(X, i, 5 + 2 * k, sin(2 * ORR_PI * t[i] / period_d[k]));
        }
    }
    double chi2 = 0;
    gsl_multifit_linear(X, v, c, cov, &chi2, w);
    gsl_multifit_linear_free(w);
    gsl_matrix_free(X);
    gsl_matrix_free(cov);
    gsl_vector_free(c);
    gsl_vector_free(v);
    return chi2;
}

// Period near `guess` that leaves the least when the other line stands at `other`.
static double best_period(const double *t, const double *y, size_t n, double guess, double other)
{
    double best = 0, least = HUGE_VAL;
    for (double f = 0.93; f <= 1.07; f += 0.001) {
        double both[2] = {guess * f, other}, chi2 = residual_with(t, y, n, both, 2);
        if (chi2 < least) {
            least = chi2;
            best = guess * f;
        }
    }
    return best;
}

static void inclination_swings_with_half_a_month_and_half_a_year(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_time t0 = 0;
    ASSERT_OK(orr_time_parse("2023-01-01", NULL, &t0, &d), d);
    orr_sky *sky = NULL;
    ASSERT_OK(
        orr_sky_init(t0, orr_time_add_s(t0, (DAYS + 1) * 86400.0), ORR_SKY_GCRS, NULL, NULL, &sky, NULL, &d),
        d);
    orr_force force = {.sun_moon = true};
    ASSERT_OK(orr_gravity_field_init(&force.earth, 2, false, &d), d);
    orr_integrator *it = NULL;
    ASSERT_OK(orr_integrator_init(&force, sky, &it, &d), d);

    const orr_kepler start = {
        .a_m = 2.655e7, .e = 0.005, .i_rad = 0.96, .raan_rad = 1.0, .argp_rad = 0.5, .m_rad = 0};
    orr_vec3 r, v;
    orr_kepler_to_state(&start, ORR_EGM96_GM, &r, &v);
    double *t = malloc(DAYS * sizeof *t), *incl = malloc(DAYS * sizeof *incl), now = 0;
    const double period = 2 * ORR_PI * sqrt(pow(start.a_m, 3) / ORR_EGM96_GM);
    for (int day = 0; day < DAYS; day++) {
        double begin = 86400.0 * day;
        assert_int_equal(orr_integrate(it, now, begin - now, &r, &v), ORR_OK);
        now = begin;
        double sum = 0;
        for (int k = 0; k < PER_REVOLUTION; k++) { // mean over a revolution, as orrery elements --method mean
            orr_kepler el;
            orr_mat3 tod;
            orr_astro_gcrs_to_tod(orr_time_add_s(t0, now), &tod);
            assert_int_equal(
                orr_kepler_from_state(orr_mat3_apply(&tod, r), orr_mat3_apply(&tod, v), ORR_EGM96_GM, &el),
                ORR_OK);
            sum += el.i_rad / PER_REVOLUTION;
            assert_int_equal(orr_integrate(it, now, period / PER_REVOLUTION, &r, &v), ORR_OK);
            now += period / PER_REVOLUTION;
        }
        t[day] = day + 0.5 * period / 86400;
        incl[day] = sum * ORR_DEG_PER_RAD;
    }
    // Theory: the node of a GPS orbit goes by -0.039 deg/day, which moves the lines little: the Moon's half
    // draconic month seen from the node, 13.66 days (tropical 27.3216/2), the Sun's half tropical year,
    // 182.62 days, each against the moving node: 1/P = 2 (n_body - n_node).
    const double node = -0.039 / 360; // turns a day
    const double moon = 0.5 / (1 / 27.321582 - node), sun = 0.5 / (1 / 365.24219 - node);
    double found_sun = sun, found_moon = moon;
    for (int turn = 0; turn < 3; turn++) {
        found_moon = best_period(t, incl, DAYS, moon, found_sun);
        found_sun = best_period(t, incl, DAYS, sun, found_moon);
    }
    print_message("inclination: %.3f days (theory %.3f) and %.2f days (theory %.2f)\n", found_moon, moon,
                  found_sun, sun);
    ASSERT_NEAR(found_moon / moon, 1, 0.02);
    ASSERT_NEAR(found_sun / sun, 1, 0.02);
    // What `orrery elements --periods` looks through has its peaks there.
    const double line[2] = {moon, sun};
    for (int k = 0; k < 2; k++) {
        double best = 0, most = 0;
        for (double f = 0.85; f <= 1.15; f += 0.005) {
            double amplitude;
            ASSERT_OK(orr_line_amplitude(t, incl, DAYS, line[k] * f, false, &amplitude, NULL, &d), d);
            if (amplitude > most) most = amplitude, best = line[k] * f;
        }
        ASSERT_NEAR(best / line[k], 1, 0.02);
    }
    // Neither line is a fancy of the fit: without it, much more is left.
    const double lines[2] = {found_moon, found_sun};
    double both = residual_with(t, incl, DAYS, lines, 2);
    assert_true(residual_with(t, incl, DAYS, &lines[0], 1) > 2 * both);
    assert_true(residual_with(t, incl, DAYS, &lines[1], 1) > 2 * both);
    free(t);
    free(incl);
    orr_integrator_free(it);
    orr_sky_free(sky);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inclination_swings_with_half_a_month_and_half_a_year)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
