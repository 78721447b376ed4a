// SPDX-License-Identifier: GPL-3.0-or-later
// Broadcast models: exact derivatives, limits, the two faces of BeiDou, GLONASS energy, choice of records.
#include "testing.h"

#include "core/astro.h"
#include "orbit/broadcast/broadcast.h"
#include "orbit/force/kepler.h"

static orr_nav_eph made(const char *sat, uint8_t message)
{
    orr_nav_eph e = {.sat = orr_sat_parse(sat), .kind = ORR_NAV_KEPLER, .message = message};
    e.toe = e.toc = orr_time_from_week(2300, 7200 * ORR_NS_PER_S);
    e.transmission = ORR_TIME_NONE;
    e.af0_s = 1e-4;
    e.af1_sps = -3e-12;
    e.af2_sps2 = 1e-19;
    e.fit_interval_h = 4;
    e.kepler = (orr_nav_kepler){.sqrt_a_sqrtm = 5153.7,
                                .e = 0.012,
                                .m0_rad = 1.1,
                                .i0_rad = 0.97,
                                .omega0_rad = 2.2,
                                .omega_rad = 0.6,
                                .delta_n_radps = 4.4e-9,
                                .idot_radps = 3e-10,
                                .omega_dot_radps = -8e-9,
                                .cuc_rad = 2e-6,
                                .cus_rad = 9e-6,
                                .crc_m = 210,
                                .crs_m = 40,
                                .cic_rad = 1e-7,
                                .cis_rad = -8e-8,
                                .toe_sow_s = 7200,
                                .top_sow_s = (double)NAN};
    return e;
}

static void check_derivatives(const orr_nav_eph *e, double reach_s, double v_tol, double a_tol)
{
    const double h = 0.2; // a whole number of nanoseconds
    for (double dt = -reach_s; dt <= reach_s; dt += reach_s / 7) {
        orr_broadcast_state a, b, c;
        orr_time t = orr_time_add_s(e->toe, dt);
        assert_int_equal(orr_broadcast_eval(e, orr_time_add_s(t, -h), &a), ORR_OK);
        assert_int_equal(orr_broadcast_eval(e, t, &b), ORR_OK);
        assert_int_equal(orr_broadcast_eval(e, orr_time_add_s(t, h), &c), ORR_OK);
        orr_vec3 v = orr_vec3_scale(0.5 / h, orr_vec3_sub(c.pos_m, a.pos_m));
        orr_vec3 acc = orr_vec3_scale(0.5 / h, orr_vec3_sub(c.vel_mps, a.vel_mps));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(v, b.vel_mps)), 0, v_tol);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(acc, b.acc_mps2)), 0, a_tol);
        ASSERT_NEAR((c.clock_s - a.clock_s) / (2 * h), b.clock_rate_sps, 1e-18);
    }
}

// Central differences err by n^2 h^2/6 = 1.4e-10 of velocity and (0.6 m/s^2) acceleration and more at
// perigee, and by 8e-9 m of rounding over 0.4 s.
static void derivatives_are_exact_for_every_kepler_message(void **state)
{
    (void)state;
    orr_nav_eph e = made("G05", ORR_NAV_LNAV);
    check_derivatives(&e, 7200, 1e-6, 3e-10);
    e = made("G05", ORR_NAV_CNAV);
    e.kepler.a_dot_mps = 0.01;
    e.kepler.delta_n_dot_radps2 = 1e-13;
    check_derivatives(&e, 7200, 1e-6, 3e-10);
    e = made("E11", ORR_NAV_INAV);
    check_derivatives(&e, 7200, 1e-6, 3e-10);
    e = made("C03", ORR_NAV_D2);
    e.kepler.sqrt_a_sqrtm = 6493.4;
    e.kepler.i0_rad = 0.09;
    check_derivatives(&e, 3600, 1e-6, 3e-10);
}

