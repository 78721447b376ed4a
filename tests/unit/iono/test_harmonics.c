// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of low degrees, orthonormality by exact quadrature, closure under rotation, and the two
// evaluators.
#include "core/rng.h"
#include "core/vec.h"
#include "iono/field/harmonics.h"
#include "testing.h"

static double one(int degree, int n, int m, double lat, double lon)
{
    orr_harm_basis b;
    orr_diag diag = {0};
    assert_int_equal(orr_harm_basis_init(degree, &b, &diag), ORR_OK);
    double *c = calloc(b.size, sizeof *c);
    c[orr_harm_slot(&b, n, m)] = 1;
    double v = orr_harm_eval(&b, c, sin(lat), cos(lat), sin(lon), cos(lon));
    free(c);
    orr_harm_basis_free(&b);
    return v;
}

// Textbook P(n,m) times sqrt((2n+1)(2-d0m)(n-m)!/(n+m)!), written out.
static void test_closed_forms(void **state)
{
    (void)state;
    for (double lat = -1.5; lat < 1.55; lat += 0.25)
        for (double lon = -3; lon < 3.2; lon += 0.7) {
            double x = sin(lat), u = cos(lat);
            ASSERT_NEAR(one(0, 0, 0, lat, lon), 1, 1e-15);
            ASSERT_NEAR(one(1, 1, 0, lat, lon), sqrt(3) * x, 1e-14);
            ASSERT_NEAR(one(1, 1, 1, lat, lon), sqrt(3) * u * cos(lon), 1e-14);
            ASSERT_NEAR(one(1, 1, -1, lat, lon), sqrt(3) * u * sin(lon), 1e-14);
            ASSERT_NEAR(one(2, 2, 0, lat, lon), sqrt(5) * (3 * x * x - 1) / 2, 1e-14);
            ASSERT_NEAR(one(3, 2, 1, lat, lon), sqrt(15) * x * u * cos(lon), 1e-14);
            ASSERT_NEAR(one(7, 2, -2, lat, lon), sqrt(15) / 2 * u * u * sin(2 * lon), 1e-14);
            ASSERT_NEAR(one(4, 3, 2, lat, lon), sqrt(105) / 2 * x * u * u * cos(2 * lon), 1e-14);
            ASSERT_NEAR(one(15, 4, 0, lat, lon), 3.0 / 8 * (35 * pow(x, 4) - 30 * x * x + 3), 1e-13);
        }
}

// The mean square over the sphere of each function is 1 and of products of two is 0 (that is what the
// normalisation is for). Gauss-Legendre in sin(lat) by Newton, equal steps in longitude: exact for degree 15
// + 15.
static void test_orthonormal(void **state)
{
    (void)state;
    enum { N = 15, Q = 16, L = 32, K = 256 };
    orr_harm_basis b;
    assert_int_equal(orr_harm_basis_init(N, &b, NULL), ORR_OK);
    static double gram[K][K], row[K];
    for (int i = 0; i < Q; i++) {
        double x = cos(ORR_PI * (i + 0.75) / (Q + 0.5)), d = 1;
        for (int it = 0; it < 50; it++) {
            double p0 = 1, p1 = x;
            for (int n = 2; n <= Q; n++) {
                double p = ((2 * n - 1) * x * p1 - (n - 1) * p0) / n;
                p0 = p1;
                p1 = p;
            }
            d = Q * (x * p1 - p0) / (x * x - 1);
            x -= p1 / d;
        }
        double weight = 2 / ((1 - x * x) * d * d) / (2 * L);
        for (int k = 0; k < L; k++) {
            double lon = 2 * ORR_PI * k / L;
            orr_harm_row(&b, x, sqrt(1 - x * x), sin(lon), cos(lon), row);
            for (int r = 0; r < K; r++)
                for (int c = 0; c <= r; c++) gram[r][c] += weight * row[r] * row[c];
        }
    }
    for (int r = 0; r < K; r++)
        for (int c = 0; c <= r; c++) ASSERT_NEAR(gram[r][c], r == c, 1e-12); // 512 terms of size <= 31
    orr_harm_basis_free(&b);
}

