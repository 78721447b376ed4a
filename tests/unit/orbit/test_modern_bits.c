// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of CNAV-2 and B-CNAV that were received on the air: their fields, read at the places that the interface documents give
// them, make the same bits again.
#include "testing.h"

#include "orbit/navdata/bcnav_bits.h"
#include "orbit/navdata/cnav2_bits.h"
#include "orbit/navdata/system_week.h"
#include "unit/orbit/received_frames.h"

#define SEMI(n) (ORR_PI * ldexp(1, -(n)))
#define SECOND ORR_NS_PER_S
#define ARCSECOND (ORR_RAD_PER_DEG / 3600)

typedef struct reader {
    orr_page page;
    size_t at;
} reader;

static double u(reader *r, int n, double lsb)
{
    double v = 0;
    for (; n > 0; n--) v = 2 * v + r->page.bit[r->at++];
    return v * lsb;
}

static double s(reader *r, int n, double lsb)
{
    const double v = u(r, n, 1);
    return (v >= ldexp(1, n - 1) ? v - ldexp(1, n) : v) * lsb;
}

static reader open(const char *hex)
{
    reader r = {.at = 0};
    received_bits(hex, &r.page);
    return r;
}

static void first_half(reader *r, double a_m, orr_nav_kepler *k)
{
    k->sqrt_a_sqrtm = sqrt(a_m + s(r, 26, 0x1p-9));
    k->a_dot_mps = s(r, 25, 0x1p-21);
    k->delta_n_radps = s(r, 17, SEMI(44));
    k->delta_n_dot_radps2 = s(r, 23, SEMI(57));
    k->m0_rad = s(r, 33, SEMI(32));
    k->e = u(r, 33, 0x1p-34);
    k->omega_rad = s(r, 33, SEMI(32));
}

static void second_half(reader *r, int rate_bits, double rate_radps, orr_nav_kepler *k)
{
    k->omega0_rad = s(r, 33, SEMI(32));
    k->i0_rad = s(r, 33, SEMI(32));
    k->omega_dot_radps = rate_radps + s(r, rate_bits, SEMI(44));
    k->idot_radps = s(r, 15, SEMI(44));
    k->cis_rad = s(r, 16, 0x1p-30);
    k->cic_rad = s(r, 16, 0x1p-30);
    k->crs_m = s(r, 24, 0x1p-8);
    k->crc_m = s(r, 24, 0x1p-8);
    k->cus_rad = s(r, 21, 0x1p-30);
    k->cuc_rad = s(r, 21, 0x1p-30);
}

static orr_nav_eph record(const char *sat, uint8_t message)
{
    return (orr_nav_eph){.sat = orr_sat_parse(sat), .kind = ORR_NAV_KEPLER, .message = message};
}

// An instant of BDT.
static orr_time bdt(double week, double seconds)
{
    return orr_time_from_week((int32_t)week + ORR_BDT_WEEK_0, 0) + (int64_t)seconds * SECOND +
           ORR_BDT_BEHIND_GPS_NS;
}

static void assert_same(const orr_page *made, size_t from, const orr_page *received, size_t n)
{
    assert_int_equal(made->status, ORR_OK);
    for (size_t k = 0; k < n; k++)
        if (made->bit[from + k] != received->bit[k]) fail_msg("bit %zu of %zu", k, n);
}

