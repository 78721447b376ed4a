// SPDX-License-Identifier: GPL-3.0-or-later
// What messages cannot hold: a sentence with the field's name, never a wrapped field; and SBAS' state, whose model is a closed form.
#include "testing.h"

#include <string.h>

#include "core/crc.h"
#include "orbit/navdata/almanac_kepler.h"
#include "orbit/navdata/beidou_bits.h"
#include "orbit/navdata/kepler_model.h"
#include "orbit/navdata/navfit.h"
#include "orbit/navdata/navic_bits.h"
#include "orbit/navdata/rtcm_ephemeris.h"
#include "orbit/navdata/sbas_bits.h"

#define T0 (orr_time_from_week(2300, 0) + 43200 * ORR_NS_PER_S)

// A satellite on an ellipse of its own, ecef.
typedef struct ellipse {
    orr_sat sat;
    orr_nav_kepler k;
} ellipse;

static orr_status on_ellipse(void *user, orr_time t, orr_vec3 *pos)
{
    const ellipse *e = user;
    const orr_kepler_axes axes = orr_kepler_axes_of(e->sat, ORR_NAV_NONE);
    *pos = orr_kepler_position(&axes, &e->k, orr_time_diff_s(t, T0), NULL);
    return ORR_OK;
}

static ellipse ellipse_of(const char *sat, double a_m, double ecc, double i_deg)
{
    return (ellipse){.sat = orr_sat_parse(sat),
                     .k = {.sqrt_a_sqrtm = sqrt(a_m),
                           .e = ecc,
                           .i0_rad = i_deg * ORR_RAD_PER_DEG,
                           .omega0_rad = 1,
                           .omega_rad = 0.7,
                           .m0_rad = 0.3,
                           .toe_sow_s = 43200}};
}

static void eccentricities_beyond_a_message(void **state)
{
    (void)state;
    const orr_time from = T0 - 3600 * ORR_NS_PER_S, to = T0 + 3600 * ORR_NS_PER_S,
                   day_from = T0 - 43200 * ORR_NS_PER_S, day_to = T0 + 43200 * ORR_NS_PER_S;
    const orr_time toa = orr_time_from_week(2300, 0) + 11 * 4096 * ORR_NS_PER_S;
    orr_navfit_report r;
    orr_nav_eph eph;
    orr_almanac a;
    orr_diag d = {0};
    ellipse heo = ellipse_of("G05", 26.56e6, 0.6, 63); // LNAV: below 0.5
    assert_int_equal(orr_navfit_kepler(heo.sat, ORR_NAV_LNAV, T0, from, to, on_ellipse, &heo, &eph, &r, &d),
                     ORR_E_RANGE);
    assert_int_equal(strncmp(d.text, "e = 0.", 6), 0);
    assert_non_null(strstr(d.text, "does not fit its 32 bits"));
    // CNAV's field is as wide.
    assert_int_equal(
        orr_navfit_kepler(heo.sat, ORR_NAV_CNAV, T0 + 0, from, to, on_ellipse, &heo, &eph, &r, &d),
        ORR_E_RANGE);
    // QZSS' almanacs hold 0.06 to 0.091, those of its geostationary satellites and NavIC's 0 to 0.031.
    static const struct {
        const char *sat;
        double a_m, e, i_deg;
        bool fits;
    } almanac[] = {{"J02", 42.164e6, 0.075, 41, true}, {"J02", 42.164e6, 0.05, 41, false},
                   {"J02", 42.164e6, 0.1, 41, false},  {"J07", 42.164e6, 0.001, 2, true},
                   {"J07", 42.164e6, 0.05, 2, false},  {"I03", 42.164e6, 0.002, 28, true},
                   {"I03", 42.164e6, 0.05, 28, false}, {"G05", 26.56e6, 0.02, 55, true},
                   {"G05", 26.56e6, 0.04, 55, false}};
    for (size_t k = 0; k < sizeof almanac / sizeof *almanac; k++) {
        ellipse e = ellipse_of(almanac[k].sat, almanac[k].a_m, almanac[k].e, almanac[k].i_deg);
        d = (orr_diag){0};
        const orr_status s = orr_almanac_fit(e.sat, toa, day_from, day_to, on_ellipse, &e, &a, &r, &d);
        if (almanac[k].fits) {
            ASSERT_OK(s, d);
            ASSERT_NEAR(a.e, almanac[k].e,
                        3e-3); // the flattening that the fit allows for is not in the ellipse
        } else {
            assert_int_equal(s, ORR_E_RANGE);
            assert_non_null(strstr(d.text, "does not fit its 16 bits"));
        }
    }
}

