// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files made field by field: every number must arrive where the format's tables put it.
#include "testing.h"

#include <unistd.h>

#include "rinex_nav_text.h"

static void gps_of_version_2(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        text t = {0};
        orr_warnings w = {0};
        text_header(&t, "     2.11           N: GPS NAV DATA", "RINEX VERSION / TYPE");
        text_header(&t, "    0.1118D-07  0.2235D-07 -0.5960D-07 -0.1192D-06", "ION ALPHA");
        text_header(&t, "    0.9011D+05  0.1311D+06 -0.6554D+05 -0.5898D+06", "ION BETA");
        text_header(&t, "     .279396772385D-08 -.177635683940D-13   147456     1500",
                    "DELTA-UTC: A0,A1,T,W");
        text_header(&t, "    14", "LEAP SECONDS");
        text_header(&t, "", "END OF HEADER");
        double set[28];
        memcpy(set, orbit, sizeof set);
        set[18] = 1500; // 2008-10-05 is the first day of GPS week 1500
        kepler(&t, " 7 08 10  5  2  0  0.0", 3, 7, set, exponents[i]);
        orr_nav nav = parse(&t, &w);
        assert_int_equal(w.count, 0);
        assert_int_equal(nav.n_eph, 1);
        const orr_nav_eph *e = &nav.eph[0];
        assert_int_equal(e->sat, orr_sat_make('G', 7));
        assert_int_equal(e->message, ORR_NAV_LNAV);
        assert_true(e->toe == at(2008, 10, 5, 2, 0, 0, ORR_SCALE_GPS) && e->toc == e->toe);
        assert_true(e->transmission == e->toe - 300 * ORR_NS_PER_S);
        assert_orbit(e);
        assert_int_equal(e->iode, 45);
        assert_int_equal(e->iodc, 45);
        assert_int_equal(e->week, 1500);
        assert_int_equal(e->data_sources, 1);
        ASSERT_NEAR(e->accuracy_m, 2.5, 0);
        ASSERT_NEAR(e->delay.tgd_s, 4.6e-9, 0);
        ASSERT_NEAR(e->fit_interval_h, 4, 0);
        assert_true(orr_nav_eph_usable(e));
        assert_int_equal(nav.n_iono, 1);
        ASSERT_NEAR(nav.iono[0].coefficient[0], 0.1118e-7, 0);
        ASSERT_NEAR(nav.iono[0].coefficient[7], -0.5898e6, 0);
        assert_int_equal(nav.n_sto, 1);
        assert_string_equal(nav.sto[0].code, "GPUT");
        assert_true(nav.sto[0].t_ref == orr_time_from_week(1500, 147456 * ORR_NS_PER_S));
        assert_true(nav.has_leap && nav.leap_s == 14);
        orr_nav_free(&nav);
        text_free(&t);
    }
}

static void glonass_state(text *t, int indent, bool flags)
{
    double rows[4][4] = {
        {12000.5, 1.5, 1e-9, 0}, {-15000.25, -2.25, 0, -7}, {16000, 0.5, -2e-9, 3}, {179, 8e-9, 2, 3}};
    for (int i = 0; i < (flags ? 4 : 3); i++) text_fields(t, indent, 'D', 4, rows[i]);
}

static void assert_glonass(const orr_nav_eph *e)
{
    const orr_nav_glonass *g = &e->glonass;
    assert_int_equal(e->kind, ORR_NAV_GLONASS);
    ASSERT_NEAR(g->pos_m.x, 12000500, 1e-9);
    ASSERT_NEAR(g->pos_m.y, -15000250, 1e-9);
    ASSERT_NEAR(g->vel_mps.y, -2250, 1e-12);
    ASSERT_NEAR(g->acc_mps2.z, -2e-6, 1e-20);
    ASSERT_NEAR(e->af0_s, 7.5e-5, 0);
    ASSERT_NEAR(e->af1_sps, 1e-12, 0);
    assert_int_equal(g->freq_channel, -7);
    ASSERT_NEAR(g->age_days, 3, 0);
    assert_true(orr_nav_eph_usable(e));
}

