// SPDX-License-Identifier: GPL-3.0-or-later
// RINEX clock files of versions 2.00, 3.00 and 3.04 on made text.
#include "testing.h"

#include "ingest/rinex/clk.h"
#include "unit/ingest/made_text.h"

static orr_status parse(made_text *t, orr_clk *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    orr_status s = orr_clk_parse("made", t->s, t->n, NULL, x, w, d);
    made_free(t);
    return s;
}

static orr_time gps(int h, int m, int s)
{
    orr_time t;
    assert_int_equal(orr_time_from_civil(&(orr_civil){2024, 2, 4, h, m, s, 0}, ORR_SCALE_GPS, NULL, &t),
                     ORR_OK);
    return t;
}

static made_text version3(void)
{
    made_text t = {0};
    made_label(&t, "     3.00           C                   M", "RINEX VERSION / TYPE");
    made_label(&t, "program             agency              20240204 000000 UTC", "PGM / RUN BY / DATE");
    made_label(&t, "   GPS", "TIME SYSTEM ID");
    made_label(&t, "    18", "LEAP SECONDS");
    made_label(&t, "WHU  GNSS RESEARCH CENTER", "ANALYSIS CENTER");
    made_label(&t, "BRUX 13101M010           0.000000000000E+00", "ANALYSIS CLK REF");
    made_label(&t, "", "END OF HEADER");
    for (int k = 0; k < 3; k++) {
        made_add(&t, "AR BRUX 2024 02 04 00 %02d %9.6f  2    0.%d00000000000E-08  0.300000000000E-10\n",
                 k / 2, 30.0 * (k % 2), k + 1);
        made_add(&t, "AS R05  2024 02 04 00 %02d %9.6f  1   -0.%d00000000000E-04\n", k / 2, 30.0 * (k % 2),
                 k + 1);
        made_add(&t, "AS G30  2024  2  4  0 %2d %9.6f  2    0.%d00419332247E-03  0.100000000000E-10\n", k / 2,
                 30.0 * (k % 2), k + 1);
    }
    return t;
}

static void test_version_3(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = version3();
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_sats, 2);
    assert_int_equal(x.n_receivers, 1);
    assert_int_equal(x.sat[0].sat, orr_sat_make('G', 30)); // ascending
    assert_int_equal(x.sat[1].sat, orr_sat_make('R', 5));
    assert_int_equal(x.sat[0].n, 3);
    assert_true(x.sat[0].record[2].t == gps(0, 1, 0));
    ASSERT_NEAR(x.sat[0].record[1].bias_s, 0.200419332247e-3, 1e-19);
    ASSERT_NEAR(x.sat[0].record[1].bias_sdev_s, 1e-11, 1e-26);
    assert_true(isnan(x.sat[1].record[0].bias_sdev_s));
    assert_true(isnan(x.sat[1].record[0].rate_sps));
    assert_string_equal(x.receiver[0].name, "BRUX");
    assert_string_equal(x.reference, "BRUX");
    assert_string_equal(x.agency, "WHU  GNSS RESEARCH CENTER");
    assert_int_equal(x.leap_seconds, 18);
    assert_int_equal(x.system, 'M');
    assert_int_equal(x.n_epochs, 3);
    ASSERT_NEAR(x.interval_s, 30, 0);
    assert_true(x.from == gps(0, 0, 0) && x.to == gps(0, 1, 0));
    assert_non_null(orr_clk_find(&x, orr_sat_make('R', 5)));
    assert_null(orr_clk_find(&x, orr_sat_make('R', 6)));
    orr_clk_free(&x);
    orr_warnings_free(&w);
}

