// SPDX-License-Identifier: GPL-3.0-or-later
// Multiple signal messages at their limits: clocks of the systems, lock time indicators, masks that are full, what fields cannot hold.
#include "src/scenario/receiver/msm.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/nan.h"
#include "testing.h"

#define MS_M (ORR_LIGHT_MPS * 1e-3)

static uint64_t bits(const orr_rtcm_frame *f, size_t from, size_t n)
{
    uint64_t v = 0;
    for (size_t k = from; k < from + n; k++) v = v << 1 | (f->data[3 + k / 8] >> (7 - k % 8) & 1u);
    return v;
}

static int64_t signed_bits(const orr_rtcm_frame *f, size_t from, size_t n)
{
    const int64_t v = (int64_t)bits(f, from, n);
    return v >> (n - 1) != 0 ? v - (INT64_C(1) << n) : v;
}

static orr_time instant(const char *text)
{
    orr_time t;
    orr_diag diag = {0};
    ASSERT_OK(orr_time_parse(text, NULL, &t, &diag), diag);
    return t;
}

static void every_system_has_its_clock(void **state)
{
    (void)state;
    // The Sunday on which the GPS week begins, half a second before and after.
    assert_int_equal(orr_msm_epoch('G', instant("2025-03-22T23:59:59.5"), NULL), 604799500);
    assert_int_equal(orr_msm_epoch('E', instant("2025-03-23T00:00:00"), NULL), 0);
    assert_int_equal(orr_msm_epoch('C', instant("2025-03-23T00:00:13.999"), NULL), 604799999);
    assert_int_equal(orr_msm_epoch('C', instant("2025-03-23T00:00:14"), NULL), 0);
    // Moscow's Sunday begins three hours ahead of UTC's, 18 s behind GPS.
    assert_int_equal(orr_msm_epoch('R', instant("2025-03-22T20:59:59.999Z"), NULL), 6u << 27 | 86399999u);
    assert_int_equal(orr_msm_epoch('R', instant("2025-03-22T21:00:18"), NULL), 0);
    // The leap second at the end of 2016, a Saturday, is within Moscow's Sunday: 02:59:60 and 03:00:00.
    assert_int_equal(orr_msm_epoch('R', instant("2016-12-31T23:59:59Z"), NULL), 10799000);
    assert_int_equal(orr_msm_epoch('R', instant("2017-01-01T00:00:01Z"), NULL), 10801000);
}

static void lock_times_are_the_tables(void **state)
{
    (void)state;
    // Table 3.5-74: 2^(i + 4) ms from 1 on; table 3.5-75: 32 steps of 2^k ms each behind 64 of one.
    assert_int_equal(orr_msm_lock4(31), 0);
    assert_int_equal(orr_msm_lock7(63), 63);
    for (unsigned i = 1; i <= 15; i++) {
        assert_int_equal(orr_msm_lock4(INT64_C(1) << (i + 4)), i);
        assert_int_equal(orr_msm_lock4((INT64_C(1) << (i + 4)) - 1), i - 1);
    }
    assert_int_equal(orr_msm_lock4(INT64_C(1) << 40), 15);
    static const struct { // the least of each stretch, as the table has it
        unsigned i;
        int64_t ms;
    } table[] = {{64, 64},    {96, 128},    {128, 256},      {160, 512},     {192, 1024},
                 {224, 2048}, {352, 32768}, {672, 33554432}, {704, 67108864}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        assert_int_equal(orr_msm_lock7(table[k].ms), table[k].i);
        assert_int_equal(orr_msm_lock7(table[k].ms - 1), table[k].i - 1);
    }
    assert_int_equal(orr_msm_lock7(INT64_MAX), 704);
}

static orr_msm_cell cell_of(char system, int number, int signal, double range_m)
{
    const orr_sat sat = orr_sat_make(system, number);
    return (orr_msm_cell){.sat = sat,
                          .satellite = (uint8_t)orr_msm_satellite(sat),
                          .signal = (uint8_t)signal,
                          .code_m = range_m,
                          .phase_m = range_m,
                          .cn0_dbhz = 45};
}