// A geostationary satellite stands still over the ground: with i = 5 deg in the tilted plane and the node
// where the tilt takes it away, D2 gives a fixed point on the equator.
static void beidou_geo_stands_still(void **state)
{
    (void)state;
    orr_nav_eph e = made("C01", ORR_NAV_D2);
    const double u = 7.2921150e-5, a = cbrt(3.986004418e14 / (u * u));
    e.kepler = (orr_nav_kepler){.sqrt_a_sqrtm = sqrt(a),
                                .i0_rad = 5 * ORR_RAD_PER_DEG,
                                .toe_sow_s = 7200,
                                .omega0_rad = u * 7200 + ORR_PI,
                                .m0_rad = 1.0,
                                .top_sow_s = (double)NAN};
    orr_broadcast_state s0, s;
    assert_int_equal(orr_broadcast_eval(&e, e.toe, &s0), ORR_OK);
    ASSERT_NEAR(s0.pos_m.z, 0, 1e-6);
    ASSERT_NEAR(orr_vec3_norm(s0.pos_m), a, 1e-6);
    for (double dt = -3600; dt <= 3600; dt += 600) {
        assert_int_equal(orr_broadcast_eval(&e, orr_time_add_s(e.toe, dt), &s), ORR_OK);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.pos_m, s0.pos_m)), 0, 1e-6);
        ASSERT_NEAR(orr_vec3_norm(s.vel_mps), 0, 1e-9);
    }
}

// Without corrections the model is Kepler's ellipse turned into ecef; relativity is -2 r.v/c^2 of the
// inertial motion.
static void bare_elements_are_a_kepler_ellipse(void **state)
{
    (void)state;
    orr_nav_eph e = made("G07", ORR_NAV_LNAV);
    orr_nav_kepler *k = &e.kepler;
    k->delta_n_radps = k->idot_radps = k->omega_dot_radps = 0;
    k->cuc_rad = k->cus_rad = k->crc_m = k->crs_m = k->cic_rad = k->cis_rad = 0;
    const double gm = 3.986005e14, u = 7.2921151467e-5, a = k->sqrt_a_sqrtm * k->sqrt_a_sqrtm;
    for (double dt = -7000; dt < 7000; dt += 1234) {
        orr_broadcast_state s;
        assert_int_equal(orr_broadcast_eval(&e, orr_time_add_s(e.toe, dt), &s), ORR_OK);
        orr_kepler el = {a,
                         k->e,
                         k->i0_rad,
                         k->omega0_rad - u * (7200 + dt),
                         k->omega_rad,
                         k->m0_rad + sqrt(gm / (a * a * a)) * dt,
                         0};
        orr_vec3 r, v;
        orr_kepler_to_state(&el, gm, &r, &v);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.pos_m, r)), 0, 1e-6);
        orr_vec3 turning = orr_vec3_sub(v, orr_vec3_cross((orr_vec3){0, 0, u}, r));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s.vel_mps, turning)), 0, 1e-9);
        const double c = ORR_LIGHT_MPS;
        ASSERT_NEAR(s.relativity_s, -2 * orr_vec3_dot(r, v) / (c * c), 1e-17);
    }
}

static orr_nav_eph made_glonass(void)
{
    orr_nav_eph e = {.sat = orr_sat_parse("R07"),
                     .kind = ORR_NAV_GLONASS,
                     .message = ORR_NAV_FDMA,
                     .transmission = ORR_TIME_NONE};
    e.toe = e.toc = orr_time_from_week(2300, 9900 * ORR_NS_PER_S);
    e.glonass.pos_m = (orr_vec3){7003008.789, -12206626.953, 21280765.625};
    e.glonass.vel_mps = (orr_vec3){783.5417, 2804.2530, 1352.5150};
    e.glonass.acc_mps2 = (orr_vec3){0, 1.7e-6, -5.41e-6};
    return e;
}

// The worked example of the GLONASS ICD 5.1 (A.3.1.2): a state carried over 600 s. The printed result lies
// between ours with and without the broadcast lunisolar acceleration (1 m of effect along axis 3), so no
// better than that can be asked.
static void glonass_icd_example(void **state)
{
    (void)state;
    orr_nav_eph e = made_glonass();
    orr_broadcast_state s;
    assert_int_equal(orr_broadcast_eval(&e, orr_time_add_s(e.toe, 600), &s), ORR_OK);
    ASSERT_NEAR(s.pos_m.x, 7523174.819, 0.6);
    ASSERT_NEAR(s.pos_m.y, -10506961.965, 0.6);
    ASSERT_NEAR(s.pos_m.z, 21999239.413, 0.6);
    ASSERT_NEAR(s.vel_mps.x, 950.126007, 0.002);
    ASSERT_NEAR(s.vel_mps.y, 2855.687825, 0.002);
    ASSERT_NEAR(s.vel_mps.z, 1040.679862, 0.002);
}

