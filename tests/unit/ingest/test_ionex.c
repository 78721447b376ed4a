// SPDX-License-Identifier: GPL-3.0-or-later
// Every rule of the IONEX reader on made text, and the writer through the reader.
#include "testing.h"

#include <unistd.h>

#include "core/nan.h"
#include "ingest/maps/ionex.h"
#include "read_file.h"
#include "unit/ingest/made_text.h"

READ_FILE_BY_PARSER(ionex)

enum { LATS = 3, LONS = 18 }; // 18 longitudes: one full line of 16 values and one of 2

static void header(made_text *t, const char *extra, int maps)
{
    char line[64];
    made_label(t, "     1.0            IONOSPHERE MAPS     GNSS", "IONEX VERSION / TYPE");
    made_label(t, "made by hand        nobody              01-JAN-24 00:00", "PGM / RUN BY / DATE");
    made_label(t, "Made maps", "DESCRIPTION");
    made_label(t, "  2024     2     4     0     0     0", "EPOCH OF FIRST MAP");
    made_label(t, "  2024     2     4     2     0     0", "EPOCH OF LAST MAP");
    made_label(t, "  7200", "INTERVAL");
    snprintf(line, sizeof line, "%6d", maps);
    made_label(t, line, "# OF MAPS IN FILE");
    made_label(t, "  COSZ", "MAPPING FUNCTION");
    made_label(t, "    10.0", "ELEVATION CUTOFF");
    made_label(t, "phase", "OBSERVABLES USED");
    made_label(t, "   239", "# OF STATIONS");
    made_label(t, "    80", "# OF SATELLITES");
    made_label(t, "  6371.0", "BASE RADIUS");
    made_label(t, "     2", "MAP DIMENSION");
    made_label(t, "   450.0 450.0   0.0", "HGT1 / HGT2 / DHGT");
    made_label(t, "    10.0 -10.0 -10.0", "LAT1 / LAT2 / DLAT");
    made_label(t, "  -180.0 160.0  20.0", "LON1 / LON2 / DLON");
    made_label(t, "    -1", "EXPONENT");
    if (extra != NULL) made_bytes(t, extra, strlen(extra));
    made_label(t, "", "END OF HEADER");
}

// Value of a cell, different everywhere, so that any exchange of rows, columns or maps shows.
static int cell(int map, int lat, int lon) { return 1000 * map + 100 * lat + lon; }

static void map(made_text *t, const char *kind, int number, const char *epoch, const char *extra)
{
    char line[64], label[24];
    snprintf(line, sizeof line, "%6d", number);
    snprintf(label, sizeof label, "START OF %s MAP", kind);
    made_label(t, line, label);
    if (epoch != NULL) made_label(t, epoch, "EPOCH OF CURRENT MAP");
    if (extra != NULL) made_bytes(t, extra, strlen(extra));
    for (int i = 0; i < LATS; i++) {
        snprintf(line, sizeof line, "  %6.1f-180.0 160.0  20.0 450.0", 10.0 - 10.0 * i);
        made_label(t, line, "LAT/LON1/LON2/DLON/H");
        for (int k = 0; k < LONS; k++)
            made_add(t, "%5d%s", cell(number, i, k), k == 15 || k == LONS - 1 ? "\n" : "");
    }
    snprintf(line, sizeof line, "%6d", number);
    snprintf(label, sizeof label, "END OF %s MAP", kind);
    made_label(t, line, label);
}

#define EPOCH_0 "  2024     2     4     0     0     0"
#define EPOCH_1 "  2024     2     4     1     0     0"
#define EPOCH_2 "  2024     2     4     2     0     0"

static made_text two_maps(void)
{
    made_text t = {0};
    header(&t, NULL, 2);
    map(&t, "TEC", 1, EPOCH_0, NULL);
    map(&t, "TEC", 2, EPOCH_2, NULL);
    made_label(&t, "", "END OF FILE");
    return t;
}

