// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics against sorting, and the growth of arrays.
#include "testing.h"

#include "core/array.h"
#include "core/rng.h"
#include "core/robust.h"

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void order_statistics_are_those_of_the_sorted_values(void **state)
{
    (void)state;
    double x[60], sorted[60], work[60];
    for (size_t n = 1; n <= 60; n++) {
        for (size_t i = 0; i < n; i++) // every other one has equals
            x[i] = i % 2 == 0 ? orr_rng_normal(7, n, i) : floor(3 * orr_rng_uniform(8, n, i));
        memcpy(sorted, x, n * sizeof *x);
        qsort(sorted, n, sizeof *sorted, ascending);
        for (size_t k = 0; k < n; k++) {
            memcpy(work, x, n * sizeof *x);
            ASSERT_NEAR(orr_order_statistic(work, n, k), sorted[k], 0);
        }
        memcpy(work, x, n * sizeof *x);
        ASSERT_NEAR(orr_upper_median(work, n), sorted[n / 2], 0);
        memcpy(work, x, n * sizeof *x);
        ASSERT_NEAR(orr_median(work, n), n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2,
                    0);
    }
}

// The median of |x| times the constant is the standard deviation of normal noise, whatever a tenth of it is.
static void outliers_do_not_move_the_sigma(void **state)
{
    (void)state;
    enum { N = 40000 };
    double *x = malloc(N * sizeof *x);
    assert_non_null(x);
    for (size_t i = 0; i < N; i++) x[i] = fabs(2.5 * orr_rng_normal(1, 2, i));
    // The scatter of a median of N sizes is 1.17 sigma / sqrt(N) = 0.015: five of them.
    ASSERT_NEAR(ORR_SIGMA_PER_MAD * orr_median(x, N), 2.5, 0.075);
    for (size_t i = 0; i < N; i += 1000) x[i] = 1e9;
    ASSERT_NEAR(ORR_SIGMA_PER_MAD * orr_median(x, N), 2.5, 0.085);
    free(x);
}

static void arrays_grow_and_keep_what_they_hold(void **state)
{
    (void)state;
    struct pair {
        int64_t a;
        double b;
    } *list = NULL;
    for (size_t n = 0; n < 3000; n++) {
        assert_true(ORR_ARRAY_GROW(list, n));
        list[n] = (struct pair){(int64_t)n, 0.5 * (double)n}; // past the end is what the sanitizers see
        assert_true(list[n / 2].a == (int64_t)(n / 2));
    }
    for (size_t n = 0; n < 3000; n++) ASSERT_NEAR(list[n].b, 0.5 * (double)n, 0);
    for (size_t n = 0; n < 40; n++) { // emptied and filled again
        assert_true(ORR_ARRAY_GROW(list, n));
        list[n].a = -1;
    }
    free(list);
}

static void an_array_without_memory_stays_as_it_was(void **state)
{
    (void)state;
    char *list = NULL;
    assert_true(orr_array_grow(&list, 0, 1));
    char *before = list;
    list[15] = 'x';
    assert_false(
        orr_array_grow(&list, (size_t)1 << (8 * sizeof(size_t) - 2), 16)); // 2^63 elements of 16 bytes
    assert_ptr_equal(list, before);
    assert_int_equal(list[15], 'x');
    free(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_statistics_are_those_of_the_sorted_values),
        cmocka_unit_test(outliers_do_not_move_the_sigma),
        cmocka_unit_test(arrays_grow_and_keep_what_they_hold),
        cmocka_unit_test(an_array_without_memory_stays_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