static void glonass(void **state)
{
    (void)state;
    orr_warnings w = {0};
    double clock[3] = {7.5e-5, 1e-12, 86370};
    text t = {0};
    text_header(&t, "     2.10           G: GLONASS NAV DATA", "RINEX VERSION / TYPE");
    text_header(&t, "  2009     4     1     -.158790498972D-06", "CORR TO SYSTEM TIME");
    text_header(&t, "", "END OF HEADER");
    text_add(&t, " 3 09  4  1  0 15  0.0");
    text_fields(&t, 0, 'D', 3, clock);
    glonass_state(&t, 3, false);
    orr_nav nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 1);
    assert_glonass(&nav.eph[0]);
    // The epoch is UTC (15 leap seconds in 2009), and the frame of 23:59:30 belongs to the day before.
    assert_true(nav.eph[0].toe == at(2009, 4, 1, 0, 15, 15, ORR_SCALE_GPS));
    assert_true(nav.eph[0].transmission == at(2009, 3, 31, 23, 59, 30, ORR_SCALE_UTC));
    assert_false(nav.eph[0].glonass.has_flags);
    assert_string_equal(nav.sto[0].code, "GLUT");
    ASSERT_NEAR(nav.sto[0].a0_s, -0.158790498972e-6, 0);
    orr_nav_free(&nav);
    text_free(&t);

    header_v3(&t, "3.05");
    for (int flags = 0; flags < 2; flags++) { // files of 3.05 without the fourth line exist
        text_add(&t, "R%02d 2024 02 04 00 15 00", 5 + flags);
        text_fields(&t, 0, 'D', 3, clock);
        glonass_state(&t, 4, flags);
    }
    nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 2);
    assert_glonass(&nav.eph[0]);
    assert_glonass(&nav.eph[1]);
    assert_true(nav.eph[0].toe == at(2024, 2, 4, 0, 15, 18, ORR_SCALE_GPS));
    assert_false(nav.eph[0].glonass.has_flags);
    assert_true(nav.eph[1].glonass.has_flags);
    assert_int_equal(nav.eph[1].glonass.status_flags, 179);
    ASSERT_NEAR(nav.eph[1].glonass.delta_tau_s, 8e-9, 0);
    assert_int_equal(nav.eph[1].glonass.health_flags, 3);
    assert_int_equal(w.count, 0);
    orr_nav_free(&nav);
    text_free(&t);
}

