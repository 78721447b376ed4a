// SPDX-License-Identifier: GPL-3.0-or-later
// Solvers against the systems that they solve, and what they say about those without an answer.
#include "testing.h"

#include "core/linalg.h"
#include "core/rng.h"

enum { MOST = 60 };

// Symmetric positive definite: G G' + n E of random G, of a condition of a few.
static void make_definite(size_t n, uint64_t seed, double *a)
{
    double g[MOST * MOST];
    for (size_t i = 0; i < n * n; i++) g[i] = orr_rng_normal(seed, n, i);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double sum = i == j ? (double)n : 0;
            for (size_t k = 0; k < n; k++) sum += g[i * n + k] * g[j * n + k];
            a[i * n + j] = sum;
        }
}

static void definite_systems_are_solved(void **state)
{
    (void)state;
    double a[MOST * MOST], l[MOST * MOST], x[MOST], b[MOST], y[MOST];
    for (size_t n = 1; n <= MOST; n++) {
        make_definite(n, 3, a);
        for (size_t i = 0; i < n; i++) {
            x[i] = orr_rng_normal(4, n, i);
            b[i] = 0;
        }
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++) b[i] += a[i * n + j] * x[j];
        for (size_t i = 0; i < n; i++) // the lower triangle alone is read
            for (size_t j = 0; j < n; j++) l[i * n + j] = j <= i ? a[i * n + j] : (double)NAN;
        assert_int_equal(orr_cholesky_factor(l, n, 1e-6), ORR_OK);
        memcpy(y, b, n * sizeof *y);
        assert_int_equal(orr_cholesky_solve(l, n, y), ORR_OK);
        for (size_t i = 0; i < n; i++) ASSERT_NEAR(y[i], x[i], 1e-13); // condition 5, rounding of n terms
        memcpy(y, b, n * sizeof *y);
        assert_int_equal(orr_cholesky_solve_lower(l, n, y), ORR_OK); // b' a^-1 b = |L^-1 b|^2
        double squared = 0, expected = 0;
        for (size_t i = 0; i < n; i++) {
            squared += y[i] * y[i];
            expected += b[i] * x[i];
        }
        ASSERT_NEAR(squared / expected, 1, 1e-13);
        assert_int_equal(orr_cholesky_invert(l, n), ORR_OK);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++) {
                double sum = 0;
                for (size_t k = 0; k < n; k++) sum += l[i * n + k] * a[k * n + j];
                ASSERT_NEAR(sum, i == j ? 1 : 0, 1e-13);
            }
    }
}

static void what_is_not_definite_is_said(void **state)
{
    (void)state;
    double indefinite[4] = {1, 0, 2, 1}, negative[1] = {-1}, none[1] = {(double)NAN};
    assert_int_equal(orr_cholesky_factor(indefinite, 2, 0), ORR_E_NUMERIC); // eigenvalues 3 and -1
    assert_int_equal(orr_cholesky_factor(negative, 1, 0), ORR_E_NUMERIC);
    assert_int_equal(orr_cholesky_factor(none, 1, 0), ORR_E_NUMERIC);
    double hidden[4] = {1, 0, (double)NAN, 1};
    assert_int_equal(orr_cholesky_factor(hidden, 2, 0), ORR_E_NUMERIC);
    // Its second pivot is 1e-8: positive, and less than is asked for.
    double weak[4] = {1, 0, 1, 1 + 1e-8}, again[4] = {1, 0, 1, 1 + 1e-8};
    assert_int_equal(orr_cholesky_factor(weak, 2, 1e-10), ORR_OK);
    assert_int_equal(orr_cholesky_factor(again, 2, 1e-6), ORR_E_NUMERIC);
}

// Metres beside micrometres: a definite matrix whose unknowns are scaled by powers of ten, within a larger one.
static void unknowns_of_different_sizes_are_solved(void **state)
{
    (void)state;
    enum { STRIDE = 70, COLUMNS = 4 };
    double a[MOST * MOST], wide[MOST * STRIDE], x[MOST * COLUMNS], b[MOST * COLUMNS], size[MOST];
    for (size_t n = 1; n <= MOST; n++) {
        make_definite(n, 7, a);
        for (size_t i = 0; i < n; i++) size[i] = pow(10, 24 * orr_rng_uniform(8, n, i) - 12);
        for (size_t i = 0; i < n * COLUMNS; i++) {
            x[i] = orr_rng_normal(9, n, i) / size[i / COLUMNS];
            b[i] = 0;
        }
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++) {
                wide[i * STRIDE + j] = j <= i ? a[i * n + j] * size[i] * size[j] : (double)NAN;
                for (size_t c = 0; c < COLUMNS; c++)
                    b[i * COLUMNS + c] += a[i * n + j] * size[i] * size[j] * x[j * COLUMNS + c];
            }
        assert_int_equal(orr_symmetric_solve(wide, STRIDE, n, b, COLUMNS), ORR_OK);
        for (size_t i = 0; i < n * COLUMNS; i++)
            ASSERT_NEAR((b[i] - x[i]) * size[i / COLUMNS], 0, 1e-12); // condition 5, values of one
    }
    double indefinite[4] = {1, 2, 2, 1}, weak[4] = {1, 1, 1, 1 + 1e-15}, y[2] = {1, 1};
    assert_int_equal(orr_symmetric_solve(indefinite, 2, 2, y, 1), ORR_E_NUMERIC);
    assert_int_equal(orr_symmetric_solve(weak, 2, 2, y, 1), ORR_E_NUMERIC);
    assert_int_equal(orr_symmetric_solve(wide, STRIDE, ORR_SYMMETRIC_MOST + 1, b, 1), ORR_E_ARG);
}

