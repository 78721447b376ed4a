// SPDX-License-Identifier: GPL-3.0-or-later
// Bias-SINEX and CODE's older texts on made text, and differences of observables from either.
#include "testing.h"

#include "ingest/tables/bias.h"
#include "unit/ingest/made_text.h"

static const char sinex[] =
    "%=BIA 1.00 COD 2024:040:29169 IGS 2024:035:00000 2024:036:00000 A 00000006\n"
    "+BIAS/DESCRIPTION\n"
    "*KEYWORD________________________________ VALUE(S)_______________________________\n"
    " BIAS_MODE                               ABSOLUTE\n"
    " TIME_SYSTEM                             G  \n"
    "-BIAS/DESCRIPTION\n"
    "+BIAS/SOLUTION\n"
    "*BIAS SVN_ PRN STATION__ OBS1 OBS2 BIAS_START____ BIAS_END______ UNIT __ESTIMATED_VALUE____ _STD_DEV___ "
    "__ESTIMATED_SLOPE____ _STD_DEV___\n"
    " OSB  G063 G01           C1C       2024:035:00000 2024:036:00000 ns                  9.5198      "
    "0.0001\n"
    " OSB  G063 G01           C1W       2024:035:00000 2024:036:00000 ns                 11.0188      0.0002 "
    "1.000000000000000E-05 1.00000E-06\n"
    " OSB  G063 G01           L1C       2024:035:00000 2024:036:00000 cyc                 0.2500      "
    "0.0000\n"
    " DSB  G063 G01           C1C  C2W  2024:035:00000 2024:036:00000 ns                 -1.5000      "
    "0.0300\n"
    " DSB  G063 G01           C2L  C2W  2024:035:00000 2024:036:00000 ns                  0.7500      "
    "0.0300\n"
    " DSB       G   BOR1      C1C  C1W  2024:035:00000 0000:000:00000 ns                  2.0000      "
    "0.0300\n"
    "-BIAS/SOLUTION\n"
    "%=ENDBIA\n";

static orr_status parse(const char *text, orr_bias_set *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    return orr_bias_parse("made", text, strlen(text), NULL, x, w, d);
}

static orr_time at(int day, int hour)
{
    orr_time t;
    assert_int_equal(orr_time_from_civil(&(orr_civil){2024, 2, day, hour, 0, 0, 0}, ORR_SCALE_GPS, NULL, &t),
                     ORR_OK);
    return t;
}

