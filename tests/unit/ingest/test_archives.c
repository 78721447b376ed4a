// SPDX-License-Identifier: GPL-3.0-or-later
// Names of IGS products of both eras, against names that were really used, and the user's own table.
#include "testing.h"

#include "ingest/fetch/archives.h"

static int32_t mjd(int y, int m, int d) { return orr_mjd_from_date(y, m, d); }

static size_t candidates(const orr_archives *a, orr_product p, int32_t day, const char *centre, orr_tier tier,
                         const char *station, orr_candidate **out)
{
    orr_wanted w = {.product = p, .mjd = day, .tier = tier};
    orr_diag d = {0};
    size_t n = 0;
    snprintf(w.centre, sizeof w.centre, "%s", centre);
    snprintf(w.station, sizeof w.station, "%s", station);
    orr_status s = orr_archives_candidates(a, &w, out, &n, &d);
    if (s != ORR_OK) fail_msg("%s: %s", orr_status_name(s), d.text);
    return n;
}

static orr_archives *builtin(void)
{
    orr_archives *a;
    orr_diag d = {0};
    ASSERT_OK(orr_archives_read(NULL, &a, &d), d);
    return a;
}

// Names as they stand on published files.
static void test_real_names(void **state)
{
    (void)state;
    static const struct {
        orr_product product;
        int y, m, d;
        const char *centre, *station, *name;
    } cases[] = {
        {ORR_PRODUCT_SP3, 2024, 2, 4, "COD", "", "COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"},
        {ORR_PRODUCT_SP3, 2008, 10, 5, "COD", "", "COD15000.EPH.Z"},
        {ORR_PRODUCT_SP3, 2010, 7, 1, "IGS", "", "igs15904.sp3.Z"},
        {ORR_PRODUCT_SP3, 2009, 9, 22, "IGL", "", "igl15502.sp3.Z"},
        {ORR_PRODUCT_SP3, 2020, 6, 25, "GRG", "", "GRG0MGXFIN_20201770000_01D_15M_ORB.SP3.gz"},
        {ORR_PRODUCT_ERP, 2008, 10, 8, "COD", "", "COD15007.ERP.Z"}, // a Wednesday's is in the week's file
        {ORR_PRODUCT_ERP, 2022, 9, 8, "IGS", "", "igr22264.erp.Z"},
        {ORR_PRODUCT_IONEX, 2024, 2, 4, "IGS", "", "IGS0OPSFIN_20240350000_01D_02H_GIM.INX.gz"},
        {ORR_PRODUCT_IONEX, 2022, 1, 2, "COD", "", "CODG0020.22I.Z"},
        {ORR_PRODUCT_ION, 2010, 7, 1, "COD", "", "COD15904.ION.Z"},
        {ORR_PRODUCT_BIAS, 2024, 2, 4, "COD", "", "COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz"},
        {ORR_PRODUCT_SINEX, 2024, 2, 4, "IGS", "", "IGS0OPSSNX_20240350000_01D_01D_CRD.SNX.gz"},
        {ORR_PRODUCT_NAV, 2010, 7, 1, "", "", "brdc1820.10n.Z"},
        {ORR_PRODUCT_NAV, 2009, 4, 1, "", "", "brdc0910.09g.Z"},
        {ORR_PRODUCT_NAV, 2024, 2, 4, "", "", "BRDC00IGS_R_20240350000_01D_MN.rnx.gz"},
        {ORR_PRODUCT_OBS, 2024, 2, 4, "", "bor1", "BOR100POL_R_20240350000_01D_30S_MO.crx.gz"},
        {ORR_PRODUCT_OBS, 2019, 7, 1, "", "DJIG00DJI", "DJIG00DJI_R_20191820000_01D_30S_MO.crx.gz"},
        {ORR_PRODUCT_OBS, 2016, 2, 13, "", "SEAT", "seat0440.16d.Z"},
    };
    orr_archives *a = builtin();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        orr_candidate *c = NULL;
        size_t n = candidates(a, cases[i].product, mjd(cases[i].y, cases[i].m, cases[i].d), cases[i].centre,
                              ORR_TIER_FINAL, cases[i].station, &c);
        bool found = false;
        for (size_t k = 0; k < n; k++) {
            found |= strcmp(c[k].name, cases[i].name) == 0;
            const char *end = strrchr(c[k].url, '/');
            assert_non_null(end);
            assert_string_equal(end + 1, c[k].name);
        }
        if (!found) fail_msg("%s is not among the %zu candidates", cases[i].name, n);
        free(c);
    }
    orr_archives_free(a);
}

// The day before and the day of the switch to long names, GPS week 2238.
static void test_switch_of_names(void **state)
{
    (void)state;
    orr_archives *a = builtin();
    orr_candidate *c = NULL;
    candidates(a, ORR_PRODUCT_SP3, mjd(2022, 11, 26), "IGS", ORR_TIER_FINAL, "", &c);
    assert_string_equal(c[0].name, "igs22376.sp3.Z");
    free(c);
    candidates(a, ORR_PRODUCT_SP3, mjd(2022, 11, 27), "IGS", ORR_TIER_FINAL, "", &c);
    assert_string_equal(c[0].name, "IGS0OPSFIN_20223310000_01D_15M_ORB.SP3.gz");
    free(c);
    orr_archives_free(a);
}

