// SPDX-License-Identifier: GPL-3.0-or-later
// ANTEX on made text: satellites and receivers, validity, patterns, one bad antenna among good ones.
#include "testing.h"

#include "ingest/tables/antex.h"
#include "unit/ingest/made_text.h"

static void start(made_text *t)
{
    made_label(t, "     1.4            M", "ANTEX VERSION / SYST");
    made_label(t, "A", "PCV TYPE / REFANT");
    made_label(t, "", "END OF HEADER");
}

static void satellite(made_text *t, const char *from, const char *until, double up)
{
    char line[80];
    made_label(t, "", "START OF ANTENNA");
    made_label(t, "BLOCK IIR-M         G01                 G049      2009-014A", "TYPE / SERIAL NO");
    made_label(t, "                                             0    29-JAN-17", "METH / BY / # / DATE");
    made_label(t, "     0.0", "DAZI");
    made_label(t, "     0.0   4.0   1.0", "ZEN1 / ZEN2 / DZEN");
    made_label(t, "     2", "# OF FREQUENCIES");
    made_label(t, from, "VALID FROM");
    if (until != NULL) made_label(t, until, "VALID UNTIL");
    made_label(t, "IGS14_1972", "SINEX CODE");
    for (int k = 1; k <= 2; k++) {
        snprintf(line, sizeof line, "   G%02d", k);
        made_label(t, line, "START OF FREQUENCY");
        snprintf(line, sizeof line, "%10.2f%10.2f%10.2f", 279.0, -1.5, up);
        made_label(t, line, "NORTH / EAST / UP");
        made_add(t, "   NOAZI   10.70   10.10    8.00    4.60    0.50\n");
        snprintf(line, sizeof line, "   G%02d", k);
        made_label(t, line, "END OF FREQUENCY");
    }
    made_label(t, "", "END OF ANTENNA");
}

static void receiver(made_text *t)
{
    made_label(t, "", "START OF ANTENNA");
    made_label(t, "TRM59800.00     NONE", "TYPE / SERIAL NO");
    made_label(t, "    90.0", "DAZI");
    made_label(t, "     0.0  10.0   5.0", "ZEN1 / ZEN2 / DZEN");
    made_label(t, "     1", "# OF FREQUENCIES");
    made_label(t, "   G01", "START OF FREQUENCY");
    made_label(t, "      1.00     -2.00     88.91", "NORTH / EAST / UP");
    made_add(t, "   NOAZI    0.00    1.00    2.00\n");
    for (int az = 0; az <= 360; az += 90)
        made_add(t, "%8.1f%8.2f%8.2f%8.2f\n", (double)az, 0.1 * (az % 360), 0.1 * (az % 360) + 1,
                 0.1 * (az % 360) + 2);
    made_label(t, "   G01", "END OF FREQUENCY");
    made_label(t, "   G01", "START OF FREQ RMS");
    made_label(t, "      0.10      0.20      0.30", "NORTH / EAST / UP");
    made_add(t, "   NOAZI    0.00    1.00    2.00\n");
    made_label(t, "   G01", "END OF FREQ RMS");
    made_label(t, "", "END OF ANTENNA");
}

#define FROM_2009 "  2009     3    24     0     0    0.0000000"
#define UNTIL_2011 "  2011     5     6    23    59   59.9999999"
#define FROM_2011 "  2011     7    16     0     0    0.0000000"

static made_text whole(void)
{
    made_text t = {0};
    start(&t);
    satellite(&t, FROM_2009, UNTIL_2011, 963.2);
    satellite(&t, FROM_2011, NULL, 1501.7);
    receiver(&t);
    return t;
}

static orr_status parse(made_text *t, orr_antex *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    orr_status s = orr_antex_parse("made", t->s, t->n, NULL, x, w, d);
    made_free(t);
    return s;
}

static orr_time day(int year, int month, int d)
{
    orr_time t;
    assert_int_equal(orr_time_from_civil(&(orr_civil){year, month, d, 0, 0, 0, 0}, ORR_SCALE_GPS, NULL, &t),
                     ORR_OK);
    return t;
}

static void test_reads_everything(void **state)
{
    (void)state;
    orr_antex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = whole();
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.n_antennas, 3);
    assert_int_equal(x.n_satellites, 2);
    assert_int_equal(x.pcv_type, 'A');
    const orr_sat g01 = orr_sat_make('G', 1);
    const orr_antex_antenna *a = orr_antex_find_sat(&x, g01, day(2010, 1, 1));
    assert_non_null(a);
    assert_string_equal(a->type, "BLOCK IIR-M");
    assert_string_equal(a->svn, "G049");
    assert_string_equal(a->cospar, "2009-014A");
    const orr_antex_frequency *f = orr_antex_find_frequency(a, "G02");
    assert_non_null(f);
    ASSERT_NEAR(f->offset_m[0], 0.279, 1e-15);
    ASSERT_NEAR(f->offset_m[1], -0.0015, 1e-15);
    ASSERT_NEAR(f->offset_m[2], 0.9632, 1e-15);
    assert_true(isnan(f->offset_rms_m[0]));
    assert_null(orr_antex_find_frequency(a, "G05"));
    // Validity: before, between and after the two satellites that were G01.
    assert_null(orr_antex_find_sat(&x, g01, day(2009, 3, 23)));
    assert_non_null(orr_antex_find_sat(&x, g01, day(2009, 3, 24)));
    assert_non_null(orr_antex_find_sat(&x, g01, day(2011, 5, 7) - 1000)); // a microsecond before midnight
    assert_null(orr_antex_find_sat(&x, g01, day(2011, 6, 1)));
    ASSERT_NEAR(orr_antex_find_frequency(orr_antex_find_sat(&x, g01, day(2030, 1, 1)), "G01")->offset_m[2],
                1.5017, 1e-15);
    assert_null(orr_antex_find_sat(&x, orr_sat_make('G', 2), day(2010, 1, 1)));
    assert_null(orr_antex_find_sat(&x, ORR_SAT_NONE, day(2010, 1, 1)));
    // Nadir angles: nodes, between them, held beyond the ends.
    ASSERT_NEAR(orr_antex_variation_m(a, f, 0, 1), 10.10e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 77, 1.5), 9.05e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 0, -3), 10.70e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 0, 90), 0.50e-3, 1e-15);
    orr_antex_free(&x);
}

