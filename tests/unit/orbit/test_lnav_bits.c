// SPDX-License-Identifier: GPL-3.0-or-later
// LNAV bits read back by a decoder of the test's own, written from the figures of IS-GPS-200N: field by
// field, and parity by the receiver's masks over D29* D30* d1..d24.
#include "testing.h"

#include "lnav_parity.h"

#include "core/rng.h"
#include "orbit/navdata/lnav_bits.h"

// Data bit `n` (1..300) of a received subframe, with D30* of the word before taken out.
static uint32_t bit(const orr_lnav_subframe *s, int n)
{
    int w = (n - 1) / 30, k = (n - 1) % 30;
    uint32_t raw = s->word[w] >> (29 - k) & 1u;
    uint32_t d30 = w > 0 && k < 24 ? s->word[w - 1] & 1u : 0;
    return raw ^ d30;
}

static uint32_t get(const orr_lnav_subframe *s, int first, int n)
{
    uint32_t v = 0;
    for (int k = 0; k < n; k++) v = v << 1 | bit(s, first + k);
    return v;
}

static double get_signed(const orr_lnav_subframe *s, int first, int n)
{
    uint32_t v = get(s, first, n);
    return v >> (n - 1) ? (double)v - ldexp(1, n) : (double)v;
}

static double get_split(const orr_lnav_subframe *s, int first1, int n1, int first2, int n2, bool is_signed)
{
    uint32_t v = get(s, first1, n1) << n2 | get(s, first2, n2);
    int n = n1 + n2;
    return is_signed && v >> (n - 1) ? (double)v - ldexp(1, n) : (double)v;
}

#define PI_ ORR_PI

static orr_nav_eph random_record(uint64_t n)
{
#define U(k) orr_rng_uniform(11, (k), n)
#define S(k) (2 * U(k) - 1)
    orr_nav_eph e = {.sat = orr_sat_parse("G05"), .kind = ORR_NAV_KEPLER, .message = ORR_NAV_LNAV};
    e.toe = e.toc = orr_time_from_week(2300 + (int32_t)n, (int64_t)(16 * floor(37799 * U(0))) * ORR_NS_PER_S);
    int32_t week;
    int64_t sow;
    orr_time_week(e.toe, &week, &sow);
    e.week = week;
    e.af0_s = 9e-4 * S(1), e.af1_sps = 3e-9 * S(2), e.af2_sps2 = 3e-15 * S(3);
    e.accuracy_m = 2, e.fit_interval_h = n % 2 ? 6 : 4, e.iode = (int32_t)(n % 256),
    e.iodc = (int32_t)(n % 1024), e.health = n % 64;
    e.delay.tgd_s = 5e-8 * S(4);
    e.kepler = (orr_nav_kepler){.sqrt_a_sqrtm = 5153 + U(5),
                                .e = 0.03 * U(6),
                                .m0_rad = PI_ * S(7),
                                .i0_rad = 0.96 + 0.01 * S(8),
                                .omega0_rad = PI_ * S(9),
                                .omega_rad = PI_ * S(10),
                                .delta_n_radps = 1e-8 * S(11),
                                .idot_radps = 2e-9 * S(12),
                                .omega_dot_radps = -9e-9 * U(13),
                                .cuc_rad = 6e-5 * S(14),
                                .cus_rad = 6e-5 * S(15),
                                .crc_m = 1000 * S(16),
                                .crs_m = 1000 * S(17),
                                .cic_rad = 6e-5 * S(18),
                                .cis_rad = 6e-5 * S(19),
                                .toe_sow_s = (double)sow * 1e-9};
    return e;
}

