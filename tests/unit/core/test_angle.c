// SPDX-License-Identifier: GPL-3.0-or-later
// orr_atan2 against the C library's, in all quadrants, at the table's edges and where one side is tiny; orr_turn_sincos likewise.
#include "core/angle.h"

#include <math.h>

#include "core/constants.h"
#include "core/rng.h"
#include "testing.h"

static void it_is_the_librarys(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 400000; k++) {
        const double a = (orr_rng_uniform(1, 1, k) - 0.5) * 2 * ORR_PI,
                     r = exp(60 * (orr_rng_uniform(1, 2, k) - 0.5));
        const double y = r * sin(a), x = r * cos(a);
        ASSERT_NEAR(orr_atan2(y, x), atan2(y, x),
                    4.5e-16 * (fabs(a) > 1 ? fabs(a) : 1)); // an ulp of the result
    }
    // The table's nodes, its middles, and their neighbours, where the rounded quotient may fall to either side.
    for (int k = 0; k <= 256; k++)
        for (int side = -1; side <= 1; side++) {
            const double y = k / 256.0 * (1 + side * 1e-15);
            ASSERT_NEAR(orr_atan2(y, 1), atan2(y, 1), 3e-16);
            ASSERT_NEAR(orr_atan2(-1, y), atan2(-1, y), 5e-16);
        }
}

static void small_angles_keep_their_digits(void **state)
{
    (void)state;
    for (double y = 1e-3; y > 1e-140; y /= 7) ASSERT_NEAR(orr_atan2(y, 1) / y, atan2(y, 1) / y, 3e-16);
}

static void axes_are_exact(void **state)
{
    (void)state;
    static const double at[][2] = {{0.0, 1},  {-0.0, 1},  {0.0, -1},   {-0.0, -1},  {1, 0.0},
                                   {-1, 0.0}, {0.0, 0.0}, {-0.0, 0.0}, {0.0, -0.0}, {-0.0, -0.0}};
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        const double a = orr_atan2(at[k][0], at[k][1]), b = atan2(at[k][0], at[k][1]);
        assert_true(a == b && signbit(a) == signbit(b));
    }
}

static void turns_wrap(void **state)
{
    (void)state;
    double s, c;
    for (uint64_t k = 0; k < 200000; k++) {
        const uint64_t turn = orr_rng_u64(1, 3, k);
        const long double a = 2 * 3.14159265358979323846L * 0x1p-64L * (long double)(int64_t)turn;
        orr_turn_sincos(turn, &s, &c);
        ASSERT_NEAR(s, (double)sinl(a), 3e-16);
        ASSERT_NEAR(c, (double)cosl(a), 3e-16);
    }
    for (int eighth = 0; eighth < 8; eighth++) // borders of the series, to either side
        for (int side = -1; side <= 1; side++) {
            orr_turn_sincos(((uint64_t)eighth << 61) + (uint64_t)(int64_t)side, &s, &c);
            ASSERT_NEAR(s, sin(ORR_PI / 4 * eighth), 1e-15); // the angle is rounded
            ASSERT_NEAR(c, cos(ORR_PI / 4 * eighth), 1e-15);
        }
    static const int quarter[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    for (uint64_t q = 0; q < 4; q++) {
        orr_turn_sincos(q << 62, &s, &c);
        assert_true(s == quarter[q][0] && c == quarter[q][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_librarys),
        cmocka_unit_test(small_angles_keep_their_digits),
        cmocka_unit_test(axes_are_exact),
        cmocka_unit_test(turns_wrap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
