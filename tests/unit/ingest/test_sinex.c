// SPDX-License-Identifier: GPL-3.0-or-later
// SINEX sites, eccentricities and coordinates on made text.
#include "testing.h"

#include "ingest/tables/sinex.h"
#include "unit/ingest/made_text.h"

static const char text[] =
    "%=SNX 2.02 IGN 24:053:83755 IGN 24:035:00000 24:036:00000 C  1484 2 S E\n"
    "+FILE/REFERENCE\n"
    " DESCRIPTION        made\n"
    "-FILE/REFERENCE\n"
    "+SITE/ID\n"
    "*CODE PT __DOMES__ T _STATION DESCRIPTION__ _LONGITUDE_ _LATITUDE__ HEIGHT_\n"
    " BOR1  A 12205M002 P Borowiec, POLAND        17 04 24.4  52 16 37.0   124.3\n"
    " AMU2  A 66040M001 P South Pole              -0 30 00.0 -89 59 52.0  2816.0\n"
    "-SITE/ID\n"
    "+SITE/ECCENTRICITY\n"
    "*CODE PT SOLN T _DATA START_ __DATA_END__ REF __DX_U__ __DX_N__ __DX_E__\n"
    " BOR1  A ---- P 99:169:00000 20:001:00000 UNE   0.0624   0.0010  -0.0020\n"
    " BOR1  A ---- P 20:001:00001 00:000:00000 UNE   0.0700   0.0000   0.0000\n"
    "-SITE/ECCENTRICITY\n"
    "+SOLUTION/ESTIMATE\n"
    "*INDEX _TYPE_ CODE PT SOLN _REF_EPOCH__ UNIT S ___ESTIMATED_VALUE___ __STD_DEV__\n"
    "     1 STAX   BOR1  A    1 24:035:43200 m    2  3.73835813450000e+06 1.10000e-03\n"
    "     2 STAY   BOR1  A    1 24:035:43200 m    2  1.14817400900000e+06 1.20000e-03\n"
    "     3 STAZ   BOR1  A    1 24:035:43200 m    2  5.02181593570000e+06 1.30000e-03\n"
    "     4 VELX   BOR1  A    1 24:035:43200 m/y  2 -1.73000000000000e-02 1.00000e-05\n"
    "     5 VELY   BOR1  A    1 24:035:43200 m/y  2  1.60000000000000e-02 1.00000e-05\n"
    "     6 VELZ   BOR1  A    1 24:035:43200 m/y  2  7.00000000000000e-03 1.00000e-05\n"
    "     7 XPO                 24:035:43200 mas  2  7.00000000000000e-03 1.00000e-05\n"
    "     8 STAX   AMU2  A    1 24:035:43200 m    2 -3.87730000000000e+03 1.10000e-03\n"
    "-SOLUTION/ESTIMATE\n"
    "%ENDSNX\n";

static orr_status parse(const char *t, orr_sinex *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    return orr_sinex_parse("made", t, strlen(t), NULL, x, w, d);
}

static orr_time at(int year, int month, int day, int hour)
{
    orr_time t;
    assert_int_equal(
        orr_time_from_civil(&(orr_civil){year, month, day, hour, 0, 0, 0}, ORR_SCALE_UTC, NULL, &t), ORR_OK);
    return t;
}