// Every field comes back to half an LSB.
static void ephemerides_read_back(void **state)
{
    (void)state;
    for (uint64_t n = 0; n < 500; n++) {
        orr_nav_eph e = random_record(n);
        orr_lnav_how how = {.tow_count = (uint32_t)(n * 201 % 100800),
                            .anti_spoof = n % 3 == 0,
                            .tlm_message = (uint32_t)n,
                            .week = e.week - (int32_t)(n % 2)}; // toe may be the next week's
        orr_lnav_subframe s[3];
        orr_diag d = {0};
        for (int k = 0; k < 3; k++) {
            ASSERT_OK(orr_lnav_encode_ephemeris(&e, k + 1, &how, &s[k], &d), d);
            assert_true(lnav_parity_holds(&s[k]));
            assert_int_equal(get(&s[k], 1, 8), 0x8b);
            assert_int_equal(get(&s[k], 9, 14), n);
            assert_int_equal(get(&s[k], 31, 17), how.tow_count);
            assert_int_equal(get(&s[k], 49, 1), how.anti_spoof);
            assert_int_equal(get(&s[k], 50, 3), k + 1);
            assert_int_equal(s[k].word[1] & 3u, 0);
            assert_int_equal(s[k].word[9] & 3u, 0);
            for (int w = 0; w < 10; w++) assert_int_equal(s[k].word[w] >> 30, 0);
        }
        const orr_nav_kepler *q = &e.kepler;
        assert_int_equal(get(&s[0], 61, 10), how.week % 1024);
        assert_int_equal(get(&s[0], 73, 4), 0);
        assert_int_equal(get(&s[0], 77, 6), e.health);
        assert_int_equal(get_split(&s[0], 83, 2, 211, 8, false), e.iodc);
        ASSERT_NEAR(ldexp(get_signed(&s[0], 197, 8), -31), e.delay.tgd_s, ldexp(0.51, -31));
        ASSERT_NEAR(get(&s[0], 219, 16) * 16.0, q->toe_sow_s, 1e-9); // rounding of nanoseconds to seconds
        ASSERT_NEAR(ldexp(get_signed(&s[0], 241, 8), -55), e.af2_sps2, ldexp(0.51, -55));
        ASSERT_NEAR(ldexp(get_signed(&s[0], 249, 16), -43), e.af1_sps, ldexp(0.51, -43));
        ASSERT_NEAR(ldexp(get_signed(&s[0], 271, 22), -31), e.af0_s, ldexp(0.51, -31));
        assert_int_equal(get(&s[1], 61, 8), e.iode);
        ASSERT_NEAR(ldexp(get_signed(&s[1], 69, 16), -5), q->crs_m, ldexp(0.51, -5));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s[1], 91, 16), -43), q->delta_n_radps, PI_ * ldexp(0.51, -43));
        ASSERT_NEAR(PI_ * ldexp(get_split(&s[1], 107, 8, 121, 24, true), -31), q->m0_rad,
                    PI_ * ldexp(0.51, -31));
        ASSERT_NEAR(ldexp(get_signed(&s[1], 151, 16), -29), q->cuc_rad, ldexp(0.51, -29));
        ASSERT_NEAR(ldexp(get_split(&s[1], 167, 8, 181, 24, false), -33), q->e, ldexp(0.51, -33));
        ASSERT_NEAR(ldexp(get_signed(&s[1], 211, 16), -29), q->cus_rad, ldexp(0.51, -29));
        ASSERT_NEAR(ldexp(get_split(&s[1], 227, 8, 241, 24, false), -19), q->sqrt_a_sqrtm, ldexp(0.51, -19));
        ASSERT_NEAR(get(&s[1], 271, 16) * 16.0, q->toe_sow_s, 1e-9);
        assert_int_equal(get(&s[1], 287, 1), n % 2);
        ASSERT_NEAR(ldexp(get_signed(&s[2], 61, 16), -29), q->cic_rad, ldexp(0.51, -29));
        ASSERT_NEAR(PI_ * ldexp(get_split(&s[2], 77, 8, 91, 24, true), -31), q->omega0_rad,
                    PI_ * ldexp(0.51, -31));
        ASSERT_NEAR(ldexp(get_signed(&s[2], 121, 16), -29), q->cis_rad, ldexp(0.51, -29));
        ASSERT_NEAR(PI_ * ldexp(get_split(&s[2], 137, 8, 151, 24, true), -31), q->i0_rad,
                    PI_ * ldexp(0.51, -31));
        ASSERT_NEAR(ldexp(get_signed(&s[2], 181, 16), -5), q->crc_m, ldexp(0.51, -5));
        ASSERT_NEAR(PI_ * ldexp(get_split(&s[2], 197, 8, 211, 24, true), -31), q->omega_rad,
                    PI_ * ldexp(0.51, -31));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s[2], 241, 24), -43), q->omega_dot_radps, PI_ * ldexp(0.51, -43));
        assert_int_equal(get(&s[2], 271, 8), e.iode);
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s[2], 279, 14), -43), q->idot_radps, PI_ * ldexp(0.51, -43));
    }
}

static void every_flipped_bit_is_noticed(void **state)
{
    (void)state;
    orr_nav_eph e = random_record(7);
    orr_lnav_how how = {.tow_count = 1};
    orr_lnav_subframe s;
    orr_diag d = {0};
    ASSERT_OK(orr_lnav_encode_ephemeris(&e, 2, &how, &s, &d), d);
    for (int w = 0; w < 10; w++)
        for (int b = 0; b < 30; b++) {
            orr_lnav_subframe t = s;
            t.word[w] ^= UINT32_C(1) << b;
            assert_false(lnav_parity_holds(&t));
        }
}