static void cnav2_subframe_2(void **state)
{
    (void)state;
    reader r = open(RECEIVED_CNAV2_SUBFRAME2);
    orr_nav_eph e = record("J02", ORR_NAV_CNV2);
    orr_cnav2_frame c = {.eph = &e};
    const int32_t week = (int32_t)u(&r, 13, 1);
    c.t = orr_time_from_week(week, 0) + (int64_t)u(&r, 8, 7200) * SECOND + 18 * SECOND;
    e.transmission = c.t;
    e.kepler.top_sow_s = u(&r, 11, 300);
    e.health = (uint32_t)u(&r, 1, 1);
    e.ura_ed = (int32_t)s(&r, 5, 1);
    e.kepler.toe_sow_s = u(&r, 11, 300);
    first_half(&r, 42164200, &e.kepler);
    second_half(&r, 17, -2.6e-9 * ORR_PI, &e.kepler);
    e.ura_ned[0] = (int32_t)s(&r, 5, 1);
    e.ura_ned[1] = (int32_t)u(&r, 3, 1);
    e.ura_ned[2] = (int32_t)u(&r, 3, 1);
    e.af0_s = s(&r, 26, 0x1p-35);
    e.af1_sps = s(&r, 20, 0x1p-48);
    e.af2_sps2 = s(&r, 10, 0x1p-60);
    e.delay.tgd_s = s(&r, 13, 0x1p-35);
    e.delay.isc_l1cp_s = s(&r, 13, 0x1p-35);
    e.delay.isc_l1cd_s = s(&r, 13, 0x1p-35);
    assert_int_equal(r.at, 565);
    orr_page made;
    made.diag = NULL;
    orr_cnav2_frame_bits(&c, ORR_CNAV2_UTC_AND_IONOSPHERE, false, &made);
    assert_int_equal(made.n, 9 + 600 + 274);
    assert_same(&made, 9, &r.page, 565);
    r.page.bit[565] = 0; // integrity status: that satellite sets it
    assert_same(&made, 9, &r.page, 576);
}

static void cnav2_midi_almanac(void **state)
{
    (void)state;
    reader r = open(RECEIVED_CNAV2_SUBFRAME3);
    assert_int_equal(u(&r, 8, 1), 194);
    assert_int_equal(u(&r, 6, 1), ORR_CNAV2_MIDI_ALMANAC);
    orr_nav_eph e = record("J02", ORR_NAV_CNV2);
    e.kepler.sqrt_a_sqrtm = sqrt(42164200.0);
    orr_almanac a = {0};
    orr_cnav2_frame c = {.eph = &e, .almanacs.midi = &a};
    c.almanacs.week = (int32_t)u(&r, 13, 1);
    c.almanacs.toa_s = (uint32_t)u(&r, 8, 4096);
    a.number = (int)u(&r, 8, 1);
    a.health = (uint32_t)u(&r, 3, 1);
    a.e = u(&r, 11, 0x1p-16);
    a.i_offset_rad = s(&r, 11, SEMI(14));
    a.omega_dot_radps = s(&r, 11, SEMI(33));
    a.sqrt_a_sqrtm = u(&r, 17, 0x1p-4);
    a.omega0_rad = s(&r, 16, SEMI(15));
    a.omega_rad = s(&r, 16, SEMI(15));
    a.m0_rad = s(&r, 16, SEMI(15));
    a.af0_s = s(&r, 11, 0x1p-20);
    a.af1_sps = s(&r, 10, 0x1p-37);
    assert_int_equal(a.number, 199); // QZSS numbers its own from 193 on
    orr_page made;
    made.diag = NULL;
    orr_cnav2_frame_bits(&c, ORR_CNAV2_MIDI_ALMANAC, false, &made);
    assert_same(&made, 609, &r.page, 274);
}

static void clock_of(reader *r, orr_nav_eph *e, int32_t week)
{
    e->toc = bdt(week, u(r, 11, 300));
    e->af0_s = s(r, 25, 0x1p-34);
    e->af1_sps = s(r, 22, 0x1p-50);
    e->af2_sps2 = s(r, 11, 0x1p-66);
}

static void ephemeris_1(reader *r, orr_nav_eph *e)
{
    e->kepler.toe_sow_s = u(r, 11, 300);
    assert_int_equal(u(r, 2, 1), 3); // a medium orbit
    first_half(r, 27906100, &e->kepler);
}