static void messages_of_other_systems(void **state)
{
    (void)state;
    const orr_time from = T0 - 3600 * ORR_NS_PER_S, to = T0 + 3600 * ORR_NS_PER_S;
    orr_navfit_report r;
    orr_nav_eph eph;
    orr_diag d = {0};
    ellipse e = ellipse_of("G05", 26.56e6, 0.01, 55);
    assert_int_equal(orr_navfit_kepler(e.sat, ORR_NAV_INAV, T0, from, to, on_ellipse, &e, &eph, &r, &d),
                     ORR_E_ARG);
    assert_string_equal(d.text, "GPS satellites send no Kepler elements in a message INAV");
    assert_int_equal(orr_navfit_geo(e.sat, T0, from, from + 300 * ORR_NS_PER_S, on_ellipse, &e, &eph, &r, &d),
                     ORR_E_ARG);
    assert_string_equal(d.text, "message 9 is that of SBAS satellites");
    eph = (orr_nav_eph){.sat = e.sat, .kind = ORR_NAV_KEPLER, .message = ORR_NAV_CNAV};
    orr_rtcm_frame frame;
    assert_int_equal(orr_rtcm_ephemeris(&eph, NULL, &frame, &d), ORR_E_ARG);
    assert_string_equal(d.text, "G05: RTCM 3 has no message for CNAV");
}

// A parabola in ecef.
typedef struct parabola {
    orr_vec3 p, v, a;
} parabola;

static orr_status on_parabola(void *user, orr_time t, orr_vec3 *pos)
{
    const parabola *q = user;
    const double dt = orr_time_diff_s(t, T0);
    *pos = orr_vec3_axpy(0.5 * dt * dt, q->a, orr_vec3_axpy(dt, q->v, q->p));
    return ORR_OK;
}

static void a_parabola_is_found_to_the_last_bit(void **state)
{
    (void)state;
    const orr_time from = T0 - 150 * ORR_NS_PER_S, to = T0 + 150 * ORR_NS_PER_S;
    const orr_sat sat = orr_sat_parse("S33");
    parabola q = {{0.08 * 12345678, -0.08 * 300000001, 0.4 * -54321},
                  {0.000625 * 701, -0.000625 * 1301, 0.004 * 77},
                  {0.0000125 * 3, -0.0000125 * 5, 0.0000625 * 2}};
    orr_navfit_report r;
    orr_nav_eph eph;
    orr_diag d = {0};
    ASSERT_OK(orr_navfit_geo(sat, T0, from, to, on_parabola, &q, &eph, &r, &d), d);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(eph.geo.pos_m, q.p)), 0, 1e-6);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(eph.geo.vel_mps, q.v)), 0, 1e-9);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(eph.geo.acc_mps2, q.a)), 0, 1e-12);
    ASSERT_NEAR(r.rms_m, 0, 1e-5);
    // Off the lattice: a centimetre before rounding, at most half an LSB of each afterwards.
    q.p.x += 0.031, q.p.z += 0.19, q.v.y += 0.0003;
    ASSERT_OK(orr_navfit_geo(sat, T0, from, to, on_parabola, &q, &eph, &r, &d), d);
    ASSERT_NEAR(r.fit_rms_m, 0, 1e-5);
    assert_true(r.rms_m > 0.01 && r.rms_m < 0.3);
    assert_int_equal(orr_navfit_geo(sat, T0 + 8 * ORR_NS_PER_S, from, to, on_parabola, &q, &eph, &r, &d),
                     ORR_E_ARG);
    assert_int_equal(orr_navfit_geo(sat, T0, from, from + 30 * ORR_NS_PER_S, on_parabola, &q, &eph, &r, &d),
                     ORR_E_ARG);
    q.a.x = 0.0064; // 9 bits of 12.5 um/s^2
    assert_int_equal(orr_navfit_geo(sat, T0, from, to, on_parabola, &q, &eph, &r, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "ax = 0.0064 does not fit its 10 bits"));
}

