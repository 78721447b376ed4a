// SPDX-License-Identifier: GPL-3.0-or-later
// Published files of analysis centres, read by our readers and counted beside them by plain looks at their
// lines; and the verdict on every odd file of these kinds.
#include "testing.h"

#include "core/vec.h"
#include "ingest/input/input.h"
#include "ingest/maps/ionex.h"
#include "ingest/rinex/clk.h"
#include "ingest/tables/antex.h"
#include "ingest/tables/bias.h"
#include "ingest/tables/erp.h"
#include "ingest/tables/sinex.h"
#include "read_file.h"

READ_FILE_BY_PARSER(ionex)
READ_FILE_BY_PARSER(clk)
READ_FILE_BY_PARSER(sinex)

// ---- plain counting: nothing of ours but what inflates ----

static orr_bytes load(const char *path)
{
    orr_bytes b;
    orr_diag d = {0};
    ASSERT_OK(orr_input_read_all(path, NULL, &b, &d), d);
    return b;
}

// Lines that start with `start` and have `part` at column `column` (from 1); an empty text matches all.
static size_t count(const orr_bytes *b, const char *start, int column, const char *part)
{
    size_t n = 0;
    for (const char *line = b->text; *line != '\0';) {
        const char *end = strchr(line, '\n');
        size_t len = end != NULL ? (size_t)(end - line) : strlen(line);
        size_t need = (size_t)(column - 1) + strlen(part);
        if (len >= strlen(start) && strncmp(line, start, strlen(start)) == 0 &&
            (*part == '\0' || (len >= need && strncmp(line + column - 1, part, strlen(part)) == 0)))
            n++;
        line = end != NULL ? end + 1 : line + len;
    }
    return n;
}

static bool path_of(const char *name, char path[1024]) { return orr_test_data(name, path, 1024); }

static orr_time gps(int year, int month, int day, int hour)
{
    orr_time t;
    orr_civil c = {year, month, day, hour, 0, 0, 0};
    assert_int_equal(orr_time_from_civil(&c, ORR_SCALE_GPS, NULL, &t), ORR_OK);
    return t;
}

// ---- maps ----

// The sum of all TEC values, field by field from the text, and how many are 9999.
static long long sum_of_text(char *text, size_t *missing)
{
    long long sum = 0;
    bool tec = false, values = false;
    *missing = 0;
    for (char *line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        bool labelled = strlen(line) > 60 && strspn(line + 60, "0123456789 -") != strlen(line + 60);
        if (labelled) {
            if (strstr(line, "START OF TEC")) tec = true;
            if (strstr(line, "END OF TEC")) tec = false;
            values = strstr(line, "LAT/LON1/LON2") != NULL;
        }
        for (size_t k = 0; !labelled && tec && values && k + 5 <= strlen(line); k += 5) {
            char field[6];
            snprintf(field, sizeof field, "%.5s", line + k);
            if (strspn(field, " ") == 5) break;
            if (atoi(field) == 9999)
                ++*missing;
            else
                sum += atoi(field);
        }
    }
    return sum;
}