static void glonass_runs_both_ways_and_its_derivatives_hold(void **state)
{
    (void)state;
    orr_nav_eph e = made_glonass();
    check_derivatives(&e, 1000, 1e-5, 1e-8); // and steps of 60 s differ by a part of their 1e-6 m
    orr_broadcast_state there;
    assert_int_equal(orr_broadcast_eval(&e, orr_time_add_s(e.toe, 900), &there), ORR_OK);
    orr_nav_eph back = e;
    back.toe = orr_time_add_s(e.toe, 900);
    back.glonass.pos_m = there.pos_m;
    back.glonass.vel_mps = there.vel_mps;
    orr_broadcast_state home;
    assert_int_equal(orr_broadcast_eval(&back, e.toe, &home), ORR_OK);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(home.pos_m, e.glonass.pos_m)), 0,
                1e-4); // fourth order, 60 s steps
    assert_int_equal(orr_broadcast_eval(&e, orr_time_add_s(e.toe, 90000), &there), ORR_E_RANGE);
}

static void geo_is_a_parabola(void **state)
{
    (void)state;
    orr_nav_eph e = {.sat = orr_sat_parse("S23"),
                     .kind = ORR_NAV_GEO,
                     .message = ORR_NAV_SBAS,
                     .transmission = ORR_TIME_NONE};
    e.geo.pos_m = (orr_vec3){4.2e7, 1e6, 2e4};
    e.geo.vel_mps = (orr_vec3){1, -2, 0.5};
    e.geo.acc_mps2 = (orr_vec3){0, 1e-5, 2e-5};
    orr_broadcast_state s;
    assert_int_equal(orr_broadcast_eval(&e, 100 * ORR_NS_PER_S, &s), ORR_OK);
    ASSERT_NEAR(s.pos_m.z, 2e4 + 50 + 0.1, 1e-9);
    ASSERT_NEAR(s.vel_mps.y, -2 + 1e-3, 1e-12);
}

static void the_nearest_healthy_allowed_record_is_chosen(void **state)
{
    (void)state;
    orr_nav_eph e[4] = {made("G05", ORR_NAV_LNAV), made("G05", ORR_NAV_LNAV), made("G05", ORR_NAV_LNAV),
                        made("G05", ORR_NAV_CNAV)};
    orr_time toe = e[0].toe;
    for (int i = 0; i < 3; i++) {
        e[i].toe = orr_time_add_s(toe, 7200.0 * i);
        e[i].transmission = orr_time_add_s(toe, 7200.0 * i - 7000);
        e[i].iode = e[i].iodc = 10 + i;
    }
    e[1].health = 63;
    e[3].toe = orr_time_add_s(toe, 3 * 7200.0);
    orr_nav nav = {.n_eph = 4, .eph = e};
    orr_broadcast_choice c = orr_broadcast_choice_default();
    orr_sat sat = e[0].sat;
    assert_ptr_equal(orr_broadcast_select(&nav, sat, toe, &c), &e[0]);
    assert_null(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 7300), &c) == &e[1] ? &e[1] : NULL);
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 7300), &c),
                     &e[2]); // the unhealthy one is passed over
    c.healthy = false;
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 7300), &c), &e[1]);
    c.iode = 12;
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 7300), &c), &e[2]);
    c = orr_broadcast_choice_default();
    c.causal = true;
    c.healthy = false;
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 100), &c),
                     &e[0]); // e[1] is not sent before toe + 200
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 3700), &c), &e[1]);
    c.causal = false;
    assert_null(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 30000), &c)); // stale
    c.messages = 1u << ORR_NAV_CNAV;
    assert_ptr_equal(orr_broadcast_select(&nav, sat, orr_time_add_s(toe, 20000), &c), &e[3]);
    assert_null(orr_broadcast_select(&nav, orr_sat_parse("G06"), toe, &c));
}