static void every_system_of_version_3(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "3.04");
    double set[28];
    memcpy(set, orbit, sizeof set);
    kepler(&t, "G07 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[17] = 517; // I/NAV E1-B and E5b, clock for E5b, E1
    set[23] = -5e-9;
    kepler(&t, "E11 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[17] = 258; // F/NAV E5a
    kepler(&t, "E11 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[18] = 944; // BDT week
    set[25] = 3;
    kepler(&t, "C03 2024 02 04 02 00 00", 4, 7, set, 'E');
    kepler(&t, "C30 2024 02 04 02 00 00", 4, 7, set, 'E');
    memcpy(set, orbit, sizeof set);
    set[21] = 1; // L1C/B alone is unhealthy
    set[25] = 1;
    kepler(&t, "J02 2024 02 04 02 00 00", 4, 7, set, 'E');
    memcpy(set, orbit, sizeof set);
    set[17] = set[19] = set[23] = B;
    kepler(&t, "I05 2024 02 04 02 00 00", 4, 7, set, 'E');
    text_add(&t, "S33 2024 02 04 00 15 00");
    double clock[3] = {7.5e-5, 1e-12, 420},
           rows[3][4] = {{42000, 0, 0, 0}, {1500, 0.001, 0, 4}, {10, 0, 1e-9, 17}};
    text_fields(&t, 0, 'E', 3, clock);
    for (int i = 0; i < 3; i++) text_fields(&t, 4, 'E', 4, rows[i]);
    orr_nav nav = parse(&t, &w);
    assert_int_equal(w.count, 0);
    assert_int_equal(nav.n_eph, 8);
    static const int message[] = {ORR_NAV_LNAV, ORR_NAV_INAV, ORR_NAV_FNAV, ORR_NAV_D2,
                                  ORR_NAV_D1,   ORR_NAV_LNAV, ORR_NAV_LNAV, ORR_NAV_SBAS};
    static const char sats[8][4] = {"G07", "E11", "E11", "C03", "C30", "J02", "I05", "S33"};
    for (size_t i = 0; i < 8; i++) {
        char id[ORR_SAT_TEXT];
        assert_string_equal(orr_sat_text(nav.eph[i].sat, id), sats[i]);
        assert_int_equal(nav.eph[i].message, message[i]);
        assert_true(orr_nav_eph_usable(&nav.eph[i]));
        if (nav.eph[i].kind == ORR_NAV_KEPLER) assert_orbit(&nav.eph[i]);
    }
    assert_true(nav.eph[0].toe == at(2024, 2, 4, 2, 0, 0, ORR_SCALE_GPS));
    assert_true(nav.eph[3].toe == at(2024, 2, 4, 2, 0, 14, ORR_SCALE_GPS)); // BDT is 14 s behind
    assert_true(nav.eph[3].transmission == at(2024, 2, 4, 1, 55, 14, ORR_SCALE_GPS));
    ASSERT_NEAR(nav.eph[1].delay.bgd_e5a_e1_s, 4.6e-9, 0);
    ASSERT_NEAR(nav.eph[1].delay.bgd_e5b_e1_s, -5e-9, 0);
    ASSERT_NEAR(nav.eph[3].delay.tgd2_s, -5e-9, 0);
    assert_int_equal(nav.eph[3].iodc, 3);
    ASSERT_NEAR(nav.eph[5].fit_interval_h, 4, 0);
    ASSERT_NEAR(nav.eph[7].geo.pos_m.x, 42e6, 0);
    assert_int_equal(nav.eph[7].geo.iodn, 17);
    assert_true(nav.eph[7].transmission == at(2024, 2, 4, 0, 7, 0, ORR_SCALE_GPS));
    size_t first = 0, count = 0;
    orr_nav_of_sat(&nav, orr_sat_make('E', 11), &first, &count);
    assert_int_equal(first, 1);
    assert_int_equal(count, 2);
    orr_nav_of_sat(&nav, orr_sat_make('E', 12), &first, &count);
    assert_int_equal(count, 0);
    orr_nav_free(&nav);
    text_free(&t);
}

static void records_of_version_4(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "4.02");
    double cnav[36];
    memcpy(cnav, orbit, sizeof cnav);
    cnav[0] = -0.005; // A dot
    cnav[17] = 1e-14; // delta n dot
    cnav[8] = 3600;   // time of prediction
    cnav[18] = -6, cnav[19] = 2, cnav[20] = -1, cnav[23] = 7;
    for (int i = 24; i < 28; i++) cnav[i] = i * 1e-10;
    cnav[28] = 7000, cnav[29] = 2299;
    text_add(&t, "> EPH G07 CNAV\n");
    kepler(&t, "G07 2024 02 04 02 00 00", 4, 8, cnav, 'E');
    cnav[28] = 2.8e-9, cnav[29] = 2.9e-9, cnav[30] = cnav[31] = B, cnav[32] = 7010, cnav[33] = 2299;
    text_add(&t, "> EPH G07 CNV2\n");
    kepler(&t, "G07 2024 02 04 02 00 00", 4, 9, cnav, 'E');
    double bds[36];
    memcpy(bds, orbit, sizeof bds);
    bds[0] = -0.005, bds[17] = 1e-14, bds[18] = 3, bds[19] = 3600;
    for (int i = 20; i < 36; i++) bds[i] = i - 15;
    bds[24] = 1e-9, bds[25] = B, bds[26] = 2e-9, bds[27] = 3e-9, bds[32] = 7100;
    text_add(&t, "> EPH C30 CNV1\n");
    kepler(&t, "C30 2024 02 04 02 00 00", 4, 9, bds, 'E');
    bds[24] = 12, bds[25] = 0, bds[26] = 4, bds[27] = -4e-9, bds[28] = 7100;
    text_add(&t, "> EPH C30 CNV3\n");
    kepler(&t, "C30 2024 02 04 02 00 00", 4, 8, bds, 'E');
    double l1nv[36];
    memcpy(l1nv, cnav, sizeof l1nv);
    l1nv[8] = 7200, l1nv[20] = 2.0, l1nv[22] = 1e-9, l1nv[23] = 2e-9, l1nv[28] = 7020, l1nv[29] = 2300;
    text_add(&t, "> EPH I05 L1NV\n");
    kepler(&t, "I05 2024 02 04 02 00 00", 4, 8, l1nv, 'E');
    text_add(&t, "> EPH R05 L3OC\n");
    kepler(&t, "R05 2024 02 04 02 00 00", 4, 7, orbit, 'E');
    text_add(&t, "> STO G07 LNAV\n    2024 02 04 02 00 00 GPUT               EGNOS              UTC(USNO)\n");
    text_fields(&t, 4, 'E', 4, (double[]){7000, 1e-9, 2e-15, 3e-20});
    text_add(&t, "> ION C30 CNVX\n    2024 02 04 02 00 00");
    text_fields(&t, 0, 'E', 3, (double[]){1, 2, 3});
    text_fields(&t, 4, 'E', 4, (double[]){4, 5, 6, 7});
    text_fields(&t, 4, 'E', 2, (double[]){8, 9});
    text_add(&t, "> ION E11 IFNV\n    2024 02 04 02 00 00");
    text_fields(&t, 0, 'E', 3, (double[]){160, 0.37, 0.009});
    text_fields(&t, 4, 'E', 1, (double[]){5});
    text_add(&t, "> ION J02 LNAV\n    2024 02 04 02 00 00");
    text_fields(&t, 0, 'E', 3, (double[]){1, 2, 3});
    text_fields(&t, 4, 'E', 4, (double[]){4, 5, 6, 7});
    text_fields(&t, 4, 'E', 2, (double[]){8, 1});
    text_add(&t, "> ION I05 L1NV NEQN\n    2024 02 04 02 00 00");
    text_fields(&t, 0, 'E', 1, (double[]){77});
    for (int i = 0; i < 6; i++)
        text_fields(&t, 4, 'E', 4, (double[]){4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
    text_add(&t, "> EOP G27 CNVX\n    2024 02 04 02 00 00");
    text_fields(&t, 0, 'E', 3, (double[]){-0.04, 4e-5, 0});
    text_fields(&t, 4, 'E', 4, (double[]){B, 0.36, 2.6e-3, 0});
    text_fields(&t, 4, 'E', 4, (double[]){7000, -0.019, -1.4e-4, 0});
    orr_nav nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 5);
    assert_int_equal(nav.n_skipped, 1);
    assert_int_equal(w.count, 1); // L3OC
    const orr_nav_eph *g = &nav.eph[0];
    assert_int_equal(g->message, ORR_NAV_CNAV);
    assert_true(g->toe == g->toc && g->toe == at(2024, 2, 4, 2, 0, 0, ORR_SCALE_GPS));
    ASSERT_NEAR(g->kepler.a_dot_mps, -0.005, 0);
    ASSERT_NEAR(g->kepler.delta_n_dot_radps2, 1e-14, 0);
    ASSERT_NEAR(g->kepler.top_sow_s, 3600, 0);
    ASSERT_NEAR(g->kepler.toe_sow_s, 7200, 0);
    assert_int_equal(g->ura_ned[0], -6);
    assert_int_equal(g->ura_ned[1], 2);
    assert_int_equal(g->ura_ned[2], 7);
    assert_int_equal(g->ura_ed, -1);
    ASSERT_NEAR(g->delay.isc_l5q5_s, 27e-10, 0);
    assert_true(g->transmission == g->toe - 200 * ORR_NS_PER_S);
    assert_int_equal(nav.eph[1].message, ORR_NAV_CNV2);
    ASSERT_NEAR(nav.eph[1].delay.isc_l1cp_s, 2.9e-9, 0);
    const orr_nav_eph *c = &nav.eph[2];
    assert_int_equal(c->message, ORR_NAV_CNV1);
    assert_int_equal(c->sat_type, 3);
    ASSERT_NEAR(c->delay.isc_b1cd_s, 1e-9, 0);
    ASSERT_NEAR(c->delay.tgd_b2ap_s, 3e-9, 0);
    assert_int_equal(c->sismai, 13);
    assert_int_equal(c->health, 14);
    assert_int_equal(c->iodc, 16);
    assert_int_equal(c->iode, 20);
    assert_int_equal(nav.eph[3].message, ORR_NAV_CNV3);
    assert_int_equal(nav.eph[3].sismai, 12);
    ASSERT_NEAR(nav.eph[3].delay.tgd_s, -4e-9, 0);
    assert_int_equal(nav.eph[4].message, ORR_NAV_L1NV);
    ASSERT_NEAR(nav.eph[4].delay.tgd2_s, 2e-9, 0);
    assert_int_equal(nav.n_sto, 1);
    assert_string_equal(nav.sto[0].sbas_id, "EGNOS");
    assert_string_equal(nav.sto[0].utc_id, "UTC(USNO)");
    ASSERT_NEAR(nav.sto[0].a2_sps2, 3e-20, 0);
    assert_int_equal(nav.n_iono, 4);
    static const int kinds[] = {ORR_NAV_BDGIM, ORR_NAV_NEQUICK_G, ORR_NAV_KLOBUCHAR, ORR_NAV_NEQUICK_N},
                     counts[] = {9, 3, 8, 24};
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(nav.iono[i].kind, kinds[i]);
        if (i != 1)
            for (int k = 0; k < counts[i]; k++) ASSERT_NEAR(nav.iono[i].coefficient[k], k + (i < 3), 0);
    }
    assert_int_equal(nav.iono[1].flags, 5);
    assert_int_equal(nav.iono[2].flags, 1);
    assert_int_equal(nav.iono[3].iod, 77);
    assert_int_equal(nav.n_eop, 1);
    ASSERT_NEAR(nav.eop[0].yp_rad, 0.36 * 4.84813681109536e-6, 1e-20);
    ASSERT_NEAR(nav.eop[0].dut1_rate_sps, -1.4e-4 / 86400, 1e-24);
    orr_nav_free(&nav);
    orr_warnings_free(&w);
    text_free(&t);
}

static void same_double(double a, double b)
{
    if (isnan(a) && isnan(b)) return;
    ASSERT_NEAR(a, b, 0);
}

// What is written must read back the same: twelve decimals are what the fields had.
static void written_and_read_back(void **state)
{
    (void)state;
    text t = {0};
    text_header(&t, "     3.05           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE");
    text_header(&t, "GPSA   1.1176E-08  2.2352E-08 -5.9605E-08 -1.1921E-07", "IONOSPHERIC CORR");
    text_header(&t, "GPSB   9.0112E+04  1.3107E+05 -6.5536E+04 -5.8982E+05", "IONOSPHERIC CORR");
    text_header(&t, "BDUT  5.5879354477E-09 9.769962617E-15 159414  790        3", "TIME SYSTEM CORR");
    text_header(&t, "    18    18  1929     7GPS", "LEAP SECONDS");
    text_header(&t, "", "END OF HEADER");
    double set[28], clock[3] = {7.5e-5, 1e-12, 900};
    memcpy(set, orbit, sizeof set);
    kepler(&t, "G07 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[24] = 0.9999e9;
    kepler(&t, "J02 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[17] = 517, set[20] = -1;
    kepler(&t, "E11 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[18] = 944, set[20] = 2, set[24] = 604790; // sent in the week before: the nearest such instant
    kepler(&t, "C30 2024 02 04 02 00 00", 4, 7, set, 'E');
    set[18] = 2300, set[23] = B;
    kepler(&t, "I05 2024 02 04 02 00 00", 4, 7, set, 'E');
    text_add(&t, "R05 2024 02 04 00 15 00");
    text_fields(&t, 0, 'E', 3, clock);
    glonass_state(&t, 4, true);
    text_add(&t, "S33 2024 02 04 00 15 00");
    text_fields(&t, 0, 'E', 3, clock);
    glonass_state(&t, 4, false);
    orr_nav a = parse(&t, NULL), b;
    assert_int_equal(a.n_eph, 7);
    char path[64];
    snprintf(path, sizeof path, "test_rinex_nav.%ld.rnx", (long)getpid());
    orr_diag diag = {0};
    size_t left = 99;
    a.eph[0].message = ORR_NAV_LNAV;
    ASSERT_OK(orr_nav_write(&a, path, &left, &diag), diag);
    assert_int_equal(left, 0);
    orr_warnings w = {0};
    ASSERT_OK(orr_nav_read(path, NULL, &b, &w, &diag), diag);
    unlink(path);
    assert_int_equal(w.count, 0);
    assert_int_equal(b.n_eph, a.n_eph);
    assert_int_equal(b.n_iono, 1);
    for (int i = 0; i < 8; i++) same_double(a.iono[0].coefficient[i], b.iono[0].coefficient[i]);
    assert_true(a.sto[0].t_ref == b.sto[0].t_ref);
    ASSERT_NEAR(a.sto[0].a1_sps, b.sto[0].a1_sps, 0);
    assert_int_equal(b.leap_s, 18);
    for (size_t i = 0; i < a.n_eph; i++) {
        const orr_nav_eph *x = &a.eph[i], *y = &b.eph[i];
        assert_int_equal(x->sat, y->sat);
        assert_int_equal(x->message, y->message);
        assert_true(x->toe == y->toe && x->toc == y->toc && x->transmission == y->transmission);
        assert_int_equal(x->health, y->health);
        assert_int_equal(x->iode, y->iode);
        same_double(x->accuracy_m, y->accuracy_m);
        same_double(x->delay.tgd_s, y->delay.tgd_s);
        same_double(x->delay.bgd_e5b_e1_s, y->delay.bgd_e5b_e1_s);
        if (x->kind == ORR_NAV_KEPLER) {
            const double *p = (const double *)&x->kepler, *q = (const double *)&y->kepler;
            for (size_t k = 0; k < sizeof x->kepler / sizeof *p; k++) same_double(p[k], q[k]);
        } else if (x->kind == ORR_NAV_GLONASS) {
            const orr_nav_glonass *p = &x->glonass, *q = &y->glonass;
            same_double(p->pos_m.x, q->pos_m.x);
            same_double(p->vel_mps.y, q->vel_mps.y);
            same_double(p->acc_mps2.z, q->acc_mps2.z);
            same_double(p->delta_tau_s, q->delta_tau_s);
            same_double(p->frame_time_s, q->frame_time_s);
            assert_int_equal(p->freq_channel, q->freq_channel);
            assert_int_equal(p->status_flags, q->status_flags);
        } else {
            same_double(x->geo.pos_m.z, y->geo.pos_m.z);
            same_double(x->geo.ura_m, y->geo.ura_m);
        }
    }
    orr_nav_free(&a);
    orr_nav_free(&b);
    text_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gps_of_version_2),          cmocka_unit_test(glonass),
        cmocka_unit_test(every_system_of_version_3), cmocka_unit_test(records_of_version_4),
        cmocka_unit_test(written_and_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