static void check_ionex(const char *name, double step_s, double first_value)
{
    char path[1024];
    if (!path_of(name, path)) SKIP_NO_DATA(name);
    orr_ionex x;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(read_ionex(path, NULL, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    orr_bytes b = load(path);
    assert_int_equal(x.n_epochs, count(&b, "", 61, "START OF TEC MAP"));
    assert_int_equal(x.n_epochs, count(&b, "", 61, "START OF RMS MAP"));
    assert_int_equal(x.n_epochs * x.n_lats * 2, count(&b, "", 61, "LAT/LON1/LON2/DLON/H"));
    assert_int_equal(x.n_dcbs,
                     count(&b, "", 61, "PRN / BIAS / RMS") + count(&b, "", 61, "STATION / BIAS / RMS"));
    assert_int_equal(x.n_lats, 71);
    assert_int_equal(x.n_lons, 73);
    ASSERT_NEAR(x.tec_tecu[0], first_value, 1e-12);
    for (size_t e = 0; e < x.n_epochs; e++) {
        if (e > 0) assert_true(x.epoch[e] - x.epoch[e - 1] == (orr_time)(step_s * 1e9));
        for (size_t i = 0; i < x.n_lats; i++) { // -180 and 180 are one meridian
            size_t a = orr_ionex_index(&x, e, 0, i, 0);
            assert_true(x.tec_tecu[a] == x.tec_tecu[a + x.n_lons - 1]);
        }
    }
    size_t missing, ours_missing = 0;
    double ours = 0;
    long long sum = sum_of_text(b.text, &missing);
    for (size_t i = 0; i < x.n_epochs * x.n_lats * x.n_lons; i++) {
        if (isnan(x.tec_tecu[i]))
            ours_missing++;
        else
            ours += x.tec_tecu[i] * 10;
    }
    ASSERT_NEAR(ours, (double)sum, 1e-3); // rounding of 10^5 additions of numbers below 10^4
    assert_int_equal(ours_missing, missing);
    orr_bytes_free(&b);
    orr_ionex_free(&x);
}

static void test_ionex_code(void **state)
{
    (void)state;
    check_ionex("2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz", 3600, 17.3);
}

static void test_ionex_igs(void **state)
{
    (void)state;
    check_ionex("2024-035/IGS0OPSFIN_20240350000_01D_02H_GIM.INX.gz", 7200, 14.4);
}

// Written and read again, a real file says the same.
static void test_ionex_round_trip(void **state)
{
    (void)state;
    const char *name = "2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz";
    char path[1024];
    if (!path_of(name, path)) SKIP_NO_DATA(name);
    orr_ionex a, b;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(read_ionex(path, NULL, &a, NULL, &d), d);
    const char *copy = ORR_BINARY_DIR "/round-trip.inx";
    ASSERT_OK(orr_ionex_write(&a, copy, &d), d);
    ASSERT_OK(read_ionex(copy, NULL, &b, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(a.n_epochs, b.n_epochs);
    size_t n = a.n_epochs * a.n_lats * a.n_lons * sizeof(double);
    assert_memory_equal(a.tec_tecu, b.tec_tecu, n);
    assert_memory_equal(a.rms_tecu, b.rms_tecu, n);
    assert_int_equal(a.n_dcbs, b.n_dcbs);
    for (size_t i = 0; i < a.n_dcbs; i++) {
        assert_string_equal(a.dcb[i].station, b.dcb[i].station);
        ASSERT_NEAR(a.dcb[i].bias_s, b.dcb[i].bias_s, 1e-18);
    }
    remove(copy);
    orr_ionex_free(&a);
    orr_ionex_free(&b);
}

// ---- Earth rotation ----

static void test_erp(void **state)
{
    (void)state;
    char path[1024];
    if (!path_of("2008-279/COD15007.ERP.Z", path)) SKIP_NO_DATA("2008-279/COD15007.ERP.Z");
    orr_erp x;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(read_erp(path, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    orr_bytes b = load(path);
    assert_int_equal(x.series.n, count(&b, "547", 1, ""));
    const double uas = 1e-6 / 3600 * ORR_RAD_PER_DEG;
    ASSERT_NEAR(x.series.mjd_utc[1], 54744.5, 0); // "54744.50 253263 208651 -4948440 3324 ... -2116 -2114"
    ASSERT_NEAR(x.series.value[1].xp_rad, 253263 * uas, 1e-18);
    ASSERT_NEAR(x.series.value[1].yp_rad, 208651 * uas, 1e-18);
    ASSERT_NEAR(x.series.value[1].ut1_utc_s, -0.4948440, 1e-12);
    ASSERT_NEAR(x.series.value[1].lod_s, 0.0003324, 1e-15);
    ASSERT_NEAR(x.detail[1].yp_rate_radps, -2114 * uas / 86400, 1e-22);
    // LOD is minus the daily change of UT1: the columns are what we take them for. The middle of two days of
    // UT1 differs from a day's LOD by the tides' curvature, well below 1e-4 s.
    const orr_eop *v = x.series.value;
    for (size_t i = 1; i + 1 < x.series.n; i++)
        ASSERT_NEAR((v[i - 1].ut1_utc_s - v[i + 1].ut1_utc_s) / 2, v[i].lod_s, 1e-4);
    orr_bytes_free(&b);
    orr_erp_free(&x);
    if (!path_of("2008-279/igr22264.erp.gz", path)) SKIP_NO_DATA("2008-279/igr22264.erp.gz");
    ASSERT_OK(read_erp(path, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.series.n, 1);
    ASSERT_NEAR(x.series.value[0].ut1_utc_s, -0.0098409, 1e-12);
    orr_erp_free(&x);
}

// ---- clocks ----

static void test_clk(void **state)
{
    (void)state;
    const char *name = "2008-279/whp15000.clk.Z";
    char path[1024];
    if (!path_of(name, path)) SKIP_NO_DATA(name);
    orr_clk x;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(read_clk(path, NULL, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    orr_bytes b = load(path);
    size_t records = 0;
    for (size_t i = 0; i < x.n_sats; i++) {
        char start[16], sat[ORR_SAT_TEXT];
        snprintf(start, sizeof start, "AS %s", orr_sat_text(x.sat[i].sat, sat));
        assert_int_equal(x.sat[i].n, count(&b, start, 1, ""));
        records += x.sat[i].n;
    }
    assert_int_equal(records, count(&b, "AS ", 1, ""));
    assert_int_equal(x.n_receivers, 0);
    ASSERT_NEAR(x.interval_s, 30, 0);
    assert_true(x.from == gps(2008, 10, 5, 0));
    const orr_clk_series *g32 = orr_clk_find(&x, orr_sat_make('G', 32));
    assert_non_null(g32); // the last line of the file
    ASSERT_NEAR(g32->record[g32->n - 1].bias_s, 0.316534379284e-03, 1e-18);
    orr_bytes_free(&b);
    orr_clk_free(&x);
}

// ---- biases and coordinates ----

static void test_biases(void **state)
{
    (void)state;
    static const char *const names[] = {"2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz",
                                        "2024-035/GRG0MGXFIN_20240350000_01D_01D_OSB.BIA.gz"};
    for (size_t f = 0; f < 2; f++) {
        char path[1024];
        if (!path_of(names[f], path)) SKIP_NO_DATA(names[f]);
        orr_bias_set x;
        orr_diag d = {0};
        orr_warnings w = {0};
        ASSERT_OK(orr_bias_read(path, NULL, &x, &w, &d), d);
        assert_int_equal(w.count, 0);
        orr_bytes b = load(path);
        assert_int_equal(x.n, count(&b, " OSB ", 1, ""));
        assert_int_equal(x.n, strtoul(b.text + 65, NULL, 10)); // "... A 00014361" ends the first line
        orr_bytes_free(&b);
        double v;
        const orr_sat g01 = orr_sat_make('G', 1);
        if (f == 0) {
            assert_int_equal(orr_bias_osb(&x, g01, "C1C", gps(2024, 2, 4, 6), &v), ORR_OK);
            ASSERT_NEAR(v, 9.5198e-9, 1e-20);
            assert_int_equal(orr_bias_dsb(&x, g01, "C1C", "C1W", gps(2024, 2, 4, 6), &v), ORR_OK);
            ASSERT_NEAR(v, (9.5198 - 11.0188) * 1e-9, 1e-20);
            assert_int_equal(orr_bias_osb(&x, g01, "C1C", gps(2024, 2, 5, 6), &v), ORR_E_NODATA);
        }
        orr_bias_free(&x);
    }
}

static void test_sinex(void **state)
{
    (void)state;
    const char *name = "2024-035/IGS0OPSSNX_20240350000_01D_01D_CRD.SNX.gz";
    char path[1024];
    if (!path_of(name, path)) SKIP_NO_DATA(name);
    orr_sinex x;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(read_sinex(path, NULL, &x, &w, &d), d);
    assert_int_equal(w.count, 1); // the line of GODE is out of its columns in the file itself
    orr_bytes b = load(path);
    const char *at = strstr(b.text, "+SOLUTION/ESTIMATE");
    assert_non_null(at);
    size_t n = 0;
    for (; (at = strstr(at, " STAX ")) != NULL; at++) n++;
    assert_int_equal(x.n_estimates, n);
    orr_bytes_free(&b);
    double pos[3];
    assert_int_equal(orr_sinex_position(&x, "BOR1", gps(2024, 2, 4, 12), pos), ORR_OK);
    ASSERT_NEAR(pos[0], 3738358.13315294,
                1e-8); // "163 STAX BOR1 A 3 ... 3.73835813315294e+06" of the estimate
    ASSERT_NEAR(pos[1], 1148174.00879205, 1e-8);
    ASSERT_NEAR(pos[2], 5021815.93384643, 1e-8);
    ASSERT_NEAR(pos[0], 3738358.1345,
                3e-3); // the a-priori figures of the same file; estimates move by millimetres
    ASSERT_NEAR(pos[1], 1148174.0090, 3e-3);
    ASSERT_NEAR(pos[2], 5021815.9357, 3e-3);
    const orr_sinex_eccentricity *e = orr_sinex_find_eccentricity(&x, "BOR1", gps(2024, 2, 4, 12));
    assert_non_null(e);
    assert_true(e->local);
    orr_sinex_free(&x);
    orr_warnings_free(&w);
}

// ---- antennas ----

static void test_antex(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t warnings; // igs20-small was cut by hand: one antenna names 21 frequencies and has 2
    } files[] = {{"antex/igs05.atx.gz", 0}, {"antex/igs14-small.atx.gz", 0}, {"antex/igs20-small.atx.gz", 1}};
    for (size_t f = 0; f < 3; f++) {
        char path[1024];
        if (!path_of(files[f].name, path)) SKIP_NO_DATA(files[f].name);
        orr_antex x;
        orr_diag d = {0};
        orr_warnings w = {0};
        ASSERT_OK(orr_antex_read(path, NULL, &x, &w, &d), d);
        assert_int_equal(w.count, files[f].warnings);
        orr_bytes b = load(path);
        assert_int_equal(x.n_antennas, count(&b, "", 61, "START OF ANTENNA"));
        size_t frequencies = 0;
        for (size_t i = 0; i < x.n_antennas; i++) frequencies += x.antenna[i].n_frequencies;
        assert_int_equal(frequencies, count(&b, "", 61, "START OF FREQUENCY"));
        if (f == 0) {
            // "BLOCK IIR-M  G07  G048  2008-012A", valid from 2008-03-15: up 700.00 mm, nadir 0: 10.70 mm
            const orr_antex_antenna *a = orr_antex_find_sat(&x, orr_sat_make('G', 7), gps(2010, 1, 1, 0));
            assert_non_null(a);
            assert_string_equal(a->svn, "G048");
            const orr_antex_frequency *g02 = orr_antex_find_frequency(a, "G02");
            assert_non_null(g02);
            ASSERT_NEAR(g02->offset_m[2], 0.7, 1e-12);
            ASSERT_NEAR(orr_antex_variation_m(a, g02, 0, 0), 10.70e-3, 1e-12);
            assert_non_null(orr_antex_find_receiver(&x, "TRM59800.00     SCIT", NULL));
        }
        orr_bytes_free(&b);
        orr_antex_free(&x);
        orr_warnings_free(&w);
    }
}

// ---- odd files ----

typedef enum verdict { ACCEPTED, WITH_WARNINGS, REFUSED } verdict;

static const struct {
    const char *name;
    verdict verdict;
    int64_t line;      // of the refusal; 0: at the end of the header
    const char *words; // of the refusal
} odd[] = {
    // A letter among the values of a row.
    {"odd/ionex/corrupted-bad-data-gpsg0150.19i.gz", REFUSED, 22, "TA"},
    // Version 1.1, fields without blanks between them, labels with underscores: all of it is legible.
    {"odd/ionex/jammed-fields.14i.gz", ACCEPTED, 0, ""},
    // The grid is told nowhere but in the rows; a header without LAT1 and LON1 is no IONEX header.
    {"odd/ionex/missing-lat-lon-header-gpsg0150.19i.gz", REFUSED, 0, "LAT1 / LAT2 / DLAT"},
    // Three maps cut out of a day: complete in itself.
    {"odd/ionex/split-2.19i.gz", ACCEPTED, 0, ""},
    // A word instead of a value; the file has no other antenna.
    {"odd/antex/igs14-corrupted.atx.gz", REFUSED, 21, "no number"},
    // What a line with an unknown label means for its antenna (a validity, perhaps) cannot be known; no other
    // antenna.
    {"odd/antex/igs14-unknown-label.atx.gz", REFUSED, 17, "no label of an antenna"},
    // A pattern shorter than its grid; no other antenna.
    {"odd/antex/igs14-wrong-columns.atx.gz", REFUSED, 25, "only 9 of the 16"},
};

static void test_odd_files(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
        char path[1024];
        if (!path_of(odd[i].name, path)) SKIP_NO_DATA(odd[i].name);
        orr_diag d = {0};
        orr_warnings w = {0};
        orr_status s;
        if (strstr(odd[i].name, "ionex") != NULL) {
            orr_ionex x;
            s = read_ionex(path, NULL, &x, &w, &d);
            orr_ionex_free(&x);
        } else {
            orr_antex x;
            s = orr_antex_read(path, NULL, &x, &w, &d);
            orr_antex_free(&x);
        }
        verdict got = s != ORR_OK ? REFUSED : w.count > 0 ? WITH_WARNINGS : ACCEPTED;
        if (got != odd[i].verdict)
            fail_msg("%s: verdict %d, not %d (%s)", odd[i].name, (int)got, (int)odd[i].verdict, d.text);
        if (got == REFUSED) {
            assert_int_equal(s, ORR_E_FORMAT);
            if (strstr(d.text, odd[i].words) == NULL) fail_msg("%s: \"%s\"", odd[i].name, d.text);
            if (odd[i].line > 0) assert_int_equal(d.line, odd[i].line);
        }
        orr_warnings_free(&w);
    }
}

// The jammed file's values are what its text says: 10157 beside 10167 without a blank between.
static void test_jammed_values(void **state)
{
    (void)state;
    const char *name = "odd/ionex/jammed-fields.14i.gz";
    char path[1024];
    if (!path_of(name, path)) SKIP_NO_DATA(name);
    orr_ionex x;
    orr_diag d = {0};
    ASSERT_OK(read_ionex(path, NULL, &x, NULL, &d), d);
    ASSERT_NEAR(x.tec_tecu[orr_ionex_index(&x, 0, 0, 0, 0)], 89.17, 1e-12);
    ASSERT_NEAR(x.tec_tecu[orr_ionex_index(&x, 0, 0, 1, 0)], 101.57, 1e-12);
    ASSERT_NEAR(x.tec_tecu[orr_ionex_index(&x, 0, 0, 1, 1)], 101.67, 1e-12);
    ASSERT_NEAR(x.tec_tecu[orr_ionex_index(&x, 0, 0, 1, 72)], 101.57, 1e-12);
    ASSERT_NEAR(x.tec_tecu[orr_ionex_index(&x, 0, 0, 2, 2)], 110.27, 1e-12);
    orr_ionex_free(&x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ionex_code),
        cmocka_unit_test(test_ionex_igs),
        cmocka_unit_test(test_ionex_round_trip),
        cmocka_unit_test(test_erp),
        cmocka_unit_test(test_clk),
        cmocka_unit_test(test_biases),
        cmocka_unit_test(test_sinex),
        cmocka_unit_test(test_antex),
        cmocka_unit_test(test_odd_files),
        cmocka_unit_test(test_jammed_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
