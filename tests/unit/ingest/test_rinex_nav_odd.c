// SPDX-License-Identifier: GPL-3.0-or-later
// Navigation files that are odd: what stands in fields that nobody uses, numbers as old programs write them, weeks that end, records
// that contradict each other, records and headers that cannot be read.
#include "testing.h"

#include "core/cursor.h"
#include "rinex_nav_text.h"

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
        cmocka_unit_test(ends_of_weeks),
        cmocka_unit_test(bad_records_one_by_one),
        cmocka_unit_test(headers_of_version_3),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