static orr_status parse(made_text *t, orr_ionex *x, orr_warnings *w, orr_diag *d)
{
    *d = (orr_diag){0};
    orr_status s = orr_ionex_parse("made", t->s, t->n, NULL, x, w, d);
    made_free(t);
    return s;
}

static void assert_refused(made_text *t, orr_status expected, int line, const char *words)
{
    orr_ionex x;
    orr_diag d;
    orr_status s = parse(t, &x, NULL, &d);
    assert_int_equal(s, expected);
    assert_null(x.tec_tecu); // nothing is left behind
    if (line > 0) assert_int_equal(d.line, line);
    if (strstr(d.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", d.text, words);
}

static orr_time utc(int h)
{
    orr_time t;
    assert_int_equal(orr_time_from_civil(&(orr_civil){2024, 2, 4, h, 0, 0, 0}, ORR_SCALE_UTC, NULL, &t),
                     ORR_OK);
    return t;
}

static void test_reads_everything(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = {0};
    header(&t,
           "Comment of the header                                       COMMENT             \n"
           "DIFFERENTIAL CODE BIASES                                    START OF AUX DATA   \n"
           "   G01    -7.047     0.051                                  PRN / BIAS / RMS    \n"
           "    02     7.592     0.044                                  PRN / BIAS / RMS    \n"
           "   R  BOR1 12205M002           8.609     0.107              STATION / BIAS / RMS\n"
           "DIFFERENTIAL CODE BIASES                                    END OF AUX DATA     \n",
           2);
    map(&t, "TEC", 1, EPOCH_0, NULL);
    map(&t, "TEC", 2, EPOCH_2, NULL);
    map(&t, "RMS", 1, EPOCH_0, NULL);
    map(&t, "RMS", 2, EPOCH_2, NULL);
    map(&t, "HEIGHT", 1, EPOCH_0, NULL);
    map(&t, "HEIGHT", 2, NULL, NULL); // takes the epoch of TEC map 2
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_string_equal(x.technique, "GNSS");
    assert_string_equal(x.program, "made by hand");
    assert_int_equal(x.mapping, ORR_IONEX_MAP_COSZ);
    ASSERT_NEAR(x.base_radius_m, 6371e3, 0);
    ASSERT_NEAR(x.elevation_cutoff_deg, 10, 0);
    assert_int_equal(x.n_stations, 239);
    assert_int_equal(x.n_satellites, 80);
    assert_int_equal(x.n_epochs, 2);
    assert_int_equal(x.n_heights, 1);
    assert_int_equal(x.n_lats, LATS);
    assert_int_equal(x.n_lons, LONS);
    ASSERT_NEAR(x.height_m[0], 450e3, 0);
    ASSERT_NEAR(x.lat_deg[2], -10, 0);
    ASSERT_NEAR(x.lon_deg[17], 160, 0);
    assert_true(x.epoch[0] == utc(0) && x.epoch[1] == utc(2));
    for (size_t e = 0; e < 2; e++)
        for (size_t i = 0; i < LATS; i++)
            for (size_t k = 0; k < LONS; k++) {
                size_t at = orr_ionex_index(&x, e, 0, i, k);
                double v = cell((int)e + 1, (int)i, (int)k) / 10.0;
                assert_true(x.tec_tecu[at] == v); // the double nearest the decimal, bit for bit
                assert_true(x.rms_tecu[at] == v);
                ASSERT_NEAR(x.hgt_m[at], v * 1e3, 1e-9); // one rounding of a product
            }
    assert_int_equal(x.n_dcbs, 3);
    assert_int_equal(x.dcb[0].sat, orr_sat_make('G', 1));
    ASSERT_NEAR(x.dcb[0].bias_s, -7.047e-9, 1e-20);
    assert_int_equal(x.dcb[1].sat, orr_sat_make('G', 2)); // blank system letter of the oldest files
    assert_int_equal(x.dcb[2].sat, ORR_SAT_NONE);
    assert_string_equal(x.dcb[2].station, "BOR1 12205M002");
    assert_int_equal(x.dcb[2].system, 'R');
    assert_int_equal(x.n_comments, 1);
    assert_int_equal(x.n_descriptions, 1);
    orr_ionex_free(&x);
    orr_warnings_free(&w);
}

static void test_missing_and_five_digits(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    made_text t = two_maps();
    made_replace(&t, " 1000 1001 1002", " 999910158 -002");
    ASSERT_OK(parse(&t, &x, NULL, &d), d);
    assert_true(isnan(x.tec_tecu[0]));
    assert_true(x.tec_tecu[1] == 1015.8);
    assert_true(x.tec_tecu[2] == -0.2);
    orr_ionex_free(&x);
}

static void test_exponents(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = {0};
    header(&t, NULL, 3);
    map(&t, "TEC", 1, EPOCH_0, NULL); // header's
    map(&t, "TEC", 2, EPOCH_1,
        "    -2                                                      EXPONENT            \n");
    map(&t, "TEC", 3, EPOCH_2,
        "     1                                                      EXPONENT            \n");
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(x.exponent, -1);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 0, 0, 1, 5)] == 110.5);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 1, 0, 1, 5)] == 21.05);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 2, 0, 1, 5)] == 31050.0);
    orr_ionex_free(&x);

    // A map without its own after one with: the header's holds, and that is said.
    t = (made_text){0};
    header(&t, NULL, 2);
    map(&t, "TEC", 1, EPOCH_0,
        "    -2                                                      EXPONENT            \n");
    map(&t, "TEC", 2, EPOCH_2, NULL);
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(w.count, 1);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 0, 0, 0, 0)] == 10.0);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 1, 0, 0, 0)] == 200.0);
    orr_ionex_free(&x);
    orr_warnings_free(&w);
}

