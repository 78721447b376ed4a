// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files made field by field: every number must arrive where the format's tables put it.
#include "testing.h"

#include <unistd.h>

#include "core/cursor.h"
#include "ingest/rinex/rinex_nav.h"
#include "rinex_text.h"

#define B TEXT_BLANK

static orr_nav parse(const text *t, orr_warnings *w)
{
    orr_nav nav;
    orr_diag diag = {0};
    ASSERT_OK(orr_nav_parse("made.nav", t->p, t->n, NULL, &nav, w, &diag), diag);
    return nav;
}

static orr_time at(int y, int mo, int d, int h, int mi, int s, orr_scale scale)
{
    orr_civil c = {y, mo, d, h, mi, s, 0};
    orr_time t = 0;
    assert_int_equal(orr_time_from_civil(&c, scale, NULL, &t), ORR_OK);
    return t;
}

static const char *exponents = "DdEe"; // all are read

// A Kepler record whose k-th number after the clock is 1000 + k where nothing else is asked for.
static void kepler(text *t, const char *first, int indent, int lines, const double *set, char letter)
{
    double clock[3] = {-1.25e-4, 3.5e-12, 0};
    text_add(t, "%s", first);
    text_fields(t, 0, letter, 3, clock);
    for (int i = 0; i < lines; i++) text_fields(t, indent, letter, 4, set + 4 * i);
}

static const double orbit[36] = {45,   -88.5, 4.5e-9, 1.25, 2e-6,   0.0123, 7e-6,  5153.7, 7200,
                                 1e-7, -2.5,  -3e-8,  0.97, 250.25, 0.7,    -8e-9, 2e-10,  1,
                                 2300, 0,     2.5,    0,    4.6e-9, 45,     6900,  4,      B,
                                 B,    31,    32,     33,   34,     35,     36,    37,     38};

static void assert_orbit(const orr_nav_eph *e)
{
    const orr_nav_kepler *k = &e->kepler;
    ASSERT_NEAR(e->af0_s, -1.25e-4, 0);
    ASSERT_NEAR(e->af1_sps, 3.5e-12, 0);
    ASSERT_NEAR(k->crs_m, -88.5, 0);
    ASSERT_NEAR(k->delta_n_radps, 4.5e-9, 0);
    ASSERT_NEAR(k->m0_rad, 1.25, 0);
    ASSERT_NEAR(k->cuc_rad, 2e-6, 0);
    ASSERT_NEAR(k->e, 0.0123, 0);
    ASSERT_NEAR(k->cus_rad, 7e-6, 0);
    ASSERT_NEAR(k->sqrt_a_sqrtm, 5153.7, 0);
    ASSERT_NEAR(k->cic_rad, 1e-7, 0);
    ASSERT_NEAR(k->omega0_rad, -2.5, 0);
    ASSERT_NEAR(k->cis_rad, -3e-8, 0);
    ASSERT_NEAR(k->i0_rad, 0.97, 0);
    ASSERT_NEAR(k->crc_m, 250.25, 0);
    ASSERT_NEAR(k->omega_rad, 0.7, 0);
    ASSERT_NEAR(k->omega_dot_radps, -8e-9, 0);
    ASSERT_NEAR(k->idot_radps, 2e-10, 0);
}

static void header_v3(text *t, const char *version)
{
    char first[64];
    snprintf(first, sizeof first, "%9s           N: GNSS NAV DATA    M: MIXED", version);
    text_header(t, first, "RINEX VERSION / TYPE");
    text_header(t, "", "END OF HEADER");
}