static void numbers_of_satellites(void **state)
{
    (void)state;
    assert_int_equal(orr_msm_satellite(orr_sat_make('S', 20)), 1); // PRN 120
    assert_int_equal(orr_msm_satellite(orr_sat_make('S', 58)), 39);
    assert_int_equal(orr_msm_satellite(orr_sat_make('S', 59)), 0);
    assert_int_equal(orr_msm_satellite(orr_sat_make('J', 7)), 7);
    assert_int_equal(orr_msm_satellite(orr_sat_make('C', 63)), 63);
    assert_int_equal(orr_msm_satellite(orr_sat_make('R', 25)), 0);
    assert_int_equal(orr_msm_satellite(orr_sat_make('L', 1)), 0);
    static const int numbers[] = {1077, 1087, 1097, 1107, 1117, 1127, 1137};
    for (size_t k = 0; k < 7; k++) assert_int_equal(orr_msm_number("GRESJCI"[k], 7), numbers[k]);
    // No signal shares its number with another of its system.
    size_t n;
    const orr_signal *s = orr_signals(&n);
    for (size_t k = 0; k < n; k++)
        for (size_t j = 0; j < k; j++)
            if (s[j].system == s[k].system && orr_msm_signal(&s[k]) != 0)
                assert_int_not_equal(orr_msm_signal(&s[j]), orr_msm_signal(&s[k]));
}

static void masks_hold_64_cells(void **state)
{
    (void)state;
    enum { SATS = 32, SIGNALS = 6 };
    static const int signal[SIGNALS] = {2, 4, 10, 17, 24, 32};
    orr_msm_cell cell[SATS * SIGNALS];
    for (int i = 0; i < SATS; i++)
        for (int k = 0; k < SIGNALS; k++)
            cell[SIGNALS * i + k] = cell_of('G', i + 1, signal[k], 2e7 + 1e5 * i);
    size_t used = 0;
    for (int message = 0; used < SATS * SIGNALS; message++) {
        orr_rtcm_frame f;
        const orr_msm_head h = {.msm = 7, .station = 4095, .epoch = 5, .more = false};
        const size_t n = orr_msm_encode(&h, cell + used, SATS * SIGNALS - used, &f);
        assert_int_equal(n, message < 3 ? 60 : 12); // ten satellites of six signals
        used += n;
        assert_true(f.n > 0 && f.n <= sizeof f.data);
        assert_int_equal(bits(&f, 12, 12), 4095);
        assert_int_equal(bits(&f, 54, 1), used < SATS * SIGNALS);
    }
}

static void what_does_not_fit_is_not_valid(void **state)
{
    (void)state;
    orr_rtcm_frame f;
    const orr_msm_head h = {.msm = 7};
    const size_t body = 169 + 1;                          // one cell: head, masks, mask of cells
    orr_msm_cell x = cell_of('G', 5, 2, 254.9995 * MS_M); // its rough range is the last that there is
    assert_int_equal(orr_msm_encode(&h, &x, 1, &f), 1);
    assert_int_equal(bits(&f, body, 8), 254);
    x.code_m = 255 * MS_M;
    (void)orr_msm_encode(&h, &x, 1, &f);
    assert_int_equal(bits(&f, body, 8), 255);
    assert_int_equal(signed_bits(&f, body + 36, 20), -(1 << 19));
    assert_int_equal(signed_bits(&f, body + 56, 24), -(1 << 23));
    x = cell_of('G', 5, 2, 2e7);
    x.rate_mps = 9000; // of a satellite that is no navigation satellite's
    x.phase_m = ORR_NAN;
    (void)orr_msm_encode(&h, &x, 1, &f);
    assert_int_equal(signed_bits(&f, body + 22, 14), -8192);
    assert_int_equal(signed_bits(&f, body + 56, 24), -(1 << 23));
    assert_int_equal(signed_bits(&f, body + 101, 15), -16384);
    // Codes of one satellite: 290 m apart, both within reach of their middle; 600 m apart neither.
    for (int far = 0; far < 2; far++) {
        orr_msm_cell two[2] = {cell_of('G', 5, 2, 2e7), cell_of('G', 5, 24, 2e7 + (far ? 1200 : 290))};
        (void)orr_msm_encode(&h, two, 2, &f);
        const double rough = (double)bits(&f, 171, 8) + (double)bits(&f, 183, 10) / 1024;
        for (size_t k = 0; k < 2; k++) {
            const int64_t fine = signed_bits(&f, 207 + 20 * k, 20);
            if (far)
                assert_int_equal(fine, -(1 << 19));
            else
                ASSERT_NEAR((rough + (double)fine / 536870912) * MS_M, two[k].code_m,
                            0.5 * MS_M / 536870912 + 1e-7);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_system_has_its_clock),     cmocka_unit_test(lock_times_are_the_tables),
        cmocka_unit_test(numbers_of_satellites),          cmocka_unit_test(masks_hold_64_cells),
        cmocka_unit_test(what_does_not_fit_is_not_valid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