static void test_reads_everything(void **state)
{
    (void)state;
    orr_sinex x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(text, &x, &w, &d), d);
    assert_int_equal(w.count, 1); // AMU2 has one coordinate of three
    assert_int_equal(x.n_sites, 2);
    assert_int_equal(x.n_eccentricities, 2);
    assert_int_equal(x.n_estimates, 1);
    assert_true(x.from == at(2024, 2, 4, 0) && x.until == at(2024, 2, 5, 0));
    assert_string_equal(x.site[0].domes, "12205M002");
    assert_string_equal(x.site[0].description, "Borowiec, POLAND");
    ASSERT_NEAR(x.site[0].lon_deg, 17 + 4 / 60.0 + 24.4 / 3600, 1e-12);
    ASSERT_NEAR(x.site[1].lon_deg, -0.5, 1e-12); // the sign of -0
    ASSERT_NEAR(x.site[1].lat_deg, -(89 + 59 / 60.0 + 52 / 3600.0), 1e-12);
    ASSERT_NEAR(x.site[0].height_m, 124.3, 0);

    double p[3];
    orr_time epoch = at(2024, 2, 4, 12);
    assert_true(x.estimate[0].epoch == epoch);
    ASSERT_NEAR(x.estimate[0].pos_sdev_m[2], 1.3e-3, 0);
    assert_int_equal(orr_sinex_position(&x, "BOR1", epoch, p), ORR_OK);
    ASSERT_NEAR(p[0], 3738358.1345, 1e-9);
    ASSERT_NEAR(p[1], 1148174.0090, 1e-9);
    ASSERT_NEAR(p[2], 5021815.9357, 1e-9);
    // A Julian year later, by the velocity; long names and small letters are the same station.
    assert_int_equal(orr_sinex_position(&x, "bor100pol", epoch + (orr_time)31557600 * ORR_NS_PER_S, p),
                     ORR_OK);
    ASSERT_NEAR(p[0], 3738358.1345 - 0.0173, 1e-9);
    ASSERT_NEAR(p[2], 5021815.9357 + 0.0070, 1e-9);
    assert_int_equal(orr_sinex_position(&x, "AMU2", epoch, p), ORR_E_NODATA);
    assert_int_equal(orr_sinex_position(&x, "BO", epoch, p), ORR_E_NODATA);

    const orr_sinex_eccentricity *e = orr_sinex_find_eccentricity(&x, "BOR1", at(2019, 12, 31, 0));
    assert_non_null(e);
    assert_true(e->local);
    ASSERT_NEAR(e->offset_m[0], 0.0624, 0);
    ASSERT_NEAR(e->offset_m[2], -0.0020, 0);
    ASSERT_NEAR(orr_sinex_find_eccentricity(&x, "BOR1", at(2030, 1, 1, 0))->offset_m[0], 0.07, 0);
    assert_null(orr_sinex_find_eccentricity(&x, "BOR1", at(1998, 1, 1, 0)));
    orr_sinex_free(&x);
    orr_warnings_free(&w);
}

static void assert_refused(const char *from, const char *to, orr_status status, const char *words)
{
    made_text t = {0};
    made_bytes(&t, text, strlen(text));
    made_replace(&t, from, to);
    orr_sinex x;
    orr_diag d;
    assert_int_equal(parse(t.s, &x, NULL, &d), status);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
    assert_null(x.estimate);
    made_free(&t);
}

// A line that cannot be read is told and left out; a coordinate less leaves its station out, and the others stand.
static void test_stray_lines(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *words;
    } cases[] = {{"3.73835813450000e+06", "3.7383581345000xe+06", "coordinate"},
                 {"2 STAY", "2 STAX", "twice"},
                 {"2 STAY", "2 STAQ", "none of X, Y, Z"},
                 {"24:035:43200 m   ", "24:366:99999 m   ", "no date"},
                 {"24:035:43200 m   ", "24:035:43200 km  ", "not in m"},
                 {"UNE   0.0624", "ABC   0.0624", "neither UNE"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        made_text t = {0};
        orr_sinex x;
        orr_diag d;
        orr_warnings w = {0};
        made_bytes(&t, text, strlen(text));
        made_replace(&t, cases[i].from, cases[i].to);
        ASSERT_OK(parse(t.s, &x, &w, &d), d);
        assert_true(w.count >= 1 && w.item[0].line > 1);
        if (strstr(w.item[0].text, cases[i].words) == NULL)
            fail_msg("\"%s\" does not say \"%s\"", w.item[0].text, cases[i].words);
        assert_true(x.n_sites > 0);
        orr_sinex_free(&x);
        orr_warnings_free(&w);
        made_free(&t);
    }
}

static void test_refusals(void **state)
{
    (void)state;
    orr_sinex x;
    orr_diag d;
    assert_int_equal(parse("", &x, NULL, &d), ORR_E_KIND);
    assert_refused("%=SNX 2.02", "%=BIA 2.02", ORR_E_KIND, "not a SINEX");
    assert_refused("%=SNX 2.02", "%=SNX 9.02", ORR_E_UNSUPPORTED, "9.02");
    assert_refused(strstr(text, "+SOLUTION/ESTIMATE"), "", ORR_E_FORMAT, "before its coordinates");
    assert_refused("-SOLUTION/ESTIMATE\n%ENDSNX\n", "", ORR_E_FORMAT, "cut short");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reads_everything),
        cmocka_unit_test(test_stray_lines),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