// Six values in two lines, D exponents, no time system (GPS then), other record types passed over.
static void test_version_2(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = {0};
    made_label(&t, "     2.00           CLOCK DATA          GPS", "RINEX VERSION / TYPE");
    made_label(&t, "", "END OF HEADER");
    made_add(&t, "AS G16  1994 07 14 20 59  0.000000  6   -0.123456789012D+00 0.123456789012D+01\n"
                 "  -0.123456789012D+02 0.123456789012D+03 -0.123456789012D+04 0.123456789012D+05\n");
    made_add(&t, "DR USNO 1994 07 14 20 59  0.000000  2   -0.123456789012E+00  0.123456789012E+01\n");
    made_add(&t, "CR USNO 1994 07 14 20 59  0.000000  4   -0.123456789012E+00  0.123456789012E+01\n"
                 "   0.000000000000E+00 0.000000000000E+00\n");
    made_add(&t, "AS G16  1994 07 14 21 04  0.000000  1   -0.123456789012D+00\r\n\n");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.n_sats, 1);
    assert_int_equal(x.n_other, 2);
    ASSERT_NEAR(x.sat[0].record[0].bias_s, -0.123456789012, 1e-16);
    ASSERT_NEAR(x.sat[0].record[0].rate_sps, -12.3456789012, 1e-14);
    ASSERT_NEAR(x.sat[0].record[0].rate_sdev_sps, 123.456789012, 1e-13);
    ASSERT_NEAR(x.interval_s, 300, 0);
    orr_clk_free(&x);
}

// 3.04: names of nine characters, labels five columns further right, UTC labels.
static void test_version_304(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d;
    made_text t = {0};
    made_add(&t, "%-65s%s\n", "3.04                 C                    M", "RINEX VERSION / TYPE");
    made_add(&t, "%-65s%s\n", "   UTC", "TIME SYSTEM ID");
    made_add(&t, "%-65s%s\n", "", "END OF HEADER");
    made_add(&t, "AR BRUX00BEL 2024 02 04 00 00  0.000000  2   0.123456789012E-08   0.100000000000E-10\n");
    made_add(&t, "AS E11       2024 02 04 00 00  0.000000  1   0.223456789012E-03\n");
    ASSERT_OK(parse(&t, &x, NULL, &d), d);
    assert_int_equal(x.system, 'M');
    assert_int_equal(x.scale, ORR_SCALE_UTC);
    assert_string_equal(x.receiver[0].name, "BRUX00BEL");
    assert_true(x.sat[0].record[0].t == gps(0, 0, 18)); // 18 leap seconds in 2024
    ASSERT_NEAR(x.sat[0].record[0].bias_s, 0.223456789012e-3, 1e-19);
    orr_clk_free(&x);
}

// A label that no version has, and a version that was never published: told, and read.
static void test_told_and_read(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = version3();
    made_replace(&t, "LEAP SECONDS", "SLEEP SECONDS");
    made_replace(&t, "     3.00", "     3.33");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_sats, 2);
    assert_int_equal(w.count, 2);
    assert_non_null(strstr(w.item[0].text, "no such version"));
    assert_non_null(strstr(w.item[1].text, "label is not known"));
    orr_warnings_free(&w);
    orr_clk_free(&x);
}

static void test_order_and_doubles(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = version3();
    made_add(&t, "AS R05  2024 02 03 00 00  0.000000  1   -0.900000000000E-04\n");
    made_add(&t, "AS R05  2024 02 04 00 00  0.000000  1   -0.800000000000E-04\n");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    const orr_clk_series *s = orr_clk_find(&x, orr_sat_make('R', 5));
    assert_int_equal(s->n, 4);
    ASSERT_NEAR(s->record[0].bias_s, -0.9e-4, 1e-19);
    ASSERT_NEAR(s->record[1].bias_s, -0.1e-4, 1e-19); // the first of two
    assert_int_equal(w.count, 2);
    orr_clk_free(&x);
    orr_warnings_free(&w);
}

static void assert_refused(made_text *t, orr_status status, const char *words)
{
    orr_clk x;
    orr_diag d;
    assert_int_equal(parse(t, &x, NULL, &d), status);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
    assert_null(x.sat);
}