// A satellite of which the file has no legacy record is served by what there is; of one that has one, stale or not, by
// that alone; and a list of messages decides in the systems that have one of them.
static void other_messages_stand_in(void **state)
{
    (void)state;
    orr_nav_eph e[4] = {made("G05", ORR_NAV_LNAV), made("G05", ORR_NAV_CNAV), made("G07", ORR_NAV_CNAV),
                        made("E11", ORR_NAV_FNAV)};
    orr_nav nav = {.n_eph = 4, .eph = e};
    orr_broadcast_choice c = orr_broadcast_choice_default();
    const orr_time toe = e[0].toe;
    e[1].toe = orr_time_add_s(toe, 30000);
    assert_ptr_equal(orr_broadcast_select(&nav, e[0].sat, toe, &c), &e[0]);
    assert_null(orr_broadcast_select(&nav, e[0].sat, e[1].toe, &c)); // no change of message in mid-file
    assert_ptr_equal(orr_broadcast_select(&nav, e[2].sat, toe, &c), &e[2]);
    assert_ptr_equal(orr_broadcast_select(&nav, e[3].sat, toe, &c), &e[3]);
    orr_diag d;
    ASSERT_OK(orr_nav_messages_parse("cnav,INAV", &c.messages, &d), d);
    assert_ptr_equal(orr_broadcast_select(&nav, e[0].sat, e[1].toe, &c), &e[1]);
    assert_null(orr_broadcast_select(&nav, e[3].sat, toe, &c)); // Galileo has I/NAV, this file has none
    uint32_t named, same;
    ASSERT_OK(orr_nav_messages_parse("BCNAV1,bcnav3,CNAV2", &named, &d), d);
    ASSERT_OK(orr_nav_messages_parse("CNV1,CNV3,CNV2", &same, &d), d);
    assert_int_equal(named, same);
    assert_int_equal(orr_nav_messages_parse("CNAV,XNAV", &c.messages, &d), ORR_E_ARG);
    assert_non_null(strstr(d.text, "XNAV"));
    assert_int_equal(orr_nav_messages_parse("", &c.messages, &d), ORR_E_ARG);
}

// Galileo's elements serve what follows their toe.
static void galileo_is_not_used_long_before_its_toe(void **state)
{
    (void)state;
    orr_nav_eph e = made("E11", ORR_NAV_INAV);
    const orr_nav nav = {.n_eph = 1, .eph = &e};
    orr_broadcast_choice c = orr_broadcast_choice_default();
    assert_ptr_equal(orr_broadcast_select(&nav, e.sat, orr_time_add_s(e.toe, 3.9 * 3600), &c), &e);
    assert_ptr_equal(orr_broadcast_select(&nav, e.sat, orr_time_add_s(e.toe, -1700), &c), &e);
    assert_null(orr_broadcast_select(&nav, e.sat, orr_time_add_s(e.toe, -1900), &c));
    c.max_age_s = 7200; // the caller's word counts on both sides
    assert_ptr_equal(orr_broadcast_select(&nav, e.sat, orr_time_add_s(e.toe, -1900), &c), &e);
    e = made("G05", ORR_NAV_LNAV);
    c = orr_broadcast_choice_default();
    assert_ptr_equal(orr_broadcast_select(&nav, e.sat, orr_time_add_s(e.toe, -7000), &c), &e);
}

// A week's end is an instant like any other: toe late on Saturday, t early on Sunday.
static void week_ends_do_not_show(void **state)
{
    (void)state;
    orr_nav_eph e = made("G05", ORR_NAV_LNAV);
    e.toe = e.toc = orr_time_from_week(2299, (int64_t)604000 * ORR_NS_PER_S);
    e.kepler.toe_sow_s = 604000;
    check_derivatives(&e, 3600, 1e-6, 3e-10);
}

static void pz90_realisations_change_on_their_days(void **state)
{
    (void)state;
    orr_vec3 r = {1.5e7, -1.5e7, 1.5e7};
    orr_time t = 0;
    assert_int_equal(orr_time_parse("2020-01-01", NULL, &t, NULL), ORR_OK);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_broadcast_pz90_to_itrf(r, t), r)), 0, 0);
    assert_int_equal(orr_time_parse("2009-04-01", NULL, &t, NULL), ORR_OK);
    orr_vec3 d = orr_vec3_sub(orr_broadcast_pz90_to_itrf(r, t), r);
    ASSERT_NEAR(d.x, -0.36, 1e-8);
    ASSERT_NEAR(d.y, 0.08, 1e-8);
    ASSERT_NEAR(d.z, 0.18, 1e-8);
    assert_int_equal(orr_time_parse("2005-04-02", NULL, &t, NULL), ORR_OK);
    d = orr_vec3_sub(orr_broadcast_pz90_to_itrf(r, t), r);
    ASSERT_NEAR(orr_vec3_norm(d), 14, 8); // the turn alone is 13 m at such a radius
}