// Only fields that are used decide over a record: whatever stands in the spare ones, it is read; what is no number in one
// that is used leaves it out.
static void spare_fields_do_not_matter(void **state)
{
    (void)state;
    static const struct {
        const char *first;
        int spare[3], used; // numbers of the fields behind the clock; -1: none
    } cases[] = {{"G05 2024 02 04 02 00 00", {26, 27, -1}, 25},
                 {"E05 2024 02 04 02 00 00", {19, 25, 27}, 23},
                 {"C06 2024 02 04 02 00 00", {17, 19, 26}, 22}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int spoil_used = 0; spoil_used < 2; spoil_used++) {
            text t = {0};
            double set[28];
            memcpy(set, orbit, sizeof set);
            for (int k = 0; k < 28; k++)
                if (set[k] == TEXT_BLANK) set[k] = 1;
            header_v3(&t, "3.04");
            const size_t start = t.n;
            kepler(&t, cases[i].first, 4, 7, set, 'E');
            char *lines = strchr(t.p + start, '\n') + 1;
            for (int k = 0; k < 4; k++) {
                const int at = k < 3 ? cases[i].spare[k] : cases[i].used;
                if (at < 0 || (k == 3 && !spoil_used)) continue;
                memcpy(lines + at / 4 * 81 + 4 + 19 * (at % 4),
                       k == 0 ? " 0.49906331467-269x" : " what is this?     ", 19);
            }
            orr_nav nav;
            orr_warnings w = {0};
            orr_diag d;
            const orr_status s = orr_nav_parse("made", t.p, t.n, NULL, &nav, &w, &d);
            if (spoil_used) {
                assert_int_equal(s, ORR_E_FORMAT);
            } else {
                ASSERT_OK(s, d);
                assert_int_equal(nav.n_eph, 1);
                assert_orbit(&nav.eph[0]);
                orr_nav_free(&nav);
            }
            orr_warnings_free(&w);
            text_free(&t);
        }
}

// Fortran drops the letter of an exponent of three digits.
static void exponents_without_a_letter(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        orr_field field;
        double value;
    } cases[] = {{"0.499063314674-269", ORR_FIELD_OK, 0.499063314674e-269},
                 {" -1.5+102 ", ORR_FIELD_OK, -1.5e102},
                 {"1.5-02", ORR_FIELD_BAD, 0},
                 {"15-002", ORR_FIELD_BAD, 0}, // no point: no real number of Fortran's
                 {"1.5-0021", ORR_FIELD_BAD, 0},
                 {"1.5+400", ORR_FIELD_BAD, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double v = 0;
        assert_int_equal(orr_view_real(orr_view_of(cases[i].text), &v), cases[i].field);
        if (cases[i].field == ORR_FIELD_OK) assert_true(v == cases[i].value);
    }
}

// The satellite and the time mark on one of the two lines alone.
static void halves_of_one_klobuchar_set(void **state)
{
    (void)state;
    static const char *const alpha[2] = {"BDSA   1.0000E-08  2.0000E-08  0.0000E+00  0.0000E+00",
                                         "BDSA   1.0000E-08  2.0000E-08  0.0000E+00  0.0000E+00 B  3"};
    static const char *const beta[2] = {"BDSB   1.0000E+05  2.0000E+05  0.0000E+00  0.0000E+00",
                                        "BDSB   1.0000E+05  2.0000E+05  0.0000E+00  0.0000E+00 B  3"};
    for (int k = 0; k < 4; k++) {
        text t = {0};
        orr_warnings w = {0};
        text_header(&t, "     3.04           N: GNSS NAV DATA    C: BDS", "RINEX VERSION / TYPE");
        text_header(&t, k < 2 ? alpha[k] : beta[k - 2], "IONOSPHERIC CORR");
        text_header(&t, k < 2 ? beta[1 - k] : alpha[3 - k], "IONOSPHERIC CORR");
        text_header(&t, "", "END OF HEADER");
        kepler(&t, "C06 2024 02 04 02 00 00", 4, 7, orbit, 'E');
        orr_nav nav = parse(&t, &w);
        assert_int_equal(w.count, 1); // the made week is GPS's
        assert_int_equal(nav.n_iono, 1);
        assert_int_equal(nav.iono[0].sat, orr_sat_make('C', 3));
        assert_int_equal(nav.iono[0].time_mark, 'B');
        ASSERT_NEAR(nav.iono[0].coefficient[1], 2e-8, 0);
        ASSERT_NEAR(nav.iono[0].coefficient[5], 2e5, 0);
        orr_nav_free(&nav);
        orr_warnings_free(&w);
        text_free(&t);
    }
}

// Two records of one issue that differ: told, both kept.
static void conflicts_are_told(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    double other[36];
    memcpy(other, orbit, sizeof other);
    other[3] += 1e-4;
    header_v3(&t, "3.04");
    kepler(&t, "G05 2024 02 04 02 00 00", 4, 7, orbit, 'E');
    kepler(&t, "G05 2024 02 04 02 00 00", 4, 7, orbit, 'E'); // once more the same: nothing to tell
    kepler(&t, "G05 2024 02 04 02 00 00", 4, 7, other, 'E');
    orr_nav nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 3);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "G05"));
    assert_non_null(strstr(w.item[0].text, "transmitted last"));
    orr_nav_free(&nav);
    orr_warnings_free(&w);
    text_free(&t);
}

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