static void test_receiver(void **state)
{
    (void)state;
    orr_antex x;
    orr_diag d;
    made_text t = whole();
    ASSERT_OK(parse(&t, &x, NULL, &d), d);
    bool ignored = true;
    const orr_antex_antenna *a = orr_antex_find_receiver(&x, "TRM59800.00     NONE", &ignored);
    assert_non_null(a);
    assert_false(ignored);
    assert_ptr_equal(a, orr_antex_find_receiver(&x, "TRM59800.00", &ignored)); // blank radome is NONE
    assert_false(ignored);
    assert_ptr_equal(a, orr_antex_find_receiver(&x, "TRM59800.00     SCIT", &ignored));
    assert_true(ignored);
    assert_null(orr_antex_find_receiver(&x, "TRM59800.80     NONE", NULL));
    assert_null(orr_antex_find_receiver(&x, "BLOCK IIR-M", NULL)); // a satellite is no receiver antenna
    const orr_antex_frequency *f = orr_antex_find_frequency(a, "G01");
    ASSERT_NEAR(f->offset_rms_m[2], 0.3e-3, 1e-18);
    // The made pattern is 0.1 mm a degree of azimuth (back to 0 at 360) + 0.2 mm a degree of zenith angle.
    ASSERT_NEAR(orr_antex_variation_m(a, f, 45, 2.5), (4.5 + 0.5) * 1e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 45 - 720, 10), (4.5 + 2) * 1e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 315, 0), 13.5e-3, 1e-15);
    ASSERT_NEAR(orr_antex_variation_m(a, f, 360, 0), 0, 1e-15);
    orr_antex_free(&x);
}

static void assert_left_out(const char *from, const char *to, const char *words)
{
    orr_antex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = whole();
    made_replace(&t, from, to);
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_antennas, 2); // the other two are there
    assert_int_equal(w.count, 1);
    if (strstr(w.item[0].text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", w.item[0].text, words);
    orr_antex_free(&x);
    orr_warnings_free(&w);
}

static void test_one_bad_antenna(void **state)
{
    (void)state;
    assert_left_out("   10.10    8.00", "   x0.10    8.00", "no number");
    assert_left_out("    4.60    0.50\n", "    4.60\n", "only 4 of the 5");
    assert_left_out("    4.60    0.50\n", "    4.60    0.50    0.60\n", "more than the 5");
    assert_left_out("NOAZI   10.70", "  0.0   10.70", "NOAZI");
    assert_left_out("     0.0   4.0   1.0", "     0.0   4.0   3.0", "no grid");
    assert_left_out("VALID FROM", "WALID FROM", "no label");
    assert_left_out("2009     3    24", "2009     3    32", "no date");
    assert_left_out("2009     3    24", "2012     3    24", "ends before");
    assert_left_out("G01                 G049", "X01                 G049", "no known satellite");
    assert_left_out("    90.0                                                    DAZI",
                    "    97.0                                                    DAZI", "circle");
    assert_left_out("   180.0   18.00", "   170.0   18.00", "row 4 of 6");
    assert_left_out("    279.00     -1.50", "    279.00    -1.5.0", "NORTH / EAST / UP");
}

static void test_count_of_frequencies(void **state)
{
    (void)state;
    orr_antex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = whole();
    made_replace(&t, "     2                                                      # OF FREQ",
                 "     3                                                      # OF FREQ");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_antennas, 3);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "names 3 frequencies and has 2"));
    orr_antex_free(&x);
    orr_warnings_free(&w);
}

static void assert_refused(made_text *t, orr_status status, const char *words)
{
    orr_antex x;
    orr_diag d;
    assert_int_equal(parse(t, &x, NULL, &d), status);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
    assert_null(x.antenna);
}

static void test_refusals(void **state)
{
    (void)state;
    made_text t = {0};
    made_add(&t, "\n\n");
    assert_refused(&t, ORR_E_KIND, "empty");
    made_label(&t, "     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
    assert_refused(&t, ORR_E_KIND, "not an ANTEX");
    start(&t);
    made_replace(&t, "     1.4", "     9.4");
    assert_refused(&t, ORR_E_UNSUPPORTED, "9.4");
    start(&t);
    assert_refused(&t, ORR_E_FORMAT, "no antenna");
    start(&t);
    satellite(&t, FROM_2009, NULL, 1);
    made_replace(&t, "10.70", "10.7x");
    assert_refused(&t, ORR_E_FORMAT, "no number"); // the only antenna
    t = whole();
    t.n -= 200;
    assert_refused(&t, ORR_E_FORMAT, "cut short");
    // A grid of millions of values in a file of a few lines asks for nothing.
    start(&t);
    satellite(&t, FROM_2009, NULL, 1);
    made_replace(&t, "     0.0                                                    DAZI",
                 "     0.1                                                    DAZI");
    made_replace(&t, "     0.0   4.0   1.0", "     0.0 180.0   0.1");
    assert_refused(&t, ORR_E_FORMAT, "ends before");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reads_everything), cmocka_unit_test(test_receiver),
        cmocka_unit_test(test_one_bad_antenna),  cmocka_unit_test(test_count_of_frequencies),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