// A line that is no record is told, with its place, and left out; the other eight stand.
static void assert_left_out(made_text *t, const char *words)
{
    orr_clk x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(t, &x, &w, &d), d);
    size_t n = 0;
    for (size_t i = 0; i < x.n_sats; i++) n += x.sat[i].n;
    for (size_t i = 0; i < x.n_receivers; i++) n += x.receiver[i].n;
    assert_int_equal(n, 8);
    assert_int_equal(w.count, 1);
    if (strstr(w.item[0].text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", w.item[0].text, words);
    assert_true(w.item[0].line >= 8);
    orr_clk_free(&x);
    orr_warnings_free(&w);
}

static void test_stray_lines(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *words;
    } cases[] = {{"AS R05", "AS X05", "no known satellite"},
                 {"AS R05", "XX R05", "none of AS"},
                 {"2024 02 04", "2024 13 04", "no date"},
                 {"-0.100000000000E-04", "-0.1000000000x0E-04", "no number"},
                 {"  1   -0.1", "  9   -0.1", "1 to 6"},
                 {"  1   -0.1", "  3   -0.1", "ends before"},
                 {"  2    0.100419332247E-03  0.100000000000E-10",
                  "  3    0.100419332247E-03  0.100000000000E-10", "second line"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        made_text t = version3();
        made_replace(&t, cases[i].from, cases[i].to);
        assert_left_out(&t, cases[i].words);
    }
    made_text t = version3();
    for (int i = 0; i < 10; i++) made_add(&t, "no record at all\n");
    orr_clk x;
    orr_diag d;
    assert_int_equal(parse(&t, &x, NULL, &d), ORR_E_FORMAT); // ten bad lines beside nine good ones
    assert_non_null(strstr(d.text, "of 19 lines 10 cannot be read"));
}

static void test_refusals(void **state)
{
    (void)state;
    made_text t = {0};
    made_add(&t, "\n");
    assert_refused(&t, ORR_E_KIND, "empty");
    made_label(&t, "     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
    assert_refused(&t, ORR_E_KIND, "not C");
    t = version3();
    made_replace(&t, "END OF HEADER", "END OF HEADEX");
    assert_refused(&t, ORR_E_FORMAT, "no END OF HEADER");
    t = version3();
    t.n = (size_t)(strstr(t.s, "AR BRUX") - t.s);
    assert_refused(&t, ORR_E_FORMAT, "no clock record");
    t = version3();
    made_replace(&t, "   GPS ", "   XYZ ");
    assert_refused(&t, ORR_E_UNSUPPORTED, "XYZ");
}

// Cut at any byte of its last record the file is refused or has lost that record whole; never another number.
static void test_cut_short(void **state)
{
    (void)state;
    made_text whole = version3();
    size_t start = whole.n - 1;
    while (whole.s[start - 1] != '\n') start--;
    for (size_t n = start; n <= whole.n; n++) {
        orr_clk x;
        orr_diag d = {0};
        if (orr_clk_parse("cut", whole.s, n, NULL, &x, NULL, &d) != ORR_OK) continue;
        const orr_clk_series *s = orr_clk_find(&x, orr_sat_make('G', 30));
        assert_true(s->n == 2 || (s->n == 3 && s->record[2].bias_s == 0.300419332247e-3 &&
                                  s->record[2].bias_sdev_s == 1e-11));
        orr_clk_free(&x);
    }
    made_free(&whole);
}

static void test_limits(void **state)
{
    (void)state;
    orr_clk x;
    orr_diag d = {0};
    made_text t = version3();
    orr_read_limits l = orr_read_default_limits();
    l.max_records = 8; // nine are there
    assert_int_equal(orr_clk_parse("made", t.s, t.n, &l, &x, NULL, &d), ORR_E_LIMIT);
    l.max_records = 9;
    assert_int_equal(orr_clk_parse("made", t.s, t.n, &l, &x, NULL, &d), ORR_OK);
    orr_clk_free(&x);
    made_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_version_3),     cmocka_unit_test(test_version_2),
        cmocka_unit_test(test_version_304),   cmocka_unit_test(test_order_and_doubles),
        cmocka_unit_test(test_told_and_read), cmocka_unit_test(test_stray_lines),
        cmocka_unit_test(test_refusals),      cmocka_unit_test(test_cut_short),
        cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