static void what_does_not_fit_is_named(void **state)
{
    (void)state;
    orr_lnav_how how = {0};
    orr_lnav_subframe s;
    orr_diag d = {0};
    orr_nav_eph e = random_record(1);
    e.kepler.crs_m = 1025;
    assert_int_equal(orr_lnav_encode_ephemeris(&e, 2, &how, &s, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "Crs"));
    e = random_record(1);
    e.kepler.m0_rad = PI_; // the one angle that two's complement lacks goes out as -pi
    ASSERT_OK(orr_lnav_encode_ephemeris(&e, 2, &how, &s, &d), d);
    ASSERT_NEAR(get_split(&s, 107, 8, 121, 24, true), -ldexp(1, 31), 0);
    assert_int_equal(orr_lnav_encode_ephemeris(&e, 4, &how, &s, &d), ORR_E_ARG);
    how.tow_count = 100800;
    assert_int_equal(orr_lnav_encode_ephemeris(&e, 1, &how, &s, &d), ORR_E_RANGE);
    e.kepler.e = (double)NAN;
    how.tow_count = 0;
    assert_int_equal(orr_lnav_encode_ephemeris(&e, 2, &how, &s, &d), ORR_E_RANGE);
}

static void ionosphere_and_utc_read_back(void **state)
{
    (void)state;
    const double alpha[4] = {1.2107e-8, 1.4901e-8, -5.9605e-8, -1.1921e-7},
                 beta[4] = {96256, 81920, -196608, -196608};
    const orr_nav_utc utc = {.a0_s = 9.31e-10,
                             .a1_sps = -1.8e-15,
                             .reference = orr_time_from_week(2300, 405504 * ORR_NS_PER_S),
                             .week_lsf = 1929,
                             .leap_s = 18,
                             .leap_future_s = 18,
                             .day = 7};
    orr_lnav_how how = {.tow_count = 55};
    orr_lnav_subframe s;
    orr_diag d = {0};
    ASSERT_OK(orr_lnav_encode_page18(alpha, beta, &utc, &how, &s, &d), d);
    assert_true(lnav_parity_holds(&s));
    assert_int_equal(get(&s, 50, 3), 4);
    assert_int_equal(get(&s, 61, 2), 1);
    assert_int_equal(get(&s, 63, 6), 56);
    static const int a_first[4] = {69, 77, 91, 99}, b_first[4] = {107, 121, 129, 137},
                     a_power[4] = {-30, -27, -24, -24}, b_power[4] = {11, 14, 16, 16};
    for (int k = 0; k < 4; k++) {
        ASSERT_NEAR(ldexp(get_signed(&s, a_first[k], 8), a_power[k]), alpha[k], ldexp(0.51, a_power[k]));
        ASSERT_NEAR(ldexp(get_signed(&s, b_first[k], 8), b_power[k]), beta[k], ldexp(0.51, b_power[k]));
    }
    ASSERT_NEAR(ldexp(get_signed(&s, 151, 24), -50), utc.a1_sps, ldexp(0.51, -50));
    ASSERT_NEAR(ldexp(get_split(&s, 181, 24, 211, 8, true), -30), utc.a0_s, ldexp(0.51, -30));
    assert_int_equal(get(&s, 219, 8) * 4096, 405504);
    assert_int_equal(get(&s, 227, 8), 2300 % 256);
    assert_int_equal(get(&s, 241, 8), 18);
    assert_int_equal(get(&s, 249, 8), 1929 % 256);
    assert_int_equal(get(&s, 257, 8), 7);
    assert_int_equal(get(&s, 271, 8), 18);
}

