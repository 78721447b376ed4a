// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/chebyshev.h"
#include "core/constants.h"
#include "core/crc.h"

static void polynomials_are_cosines(void **state)
{
    (void)state;
    double t[ORR_CHEB_MAX_DEGREE + 1], d[ORR_CHEB_MAX_DEGREE + 1], dd[ORR_CHEB_MAX_DEGREE + 1];
    for (int i = 1; i < 40; i++) {
        double theta = ORR_PI * i / 40, x = cos(theta), s = sin(theta);
        orr_cheb_basis(ORR_CHEB_MAX_DEGREE, x, t, d, dd);
        for (int j = 0; j <= ORR_CHEB_MAX_DEGREE; j++) {
            // T_j(cos a) = cos ja, T' = j sin ja / sin a, (1 - x^2) T'' = x T' - j^2 T
            ASSERT_NEAR(t[j], cos(j * theta), 1e-13);
            ASSERT_NEAR(d[j], j * sin(j * theta) / s, 1e-13 * (1 + j * j / s));
            ASSERT_NEAR(dd[j], (x * d[j] - j * j * t[j]) / (s * s), 1e-11 * (1 + j * j / (s * s)));
        }
    }
    orr_cheb_basis(ORR_CHEB_MAX_DEGREE, 1, t, d, dd); // T_n'(1) = n^2, T_n''(1) = n^2 (n^2 - 1) / 3
    for (int j = 0; j <= ORR_CHEB_MAX_DEGREE; j++) {
        ASSERT_NEAR(t[j], 1, 0);
        ASSERT_NEAR(d[j], j * j, 0);
        ASSERT_NEAR(dd[j], j * j * (j * j - 1) / 3.0, 0);
    }
}

static void each_derivative_may_be_left_out(void **state)
{
    (void)state;
    enum { N = ORR_CHEB_MAX_DEGREE + 1 };
    double t[N], d[N], dd[N], only_t[N], only_d[N], only_dd[N];
    for (double x = -1; x <= 1; x += 0.125) {
        orr_cheb_basis(N - 1, x, t, d, dd);
        orr_cheb_basis(N - 1, x, only_t, NULL, only_dd);
        assert_memory_equal(t, only_t, sizeof t);
        assert_memory_equal(dd, only_dd, sizeof dd);
        orr_cheb_basis(N - 1, x, only_t, only_d, NULL);
        assert_memory_equal(d, only_d, sizeof d);
        orr_cheb_basis(N - 1, x, only_t, NULL, NULL);
        assert_memory_equal(t, only_t, sizeof t);
    }
}

// Value and derivatives of a series, as users of the basis sum it.
static double series(const double *c, int degree, double x, double *d, double *dd)
{
    double t[ORR_CHEB_MAX_DEGREE + 1], dt[ORR_CHEB_MAX_DEGREE + 1], ddt[ORR_CHEB_MAX_DEGREE + 1], v = 0;
    orr_cheb_basis(degree, x, t, dt, ddt);
    *d = *dd = 0;
    for (int j = 0; j <= degree; j++) {
        v += c[j] * t[j];
        *d += c[j] * dt[j];
        *dd += c[j] * ddt[j];
    }
    return v;
}

// exp(a x) has the coefficients 2 I_n(a) (the first I_0(a)); values of the modified Bessel functions at 1
// from Abramowitz and Stegun, table 9.8 and 9.11.
static void interpolant_of_the_exponential(void **state)
{
    (void)state;
    static const double bessel[] = {1.266065877752008336, 0.565159103992485027, 0.135747669767038281,
                                    0.022168424924331902, 0.002737120221046866, 0.000271463155956972};
    enum { N = 20 };
    double value[N + 1], c[N + 1];
    for (int k = 0; k <= N; k++) value[k] = exp(-cos(ORR_PI * k / N));
    orr_cheb_from_lobatto(N, value, c);
    for (int j = 0; j < 6; j++) ASSERT_NEAR(c[j], (j == 0 ? 1 : 2) * bessel[j], 2e-15);
    for (double x = -1; x <= 1; x += 0.01) {
        double d, dd;
        ASSERT_NEAR(series(c, N, x, &d, &dd), exp(x), 5e-15);
        ASSERT_NEAR(d, exp(x), 1e-12);
        ASSERT_NEAR(dd, exp(x), 1e-10);
    }
}

static void interpolant_passes_through_its_points(void **state)
{
    (void)state;
    for (int degree = 0; degree <= ORR_CHEB_MAX_DEGREE; degree++) {
        double value[ORR_CHEB_MAX_DEGREE + 1], c[ORR_CHEB_MAX_DEGREE + 1];
        for (int k = 0; k <= degree; k++) value[k] = cos(1.7 * k * k);
        orr_cheb_from_lobatto(degree, value, c);
        for (int k = 0; k <= degree; k++) {
            double x = degree > 0 ? -cos(ORR_PI * k / degree) : -1, d, dd;
            ASSERT_NEAR(series(c, degree, x, &d, &dd), value[k],
                        5e-14); // n terms of rounding, twice
        }
    }
}

static void crc24q_check_value(void **state)
{
    (void)state;
    // "check" of CRC-24/LTE-A's family: poly 0x864CFB, init 0, no reflection, over "123456789"
    assert_int_equal(orr_crc24q(0, (const uint8_t *)"123456789", 9), 0xCDE703);
    // in pieces, and zero over a message with its own parity
    uint8_t message[12] = "123456789";
    uint32_t crc = orr_crc24q(orr_crc24q(0, message, 4), message + 4, 5);
    assert_int_equal(crc, 0xCDE703);
    message[9] = (uint8_t)(crc >> 16);
    message[10] = (uint8_t)(crc >> 8);
    message[11] = (uint8_t)crc;
    assert_int_equal(orr_crc24q(0, message, 12), 0);
    // every burst of at most 24 bits is seen
    for (int at = 0; at < 72; at++) {
        uint8_t hurt[12];
        memcpy(hurt, message, 12);
        hurt[at / 8] ^= (uint8_t)(0x80 >> at % 8);
        hurt[(at + 23) / 8] ^= (uint8_t)(0x80 >> (at + 23) % 8);
        assert_int_not_equal(orr_crc24q(0, hurt, 12), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_cosines),
        cmocka_unit_test(each_derivative_may_be_left_out),
        cmocka_unit_test(interpolant_of_the_exponential),
        cmocka_unit_test(interpolant_passes_through_its_points),
        cmocka_unit_test(crc24q_check_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