static void test_sinex(void **state)
{
    (void)state;
    orr_bias_set x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(sinex, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_string_equal(x.format, "BIAS-SINEX");
    assert_string_equal(x.agency, "COD");
    assert_true(x.absolute);
    assert_true(x.from == at(4, 0) && x.until == at(5, 0));
    assert_int_equal(x.n, 6);
    const orr_sat g01 = orr_sat_make('G', 1);
    assert_int_equal(x.bias[0].sat, g01);
    assert_string_equal(x.bias[0].svn, "G063");
    assert_string_equal(x.bias[0].obs1, "C1C");
    assert_string_equal(x.bias[0].obs2, "");
    ASSERT_NEAR(x.bias[0].value_s, 9.5198e-9, 1e-23);
    ASSERT_NEAR(x.bias[0].sdev_s, 1e-13, 1e-27);
    assert_true(isnan(x.bias[0].slope_sps));
    ASSERT_NEAR(x.bias[1].slope_sps, 1e-14, 1e-28);
    assert_true(x.bias[2].in_cycles);
    ASSERT_NEAR(x.bias[2].value_s, 0.25, 0);
    assert_int_equal(x.bias[3].kind, ORR_BIAS_DSB);
    assert_string_equal(x.bias[5].station, "BOR1");
    assert_int_equal(x.bias[5].sat, ORR_SAT_NONE);
    assert_int_equal(x.bias[5].system, 'G');
    assert_int_equal(x.bias[5].until, ORR_TIME_NONE);

    double v;
    assert_int_equal(orr_bias_osb(&x, g01, "C1C", at(4, 12), &v), ORR_OK);
    ASSERT_NEAR(v, 9.5198e-9, 1e-23);
    assert_int_equal(orr_bias_osb(&x, g01, "C1W", at(4, 10), &v), ORR_OK);
    ASSERT_NEAR(v, 11.0188e-9 + 36000 * 1e-14, 1e-22); // the slope counts from the start
    assert_int_equal(orr_bias_osb(&x, g01, "C1C", at(5, 0), &v), ORR_E_NODATA); // the end is not in it
    assert_int_equal(orr_bias_osb(&x, g01, "L1C", at(4, 0), &v), ORR_E_NODATA); // cycles are no seconds
    assert_int_equal(orr_bias_osb(&x, orr_sat_make('G', 2), "C1C", at(4, 0), &v), ORR_E_NODATA);

    assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C2W", at(4, 0), &v), ORR_OK);
    ASSERT_NEAR(v, -1.5e-9, 1e-23);
    assert_int_equal(orr_bias_dsb(&x, g01, "C2W", "C1C", at(4, 0), &v), ORR_OK);
    ASSERT_NEAR(v, 1.5e-9, 1e-23);
    assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C1W", at(4, 0), &v), ORR_OK); // two OSB
    ASSERT_NEAR(v, (9.5198 - 11.0188) * 1e-9, 1e-22);
    assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C2L", at(4, 0), &v), ORR_OK); // by way of C2W
    ASSERT_NEAR(v, (-1.5 - 0.75) * 1e-9, 1e-22);
    assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C1C", at(4, 0), &v), ORR_OK);
    ASSERT_NEAR(v, 0, 0);
    assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C5Q", at(4, 0), &v), ORR_E_NODATA);
    orr_bias_free(&x);
}

// Twelve characters of standard deviation, columns 93-104, and the slope a column further right.
static void test_wide_sigma(void **state)
{
    (void)state;
    static const char wide[] =
        "%=BIA 1.00 XXX 2024:036:00000 XXX 2024:035:00000 2024:036:00000 R 00000003\n+BIAS/SOLUTION\n"
        " DSB  G063 G01           C1W  C2W  2024:035:00000 2024:036:00000 ns   -7.25000000000000E+00 "
        "1.250000E-01\n"
        " OSB  G061 G02           C1W       2024:035:00000 2024:036:00000 ns   7.500000000000000E+00 "
        "2.500000E-01 "
        "1.000000000000000E-05 1.00000E-06\n"
        " OSB  G061 G03           C1W       2024:035:00000 2024:036:00000 ns   7.500000000000000E+00 "
        "2.500000E-0x\n"
        " OSB  G061 G04           C1W       2024:035:00000 2024:036:00000 ns   7.500000000000000E+001 "
        "2.50000E-01\n"
        "-BIAS/SOLUTION\n%=ENDBIA\n";
    orr_bias_set x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(wide, &x, &w, &d), d);
    assert_int_equal(x.n, 2);
    assert_int_equal(w.count, 2); // no number; a value that reaches over its columns
    ASSERT_NEAR(x.bias[0].value_s, -7.25e-9, 1e-23);
    ASSERT_NEAR(x.bias[0].sdev_s, 0.125e-9, 1e-24);
    ASSERT_NEAR(x.bias[1].sdev_s, 0.25e-9, 1e-24);
    ASSERT_NEAR(x.bias[1].slope_sps, 1e-14, 1e-28);
    ASSERT_NEAR(x.bias[1].slope_sdev_sps, 1e-15, 1e-29);
    orr_bias_free(&x);
    orr_warnings_free(&w);
}