static void test_order(void **state)
{
    (void)state;
    orr_archives *a = builtin();
    orr_candidate *c = NULL;
    size_t n = candidates(a, ORR_PRODUCT_SP3, mjd(2024, 2, 4), "COD", ORR_TIER_FINAL, "", &c);
    assert_string_equal(c[0].mirror, "AIUB");
    assert_string_equal(c[0].url,
                        "https://download.aiub.unibe.ch/CODE/2024/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz");
    bool cddis = false;
    for (size_t i = 0; i < n; i++) {
        if (i > 0) assert_true(c[i].tier >= c[i - 1].tier); // tiers only go down
        assert_string_equal(c[i].centre, "COD");
        if (strcmp(c[i].mirror, "CDDIS") != 0) continue;
        cddis = true;
        assert_true(c[i].login);
        if (c[i].tier == ORR_TIER_FINAL) assert_non_null(strstr(c[i].url, "/products/2300/"));
    }
    assert_true(cddis);
    free(c);
    n = candidates(a, ORR_PRODUCT_SP3, mjd(2024, 2, 4), "", ORR_TIER_RAPID, "", &c);
    for (size_t i = 0; i < n; i++) assert_true(c[i].tier != ORR_TIER_FINAL);
    free(c);
    // Ultra-rapids: the one that starts with the day before those that start earlier.
    n = candidates(a, ORR_PRODUCT_SP3, mjd(2024, 1, 1), "IGS", ORR_TIER_ULTRA, "", &c);
    assert_string_equal(c[0].name, "IGS0OPSULT_20240010000_02D_15M_ORB.SP3.gz");
    bool before = false;
    for (size_t i = 0; i < n; i++)
        before |= strcmp(c[i].name, "IGS0OPSULT_20233651800_02D_15M_ORB.SP3.gz") == 0;
    assert_true(before);
    free(c);
    // The short ones are labelled by the instant between observation and prediction: the day's end.
    candidates(a, ORR_PRODUCT_SP3, mjd(2015, 7, 18), "IGS", ORR_TIER_ULTRA, "", &c);
    assert_string_equal(c[0].name, "igu18540_00.sp3.Z");
    free(c);
    orr_archives_free(a);
}

static void test_unknown(void **state)
{
    (void)state;
    orr_archives *a = builtin();
    orr_candidate *c = NULL;
    size_t n;
    orr_diag d = {0};
    orr_wanted w = {.product = ORR_PRODUCT_SP3, .mjd = mjd(2024, 2, 4), .centre = "XYZ"};
    assert_int_equal(orr_archives_candidates(a, &w, &c, &n, &d), ORR_E_NODATA);
    assert_non_null(strstr(d.text, "XYZ"));
    // A station whose long name is not known has its short one.
    n = candidates(a, ORR_PRODUCT_OBS, mjd(2024, 2, 4), "", ORR_TIER_FINAL, "XXXX", &c);
    assert_true(n > 0);
    for (size_t i = 0; i < n; i++) assert_non_null(strstr(c[i].name, "xxxx0350.24"));
    free(c);
    orr_archives_free(a);
}

static void assert_refused(const char *text, int line, const char *words)
{
    orr_archives *a = NULL;
    orr_diag d = {0};
    assert_int_equal(orr_archives_parse("mine", text, strlen(text), &a, &d), ORR_E_FORMAT);
    assert_null(a);
    if (line > 0) assert_int_equal(d.line, line);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
}

static void test_users_table(void **state)
{
    (void)state;
    const char *text = "# mine\n"
                       "name sp3 COD final 2020-01-01 2020-12-31 x{yyyy}_{mm}{dd}_{doy}.sp3 shift=-24\n"
                       "name erp COD final - - w{week}{dow}.erp start=week\n"
                       "mirror here * http://127.0.0.1:1/{yy} centres=COD,IGS tiers=final,rapid\n";
    orr_archives *a = NULL;
    orr_diag d = {0};
    ASSERT_OK(orr_archives_parse("mine", text, strlen(text), &a, &d), d);
    orr_candidate *c = NULL;
    assert_int_equal(candidates(a, ORR_PRODUCT_SP3, mjd(2020, 3, 1), "", ORR_TIER_FINAL, "", &c), 1);
    assert_string_equal(c[0].url,
                        "http://127.0.0.1:1/20/x2020_0229_060.sp3"); // a day earlier, in a leap year
    free(c);
    assert_int_equal(candidates(a, ORR_PRODUCT_ERP, mjd(2024, 2, 10), "", ORR_TIER_FINAL, "", &c), 1);
    assert_string_equal(c[0].name, "w23000.erp"); // Saturday's file is the Sunday's
    free(c);
    orr_archives_free(a);
    assert_refused("name sp3 COD final\n", 1, "expected: name");
    assert_refused("name sp4 COD final - - x\n", 1, "product");
    assert_refused("name sp3 COD best - - x\n", 1, "tier");
    assert_refused("name sp3 COD final 2020-13-01 - x\n", 1, "date");
    assert_refused("name sp3 COD final - - {year}.sp3\n", 1, "field");
    assert_refused("name sp3 COD final - - ../../x\n", 1, "slash");
    assert_refused("\nmirror x sp3 nowhere\n", 2, "URL");
    assert_refused("mirror x sp3 http://h/ password=1\n", 1, "login");
    assert_refused("miror x\n", 1, "starts with");
    assert_refused("station ../BOR100\n", 1, "nine letters");
    assert_refused("# nothing\n", 0, "no name");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_real_names),  cmocka_unit_test(test_switch_of_names),
        cmocka_unit_test(test_order),       cmocka_unit_test(test_unknown),
        cmocka_unit_test(test_users_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