static void bcnav1_subframe_2(void **state)
{
    (void)state;
    reader r = open(RECEIVED_BCNAV1_SUBFRAME2);
    orr_nav_eph e = record("C19", ORR_NAV_CNV1);
    const int32_t week = (int32_t)u(&r, 13, 1);
    orr_bcnav_message b = {.eph = &e, .t = bdt(week, u(&r, 8, 3600))};
    e.iodc = (int32_t)u(&r, 10, 1);
    e.iode = (int32_t)u(&r, 8, 1);
    ephemeris_1(&r, &e);
    second_half(&r, 19, 0, &e.kepler);
    clock_of(&r, &e, week);
    e.delay.tgd_b2ap_s = s(&r, 12, 0x1p-34);
    e.delay.isc_b1cd_s = s(&r, 12, 0x1p-34);
    e.delay.tgd_b1cp_s = s(&r, 12, 0x1p-34);
    orr_page made;
    made.diag = NULL;
    orr_bcnav1_frame_bits(&b, ORR_BCNAV1_IONOSPHERE_AND_UTC, false, &made);
    assert_int_equal(made.n, 14 + 600 + 264);
    assert_same(&made, 14, &r.page, 600);
}

static void accuracy_oc(reader *r, orr_nav_eph *e)
{
    e->kepler.top_sow_s = u(r, 11, 300);
    e->sisai_ocb = (int32_t)u(r, 5, 1);
    e->sisai_oc1 = (int32_t)u(r, 3, 1);
    e->sisai_oc2 = (int32_t)u(r, 3, 1);
}

static void bdgim(reader *r, orr_bcnav_message *b)
{
    static const bool has_sign[9] = {false, true, false, false, false, true, true, true, true};
    for (int k = 0; k < 9; k++)
        b->bdgim_tecu[k] = has_sign[k] ? s(r, 8, 0.125) : u(r, k == 0 ? 10 : 8, k == 4 ? -0.125 : 0.125);
}

static void utc(reader *r, orr_bcnav_message *b)
{
    b->utc.a0_s = s(r, 16, 0x1p-35);
    b->utc.a1_sps = s(r, 13, 0x1p-51);
    assert_int_equal(u(r, 7, 1), 0); // A2
    b->utc.leap_s = (int)s(r, 8, 1) + 14;
    const double tot = u(r, 16, 16), week = u(r, 13, 1);
    b->utc.reference = bdt(week, tot);
    b->utc.week_lsf = (int32_t)u(r, 13, 1) + ORR_BDT_WEEK_0;
    b->utc.day = (int)u(r, 3, 1) + 1;
    b->utc.leap_future_s = (int)s(r, 8, 1) + 14;
    assert_int_equal(b->utc.leap_s, 18);
}

static void bcnav1_page_1(void **state)
{
    (void)state;
    reader r = open(RECEIVED_BCNAV1_SUBFRAME3);
    orr_nav_eph e = record("C19", ORR_NAV_CNV1);
    e.kepler.sqrt_a_sqrtm = sqrt(27906100.0);
    orr_bcnav_message b = {.eph = &e};
    assert_int_equal(u(&r, 6, 1), ORR_BCNAV1_IONOSPHERE_AND_UTC);
    e.health = (uint32_t)u(&r, 2, 1);
    assert_int_equal(u(&r, 3, 1), 0);
    e.sismai = (int32_t)u(&r, 4, 1);
    e.sisai_oe = (int32_t)u(&r, 5, 1);
    accuracy_oc(&r, &e);
    bdgim(&r, &b);
    utc(&r, &b);
    orr_page made;
    made.diag = NULL;
    orr_bcnav1_frame_bits(&b, ORR_BCNAV1_IONOSPHERE_AND_UTC, false, &made);
    assert_same(&made, 614, &r.page, 264);
}

