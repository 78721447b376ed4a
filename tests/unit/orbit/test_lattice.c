// SPDX-License-Identifier: GPL-3.0-or-later
// Integer least squares: lattices whose nearest point is known, and small ones where all points can be tried.
#include "testing.h"

#include "core/rng.h"
#include "orbit/navdata/lattice.h"

enum { ENOUGH = 100000 };

static double distance(size_t n, const double *R, const double *y, const double *z)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        double d = -y[i];
        for (size_t j = i; j < n; j++) d += R[i * n + j] * z[j];
        sum += d * d;
    }
    return sum;
}

// An upper triangular integer matrix with ones on the diagonal spans the lattice of all integers, in a basis
// that is as bad as its entries are large; the nearest point to y is y rounded.
static void the_integers_in_a_bad_basis(void **state)
{
    (void)state;
    for (uint64_t run = 0; run < 50; run++) {
        enum { n = 15 };
        double R[n * n] = {0}, y[n], z[n];
        for (size_t i = 0; i < n; i++) {
            y[i] = 10 * orr_rng_uniform(1, run, i) - 5;
            for (size_t j = i; j < n; j++)
                R[i * n + j] = i == j ? 1 : round(6 * orr_rng_uniform(2, run, n * i + j) - 3);
        }
        assert_int_equal(orr_lattice_closest(n, R, y, ENOUGH, z), ORR_OK);
        for (size_t i = 0; i < n; i++) {
            double point = 0;
            for (size_t j = i; j < n; j++) point += R[i * n + j] * z[j];
            ASSERT_NEAR(point, round(y[i]), 1e-6); // z reaches 1e8: integers, exact in a double
        }
    }
}

static void every_point_is_tried(void **state)
{
    (void)state;
    size_t better = 0;
    for (uint64_t run = 0; run < 500; run++) {
        enum { n = 3 };
        double R[n * n] = {0}, y[n], z[n], rounded[n], best = HUGE_VAL;
        for (size_t i = 0; i < n; i++) {
            y[i] = 4 * orr_rng_uniform(1, run, i) - 2;
            R[i * n + i] = 0.3 + orr_rng_uniform(2, run, i);
            for (size_t j = i + 1; j < n; j++) R[i * n + j] = 3 * orr_rng_uniform(3, run, n * i + j) - 1.5;
        }
        for (int a = -60; a <= 60; a++)
            for (int b = -60; b <= 60; b++)
                for (int c = -10; c <= 10; c++) {
                    double d = distance(n, R, y, (double[]){a, b, c});
                    if (d < best) best = d;
                }
        assert_int_equal(orr_lattice_closest(n, R, y, ENOUGH, z), ORR_OK);
        ASSERT_NEAR(distance(n, R, y, z), best, 1e-12);
        // Rounding one coordinate after the other in the basis as it is: never better, often worse.
        for (size_t k = n; k-- > 0;) {
            double s = y[k];
            for (size_t j = k + 1; j < n; j++) s -= R[k * n + j] * rounded[j];
            rounded[k] = round(s / R[k * n + k]);
        }
        double plain = distance(n, R, y, rounded);
        assert_true(best <= plain + 1e-12);
        better += best < plain - 1e-12;
    }
    assert_true(better > 50);
}

static void a_limited_search_still_gives_a_point(void **state)
{
    (void)state;
    enum { n = 15 };
    double R[n * n] = {0}, y[n], z[n], last = HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        y[i] = 100 * orr_rng_uniform(1, 1, i);
        for (size_t j = i; j < n; j++) R[i * n + j] = orr_rng_uniform(2, 1, n * i + j) - 0.5;
    }
    static const size_t limit[] = {0, 1, 10, 100, 1000, ENOUGH};
    for (size_t k = 0; k < sizeof limit / sizeof limit[0]; k++) {
        assert_int_equal(orr_lattice_closest(n, R, y, limit[k], z), ORR_OK);
        double d = distance(n, R, y, z);
        assert_true(isfinite(d) && d <= last + 1e-9);
        last = d;
    }
}

static void what_spans_no_lattice_is_refused(void **state)
{
    (void)state;
    double singular[4] = {1, 2, 0, 0}, nan[4] = {1, (double)NAN, 0, 1}, y[2] = {0.4, 0.2}, z[2];
    assert_int_equal(orr_lattice_closest(2, singular, y, 10, z), ORR_E_NUMERIC);
    assert_int_equal(orr_lattice_closest(2, nan, y, 10, z), ORR_E_NUMERIC);
    assert_int_equal(orr_lattice_closest(0, singular, y, 10, z), ORR_E_ARG);
    assert_int_equal(orr_lattice_closest(ORR_LATTICE_MAX + 1, singular, y, 10, z), ORR_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_integers_in_a_bad_basis),
                                       cmocka_unit_test(every_point_is_tried),
                                       cmocka_unit_test(a_limited_search_still_gives_a_point),
                                       cmocka_unit_test(what_spans_no_lattice_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