static void test_no_exponent_means_tenths(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    made_text t = two_maps();
    made_replace(&t, "    -1                                                      EXPONENT            \n",
                 "");
    ASSERT_OK(parse(&t, &x, NULL, &d), d);
    assert_true(x.tec_tecu[0] == 100.0);
    orr_ionex_free(&x);
}

static void test_three_dimensional(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    made_text t = {0};
    header(&t, NULL, 1);
    made_replace(&t, "     2                                                      MAP DIMENSION",
                 "     3                                                      MAP DIMENSION");
    made_replace(&t, "   450.0 450.0   0.0", "   200.0 400.0 100.0");
    made_label(&t, "     1", "START OF TEC MAP");
    made_label(&t, EPOCH_0, "EPOCH OF CURRENT MAP");
    for (int h = 0; h < 3; h++)
        for (int i = 0; i < LATS; i++) {
            made_add(&t, "  %6.1f-180.0 160.0  20.0%6.1f%28sLAT/LON1/LON2/DLON/H\n", 10.0 - 10.0 * i,
                     200.0 + 100 * h, "");
            for (int k = 0; k < LONS; k++)
                made_add(&t, "%5d%s", cell(h, i, k), k == 15 || k == LONS - 1 ? "\n" : "");
        }
    made_label(&t, "     1", "END OF TEC MAP");
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, NULL, &d), d);
    assert_int_equal(x.n_heights, 3);
    assert_int_equal(x.dimension, 3);
    ASSERT_NEAR(x.height_m[2], 400e3, 0);
    for (size_t h = 0; h < 3; h++)
        assert_true(x.tec_tecu[orr_ionex_index(&x, 0, h, 2, 17)] == cell((int)h, 2, 17) / 10.0);
    orr_ionex_free(&x);
}