static void almanacs_read_back_on_their_pages(void **state)
{
    (void)state;
    for (int n = 1; n <= 32; n++) {
        orr_almanac a = {.number = n,
                         .e = 0.01,
                         .toa_s = 319488,
                         .i_offset_rad = 0.02,
                         .omega_dot_radps = -8e-9,
                         .sqrt_a_sqrtm = 5153.6,
                         .omega0_rad = -2.5,
                         .omega_rad = 1.5,
                         .m0_rad = 0.7,
                         .af0_s = -3.1e-4,
                         .af1_sps = -7e-12,
                         .health = (uint32_t)n};
        orr_lnav_how how = {.tow_count = 5};
        orr_lnav_subframe s;
        orr_diag d = {0};
        int subframe = 0, page = 0;
        ASSERT_OK(orr_lnav_encode_almanac(&a, &how, &subframe, &page, &s, &d), d);
        assert_int_equal(subframe, n <= 24 ? 5 : 4);
        assert_int_equal(page, n <= 24 ? n : n <= 28 ? n - 23 : n - 22);
        assert_true(lnav_parity_holds(&s));
        assert_int_equal(get(&s, 50, 3), subframe);
        assert_int_equal(get(&s, 63, 6), n);
        ASSERT_NEAR(ldexp(get(&s, 69, 16), -21), a.e, ldexp(0.51, -21));
        assert_int_equal(get(&s, 91, 8) * 4096, 319488);
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s, 99, 16), -19), a.i_offset_rad, PI_ * ldexp(0.51, -19));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s, 121, 16), -38), a.omega_dot_radps, PI_ * ldexp(0.51, -38));
        assert_int_equal(get(&s, 137, 8), n);
        ASSERT_NEAR(ldexp(get(&s, 151, 24), -11), a.sqrt_a_sqrtm, ldexp(0.51, -11));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s, 181, 24), -23), a.omega0_rad, PI_ * ldexp(0.51, -23));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s, 211, 24), -23), a.omega_rad, PI_ * ldexp(0.51, -23));
        ASSERT_NEAR(PI_ * ldexp(get_signed(&s, 241, 24), -23), a.m0_rad, PI_ * ldexp(0.51, -23));
        ASSERT_NEAR(ldexp(get_split(&s, 271, 8, 290, 3, true), -20), a.af0_s, ldexp(0.51, -20));
        ASSERT_NEAR(ldexp(get_signed(&s, 279, 11), -38), a.af1_sps, ldexp(0.51, -38));
    }
    orr_lnav_how how = {.tow_count = 5};
    orr_lnav_subframe s;
    orr_diag d = {0};
    ASSERT_OK(orr_lnav_encode_spare(5, 0, &how, &s, &d), d);
    assert_true(lnav_parity_holds(&s));
    assert_int_equal(get(&s, 50, 3), 5);
    assert_int_equal(get(&s, 61, 2), 1);
    assert_int_equal(get(&s, 63, 6), 0);
    assert_int_equal(get(&s, 91, 24), 0xaaaaaa); // odd bits are ones: 91 is
    assert_int_equal(orr_lnav_encode_spare(3, 0, &how, &s, &d), ORR_E_ARG);
}

static void health_pages_read_back(void **state)
{
    (void)state;
    uint8_t health[32];
    for (int k = 0; k < 32; k++) health[k] = (uint8_t)(k * 5 % 64);
    uint8_t config[32];
    for (int k = 0; k < 32; k++) config[k] = (uint8_t)(k % 5);
    orr_lnav_how how = {.tow_count = 9};
    orr_lnav_subframe s5, s4;
    orr_diag d = {0};
    ASSERT_OK(orr_lnav_encode_page25(5, 319488, 2300, config, health, &how, &s5, &d), d);
    ASSERT_OK(orr_lnav_encode_page25(4, 319488, 2300, config, health, &how, &s4, &d), d);
    assert_true(lnav_parity_holds(&s5) && lnav_parity_holds(&s4));
    assert_int_equal(get(&s5, 63, 6), 51);
    assert_int_equal(get(&s5, 77, 8), 2300 % 256);
    for (int k = 0; k < 24; k++) assert_int_equal(get(&s5, 30 * (3 + k / 4) + 1 + 6 * (k % 4), 6), health[k]);
    assert_int_equal(get(&s4, 63, 6), 63);
    for (int k = 0; k < 32; k++) { // four in word 3, six in words 4 to 7, four in word 8
        const int word = k < 4 ? 2 : 3 + (k - 4) / 6, place = k < 4 ? 8 + 4 * k : 4 * ((k - 4) % 6);
        assert_int_equal(get(&s4, 30 * word + 1 + place, 4), config[k]);
    }
    assert_int_equal(get(&s4, 229, 6), health[24]);
    for (int k = 0; k < 4; k++) assert_int_equal(get(&s4, 241 + 6 * k, 6), health[25 + k]);
    for (int k = 0; k < 3; k++) assert_int_equal(get(&s4, 271 + 6 * k, 6), health[29 + k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ephemerides_read_back),
        cmocka_unit_test(every_flipped_bit_is_noticed),
        cmocka_unit_test(what_does_not_fit_is_named),
        cmocka_unit_test(ionosphere_and_utc_read_back),
        cmocka_unit_test(almanacs_read_back_on_their_pages),
        cmocka_unit_test(health_pages_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