static void assert_left_out(const char *from, const char *to, const char *words)
{
    made_text t = {0};
    made_bytes(&t, sinex, strlen(sinex));
    made_replace(&t, from, to);
    orr_bias_set x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(t.s, &x, &w, &d), d);
    assert_int_equal(x.n, 5);
    assert_int_equal(w.count, 1);
    if (strstr(w.item[0].text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", w.item[0].text, words);
    orr_bias_free(&x);
    orr_warnings_free(&w);
    made_free(&t);
}

static void test_one_bad_line(void **state)
{
    (void)state;
    assert_left_out(" OSB  G063 G01           C1C", " QSB  G063 G01           C1C", "none of OSB");
    assert_left_out(" OSB  G063 G01           C1C", " OSB  G063 X01           C1C", "no known satellite");
    assert_left_out("9.5198", "9.5x98", "no number");
    assert_left_out("2024:036:00000 ns                  9.5198", "2024:367:00000 ns                  9.5198",
                    "pair of dates");
    assert_left_out("2024:036:00000 ns                  9.5198", "2024:034:00000 ns                  9.5198",
                    "ends before");
    assert_left_out("ns                  9.5198", "m                   9.5198", "neither ns");
    assert_left_out("C1C       2024", "C1C  C1W  2024", "observable");
    assert_left_out("0.0002 1.000000000000000E-05", "0.0002  1.000000000000000E-05", "columns");
    assert_left_out(" DSB       G   BOR1", " DSB       G       ", "neither a satellite");
}

static const char dcb[] = "CODE'S MONTHLY GNSS P1-P2 DCB SOLUTION, YEAR-MONTH 08-12         06-JAN-09 10:45\n"
                          "--------------------------------------------------------------------------------\n"
                          "\n"
                          "DIFFERENTIAL (P1-P2) CODE BIASES FOR SATELLITES AND RECEIVERS:\n"
                          "\n"
                          "PRN / STATION NAME        VALUE (NS)  RMS (NS)\n"
                          "***   ****************    *****.***   *****.***\n"
                          "G01                          -1.582       0.009\n"
                          "R24                           3.250       0.019\n"
                          "G     ABPO 33302M001         -4.500       0.100\n"
                          "\n";

static void test_code_dcb(void **state)
{
    (void)state;
    orr_bias_set x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(dcb, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_string_equal(x.format, "CODE DCB");
    assert_int_equal(x.n, 3);
    assert_string_equal(x.bias[0].obs1, "C1W");
    assert_string_equal(x.bias[0].obs2, "C2W");
    assert_string_equal(x.bias[1].obs1, "C1P");
    assert_string_equal(x.bias[1].obs2, "C2P");
    assert_string_equal(x.bias[2].station, "ABPO 33302M001");
    ASSERT_NEAR(x.bias[2].value_s, -4.5e-9, 1e-23);
    ASSERT_NEAR(x.bias[1].sdev_s, 0.019e-9, 1e-24);
    orr_time december;
    assert_int_equal(
        orr_time_from_civil(&(orr_civil){2008, 12, 1, 0, 0, 0, 0}, ORR_SCALE_GPS, NULL, &december), ORR_OK);
    assert_true(x.from == december);
    assert_true(x.until - x.from == 31 * ORR_S_PER_DAY * ORR_NS_PER_S);
    double v;
    assert_int_equal(orr_bias_dsb(&x, orr_sat_make('G', 1), "C2W", "C1W", december, &v), ORR_OK);
    ASSERT_NEAR(v, 1.582e-9, 1e-23);
    orr_bias_free(&x);
}

static void test_code_dcb_cut(void **state)
{
    (void)state;
    size_t last = (size_t)(strstr(dcb, "G     ABPO") - dcb);
    for (size_t n = last; n < last + 47; n++) { // inside the last line
        orr_bias_set x;
        orr_diag d = {0};
        ASSERT_OK(orr_bias_parse("cut", dcb, n, NULL, &x, NULL, &d), d);
        assert_int_equal(x.n, 2);
        orr_bias_free(&x);
    }
}

// The titles that CODE used through the years.
static void test_dcb_periods(void **state)
{
    (void)state;
    static const struct {
        const char *title;
        int year, month, day, days; // 0 days: no period, and that is said
    } cases[] = {
        {"CODE'S MONTHLY GPS P1-C1 DCB SOLUTION, YEAR-MONTH 04-12          04-JAN-05 10:49", 2004, 12, 1, 31},
        {"CODE'S MONTHLY GPS P1-C1 DCB SOLUTION, YEAR 2012, MONTH 02       07-SEP-12 11:50", 2012, 2, 1, 29},
        {"CODE'S 30-DAY GPS P1-C1 DCB SOLUTION, ENDING D274, 2004          12-OCT-04 10:57", 2004, 9, 1, 30},
        {"CODE'S 30-DAY GNSS P1-C1 DCB SOLUTION, ENDING DAY 281, 2012      11-OCT-12 11:13", 2012, 9, 8, 30},
        {"CODE'S 30-DAY GPS P1-C1 DCB SOLUTION, ENDING DAY 226, YEAR 2     17-AUG-12 11:31", 0, 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[512];
        snprintf(text, sizeof text,
                 "%s\n\nDIFFERENTIAL (P1-C1) CODE BIASES FOR SATELLITES AND RECEIVERS:\n\nG01                "
                 "          -1.582       0.009\n",
                 cases[i].title);
        orr_bias_set x;
        orr_diag d;
        orr_warnings w = {0};
        ASSERT_OK(parse(text, &x, &w, &d), d);
        assert_int_equal(x.n, 1);
        assert_string_equal(x.bias[0].obs2, "C1C");
        if (cases[i].days == 0) {
            assert_int_equal(w.count, 1);
            assert_int_equal(x.bias[0].from, ORR_TIME_NONE);
        } else {
            orr_time from;
            assert_int_equal(
                orr_time_from_civil(&(orr_civil){cases[i].year, cases[i].month, cases[i].day, 0, 0, 0, 0},
                                    ORR_SCALE_GPS, NULL, &from),
                ORR_OK);
            assert_true(x.bias[0].from == from);
            assert_true(x.bias[0].until - from == cases[i].days * (ORR_S_PER_DAY * ORR_NS_PER_S));
        }
        orr_bias_free(&x);
        orr_warnings_free(&w);
    }
}

// Daily files: a period on each line, and blocks that are no code differences.
static void test_dcb_daily(void **state)
{
    (void)state;
    const char text[] =
        "CODE'S 1-DAY GNSS DCB SOLUTION\n"
        "DIFFERENTIAL (P1-C1) CODE BIASES FOR SATELLITES AND RECEIVERS:\n"
        "G01                           1.614       0.005  2020 12 24 00 00 00  2020 12 25 00 00 00\n"
        "DIFFERENTIAL (LC) CODE BIASES FOR SATELLITES AND RECEIVERS:\n"
        "R     ZECK 12351M001          7.962       0.035\n"
        "DIFFERENTIAL (P2-C2) CODE BIASES FOR SATELLITES AND RECEIVERS:\n"
        "G01                           0.614       0.005  2020 12 24 00 00 00  2020 12 25 00 00 00\n";
    orr_bias_set x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(text, &x, &w, &d), d);
    assert_int_equal(x.n, 2);
    assert_true(x.bias[0].until - x.bias[0].from == ORR_S_PER_DAY * ORR_NS_PER_S);
    assert_string_equal(x.bias[1].obs1, "C2W");
    assert_string_equal(x.bias[1].obs2, "C2"); // GPS C2 names no one signal
    assert_int_equal(w.count, 2);              // the period of the title, the LC block
    orr_bias_free(&x);
    orr_warnings_free(&w);
}

static void assert_refused(const char *text, orr_status status, const char *words)
{
    orr_bias_set x;
    orr_diag d;
    assert_int_equal(parse(text, &x, NULL, &d), status);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
    assert_null(x.bias);
}

static void test_refusals(void **state)
{
    (void)state;
    assert_refused("", ORR_E_KIND, "empty");
    assert_refused("%=SNX 2.02 IGN\n", ORR_E_KIND, "not a bias file");
    assert_refused("%=BIA 7.00 COD\n", ORR_E_UNSUPPORTED, "7.00");
    assert_refused("%=BIA 1.00 COD\n%=ENDBIA\n", ORR_E_FORMAT, "no bias");
    assert_refused(
        "%=BIA 1.00 COD\n+BIAS/SOLUTION\n OSB  G063 G01           C1C       xxxx\n-BIAS/SOLUTION\n",
        ORR_E_FORMAT, "pair of dates");
    char cut[sizeof sinex];
    snprintf(cut, sizeof cut, "%.*s", (int)(strstr(sinex, "-BIAS/SOLUTION") - sinex - 20), sinex);
    assert_refused(cut, ORR_E_FORMAT, "cut short");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sinex),        cmocka_unit_test(test_wide_sigma),
        cmocka_unit_test(test_one_bad_line), cmocka_unit_test(test_code_dcb),
        cmocka_unit_test(test_code_dcb_cut), cmocka_unit_test(test_dcb_periods),
        cmocka_unit_test(test_dcb_daily),    cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
