// SPDX-License-Identifier: GPL-3.0-or-later
// Earth rotation files as three centres write them, on made text.
#include "testing.h"

#include "core/vec.h"
#include "ingest/tables/erp.h"
#include "unit/ingest/made_text.h"

#define UAS (1e-6 / 3600 * ORR_RAD_PER_DEG)

static orr_status parse(const char *text, orr_erp *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    return orr_erp_parse("made", text, strlen(text), NULL, NULL, x, w, d);
}

static const char igs[] = "version 2\n"
                          "Source: Xpole,Ypole,Xrt,Yrt,LOD: weighted average of centres;\n"
                          "        UT1-UTC: integrated from the 5th day prior to Bull. A\n"
                          "\n"
                          "  MJD      Xpole   Ypole  UT1-UTC    LOD  Xsig  Ysig   UTsig  LODsig  Nr Nf Nt    "
                          "Xrt    Yrt  Xrtsig  Yrtsig\n"
                          "             (10**-6\")       (0.1 usec)    (10**-6\")     (0.1 usec)             "
                          " (10**-6\"/d)    (10**-6\"/d)\n"
                          "59830.50  301078  310229   -98409  -1857    22  10     135      23   7  1 31  "
                          "-1430  -3058     66     55\n";

static void test_igs(void **state)
{
    (void)state;
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(igs, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.series.n, 1);
    ASSERT_NEAR(x.series.mjd_utc[0], 59830.5, 0);
    ASSERT_NEAR(x.series.value[0].xp_rad, 301078 * UAS, 1e-20);
    ASSERT_NEAR(x.series.value[0].yp_rad, 310229 * UAS, 1e-20);
    ASSERT_NEAR(x.series.value[0].ut1_utc_s, -98409e-7, 1e-15);
    ASSERT_NEAR(x.series.value[0].lod_s, -1857e-7, 1e-18);
    ASSERT_NEAR(x.detail[0].xp_sdev_rad, 22 * UAS, 1e-22);
    ASSERT_NEAR(x.detail[0].ut1_sdev_s, 135e-7, 1e-18);
    ASSERT_NEAR(x.detail[0].lod_sdev_s, 23e-7, 1e-18);
    ASSERT_NEAR(x.detail[0].xp_rate_radps, -1430 * UAS / 86400, 1e-22);
    ASSERT_NEAR(x.detail[0].yp_rate_sdev_radps, 55 * UAS / 86400, 1e-22);
    assert_int_equal(x.detail[0].n_receivers, 7);
    assert_int_equal(x.detail[0].n_satellites, 31);
    assert_true(isnan(x.detail[0].dpsi_rad));
    orr_erp_free(&x);
}

static const char code[] = "VERSION 2\n"
                           "CODE FINAL GNSS ERP INFORMATION                16-OCT-08 14:33\n"
                           "---------------------------------------------------------------\n"
                           "NUTATION MODEL       : IAU2000                  SUBDAILY POLE MODEL: IERS2000\n"
                           "  MJD         X-P      Y-P   UT1UTC    LOD   S-X   S-Y  S-UT  S-LD  NR  NF  NT   "
                           "X-RT   Y-RT  S-XR  S-YR C-XY C-XT C-YT   DPSI   DEPS  S-DP  S-DE\n"
                           "              E-6\"     E-6\"    E-7S E-7S/D   E-6\"  E-6\" E-7S E-7S/D          "
                           "       E-6\"/D      E-6\"/D    E-2  E-2  E-2    E-6\"   E-6\"  E-6\"  E-6\"\n"
                           "54743.50   255584   210979 -4944934   3873     5     6     3    10 244   0  24  "
                           "-2525  -2541    13    14    3    2  -11     17     18     0     0\n"
                           "54744.50   253263   208651 -4948440   3324     5     5     7    21 244   0  24  "
                           "-2116  -2114    13    13    2   -1    3      0      0     0     0\n";