static void values_beyond_their_fields(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_page page = {.diag = &d};
    orr_nav_eph eph = {.sat = orr_sat_parse("S33"),
                       .kind = ORR_NAV_GEO,
                       .message = ORR_NAV_SBAS,
                       .toe = T0,
                       .toc = T0,
                       .af0_s = 1e-6,
                       .geo = {.pos_m = {42.164e6, 0, 0}, .ura_m = 2}};
    const orr_sbas_told told = {.eph = &eph, .t = T0};
    orr_sbas_message_bits(&told, ORR_SBAS_EPHEMERIS, &page);
    assert_int_equal(page.status, ORR_E_RANGE);
    assert_string_equal(d.text, "aGf0 = 9.997747838e-07 does not fit its 12 bits");
    eph.af0_s = 9e-7;
    orr_sbas_message_bits(&told, ORR_SBAS_EPHEMERIS, &page);
    assert_int_equal(page.status, ORR_OK);
    assert_int_equal(page.n, 250);

    ellipse e = ellipse_of("C02", 42.164e6, 0.001, 5);
    eph = (orr_nav_eph){.sat = e.sat, .kind = ORR_NAV_KEPLER, .message = ORR_NAV_D2, .toe = T0, .toc = T0};
    eph.kepler = e.k;
    eph.delay.tgd_s = 60e-9;
    static const uint8_t health[64] = {0};
    const orr_beidou_subframe sub = {.eph = &eph, .t = T0, .health = health};
    page.status = ORR_OK;
    orr_d2_frame_bits(&sub, 1, 1, &page);
    assert_int_equal(page.status, ORR_E_RANGE);
    assert_string_equal(d.text, "TGD = 6e-08 does not fit its 10 bits");
    eph.delay.tgd_s = 50e-9;
    orr_d2_frame_bits(&sub, 1, 1, &page);
    assert_int_equal(page.status, ORR_OK);
    assert_int_equal(page.n, 1500);

    e = ellipse_of("I03", 42.164e6, 0.002, 28);
    eph.sat = e.sat, eph.message = ORR_NAV_LNAV, eph.af0_s = 0.98e-3, eph.delay = (orr_nav_delays){0};
    const orr_navic_subframe one = {.eph = &eph, .t = T0, .next = T0 + 12 * ORR_NS_PER_S};
    orr_navic_subframe_bits(&one, 1, ORR_NAVIC_NULL, &page);
    assert_int_equal(page.status, ORR_E_RANGE);
    assert_non_null(strstr(d.text, "af0 = "));
    orr_rtcm_frame frame;
    assert_int_equal(orr_rtcm_ephemeris(&eph, NULL, &frame, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "af0 = "));
    eph.af0_s = 0.97e-3;
    ASSERT_OK(orr_rtcm_ephemeris(&eph, NULL, &frame, &d), d);
    assert_int_equal(frame.bits, 482); // of 1041
}

static void frames_of_rtcm(void **state)
{
    (void)state;
    orr_rtcm_frame f;
    orr_rtcm_begin(&f);
    orr_rtcm_put(&f, 12, 1005);
    orr_rtcm_put(&f, 64, UINT64_C(0x8000000000000001));
    assert_true(orr_rtcm_end(&f));
    assert_int_equal(f.n, 3 + 10 + 3); // 76 bits are ten bytes
    assert_memory_equal(f.data, "\xd3\x00\x0a\x3e\xd8\x00\x00\x00\x00\x00\x00\x00\x10", 13);
    assert_int_equal(orr_crc24q(0, f.data, f.n), 0); // a frame with its CRC leaves none
    orr_rtcm_begin(&f);
    for (int k = 0; k < 8 * ORR_RTCM_CONTENT; k++) orr_rtcm_put(&f, 1, 1);
    assert_true(orr_rtcm_end(&f));
    assert_int_equal(f.n, sizeof f.data);
    orr_rtcm_begin(&f);
    for (int k = 0; k < 8 * ORR_RTCM_CONTENT + 1; k++) orr_rtcm_put(&f, 1, 1);
    assert_false(orr_rtcm_end(&f));
    assert_int_equal(f.n, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eccentricities_beyond_a_message),
        cmocka_unit_test(messages_of_other_systems),
        cmocka_unit_test(a_parabola_is_found_to_the_last_bit),
        cmocka_unit_test(values_beyond_their_fields),
        cmocka_unit_test(frames_of_rtcm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