static void group_delays_follow_the_message(void **state)
{
    (void)state;
    orr_nav_eph e = made("G05", ORR_NAV_LNAV);
    e.delay.tgd_s = -1e-8;
    double d = 0;
    assert_int_equal(orr_broadcast_group_delay(&e, "1C", &d), ORR_OK);
    ASSERT_NEAR(d, -1e-8, 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "2W", &d), ORR_OK);
    ASSERT_NEAR(d, -1e-8 * (77.0 * 77) / (60.0 * 60), 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "5Q", &d), ORR_E_NODATA);
    e = made("E11", ORR_NAV_FNAV);
    e.delay.bgd_e5a_e1_s = 2e-9;
    assert_int_equal(orr_broadcast_group_delay(&e, "5Q", &d), ORR_OK);
    ASSERT_NEAR(d, 2e-9 * (154.0 * 154) / (115.0 * 115), 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "5", &d), ORR_E_ARG);

    // I/NAV tells E5a too. What defines BGD(E1, E5a): the lag of E5a less that of E1 is (gamma - 1) of it, whichever
    // message's clock they are counted from.
    e = made("E11", ORR_NAV_INAV);
    e.delay.bgd_e5a_e1_s = 2e-9;
    e.delay.bgd_e5b_e1_s = 3e-9;
    double e1 = 0, e5a = 0;
    assert_int_equal(orr_broadcast_group_delay(&e, "1C", &e1), ORR_OK);
    assert_int_equal(orr_broadcast_group_delay(&e, "5Q", &e5a), ORR_OK);
    ASSERT_NEAR(e1, 3e-9, 1e-20);
    ASSERT_NEAR(e5a - e1, 2e-9 * ((154.0 * 154) / (115.0 * 115) - 1), 1e-20);
    // The ionosphere-free pair of E1 and E5b has no delay against I/NAV's clock.
    double e5b = 0;
    const double g = (154.0 * 154) / (118.0 * 118);
    assert_int_equal(orr_broadcast_group_delay(&e, "7I", &e5b), ORR_OK);
    ASSERT_NEAR((g * e1 - e5b) / (g - 1), 0, 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "8Q", &d), ORR_E_NODATA);
    assert_int_equal(orr_broadcast_group_delay(&e, "1W", &d), ORR_E_NODATA); // no such signal

    // CNAV: TGD - ISC for each signal; P(Y) as LNAV has it. "1P" is P(Y), not L1C's pilot, which is "1L".
    e = made("G05", ORR_NAV_CNV2);
    e.delay = (orr_nav_delays){.tgd_s = -1e-8,
                               .isc_l1ca_s = 1e-9,
                               .isc_l2c_s = 2e-9,
                               .isc_l5i5_s = 3e-9,
                               .isc_l5q5_s = 4e-9,
                               .isc_l1cd_s = 5e-9,
                               .isc_l1cp_s = 6e-9};
    static const struct {
        const char *signal;
        double isc_s;
    } cnav[] = {{"1C", 1e-9}, {"2L", 2e-9}, {"2S", 2e-9}, {"5I", 3e-9}, {"5Q", 4e-9},
                {"1S", 5e-9}, {"1L", 6e-9}, {"1P", 0},    {"1W", 0}};
    for (size_t i = 0; i < sizeof cnav / sizeof *cnav; i++) {
        assert_int_equal(orr_broadcast_group_delay(&e, cnav[i].signal, &d), ORR_OK);
        ASSERT_NEAR(d, -1e-8 - cnav[i].isc_s, 1e-20);
    }
    assert_int_equal(orr_broadcast_group_delay(&e, "2W", &d), ORR_OK);
    ASSERT_NEAR(d, -1e-8 * (77.0 * 77) / (60.0 * 60), 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "1D", &d), ORR_E_NODATA);
    assert_int_equal(orr_broadcast_group_delay(&e, "7Q", &d), ORR_E_NODATA);
    e = made("C30", ORR_NAV_D1);
    e.delay.tgd_s = 5e-9;
    e.delay.tgd2_s = 7e-9;
    assert_int_equal(orr_broadcast_group_delay(&e, "7I", &d), ORR_OK);
    ASSERT_NEAR(d, 7e-9, 1e-20);
    assert_int_equal(orr_broadcast_group_delay(&e, "7D", &d), ORR_E_NODATA); // B2b of D1 nobody tells
    assert_int_equal(orr_broadcast_group_delay(&e, "2C", &d), ORR_E_NODATA);
}