static void test_epochs(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    orr_warnings w = {0};
    // 24:00 is the next day's 00:00; a second map of that instant is left out, with a warning.
    made_text t = {0};
    header(&t, NULL, 3);
    map(&t, "TEC", 1, "  2024     2     4    23    15     0", NULL); // irregular
    map(&t, "TEC", 2, "  2024     2     4    24     0     0", NULL);
    map(&t, "TEC", 3, "  2024     2     5     0     0     0", NULL);
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_epochs, 2);
    assert_true(x.epoch[1] - x.epoch[0] == 45 * 60 * ORR_NS_PER_S);
    assert_true(x.epoch[1] == utc(24));
    assert_true(x.tec_tecu[orr_ionex_index(&x, 1, 0, 0, 0)] == 200.0); // the first of the two
    bool said = false;
    for (size_t i = 0; i < w.kept; i++) said |= strstr(w.item[i].text, "second TEC map") != NULL;
    assert_true(said);
    orr_ionex_free(&x);
    orr_warnings_free(&w);

    // Out of order: sorted. RMS maps at other instants than TEC maps: the union of both, NAN where there is
    // none.
    w = (orr_warnings){0};
    t = (made_text){0};
    header(&t, NULL, 2);
    map(&t, "TEC", 2, EPOCH_2, NULL);
    map(&t, "TEC", 1, EPOCH_0, NULL);
    map(&t, "RMS", 5, EPOCH_1, NULL);
    map(&t, "RMS", 6, EPOCH_2, NULL);
    made_label(&t, "", "END OF FILE");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_epochs, 3);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 0, 0, 0, 0)] == 100.0);
    assert_true(isnan(x.tec_tecu[orr_ionex_index(&x, 1, 0, 0, 0)]));
    assert_true(x.tec_tecu[orr_ionex_index(&x, 2, 0, 0, 0)] == 200.0);
    assert_true(isnan(x.rms_tecu[orr_ionex_index(&x, 0, 0, 0, 0)]));
    assert_true(x.rms_tecu[orr_ionex_index(&x, 1, 0, 0, 0)] == 500.0);
    assert_true(w.count >= 2);
    orr_ionex_free(&x);
    orr_warnings_free(&w);
}

static void test_tolerated(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = two_maps();
    made_replace(&t, "MAPPING FUNCTION", "MAPPING_FUNCTION"); // seen in the wild
    made_replace(&t, "  COSZ", "  MSLM");                     // not a word of the format: warned
    made_replace(&t, "END OF HEADER       \n", "END OF HEADER\r\n");
    made_replace(
        &t, "OBSERVABLES USED    \n",
        "OBSERVABLES USED    \n                                                            NEW LABEL\n");
    made_replace(&t, "                                                            END OF FILE         \n",
                 "");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.mapping, ORR_IONEX_MAP_UNKNOWN);
    assert_string_equal(x.mapping_text, "MSLM");
    assert_int_equal(w.count, 3); // mapping, label, no END OF FILE though every map is there
    orr_ionex_free(&x);
    orr_warnings_free(&w);
}