// Clock of Saturday night, orbit of the new week; and a week number written modulo 1024.
static void ends_of_weeks(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "3.04");
    double set[28];
    memcpy(set, orbit, sizeof set);
    set[8] = 0;
    kepler(&t, "G01 2024 02 03 23 59 44", 4, 7, set, 'D');
    set[18] = 2300 - 2048;
    kepler(&t, "G02 2024 02 04 00 00 00", 4, 7, set, 'D');
    set[8] = 604784;
    set[18] = 2299;
    set[24] = -100;
    kepler(&t, "G03 2024 02 04 00 00 00", 4, 7, set, 'D');
    orr_nav nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 3);
    orr_time sunday = at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GPS);
    assert_true(nav.eph[0].toe == sunday);
    assert_true(nav.eph[0].toc == sunday - 16 * ORR_NS_PER_S);
    assert_true(nav.eph[1].toe == sunday);
    assert_int_equal(nav.eph[1].week, 252);
    assert_int_equal(w.count, 1); // that one is told
    assert_true(nav.eph[2].toe == sunday - 16 * ORR_NS_PER_S);
    assert_true(nav.eph[2].transmission == sunday - 100 * ORR_NS_PER_S);
    orr_nav_free(&nav);
    orr_warnings_free(&w);
    text_free(&t);
}

static void bad_records_one_by_one(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "3.04"); // lines 1 and 2; records of 8 lines follow
    double set[28], bad[28];
    memcpy(set, orbit, sizeof set);
    kepler(&t, "G01 2024 02 04 02 00 00", 4, 7, set, 'D');
    kepler(&t, "G02 2024 02 30 02 00 00", 4, 7, set, 'D'); // line 11: no such day
    memcpy(bad, set, sizeof bad);
    bad[7] = 0;
    kepler(&t, "G03 2024 02 04 02 00 00", 4, 7, bad, 'D'); // line 21: no orbit
    bad[7] = B;
    kepler(&t, "G04 2024 02 04 02 00 00", 4, 7, bad, 'D'); // line 29: missing
    kepler(&t, "G05 2024 02 04 02 00 00", 4, 6, set, 'D'); // line 35: a line short
    kepler(&t, "K06 2024 02 04 02 00 00", 4, 7, set, 'D'); // line 42: no system
    size_t spot = t.n;
    kepler(&t, "G07 2024 02 04 02 00 00", 4, 7, set, 'D'); // line 50
    memcpy(t.p + spot + 81 * 2 - 81 + 50, "XX", 2);        // in its second line, column 51
    kepler(&t, "G08 2024 02 04 02 00 00", 4, 7, set, 'D');
    orr_nav nav = parse(&t, &w);
    assert_int_equal(nav.n_eph, 2);
    assert_int_equal(nav.n_skipped, 6);
    assert_int_equal(w.count, 6);
    assert_int_equal(orr_sat_number(nav.eph[0].sat), 1);
    assert_int_equal(orr_sat_number(nav.eph[1].sat), 8);
    static const int64_t lines[6] = {11, 21, 29, 35, 42, 51};
    for (size_t i = 0; i < 6; i++) {
        assert_int_equal(w.item[i].line, lines[i]);
        assert_true(strlen(w.item[i].text) > 20);
    }
    assert_int_equal(w.item[5].column, 43);
    orr_nav_free(&nav);
    orr_warnings_free(&w);

    // Cut at any byte: never a record that was not there, never one with another number in it.
    text good = {0};
    header_v3(&good, "3.04");
    kepler(&good, "G01 2024 02 04 02 00 00", 4, 7, set, 'D');
    for (size_t n = 200; n <= good.n; n++) {
        orr_nav cut;
        orr_diag diag = {0};
        orr_status s = orr_nav_parse("cut.nav", good.p, n, NULL, &cut, NULL, &diag);
        assert_true(s == ORR_OK || s == ORR_E_FORMAT); // the one record cannot be read: refused
        for (size_t i = 0; i < cut.n_eph; i++) {
            assert_orbit(&cut.eph[i]);
            assert_true(cut.eph[i].transmission == ORR_TIME_NONE ||
                        cut.eph[i].transmission == cut.eph[i].toe - 300 * ORR_NS_PER_S);
        }
        orr_nav_free(&cut);
    }
    text_free(&good);
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