// Two stations' files: what both recorded is one record, order is by satellite and toe.
static void files_merge_into_one(void **state)
{
    (void)state;
    orr_nav_eph a[2] = {made("G05", ORR_NAV_LNAV), made("G07", ORR_NAV_LNAV)};
    orr_nav_eph b[2] = {made("G05", ORR_NAV_LNAV), made("G05", ORR_NAV_LNAV)};
    b[1].toe = orr_time_add_s(b[1].toe, 7200);
    orr_nav in[2] = {{.n_eph = 2, .eph = a}, {.n_eph = 2, .eph = b}}, out;
    orr_diag d = {0};
    ASSERT_OK(orr_nav_merge(in, 2, &out, NULL, &d), d);
    assert_int_equal(out.n_eph, 3);
    assert_true(out.eph[0].sat == a[0].sat && out.eph[1].sat == a[0].sat && out.eph[2].sat == a[1].sat);
    assert_true(out.eph[0].toe < out.eph[1].toe);
    orr_nav_free(&out);
}

// Two files that contradict each other about one issue: both are kept and it is told; the one transmitted last is used,
// whichever file comes first.
static void conflicts_are_told_and_the_newest_wins(void **state)
{
    (void)state;
    orr_nav_eph a = made("G05", ORR_NAV_LNAV), b = a;
    a.transmission = orr_time_add_s(a.toe, -7000);
    b.transmission = orr_time_add_s(a.toe, -3600);
    b.kepler.m0_rad += 1e-6;
    a.line = 10;
    b.line = 20;
    for (int turned = 0; turned < 2; turned++) {
        orr_nav in[2] = {{.n_eph = 1, .eph = turned ? &b : &a}, {.n_eph = 1, .eph = turned ? &a : &b}}, out;
        orr_diag d = {0};
        orr_warnings w = {0};
        ASSERT_OK(orr_nav_merge(in, 2, &out, &w, &d), d);
        assert_int_equal(out.n_eph, 2);
        assert_int_equal(w.count, 1);
        assert_non_null(strstr(w.item[0].text, "G05"));
        const orr_broadcast_choice c = orr_broadcast_choice_default();
        assert_true(orr_broadcast_select(&out, a.sat, a.toe, &c)->kepler.m0_rad == b.kepler.m0_rad);
        orr_nav_free(&out);
        orr_warnings_free(&w);
    }
    b = a; // what two programs wrote with twelve digits is no contradiction
    b.kepler.sqrt_a_sqrtm *= 1 + 1e-13;
    orr_nav in[2] = {{.n_eph = 1, .eph = &a}, {.n_eph = 1, .eph = &b}}, out;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_nav_merge(in, 2, &out, &w, &d), d);
    assert_int_equal(out.n_eph, 1);
    assert_int_equal(w.count, 0);
    orr_nav_free(&out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(other_messages_stand_in),
        cmocka_unit_test(conflicts_are_told_and_the_newest_wins),
        cmocka_unit_test(derivatives_are_exact_for_every_kepler_message),
        cmocka_unit_test(beidou_geo_stands_still),
        cmocka_unit_test(bare_elements_are_a_kepler_ellipse),
        cmocka_unit_test(glonass_icd_example),
        cmocka_unit_test(glonass_runs_both_ways_and_its_derivatives_hold),
        cmocka_unit_test(geo_is_a_parabola),
        cmocka_unit_test(the_nearest_healthy_allowed_record_is_chosen),
        cmocka_unit_test(galileo_is_not_used_long_before_its_toe),
        cmocka_unit_test(week_ends_do_not_show),
        cmocka_unit_test(pz90_realisations_change_on_their_days),
        cmocka_unit_test(group_delays_follow_the_message),
        cmocka_unit_test(files_merge_into_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