static void test_code(void **state)
{
    (void)state;
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(code, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_string_equal(x.title, "CODE FINAL GNSS ERP INFORMATION                16-OCT-08 14:33");
    assert_int_equal(x.series.n, 2);
    ASSERT_NEAR(x.series.value[0].ut1_utc_s, -0.4944934, 1e-15);
    ASSERT_NEAR(x.detail[0].yp_sdev_rad, 6 * UAS, 1e-22);
    ASSERT_NEAR(x.detail[0].yp_rate_sdev_radps, 14 * UAS / 86400, 1e-24);
    ASSERT_NEAR(x.detail[0].dpsi_rad, 17 * UAS, 1e-22); // behind three columns that are not kept
    ASSERT_NEAR(x.detail[0].deps_rad, 18 * UAS, 1e-22);
    orr_erp_free(&x);
}

// UT1 - TAI under a name of two words, as GFZ writes it; 37 s in 2024.
static void test_ut1_tai(void **state)
{
    (void)state;
    const char gfz[] =
        "version 2\n"
        "GFZ ERP-RESULTS\n"
        "  MJD     Xpole  Ypole UT1 -TAI   LOD  Xsig Ysig UTsig LODsig Nr Nf Nt X-RT Y-RT X-RTsig Y-RTsig\n"
        "          E-6\"   E-6\"   .1 us  .1 us/d E-6\" E-6\" .1 us .1 us/d           E-6\" E-6\" E-6\" "
        "E-6\"\n"
        "60582.500 225415 411006 -369409348 -301 4 4 11 11 128 99 78 520 -2158 16 17\n";
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(gfz, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    ASSERT_NEAR(x.series.value[0].ut1_utc_s, 37 - 36.9409348, 1e-12);
    ASSERT_NEAR(x.series.value[0].lod_s, -301e-7, 1e-18);
    ASSERT_NEAR(x.detail[0].yp_rate_sdev_radps, 17 * UAS / 86400, 1e-22);
    orr_erp_free(&x);
}

// Several files one behind the other, out of order, one day twice: sorted, the later line kept, both said.
static void test_several(void **state)
{
    (void)state;
    char text[4096];
    snprintf(text, sizeof text,
             "%s%s59829.50  301079  310229   -98410  -1857    22  10     135      23   7  1 31  -1430  -3058 "
             "    66     55\n"
             "59830.50  999      310229   -98409  -1857    22  10     135      23   7  1 31  -1430  -3058    "
             " 66     55\n",
             code, igs);
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(text, &x, &w, &d), d);
    assert_int_equal(x.series.n, 4);
    assert_int_equal(w.count, 2);
    for (size_t i = 1; i < 4; i++) assert_true(x.series.mjd_utc[i] > x.series.mjd_utc[i - 1]);
    ASSERT_NEAR(x.series.value[3].xp_rad, 999 * UAS, 1e-20);
    orr_erp_free(&x);
    orr_warnings_free(&w);
}

static void test_merge(void **state)
{
    (void)state;
    orr_erp x[2];
    orr_eop_series s;
    orr_diag d;
    ASSERT_OK(parse(igs, &x[0], NULL, &d), d);
    ASSERT_OK(parse(code, &x[1], NULL, &d), d);
    x[1].series.mjd_utc[1] = 59830.5; // the same instant as the IGS file's
    ASSERT_OK(orr_erp_merge(x, 2, &s, &d), d);
    assert_int_equal(s.n, 2);
    assert_true(s.mjd_utc[0] == 54743.5);
    ASSERT_NEAR(s.value[1].xp_rad, 253263 * UAS, 1e-20); // of the later file in the list
    orr_erp_series_free(&s);
    ASSERT_OK(orr_erp_merge(x, 0, &s, &d), d);
    assert_int_equal(s.n, 0);
    orr_erp_free(&x[0]);
    orr_erp_free(&x[1]);
}

// finals2000A: columns of the readme; a predicted day, a day to come, LOD in ms, and a leap second's worth of UT1 between.
static const char finals[] =
    "2412 7 60651.00 I  0.123456 0.000091 -0.234567 0.000092  I-0.0123456 0.0000123  0.7654 0.0045  P     "
    "0.123    "
    "0.128    -0.456    0.160                                                     \n"
    "2412 8 60652.00 P  0.120000 0.000291  0.230000 0.000292  P 0.0111111 0.0000999                 P     "
    "0.100    "
    "0.128    -0.400    0.160                                                     \n"
    "2412 9 60653.00                                                                                         "
    "      "
    "                                                                              \n";

static void test_finals(void **state)
{
    (void)state;
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    ASSERT_OK(parse(finals, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.series.n, 2);
    assert_true(x.series.mjd_utc[0] == 60651);
    ASSERT_NEAR(x.series.value[0].xp_rad, 123456 * UAS, 1e-20);
    ASSERT_NEAR(x.series.value[0].yp_rad, -234567 * UAS, 1e-20);
    ASSERT_NEAR(x.series.value[0].ut1_utc_s, -0.0123456, 1e-15);
    ASSERT_NEAR(x.series.value[0].lod_s, 0.7654e-3, 1e-18);
    ASSERT_NEAR(x.detail[0].ut1_sdev_s, 12.3e-6, 1e-18);
    ASSERT_NEAR(x.detail[0].lod_sdev_s, 4.5e-6, 1e-18);
    ASSERT_NEAR(x.detail[0].dpsi_rad, 123 * UAS, 1e-20);
    ASSERT_NEAR(x.series.value[1].ut1_utc_s, 0.0111111, 1e-15);
    assert_true(x.series.value[1].lod_s == 0 && isnan(x.detail[1].lod_sdev_s));
    assert_string_equal(x.title, "IERS finals (Bulletin A)");
    orr_erp_free(&x);
    orr_warnings_free(&w);
}

// C04 in the forms of 14 and 20, each with its page of text; days before 1972 are passed over.
static void test_c04(void **state)
{
    (void)state;
    static const char c14[] =
        "                             EARTH ORIENTATION PARAMETER (EOP) PRODUCT CENTER\n"
        "                                          EOP (IERS) 14 C04\n"
        "      Date      MJD      x          y        UT1-UTC       LOD         dX        dY        x Err\n"
        "                         \"          \"           s           s\n"
        "1962   1   1  37665  -0.012700   0.213000   0.0326338   0.0017230   0.000000   0.000000   0.030000  "
        " 0.030000 "
        " 0.0020000  0.0014000    0.012000    0.002000\n"
        "2019   3   4  58546   0.055555   0.366666  -0.0876543   0.0009876   0.000111  -0.000222   0.000033  "
        " 0.000044 "
        " 0.0000055  0.0000066    0.000077    0.000088\n";
    static const char c20[] = "# EOP (IERS) 20 C04 TIME SERIES  consistent with ITRF 2020\n"
                              "# YR  MM  DD  HH       MJD        x(\")        y(\")  UT1-UTC(s)       dX(\") "
                              "     dY(\")       xrt(\")\n"
                              "2019   3   4   0  58546.00    0.055555    0.366666  -0.0876543    0.000111   "
                              "-0.000222    0.001230   -0.002340"
                              "   0.0009876    0.000033    0.000044   0.0000055    0.000077    0.000088    "
                              "0.000099    0.000091   0.0000066\n"
                              "2019   3   4  12  58546.50    0.055666    0.366777  -0.0881111    0.000111   "
                              "-0.000222    0.001230   -0.002340"
                              "   0.0009876    0.000033    0.000044   0.0000055    0.000077    0.000088    "
                              "0.000099    0.000091   0.0000066\n";
    const char *const text[2] = {c14, c20};
    for (int k = 0; k < 2; k++) {
        orr_erp x;
        orr_diag d;
        orr_warnings w = {0};
        ASSERT_OK(parse(text[k], &x, &w, &d), d);
        assert_int_equal(w.count, 0);
        assert_int_equal(x.series.n, 1 + k);
        assert_true(x.series.mjd_utc[0] == 58546 && x.series.mjd_utc[k] == 58546 + 0.5 * k);
        ASSERT_NEAR(x.series.value[0].xp_rad, 55555 * UAS, 1e-20);
        ASSERT_NEAR(x.series.value[0].yp_rad, 366666 * UAS, 1e-20);
        ASSERT_NEAR(x.series.value[0].ut1_utc_s, -0.0876543, 1e-15);
        ASSERT_NEAR(x.series.value[0].lod_s, 0.0009876, 1e-18);
        ASSERT_NEAR(x.detail[0].xp_sdev_rad, 33 * UAS, 1e-22);
        ASSERT_NEAR(x.detail[0].ut1_sdev_s, 5.5e-6, 1e-18);
        ASSERT_NEAR(x.detail[0].lod_sdev_s, 6.6e-6, 1e-18);
        ASSERT_NEAR(x.detail[0].dpsi_rad, 111 * UAS, 1e-22);
        ASSERT_NEAR(x.detail[0].deps_rad, -222 * UAS, 1e-22);
        if (k == 1) ASSERT_NEAR(x.detail[0].xp_rate_radps, 1230 * UAS / 86400, 1e-24);
        orr_erp_free(&x);
        orr_warnings_free(&w);
    }
}

// One line that cannot be read is told and left out; as many bad ones as good ones and one more, and the file is refused.
static void test_stray_lines(void **state)
{
    (void)state;
    orr_erp x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = {0};
    made_bytes(&t, code, strlen(code));
    made_replace(&t, "   210979", "   ******");
    ASSERT_OK(parse(t.s, &x, &w, &d), d);
    assert_int_equal(x.series.n, 1);
    assert_int_equal(w.count, 1);
    assert_non_null(strstr(w.item[0].text, "left out"));
    assert_int_equal(w.item[0].line, 7);
    orr_erp_free(&x);
    orr_warnings_free(&w);
    made_replace(&t, "   208651", "   ******");
    assert_int_equal(parse(t.s, &x, NULL, &d), ORR_E_FORMAT);
    made_free(&t);
}

static void assert_refused(const char *base, const char *from, const char *to, orr_status status,
                           const char *words)
{
    made_text t = {0};
    made_bytes(&t, base, strlen(base));
    if (from != NULL) made_replace(&t, from, to);
    orr_erp x;
    orr_diag d;
    assert_int_equal(parse(t.s, &x, NULL, &d), status);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
    assert_null(x.series.value);
    made_free(&t);
}

static void test_refusals(void **state)
{
    (void)state;
    assert_refused("", NULL, NULL, ORR_E_KIND, "empty");
    assert_refused("something\n", NULL, NULL, ORR_E_KIND, "version 2");
    assert_refused(igs, "version 2", "version 1", ORR_E_UNSUPPORTED, "version 1");
    assert_refused(igs, "(10**-6", "(10**-5", ORR_E_FORMAT, "1e-5");
    assert_refused(code, "E-6", "E-5", ORR_E_FORMAT, "1e-5");
    assert_refused(igs, "UT1-UTC    LOD", "UT1R-UTC   LOD", ORR_E_UNSUPPORTED, "UT1R");
    assert_refused(igs, "  LOD  Xsig", "  LODR Xsig", ORR_E_UNSUPPORTED, "LODR");
    assert_refused(igs, "Xpole   Ypole", "Xpole   Xpole", ORR_E_FORMAT, "earlier");
    assert_refused(igs, "  MJD      Xpole   Ypole", "  MJD      Apole   Ypole", ORR_E_FORMAT,
                   "does not name");
    assert_refused(igs, "310229", "******", ORR_E_FORMAT, "column 3");
    assert_refused(igs, "301078", "9301078", ORR_E_FORMAT, "two arc seconds");
    assert_refused(igs, "-98409", "-98409000", ORR_E_FORMAT, "cannot be");
    assert_refused(igs, "59830.50", "5983.50", ORR_E_FORMAT, "Julian");
    assert_refused(igs, "  -98409  -1857    22  10     135      23   7  1 31  -1430  -3058     66     55", "",
                   ORR_E_FORMAT, "ends before");
    assert_refused(igs, "59830.50", "59830.50x", ORR_E_FORMAT, "does not start with a date");
    assert_refused("version 2\ntitle\n", NULL, NULL, ORR_E_FORMAT, "no line of");
}

// Cut at any byte of its last line a file is refused, or has lost that line whole or only blanks of it.
static void test_cut_short(void **state)
{
    (void)state;
    size_t n = strlen(code), start = n - 1;
    while (code[start - 1] != '\n') start--;
    for (size_t k = start; k <= n; k++) {
        orr_erp x;
        orr_diag d = {0};
        if (orr_erp_parse("cut", code, k, NULL, NULL, &x, NULL, &d) != ORR_OK) continue;
        if (x.series.n == 2) ASSERT_NEAR(x.series.value[1].ut1_utc_s, -0.4948440, 1e-15);
        orr_erp_free(&x);
    }
    orr_erp x;
    orr_diag d = {0};
    assert_int_equal(orr_erp_parse("cut", code, start + 30, NULL, NULL, &x, NULL, &d), ORR_E_FORMAT);
}

// UT1 does not step with a leap second that the built-in table does not know: what the file calls UT1 - UTC by the run's
// table is the same UT1 in the series.
static void test_leap_seconds(void **state)
{
    (void)state;
    const orr_leap_table *known = orr_leap_builtin();
    orr_leap_entry entry[64];
    memcpy(entry, known->entry, known->n * sizeof *entry);
    entry[known->n] = (orr_leap_entry){61406, 38}; // 2027-01-01
    const orr_leap_table table = {.n = known->n + 1, .entry = entry, .expires_mjd = 61583};
    char text[2000];
    size_t at =
        (size_t)snprintf(text, sizeof text, "VERSION 2\nMJD Xpole Ypole UT1-UTC LOD\n(10**-6\") (.1us)\n");
    for (int k = 0; k < 6; k++)
        at += (size_t)snprintf(text + at, sizeof text - at, "%.2f 100000 200000 %d 0\n", 61403.0 + k,
                               -5000000 + 10000 * k + (61403 + k >= 61406 ? 10000000 : 0));
    orr_erp x;
    orr_diag d = {0};
    ASSERT_OK(orr_erp_parse("made", text, at, &table, NULL, &x, NULL, &d), d);
    assert_int_equal(x.series.n, 6);
    for (int k = 0; k < 6; k++) {
        const orr_time t = orr_time_from_mjd(61403 + k, 0, ORR_SCALE_UTC, &table);
        ASSERT_NEAR(orr_eop_at(&x.series, t, NULL, NULL).ut1_utc_s - orr_leap_tai_minus_utc(t, NULL),
                    -37.5 + 1e-3 * k, 1e-10);
    }
    orr_erp_free(&x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_igs),          cmocka_unit_test(test_code),
        cmocka_unit_test(test_ut1_tai),      cmocka_unit_test(test_several),
        cmocka_unit_test(test_merge),        cmocka_unit_test(test_finals),
        cmocka_unit_test(test_c04),          cmocka_unit_test(test_stray_lines),
        cmocka_unit_test(test_refusals),     cmocka_unit_test(test_cut_short),
        cmocka_unit_test(test_leap_seconds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