// Eval (rows of all orders, Clenshaw) against row (plain recurrence), all degrees; packing there and back.
static void test_two_evaluators(void **state)
{
    (void)state;
    for (int degree = 0; degree <= ORR_HARM_MAX_DEGREE; degree++) {
        orr_harm_basis b;
        assert_int_equal(orr_harm_basis_init(degree, &b, NULL), ORR_OK);
        double *listed = calloc(3 * b.n_coef, sizeof *listed), *row = listed + b.n_coef,
               *back = row + b.n_coef;
        double *coef = calloc(b.size, sizeof *coef);
        for (size_t i = 0; i < b.n_coef; i++) listed[i] = orr_rng_normal(7, (uint64_t)degree, i);
        orr_harm_unpack(&b, listed, coef);
        orr_harm_pack(&b, coef, back);
        assert_memory_equal(listed, back, b.n_coef * sizeof *listed);
        for (int i = 0; i < 40; i++) {
            double lat = (orr_rng_uniform(8, 1, (uint64_t)i) - 0.5) * ORR_PI,
                   lon = 6.3 * orr_rng_uniform(8, 2, (uint64_t)i);
            if (i == 0) lat = ORR_PI / 2;
            if (i == 1) lat = -ORR_PI / 2;
            orr_harm_row(&b, sin(lat), fabs(cos(lat)), sin(lon), cos(lon), row);
            double sum = 0, scale = 1;
            for (size_t k = 0; k < b.n_coef; k++) {
                sum += row[k] * listed[k];
                scale += fabs(row[k] * listed[k]);
            }
            ASSERT_NEAR(orr_harm_eval(&b, coef, sin(lat), fabs(cos(lat)), sin(lon), cos(lon)), sum,
                        1e-13 * scale);
        }
        free(coef);
        free(listed);
        orr_harm_basis_free(&b);
    }
}

// Turning the coefficients is turning the point; and the functions of a degree are closed under any rotation:
// the degree's power at a rotated set of points is what it was (addition theorem: sum of squares of a degree
// is 2n+1).
static void test_rotation(void **state)
{
    (void)state;
    orr_harm_basis b;
    assert_int_equal(orr_harm_basis_init(15, &b, NULL), ORR_OK);
    double *c = calloc(2 * b.size, sizeof *c), *turned = c + b.size, row[256];
    for (size_t i = 0; i < 256; i++) row[i] = orr_rng_normal(9, 0, i);
    orr_harm_unpack(&b, row, c);
    orr_harm_turn(&b, 0.7, c, turned);
    for (double lat = -1.4; lat < 1.5; lat += 0.31)
        for (double lon = -3; lon < 3; lon += 0.9) {
            ASSERT_NEAR(orr_harm_eval(&b, turned, sin(lat), cos(lat), sin(lon - 0.7), cos(lon - 0.7)),
                        orr_harm_eval(&b, c, sin(lat), cos(lat), sin(lon), cos(lon)),
                        1e-11); // values of some 50
            orr_harm_row(&b, sin(lat), cos(lat), sin(lon), cos(lon), row);
            for (int n = 0; n <= 15; n++) {
                double sum = 0;
                for (int k = n * n; k < (n + 1) * (n + 1); k++) sum += row[k] * row[k];
                ASSERT_NEAR(sum, 2 * n + 1, 1e-12 * (2 * n + 1));
            }
        }
    free(c);
    orr_harm_basis_free(&b);
}

static void test_refusals(void **state)
{
    (void)state;
    orr_harm_basis b;
    orr_diag diag = {0};
    assert_int_equal(orr_harm_basis_init(-1, &b, &diag), ORR_E_ARG);
    assert_int_equal(orr_harm_basis_init(ORR_HARM_MAX_DEGREE + 1, &b, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "33"));
    orr_harm_basis_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_closed_forms),
                                       cmocka_unit_test(test_orthonormal),
                                       cmocka_unit_test(test_two_evaluators), cmocka_unit_test(test_rotation),
                                       cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