// Random bands below a dominant diagonal.
static void band_systems_are_solved(void **state)
{
    (void)state;
    enum { N = 200, COLUMNS = 3 };
    for (size_t band = 1; band <= 5; band++) {
        double a[N * 6] = {0}, x[N * COLUMNS], b[N * COLUMNS] = {0};
        const size_t w = band + 1;
        for (size_t i = 0; i < N; i++)
            for (size_t d = 0; d < w && i + d < N; d++)
                a[i * w + d] = d == 0 ? 2.0 * (double)band : orr_rng_uniform(5, band, i * w + d) - 0.5;
        for (size_t i = 0; i < N * COLUMNS; i++) x[i] = orr_rng_normal(6, band, i);
        for (size_t j = 0; j < N; j++)
            for (size_t d = 0; d < w && j + d < N; d++)
                for (size_t c = 0; c < COLUMNS; c++) {
                    b[(j + d) * COLUMNS + c] += a[j * w + d] * x[j * COLUMNS + c];
                    if (d > 0) b[j * COLUMNS + c] += a[j * w + d] * x[(j + d) * COLUMNS + c];
                }
        double factor[N * 6], one[N];
        memcpy(factor, a, N * w * sizeof *a);
        assert_int_equal(orr_band_factor(factor, N, band), ORR_OK);
        for (int again = 0; again < 2; again++) { // a factor serves any number of right sides
            for (size_t i = 0; i < N; i++) one[i] = b[i * COLUMNS + (size_t)again];
            assert_int_equal(orr_band_factored(factor, N, band, one), ORR_OK);
            for (size_t i = 0; i < N; i++) ASSERT_NEAR(one[i], x[i * COLUMNS + (size_t)again], 1e-12);
        }
        assert_int_equal(orr_band_solve(a, N, band, b, COLUMNS), ORR_OK);
        // Diagonally dominant by a factor of two: a condition below 3.
        for (size_t i = 0; i < N * COLUMNS; i++) ASSERT_NEAR(b[i], x[i], 1e-14 * (1 + fabs(x[i])) * 10);
    }
    double indefinite[6] = {1, 2, 1, 2, 1, 0}, y[3] = {1, 1, 1};
    assert_int_equal(orr_band_solve(indefinite, 3, 1, y, 1), ORR_E_NUMERIC);
}

// A parabola through noisy values: the residual is normal to the columns, which is what makes it the least.
static void least_squares_leave_a_normal_residual(void **state)
{
    (void)state;
    enum { ROWS = 40, N = 3 };
    double a[ROWS * N], b[ROWS], kept_a[ROWS * N], kept_b[ROWS], tau[N], x[N];
    for (size_t i = 0; i < ROWS; i++) {
        const double t = (double)i / ROWS;
        kept_a[i * N] = a[i * N] = 1;
        kept_a[i * N + 1] = a[i * N + 1] = t;
        kept_a[i * N + 2] = a[i * N + 2] = t * t;
        kept_b[i] = b[i] = 1 - 2 * t + 3 * t * t + orr_rng_normal(9, 0, i);
    }
    assert_int_equal(orr_least_squares(a, ROWS, N, b, tau, x), ORR_OK);
    for (size_t j = 0; j < N; j++) {
        double dot = 0;
        for (size_t i = 0; i < ROWS; i++) {
            double residual = kept_b[i];
            for (size_t k = 0; k < N; k++) residual -= kept_a[i * N + k] * x[k];
            dot += residual * kept_a[i * N + j];
        }
        ASSERT_NEAR(dot, 0, 1e-12);
    }
    // R x = Q' b is what is left for whoever goes on from there.
    for (size_t i = 0; i < N; i++) {
        double sum = 0;
        for (size_t j = i; j < N; j++) sum += a[i * N + j] * x[j];
        ASSERT_NEAR(sum, b[i], 1e-12);
    }
    double equal[3 * 2] = {1, 0, 0, 0, 0, 0}, right[3] = {1, 1, 1};
    assert_int_equal(orr_least_squares(equal, 3, 2, right, tau, x), ORR_E_NUMERIC);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definite_systems_are_solved),
        cmocka_unit_test(what_is_not_definite_is_said),
        cmocka_unit_test(unknowns_of_different_sizes_are_solved),
        cmocka_unit_test(band_systems_are_solved),
        cmocka_unit_test(least_squares_leave_a_normal_residual),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