static void bcnav2_message_10(void **state)
{
    (void)state;
    reader r = open(RECEIVED_BCNAV2);
    assert_int_equal(u(&r, 6, 1), 23);
    assert_int_equal(u(&r, 6, 1), ORR_BCNAV_EPHEMERIS_1);
    orr_nav_eph e = record("C23", ORR_NAV_CNV2);
    const double sow = u(&r, 18, 3);
    orr_bcnav_message b = {.eph = &e, .t = bdt(u(&r, 13, 1), sow)};
    assert_int_equal(u(&r, 3, 1), 0); // B2a is sound
    e.sismai = (int32_t)u(&r, 4, 1);
    assert_int_equal(u(&r, 3, 1), 0); // and so is B1C
    e.iode = (int32_t)u(&r, 8, 1);
    ephemeris_1(&r, &e);
    orr_page made;
    made.diag = NULL;
    orr_bcnav2_message_bits(&b, ORR_BCNAV_EPHEMERIS_1, false, &made);
    assert_int_equal(made.n, 24 + 288);
    assert_same(&made, 24, &r.page, 288);
    orr_bcnav2_message_bits(&b, ORR_BCNAV_EPHEMERIS_1, true, &made);
    assert_same(&made, 24, &r.page, 576);
}

// A message of C30 on trial: status 2, which no document explains, and every mark against it. Compared are the bits behind that.
static reader open_trial(const char *hex, int type, orr_bcnav_message *b, orr_nav_eph *e)
{
    reader r = open(hex);
    assert_int_equal(u(&r, 6, 1), 30);
    assert_int_equal(u(&r, 6, 1), type);
    b->t = bdt(645, u(&r, 18, 3));
    assert_int_equal(u(&r, 2, 1), 2);
    e->health = 1;
    assert_int_equal(u(&r, 3, 1), 7);
    e->sismai = (int32_t)u(&r, 4, 1);
    assert_int_equal(u(&r, 3, 1), 7);
    return r;
}

static void assert_trial(const orr_bcnav_message *b, int type, const reader *r)
{
    orr_page made;
    made.diag = NULL;
    orr_bcnav2_message_bits(b, type, false, &made);
    assert_int_equal(made.status, ORR_OK);
    for (size_t k = 0; k < 288 - 24; k++)
        if (k != 30 && k != 31 && made.bit[24 + k] != r->page.bit[k]) fail_msg("bit %zu", k);
}

static void bcnav2_messages_11_30_31(void **state)
{
    (void)state;
    orr_nav_eph e = record("C30", ORR_NAV_CNV2);
    orr_bcnav_message b = {.eph = &e};
    reader r = open_trial(RECEIVED_BCNAV2_11, ORR_BCNAV_EPHEMERIS_2, &b, &e);
    second_half(&r, 19, 0, &e.kepler);
    assert_trial(&b, ORR_BCNAV_EPHEMERIS_2, &r);
    r = open_trial(RECEIVED_BCNAV2_30, ORR_BCNAV_CLOCK_AND_IONOSPHERE, &b, &e);
    clock_of(&r, &e, 645);
    e.iodc = (int32_t)u(&r, 10, 1);
    e.delay.tgd_b2ap_s = s(&r, 12, 0x1p-34);
    e.delay.isc_b2ad_s = s(&r, 12, 0x1p-34);
    bdgim(&r, &b);
    e.delay.tgd_b1cp_s = s(&r, 12, 0x1p-34);
    assert_trial(&b, ORR_BCNAV_CLOCK_AND_IONOSPHERE, &r);
    r = open_trial(RECEIVED_BCNAV2_31, ORR_BCNAV_CLOCK_AND_REDUCED_ALMANACS, &b, &e);
    clock_of(&r, &e, 645);
    e.iodc = (int32_t)u(&r, 10, 1);
    b.almanacs.week = (int32_t)u(&r, 13, 1);
    b.almanacs.toa_s = (uint32_t)u(&r, 8, 4096);
    orr_almanac a[3] = {{0}};
    for (int k = 0; k < 3; k++) { // C05, C07 and C09: geostationary, inclined, inclined
        a[k].number = (int)u(&r, 6, 1);
        assert_int_equal(u(&r, 2, 1), k == 0 ? 1 : 2);
        a[k].sqrt_a_sqrtm = sqrt(42162200 + s(&r, 8, 512));
        a[k].omega0_rad = s(&r, 7, SEMI(6));
        a[k].omega_rad = 0.5;
        a[k].m0_rad = s(&r, 7, SEMI(6)) - 0.5;
        assert_int_equal(u(&r, 8, 1), 0);
        b.almanacs.reduced[k] = &a[k];
    }
    assert_trial(&b, ORR_BCNAV_CLOCK_AND_REDUCED_ALMANACS, &r);
}