static void headers_of_version_3(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    text_header(&t, "     3.05           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE");
    text_header(&t, "GPSA   1.1176E-08  2.2352E-08 -5.9605E-08 -1.1921E-07", "IONOSPHERIC CORR");
    text_header(&t, "GPSB   9.0112E+04  1.3107E+05 -6.5536E+04 -5.8982E+05", "IONOSPHERIC CORR");
    text_header(&t, "BDSA   1.0000E-08  0.0000E+00  0.0000E+00  0.0000E+00 B 12", "IONOSPHERIC CORR");
    text_header(&t, "BDSA   2.0000E-08  0.0000E+00  0.0000E+00  0.0000E+00 C 12", "IONOSPHERIC CORR");
    text_header(&t, "BDSB   1.0000E+05  0.0000E+00  0.0000E+00  0.0000E+00 B 12", "IONOSPHERIC CORR");
    text_header(&t, "GAL    1.6000E+02  3.7109E-01  9.0637E-03  0.0000E+00", "IONOSPHERIC CORR");
    text_header(&t, "BDUT  5.5879354477E-09 9.769962617E-15 159414  790        3", "TIME SYSTEM CORR");
    text_header(&t, "    18    18  1929     7GPS", "LEAP SECONDS");
    text_header(&t, "something", "NOT A LABEL");
    text_header(&t, "", "END OF HEADER");
    orr_nav nav = parse(&t, &w);
    assert_int_equal(w.count, 2); // BeiDou's set C has no beta; the label
    assert_int_equal(nav.n_iono, 3);
    ASSERT_NEAR(nav.iono[0].coefficient[7], -5.8982e5, 0);
    assert_int_equal(nav.iono[1].time_mark, 'B');
    assert_int_equal(nav.iono[1].sat, orr_sat_make('C', 12));
    ASSERT_NEAR(nav.iono[1].coefficient[4], 1e5, 0);
    assert_int_equal(nav.iono[2].kind, ORR_NAV_NEQUICK_G);
    assert_int_equal(nav.n_sto, 1);
    assert_string_equal(nav.sto[0].utc_id, "UTC(SU)");
    assert_true(nav.sto[0].t_ref == orr_time_from_week(790 + 1356, (159414 + 14) * ORR_NS_PER_S));
    assert_int_equal(nav.leap_week, 1929);
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

static void refusals(void **state)
{
    (void)state;
    static const struct {
        const char *what, *label;
        orr_status status;
    } bad[] = {
        {"     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE", ORR_E_KIND},
        {"     5.00           NAVIGATION DATA     M", "RINEX VERSION / TYPE", ORR_E_UNSUPPORTED},
        {"     x              NAVIGATION DATA     M", "RINEX VERSION / TYPE", ORR_E_FORMAT},
        {"     3.05           NAVIGATION DATA     M", "SOMETHING ELSE", ORR_E_KIND},
        {"     3.05           NAVIGATION DATA     M", "RINEX VERSION / TYPE",
         ORR_E_FORMAT}, // no END OF HEADER
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        text t = {0};
        orr_nav nav;
        orr_diag diag = {0};
        text_header(&t, bad[i].what, bad[i].label);
        assert_int_equal(orr_nav_parse("bad", t.p, t.n, NULL, &nav, NULL, &diag), bad[i].status);
        assert_string_equal(diag.file, "bad");
        assert_true(strlen(diag.text) > 10);
        text_free(&t);
    }
    text t = {0};
    header_v3(&t, "3.04");
    for (int i = 0; i < 5; i++) kepler(&t, "G07 2024 02 04 02 00 00", 4, 7, orbit, 'E');
    orr_nav_limits few = {1 << 20, 3, 100, NULL};
    orr_nav nav;
    assert_int_equal(orr_nav_parse("many", t.p, t.n, &few, &nav, NULL, NULL), ORR_E_LIMIT);
    text_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spare_fields_do_not_matter),
        cmocka_unit_test(exponents_without_a_letter),
        cmocka_unit_test(halves_of_one_klobuchar_set),
        cmocka_unit_test(conflicts_are_told),
        cmocka_unit_test(gps_of_version_2),
        cmocka_unit_test(glonass),
        cmocka_unit_test(every_system_of_version_3),
        cmocka_unit_test(ends_of_weeks),
        cmocka_unit_test(bad_records_one_by_one),
        cmocka_unit_test(records_of_version_4),
        cmocka_unit_test(headers_of_version_3),
        cmocka_unit_test(written_and_read_back),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