static void test_refusals(void **state)
{
    (void)state;
    made_text t = {0};
    made_add(&t, "#dP2024  2  4  0  0  0.00000000     289 ORBIT IGS20 FIT AIUB\n");
    assert_refused(&t, ORR_E_KIND, 1, "not an IONEX");
    made_add(&t, "%s", "");
    assert_refused(&t, ORR_E_KIND, 0, "empty");

    t = two_maps();
    made_replace(&t, "     1.0            I", "     7.0            I");
    assert_refused(&t, ORR_E_UNSUPPORTED, 1, "7.00");
    t = two_maps();
    made_replace(&t, "     1.0            I", "     1.0            O");
    assert_refused(&t, ORR_E_KIND, 1, "not I");

    t = two_maps();
    made_replace(&t, " 1003", " 10 3");
    assert_refused(&t, ORR_E_FORMAT, 23, "10 3");
    t = two_maps();
    made_replace(&t, " 1003", "  TAG");
    assert_refused(&t, ORR_E_FORMAT, 23, "TAG");
    t = two_maps();
    made_replace(&t, " 1016 1017\n",
                 " 1016\n"); // a row one value short takes its next line from the next row
    assert_refused(&t, ORR_E_FORMAT, 25, "no integer");
    t = two_maps();
    made_replace(&t, " 1016 1017\n", "\n");
    assert_refused(&t, ORR_E_FORMAT, 24, "only 16 of the 18");
    t = two_maps();
    made_replace(&t, "     0.0-180.0 160.0", "     1.0-180.0 160.0");
    assert_refused(&t, ORR_E_FORMAT, 25, "latitude 1.0");
    t = two_maps();
    made_replace(&t, "     0.0-180.0 160.0", "     0.0-180.0 180.0");
    assert_refused(&t, ORR_E_FORMAT, 25, "differ from the header");
    t = two_maps();
    made_replace(&t, "20.0 450.0", "20.0 350.0");
    assert_refused(&t, ORR_E_FORMAT, 22, "height 350.0");
    t = two_maps();
    made_replace(&t, "    10.0 -10.0 -10.0", "    10.0 -10.0  -7.0");
    assert_refused(&t, ORR_E_FORMAT, 0, "LAT1 / LAT2 / DLAT");
    t = two_maps();
    made_replace(&t, "LAT1 / LAT2 / DLAT", "LAT0 / LAT0 / DLAT");
    assert_refused(&t, ORR_E_FORMAT, 0, "no LAT1 / LAT2 / DLAT");
    t = two_maps();
    made_replace(&t, "  -180.0 160.0  20.0", "  -180.0 160.0   0.0");
    assert_refused(&t, ORR_E_FORMAT, 0, "LON1 / LON2 / DLON");
    t = two_maps();
    made_replace(&t, "     1                                                      END OF TEC MAP", "COMMENT");
    assert_refused(&t, ORR_E_FORMAT, 0, "is not ended");
    t = two_maps();
    made_replace(&t, "  2024     2     4     2     0     0                        EPOCH OF CURRENT",
                 "  2024     2    34     2     0     0                        EPOCH OF CURRENT");
    assert_refused(&t, ORR_E_FORMAT, 33, "no date");
}

// Lines that belong to nothing, between the maps and in them: told with their place, and the maps stand. So do cells
// below zero.
static void test_stray_lines_and_negatives(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d;
    orr_warnings w = {0};
    made_text t = two_maps();
    made_replace(
        &t, "     2                                                      START OF TEC MAP",
        "who wrote this?\n     2                                                      START OF TEC MAP");
    made_replace(&t, "     2                                                      END OF TEC MAP",
                 "and this?\n     2                                                      END OF TEC MAP");
    made_replace(&t, " 1003", "   -1");
    ASSERT_OK(parse(&t, &x, &w, &d), d);
    assert_int_equal(x.n_epochs, 2);
    assert_int_equal(w.count, 3);
    assert_int_equal(w.item[0].line, 32);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 0, 0, 0, 3)] == -0.1);
    assert_true(x.tec_tecu[orr_ionex_index(&x, 1, 0, 2, 17)] == cell(2, 2, 17) / 10.0);
    orr_ionex_free(&x);
    orr_warnings_free(&w);
}

// Cut after any byte, a file is either refused or has every map its header names.
static void test_cut_short(void **state)
{
    (void)state;
    made_text whole = two_maps();
    size_t accepted = 0;
    for (size_t n = 0; n < whole.n; n++) {
        orr_ionex x;
        orr_diag d = {0};
        if (orr_ionex_parse("cut", whole.s, n, NULL, &x, NULL, &d) == ORR_OK) {
            assert_int_equal(x.n_epochs, 2);
            assert_true(x.tec_tecu[orr_ionex_index(&x, 1, 0, 2, 17)] == cell(2, 2, 17) / 10.0);
            orr_ionex_free(&x);
            accepted++;
        } else {
            assert_true(d.text[0] != '\0');
        }
    }
    assert_true(accepted < 100); // only in the END OF FILE line itself and the label before it
    made_free(&whole);
}