static void bcnav3_message_30(void **state)
{
    (void)state;
    reader r = open(RECEIVED_BCNAV3);
    assert_int_equal(u(&r, 6, 1), ORR_BCNAV_CLOCK_AND_IONOSPHERE);
    orr_nav_eph e = record("C23", ORR_NAV_CNV3);
    const double sow = u(&r, 20, 1);
    const int32_t week = (int32_t)u(&r, 13, 1);
    orr_bcnav_message b = {.eph = &e, .t = bdt(week, sow)};
    for (int k = 0; k < 4; k++)
        r.page.bit[r.at++] = 0; // reserved: that satellite sends the last bits of IODC
    clock_of(&r, &e, week);
    e.delay.tgd_s = s(&r, 12, 0x1p-34);
    bdgim(&r, &b);
    utc(&r, &b);
    b.rotation.reference = bdt(week, u(&r, 16, 16));
    b.rotation.xp_rad = s(&r, 21, ARCSECOND * 0x1p-20);
    b.rotation.xp_rate_radps = s(&r, 15, ARCSECOND * 0x1p-21 / 86400);
    b.rotation.yp_rad = s(&r, 21, ARCSECOND * 0x1p-20);
    b.rotation.yp_rate_radps = s(&r, 15, ARCSECOND * 0x1p-21 / 86400);
    b.rotation.ut1_utc_s = s(&r, 31, 0x1p-24);
    b.rotation.ut1_rate_spd = s(&r, 19, 0x1p-25);
    accuracy_oc(&r, &e);
    e.sisai_oe = (int32_t)u(&r, 5, 1);
    e.health = (uint32_t)u(&r, 2, 1);
    assert_true(fabs(b.rotation.ut1_utc_s) < 0.9); // UT1 less UTC, not less BDT
    orr_page made;
    made.diag = NULL;
    orr_bcnav3_message_bits(&b, ORR_BCNAV_CLOCK_AND_IONOSPHERE, false, &made);
    assert_int_equal(made.n, 28 + 486);
    assert_same(&made, 28, &r.page, 486 - 24);
}

// The last frame of a week counts up to the next one's begin (CNAV-2) or from its own (B-CNAV), in the week that it is sent in.
static void a_week_ends(void **state)
{
    (void)state;
    orr_nav_eph gps = record("G05", ORR_NAV_CNV2), c1 = record("C19", ORR_NAV_CNV1),
                c2 = record("C19", ORR_NAV_CNV2);
    gps.kepler.sqrt_a_sqrtm = sqrt(26559710.0);
    c1.kepler.sqrt_a_sqrtm = c2.kepler.sqrt_a_sqrtm = sqrt(27906100.0);
    gps.transmission = orr_time_from_week(2299, 0);
    for (int after = 0; after < 2; after++) { // GPS week 2299 ends with BDT week 943
        reader r = {.at = 0};
        const orr_time seam = orr_time_from_week(2300, 0);
        const orr_cnav2_frame c = {.eph = &gps, .t = seam + (after - 1) * 18 * SECOND};
        r.page.diag = NULL;
        orr_cnav2_frame_bits(&c, ORR_CNAV2_OFFSET_AND_ROTATION, false, &r.page);
        assert_int_equal(r.page.status, ORR_OK);
        assert_int_equal(u(&r, 9, 1), after);
        assert_int_equal(u(&r, 13, 1), 2299 + after);
        assert_int_equal(u(&r, 8, 1), after ? 0 : 83);
        orr_bcnav_message b = {
            .eph = &c1, .t = bdt(944, 0) + (after - 1) * 18 * SECOND, .utc.reference = bdt(943, 0)};
        r = (reader){.at = 0};
        r.page.diag = NULL;
        orr_bcnav1_frame_bits(&b, ORR_BCNAV1_MIDI_ALMANAC, false, &r.page);
        assert_int_equal(r.page.status, ORR_OK);
        assert_int_equal(u(&r, 6, 1), 19);
        assert_int_equal(u(&r, 8, 1), after ? 0 : 199);
        assert_int_equal(u(&r, 13, 1), 943 + after);
        assert_int_equal(u(&r, 8, 1), after ? 0 : 167);
        b.eph = &c2, b.t = bdt(944, 0) + (after - 1) * 3 * SECOND;
        r = (reader){.at = 24 + 6 + 6};
        r.page.diag = NULL;
        orr_bcnav2_message_bits(&b, ORR_BCNAV_EPHEMERIS_1, false, &r.page);
        assert_int_equal(u(&r, 18, 3), after ? 0 : ORR_S_PER_WEEK - 3);
        assert_int_equal(u(&r, 13, 1), 943 + after);
        b.t = bdt(944, 0) + (after - 1) * SECOND;
        r = (reader){.at = 28 + 6};
        r.page.diag = NULL;
        orr_bcnav3_message_bits(&b, ORR_BCNAV_CLOCK_AND_IONOSPHERE, false, &r.page);
        assert_int_equal(u(&r, 20, 1), after ? 0 : ORR_S_PER_WEEK - 1);
        assert_int_equal(u(&r, 13, 1), 943 + after);
    }
}

// A value that its field cannot hold is told, and nothing is wrapped.
static void values_beyond_fields(void **state)
{
    (void)state;
    orr_nav_eph e = record("C23", ORR_NAV_CNV1);
    e.kepler.sqrt_a_sqrtm = sqrt(27906100.0);
    e.toc = bdt(800, 0);
    e.af0_s = 1.1e-3; // 24 bits of 2^-34 s reach 0.98 ms
    const orr_bcnav_message b = {
        .eph = &e, .t = bdt(800, 3600), .utc = {.reference = bdt(800, 0), .week_lsf = 1929, .day = 7}};
    orr_diag d = {0};
    orr_page made;
    made.diag = &d;
    orr_bcnav1_frame_bits(&b, ORR_BCNAV1_IONOSPHERE_AND_UTC, true, &made);
    assert_int_equal(made.status, ORR_E_RANGE);
    assert_non_null(strstr(d.text, "af0"));
    d = (orr_diag){0};
    orr_bcnav2_message_bits(&b, ORR_BCNAV_CLOCK_AND_IONOSPHERE, true, &made);
    assert_int_equal(made.status, ORR_E_RANGE);
    orr_bcnav3_message_bits(&b, ORR_BCNAV_CLOCK_AND_IONOSPHERE, true, &made);
    assert_int_equal(made.status, ORR_E_RANGE);
    e.af0_s = 0.9e-3;
    orr_bcnav1_frame_bits(&b, ORR_BCNAV1_IONOSPHERE_AND_UTC, true, &made);
    assert_int_equal(made.status, ORR_OK);
    assert_int_equal(made.n, 1800);
    // An almanac that does not fit is none.
    const orr_almanac far = {.number = 31, .sqrt_a_sqrtm = sqrt(60e6)};
    const orr_bcnav_message with = {
        .eph = &e, .t = b.t, .utc = b.utc, .almanacs = {.midi = &far, .reduced = {&far}}};
    orr_bcnav1_frame_bits(&with, ORR_BCNAV1_REDUCED_ALMANACS, false, &made);
    assert_int_equal(made.status, ORR_OK);
    for (size_t k = 614 + 15 + 22 + 21; k < made.n - 24; k++) assert_int_equal(made.bit[k], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cnav2_subframe_2),         cmocka_unit_test(cnav2_midi_almanac),
        cmocka_unit_test(bcnav1_subframe_2),        cmocka_unit_test(bcnav1_page_1),
        cmocka_unit_test(bcnav2_message_10),        cmocka_unit_test(bcnav3_message_30),
        cmocka_unit_test(bcnav2_messages_11_30_31), cmocka_unit_test(a_week_ends),
        cmocka_unit_test(values_beyond_fields),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