static void test_limits(void **state)
{
    (void)state;
    orr_ionex x;
    orr_diag d = {0};
    made_text t = two_maps();
    orr_read_limits l = orr_read_default_limits();
    l.max_records = 1;
    assert_int_equal(orr_ionex_parse("made", t.s, t.n, &l, &x, NULL, &d), ORR_E_LIMIT);
    l = orr_read_default_limits();
    l.max_values = LATS * LONS - 1;
    assert_int_equal(orr_ionex_parse("made", t.s, t.n, &l, &x, NULL, &d), ORR_E_LIMIT);
    l.max_values = LATS * LONS;
    assert_int_equal(orr_ionex_parse("made", t.s, t.n, &l, &x, NULL, &d), ORR_E_LIMIT);
    // A header may promise what it likes: memory follows what is there.
    made_replace(&t, "     2                                                      # OF MAPS",
                 "999999                                                      # OF MAPS");
    assert_int_equal(orr_ionex_parse("made", t.s, t.n, NULL, &x, NULL, &d), ORR_OK);
    orr_ionex_free(&x);
    made_free(&t);
}

static void test_write_reads_back(void **state)
{
    (void)state;
    orr_ionex a, b;
    orr_diag d = {0};
    orr_warnings w = {0};
    const double lat[3] = {87.5, -87.5, -2.5}, lon[3] = {-180, 180, 5}, hgt[3] = {450e3, 450e3, 0};
    ASSERT_OK(orr_ionex_alloc(3, utc(0), 3600, lat, lon, hgt, true, &a, &d), d);
    assert_int_equal(a.n_lats, 71);
    assert_int_equal(a.n_lons, 73);
    size_t n = a.n_epochs * a.n_lats * a.n_lons;
    for (size_t i = 0; i < n; i++) {
        a.tec_tecu[i] = (double)((i * 7919) % 9000) / 10.0;
        a.rms_tecu[i] = (double)(i % 97) / 10.0;
    }
    a.tec_tecu[5] = ORR_NAN;
    a.dcb = calloc(2, sizeof *a.dcb);
    a.n_dcbs = 2;
    a.dcb[0] =
        (orr_ionex_dcb){.sat = orr_sat_make('G', 7), .system = 'G', .bias_s = 3.68e-9, .rms_s = 0.08e-9};
    a.dcb[1] =
        (orr_ionex_dcb){.system = 'E', .station = "BOR1 12205M002", .bias_s = -12.619e-9, .rms_s = 0.1e-9};
    char path[] = "ionex-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    ASSERT_OK(orr_ionex_write(&a, path, &d), d);
    ASSERT_OK(read_ionex(path, NULL, &b, &w, &d), d);
    assert_int_equal(w.count, 0);
    assert_int_equal(b.n_epochs, 3);
    for (size_t e = 0; e < 3; e++) assert_true(a.epoch[e] == b.epoch[e]);
    for (size_t i = 0; i < n; i++) {
        assert_true(a.rms_tecu[i] == b.rms_tecu[i]);
        if (i != 5) assert_true(a.tec_tecu[i] == b.tec_tecu[i]);
    }
    assert_true(isnan(b.tec_tecu[5]));
    assert_int_equal(b.n_dcbs, 2);
    assert_int_equal(b.dcb[0].sat, a.dcb[0].sat);
    ASSERT_NEAR(b.dcb[1].bias_s, a.dcb[1].bias_s, 1e-20);
    assert_string_equal(b.dcb[1].station, "BOR1 12205M002");
    orr_ionex_free(&b);

    // What does not fit is refused, and the sentence names the exponent that does.
    a.tec_tecu[9] = 12000; // 120000 tenths: six columns
    assert_int_equal(orr_ionex_write(&a, path, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "exponent 1 would do"));
    a.exponent = 1;
    ASSERT_OK(orr_ionex_write(&a, path, &d), d);
    a.exponent = -1;
    a.tec_tecu[9] = 999.9; // would read back as missing
    assert_int_equal(orr_ionex_write(&a, path, &d), ORR_E_RANGE);
    orr_ionex_free(&a);
    unlink(path);
    orr_warnings_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reads_everything),
        cmocka_unit_test(test_missing_and_five_digits),
        cmocka_unit_test(test_exponents),
        cmocka_unit_test(test_no_exponent_means_tenths),
        cmocka_unit_test(test_three_dimensional),
        cmocka_unit_test(test_epochs),
        cmocka_unit_test(test_tolerated),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_stray_lines_and_negatives),
        cmocka_unit_test(test_cut_short),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_write_reads_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
