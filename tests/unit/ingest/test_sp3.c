// SPDX-License-Identifier: GPL-3.0-or-later
// The SP3 reader, rule by rule, on made text. Numbers are chosen so that the expected value is plain.
#include "testing.h"

#include "ingest/sp3/sp3.h"
#include "sp3_text.h"

#define POS "  12345.678901 -20000.000001    100.500000"

static orr_sp3 sp3;
static orr_warnings warnings;
static orr_diag diag;

static orr_status parse(const sp3_text *t)
{
    orr_warnings_free(&warnings);
    warnings = (orr_warnings){0};
    diag = (orr_diag){0};
    return orr_sp3_parse("made", t->text, t->n, NULL, &sp3, &warnings, &diag);
}

static void done(sp3_text *t)
{
    orr_sp3_free(&sp3);
    orr_warnings_free(&warnings);
    warnings = (orr_warnings){0};
    free(t->text);
    *t = (sp3_text){0};
}

static bool warned(const char *words)
{
    for (size_t i = 0; i < warnings.kept; i++)
        if (strstr(warnings.item[i].text, words) != NULL) return true;
    return false;
}

static const orr_sp3_record *at(size_t epoch, size_t sat) { return &sp3.record[epoch * sp3.n_sats + sat]; }

// A time of day of 2024-02-04 (GPS week 2300, day 0) as GPS.
static orr_time gps(int hour, int minute, double second)
{
    return orr_time_from_week(2300, 0) + (hour * 3600 + minute * 60) * ORR_NS_PER_S +
           (int64_t)llround(second * 1e9);
}

static void test_plain(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#dP", "GPS", 2, "G05R24E01");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG05" POS "    123.456789 10 11 12 100 EP  MP\n");
    sp3_add(&t, "PR24      0.000000      0.000000      0.000000 999999.999999\n");
    sp3_add(&t, "PE01" POS "      0.000000 99    12 999\n");
    sp3_add_epoch_line(&t, 0, 15, 0);
    sp3_add(&t, "PG05" POS " 999999.99\nPR24" POS "\nPE01" POS "     -0.000001\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(warnings.count, 0);
    assert_int_equal(sp3.version, 'd');
    assert_false(sp3.has_velocity);
    assert_string_equal(sp3.agency, "TEST");
    assert_string_equal(sp3.data_used, "d+D");
    assert_string_equal(sp3.coordinates, "TEST");
    assert_string_equal(sp3.orbit_type, "FIT");
    assert_string_equal(sp3.file_type, "M");
    assert_int_equal(sp3.n_sats, 3);
    assert_int_equal(sp3.n_epochs, 2);
    assert_int_equal(sp3.n_comments, 4);
    assert_string_equal(sp3.comment[3], "COMMENT 3");
    assert_int_equal(sp3.accuracy_exp[1], 2);
    assert_true(sp3.epoch[0] == gps(0, 0, 0) && sp3.epoch[1] == gps(0, 15, 0));
    // Exactly the decimal numbers of the file, once rounded.
    assert_true(at(0, 0)->pos_m[0] == 12345678.901 && at(0, 0)->pos_m[1] == -20000000.001);
    assert_true(at(0, 0)->pos_m[2] == 100500.0 && at(0, 0)->clock_s == 123.456789e-6);
    ASSERT_NEAR(at(0, 0)->pos_sdev_m[0], pow(1.25, 10) * 1e-3, 1e-9); // float's rounding of 9.3 mm is 1e-9 m
    ASSERT_NEAR(at(0, 0)->clock_sdev_s, pow(1.025, 100) * 1e-12, 1e-18);
    assert_int_equal(at(0, 0)->flags, ORR_SP3_CLOCK_EVENT | ORR_SP3_CLOCK_PREDICTED | ORR_SP3_MANOEUVRE |
                                          ORR_SP3_ORBIT_PREDICTED);
    assert_true(isnan(at(0, 1)->pos_m[0]) && isnan(at(0, 1)->pos_m[2]) && isnan(at(0, 1)->clock_s));
    assert_true(at(0, 2)->clock_s == 0);         // a zero beside a position is a value
    assert_true(isinf(at(0, 2)->pos_sdev_m[0])); // 99: too large to be written
    assert_true(isnan(at(0, 2)->pos_sdev_m[1])); // blank: unknown
    assert_true(isinf(at(0, 2)->clock_sdev_s));
    assert_true(isnan(at(1, 0)->clock_s)); // fractional nines are optional
    assert_true(isnan(at(1, 1)->clock_s)); // no clock at all
    assert_true(at(1, 2)->clock_s == -1e-12);
    assert_true(isnan(at(1, 2)->vel_mps[0]));
    assert_int_equal(sp3.n_records[1], 2);
    assert_null(sp3.correlation);
    done(&t);
}

static void test_velocity_and_correlations(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cV", "GPS", 1, "G05G06");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG05" POS "      1.000000 18 18 18 219\n");
    sp3_add(&t, "EP    55  222 9999      90  1234567 -5000000        1 10000000               0\n");
    sp3_add(&t, "VG05  20298.880364 -18462.044804      0.000001     -4.534317 14 14 14 191\n");
    sp3_add(&t, "EV    22   22   22     111  1234567  1234567  1234567  1234567  1234567  1234567\n");
    sp3_add(&t, "PG06" POS "      1.000000\n");
    sp3_add(&t, "VG06      0.000000      0.000000      0.000000 999999.999999\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(warnings.count, 0);
    assert_true(sp3.has_velocity);
    assert_true(at(0, 0)->vel_mps[0] == 2029.8880364 && at(0, 0)->vel_mps[2] == 1e-7);
    assert_true(at(0, 0)->clock_rate_sps == -4.534317e-10);
    // EP is finer than the exponents and rules; 9999 is too large to be written.
    ASSERT_NEAR(at(0, 0)->pos_sdev_m[0], 0.055, 1e-8);
    assert_true(isinf(at(0, 0)->pos_sdev_m[2]));
    ASSERT_NEAR(at(0, 0)->clock_sdev_s, 90e-12, 1e-17);
    ASSERT_NEAR(at(0, 0)->vel_sdev_mps[0], 22e-7, 1e-12);
    ASSERT_NEAR(at(0, 0)->clock_rate_sdev_sps, 111e-16, 1e-20);
    assert_non_null(sp3.correlation);
    ASSERT_NEAR(sp3.correlation[0].p[0], 0.1234567, 1e-8);
    ASSERT_NEAR(sp3.correlation[0].p[1], -0.5, 0);
    ASSERT_NEAR(sp3.correlation[0].p[3], 1, 0);
    assert_true(isnan(sp3.correlation[0].p[4]) && sp3.correlation[0].p[5] == 0);
    ASSERT_NEAR(sp3.correlation[0].v[5], 0.1234567, 1e-8);
    assert_true(isnan(sp3.correlation[1].p[0]));
    assert_true(isnan(at(0, 1)->vel_mps[0]) && isnan(at(0, 1)->clock_rate_sps));
    done(&t);
}

// Labels of every time system come out as GPS time: UTC and GLONASS 18 s later in 2024, TAI 19 s earlier,
// BeiDou 14 s later, the rest as they are.
static void test_time_systems(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int shift_s;
    } scales[] = {{"GPS", 0},  {"GAL", 0},  {"QZS", 0},   {"IRN", 0}, {"GLO", 18},
                  {"UTC", 18}, {"BDT", 14}, {"TAI", -19}, {"ccc", 0}};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        sp3_text t = {0};
        sp3_add_header(&t, "#dP", scales[i].name, 1, "G01");
        sp3_add_epoch_line(&t, 0, 0, 0);
        sp3_add(&t, "PG01" POS "      1.000000\nEOF\n");
        ASSERT_OK(parse(&t), diag);
        assert_true(sp3.epoch[0] == gps(0, 0, scales[i].shift_s));
        assert_int_equal(warnings.count, strcmp(scales[i].name, "ccc") == 0); // nobody told: a warning
        done(&t);
    }
    sp3_text t = {0};
    sp3_add_header(&t, "#dP", "XYZ", 1, "G01");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01" POS "      1.000000\nEOF\n");
    assert_int_equal(parse(&t), ORR_E_FORMAT);
    assert_non_null(strstr(diag.text, "XYZ"));
    assert_int_equal(diag.column, 10);
    done(&t);
    // A leap second has its own epoch.
    sp3_add_header(&t, "#cP", "UTC", 1, "G01");
    sp3_add(&t, "*  2016 12 31 23 59 60.50000000\nPG01" POS "      1.000000\n");
    sp3_add(&t, "*  2017  1  1  0  0  0.00000000\nPG01" POS "      1.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_true(sp3.epoch[1] - sp3.epoch[0] == ORR_NS_PER_S / 2);
    done(&t);
}

static void test_version_a(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#aP", "ccc", 1, "  1 31");
    sp3_add_epoch_line(&t, 24, 0, 0);
    sp3_add(&t,
            "P  1" POS "      1.000000\nP 31      0.000000      0.000000      0.000000      0.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.sat[0], orr_sat_make('G', 1));
    assert_int_equal(sp3.sat[1], orr_sat_make('G', 31));
    assert_true(sp3.epoch[0] == gps(24, 0, 0)); // 24:00 is the next day's 00:00
    assert_true(isnan(at(0, 1)->clock_s));      // all zeros: not there
    assert_true(warned("the header says the start is"));
    assert_int_equal(warnings.count, 1);
    done(&t);
}

static void test_many_satellites_and_comments(void **state)
{
    (void)state;
    sp3_text t = {0};
    char sats[3 * 150 + 1], *s = sats;
    for (int i = 0; i < 150; i++) s += sprintf(s, "%c%02d", "GREC"[i / 40], 1 + i % 40);
    sp3_add_header(&t, "#dP", "GPS", 1, sats);
    for (int i = 0; i < 500; i++) sp3_add(&t, "/* line %d with \xc3\xa9\n", i);
    sp3_add(&t, "/*\n/*no blank\n/* %076d\n/* %077d\n/* %078d\n", 1, 2, 3);
    sp3_add_epoch_line(&t, 0, 0, 0);
    for (int i = 0; i < 150; i++)
        sp3_add(&t, "P%.3s%14.6f%14.6f%14.6f%14.6f\n", sats + 3 * i, 10000.0 + i, 2e4, 0.0, 1.0);
    sp3_add(&t, "EOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_sats, 150);
    assert_int_equal(sp3.sat[149], orr_sat_make('C', 30));
    assert_true(at(0, 149)->pos_m[0] == 10149e3);
    assert_int_equal(sp3.accuracy_exp[149], 1 + 149 % 9);
    assert_int_equal(sp3.n_comments, 509);
    assert_string_equal(sp3.comment[4 + 499], "line 499 with \xc3\xa9");
    assert_string_equal(sp3.comment[504], "");
    assert_string_equal(sp3.comment[505], "no blank");
    assert_int_equal(strlen(sp3.comment[508]), 78);
    assert_int_equal(warnings.count, 1); // the one of 81 columns
    assert_true(warned("column 80"));
    done(&t);
}

// Records rule over what the header says of them.
static void test_header_lies(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cP", "GPS", 96, "G01G02");
    char *count = strstr(t.text, "\n+    2") + 6;
    *count = '8';
    sp3_add(&t, "*  2024  2  4  0 10  0.00000000\nPG01" POS "\nPG09" POS "\n");
    sp3_add(&t, "*  2024  2  4  0 15  0.00000000\nPG01" POS "\nPG09" POS "\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 2);
    assert_int_equal(sp3.n_sats, 3);
    assert_int_equal(sp3.sat[2], orr_sat_make('G', 9));
    assert_true(at(1, 2)->pos_m[0] == 12345678.901);
    assert_int_equal(sp3.n_records[1], 0);
    assert_true(warned("96 epochs, found 2") && warned("says 8 satellites and lists 2"));
    assert_true(warned("does not list") && warned("no position record") && warned("the start is"));
    assert_true(warned("smallest step 300 s"));
    done(&t);
}

static void test_order(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cP", "GPS", 4, "G01G02");
    sp3_add_epoch_line(&t, 0, 30, 0);
    sp3_add(&t, "PG01" POS "      3.000000\n");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01" POS "      1.000000\n");
    sp3_add_epoch_line(&t, 0, 15, 0);
    sp3_add(&t, "PG01" POS "      2.000000\n");
    sp3_add_epoch_line(&t, 0, 30, 0); // again, with another value for G01 and a first one for G02
    sp3_add(&t, "PG01" POS "      9.000000\nPG02" POS "      4.000000\nPG02" POS "      5.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 3);
    for (int e = 0; e < 3; e++) {
        assert_true(sp3.epoch[e] == gps(0, 15 * e, 0));
        ASSERT_NEAR(at((size_t)e, 0)->clock_s, (e + 1) * 1e-6, 1e-20);
    }
    ASSERT_NEAR(at(2, 1)->clock_s, 4e-6, 1e-20);
    assert_int_equal(sp3.n_records[0], 3);
    assert_true(warned("not in order") && warned("more than once") && warned("second records"));
    done(&t);
}

static void test_damaged_records(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cP", "GPS", 3, "G01G02G03G04");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01" POS "      1.000000\n");
    sp3_add(&t, "PG02  12345.67x901 -20000.000001    100.500000      1.000000\n"); // line 25
    sp3_add(&t, "PG03  12345.678901 -20000.000001\n");
    sp3_add(&t, "P?04" POS "\n");
    sp3_add(&t, "EP    55   55   55      90\n"); // of no record
    sp3_add_epoch_line(&t, 0, 15, 0);
    for (int i = 1; i <= 4; i++) sp3_add(&t, "PG%02d" POS "      1.000000 xx 18 18 219 Q\n", i);
    sp3_add(&t, "*  2024  2 30  0 30  0.00000000\n"); // no date: its records have no place
    for (int i = 1; i <= 4; i++) sp3_add(&t, "PG%02d" POS "      7.000000\n", i);
    sp3_add(&t, "EOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 2);
    assert_true(isnan(at(0, 1)->pos_m[0]) && isnan(at(0, 2)->pos_m[0]) && isnan(at(0, 3)->pos_m[0]));
    assert_true(at(1, 3)->pos_m[0] == 12345678.901 && isnan(at(1, 3)->pos_sdev_m[0]));
    assert_int_equal(warnings.item[0].line, 25);
    assert_int_equal(warnings.item[0].column, 5);
    assert_true(warned("coordinate cannot be read") && warned("coordinate is missing") &&
                warned("satellite of this"));
    assert_true(warned("EP or EV") && warned("no flag") && warned("no date and time") &&
                warned("epoch is not known"));
    assert_true(warned("standard deviations or correlations that cannot"));
    done(&t);

    // An epoch line that is spoilt must not give its records to the epoch before.
    sp3_add_header(&t, "#cP", "GPS", 2, "G01G02");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01" POS "      1.000000\n");
    sp3_add(&t,
            "?  2024  2  4  0 15  0.00000000\nPG01" POS "      2.000000\nPG02" POS "      2.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 1);
    assert_true(isnan(at(0, 1)->pos_m[0]));
    ASSERT_NEAR(at(0, 0)->clock_s, 1e-6, 1e-20);
    assert_true(warned("begins like none"));
    done(&t);

    // More damaged than sound: refused at the first.
    sp3_add_header(&t, "#cP", "GPS", 1, "G01G02G03");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01" POS "      1.000000\nPG02  rubbish\nPG03  rubbish\nEOF\n");
    assert_int_equal(parse(&t), ORR_E_FORMAT);
    assert_int_equal(diag.line, 25);
    done(&t);
}

// Cut at every byte: never a record that differs from the whole file's, never silence.
static void test_cut(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cP", "GPS", 2, "G01G02");
    for (int e = 0; e < 2; e++) {
        sp3_add_epoch_line(&t, 0, 15 * e, 0);
        sp3_add(&t,
                "PG01" POS "    123.456789 10 11 12 100 EP  MP\nPG02" POS "    -23.456789 18 18 18 219\n");
    }
    sp3_add(&t, "EOF\n");
    orr_sp3 whole;
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(warnings.count, 0);
    whole = sp3;
    sp3 = (orr_sp3){0};
    size_t n = t.n;
    for (size_t cut = 0; cut < n - 1; cut++) {
        char *part = malloc(cut + 1); // exactly so long, so that a sanitizer sees reading beyond
        memcpy(part, t.text, cut);
        sp3_text p = {.text = part, .n = cut};
        orr_status st = parse(&p);
        if (st == ORR_OK) {
            if (cut < n - 1) assert_true(cut + 1 >= n || warnings.count > 0);
            for (size_t e = 0; e < sp3.n_epochs; e++)
                for (size_t s = 0; s < sp3.n_sats; s++) {
                    const orr_sp3_record *a = at(e, s), *b = &whole.record[e * 2 + s];
                    if (isnan(a->pos_m[0])) continue;
                    assert_true(a->pos_m[0] == b->pos_m[0] && a->clock_s == b->clock_s &&
                                a->flags == b->flags);
                }
        } else {
            assert_true(strlen(diag.text) > 0);
        }
        orr_sp3_free(&sp3);
        free(part);
    }
    orr_sp3_free(&whole);
    done(&t);
}

static void test_oddities_of_text(void **state)
{
    (void)state;
    // CR LF, a BOM, no newline behind EOF, blank lines, comments among the records, ^Z.
    sp3_text t = {0}, crlf = {0};
    sp3_add_header(&t, "#cP", "GPS", 1, "G01");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "\n/* LATE\nPG01" POS "      1.000000      \t \nEOF");
    sp3_add(&crlf, "\xef\xbb\xbf");
    for (size_t i = 0; i < t.n; i++) sp3_add(&crlf, t.text[i] == '\n' ? "\r\n" : "%c", t.text[i]);
    ASSERT_OK(parse(&crlf), diag);
    assert_int_equal(sp3.n_comments, 5);
    assert_true(at(0, 0)->pos_m[0] == 12345678.901);
    assert_int_equal(warnings.count, 1); // the blank line
    orr_sp3_free(&sp3);
    sp3_add(&crlf, "\r\n\x1a");
    ASSERT_OK(parse(&crlf), diag);
    assert_int_equal(warnings.count, 1);
    orr_sp3_free(&sp3);
    sp3_add(&crlf, "\r\nmore");
    ASSERT_OK(parse(&crlf), diag);
    assert_true(warned("after EOF"));
    done(&crlf);
    // A second file behind the first is not lost silently, with EOF between and without.
    sp3_text two = {0};
    sp3_append(&two, t.text, t.n);
    sp3_add(&two, "\n");
    sp3_add_header(&two, "#cP", "GPS", 1, "G01");
    assert_int_equal(parse(&two), ORR_E_FORMAT);
    assert_non_null(strstr(diag.text, "two files"));
    done(&two);
    done(&t);
    // Numbers that are not in their usual place in the field, and without decimals.
    sp3_add_header(&t, "#cP", "GPS", 1, "G01");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG01 12345.6789        -20000        .5           1.5         \nEOF\n");
    ASSERT_OK(parse(&t), diag);
    ASSERT_NEAR(at(0, 0)->pos_m[0], 12345678.9, 0);
    ASSERT_NEAR(at(0, 0)->pos_m[1], -2e7, 0);
    ASSERT_NEAR(at(0, 0)->pos_m[2], 500, 0);
    ASSERT_NEAR(at(0, 0)->clock_s, 1.5e-6, 0);
    done(&t);
}

// A constellation that has no letter here yet is left out, and said so; the rest of the file is as good as
// ever.
static void test_shifted_columns(void **state)
{
    (void)state;
    // A lost digit or blank moves the rest of the line: half a number must not be taken for a whole one.
    static const struct {
        const char *line; // where "PG01  12345.678901 -20000.000001    100.500000      1.000000" would stand
        const char *words;
        bool read;
    } cases[] = {
        {"PG01  1234.678901 -20000.000001    100.500000      1.000000", "not in their columns", false},
        {"PG01  12345.67890 -20000.000001    100.500000      1.000000", "not in their columns", false},
        {"PG01   12345.678901 -20000.000001    100.500000      1.000000", "cannot be read", false},
        {"PG01  12345.678901 -20000.000001    100.500000      1.00000", "not in their columns", false},
        {"PG01  12345.678901 -20000.000001    100.500000      1.000000 1  18 18 219", "between the fields",
         true},
        {"PG01  12345.678901 -20000.000001    100.500000      1.000000 18 18 18219", "between the fields",
         true},
        {"PG01  12345.678901 -20000.000001    100.500000      1.000000 18 18 18 219EP", "between the fields",
         true},
        {"PG01  12345.678901 -20000.000001    100.500000      1.000000 18 18 18 219    M",
         "between the fields", true},
        {"PG01  12345.678901 -20000.000001    100.500000    21.999E99", "clock cannot be read", false},
        {"PG01  12345.678901 -20000.000001    100.500000 9999999.999999", "clock cannot be read", false},
        {"PG01      0.00000       0.000000      0.000000 999999.", "", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        sp3_text t = {0};
        sp3_add_header(&t, "#dP", "GPS", 2, "G01");
        sp3_add_epoch_line(&t, 0, 0, 0);
        sp3_add(&t, "PG01" POS "      1.000000\n");
        sp3_add_epoch_line(&t, 0, 15, 0);
        sp3_add(&t, "%s\nEOF\n", cases[i].line);
        ASSERT_OK(parse(&t), diag);
        bool read = !isnan(at(1, 0)->pos_m[0]);
        bool told = cases[i].words[0] == '\0' ? warnings.count == 0 : warned(cases[i].words);
        if (read != cases[i].read || !told) fail_msg("%s: %s", cases[i].line, read ? "read" : "left out");
        done(&t);
    }
    // A line that is lost altogether.
    sp3_text hole = {0};
    sp3_add_header(&hole, "#dV", "GPS", 2, "G01");
    sp3_add_epoch_line(&hole, 0, 0, 0);
    sp3_add(&hole, "PG01" POS "\n");
    sp3_add_epoch_line(&hole, 0, 15, 0);
    sp3_add(&hole, "VG01" POS "\nEOF\n");
    ASSERT_OK(parse(&hole), diag);
    assert_true(warned("1 records are not there") && warned("1 positions have no velocity"));
    done(&hole);
    // The same in an epoch line: 12 must not become 2.
    sp3_text t = {0};
    sp3_add_header(&t, "#dP", "GPS", 2, "G01");
    sp3_add(&t, "*  2024 12 10 12 30  0.00000000\nPG01" POS "\n*  2024 2 10 12 45  0.00000000\nPG01" POS
                "\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 1);
    assert_true(warned("no date and time"));
    done(&t);
}

// Epoch lines a column to the left of their place, in the whole file or in one line that is the epoch that is due;
// day 0 of a month is the last of the month before. A date that is another epoch than the one due stays refused.
static void test_shifted_epochs(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#cP", "GPS", 3, "G05");
    sp3_add(&t, "* 2024  1 31 23 45  0.00000000\nPG05" POS "      1.000000\n");
    sp3_add(&t, "* 2024  2  0 23 59 59.00000000\nPG05" POS "      2.000000\n");
    sp3_add(&t, "* 2024  2  1  0  0  0.00000000\nPG05" POS "      3.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 3);
    assert_true(sp3.epoch[0] == gps(-4 * 24 + 23, 45, 0)); // 31 January is four days before 4 February
    assert_true(sp3.epoch[1] == gps(-4 * 24 + 23, 59, 59));
    assert_true(sp3.epoch[2] == gps(-3 * 24, 0, 0));
    assert_true(warned("a column off") && warned("day 0"));
    done(&t);

    sp3_add_header(&t, "#cP", "GPS", 3, "G05");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PG05" POS "      1.000000\n* 2024  2  4  0 15  0.00000000\nPG05" POS "      2.000000\n");
    sp3_add(&t, "* 2024  2  4  0 16  0.00000000\nPG05" POS "      2.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_epochs, 2);
    assert_true(warned("no date and time"));
    done(&t);
}

// The first line as it was before versions had letters.
static void test_no_version_letter(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#  ", "ccc", 1, " 05");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "P  5" POS "    123.456789\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.version, 'a');
    assert_false(sp3.has_velocity);
    assert_int_equal(sp3.sat[0], orr_sat_make('G', 5));
    assert_true(at(0, 0)->clock_s == 123.456789e-6);
    assert_true(warned("no version letter"));
    done(&t);
    sp3_add(&t, "# a comment of some table\n1 2 3\n");
    assert_int_equal(parse(&t), ORR_E_KIND);
    done(&t);
}

static void test_unknown_system(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#dP", "GPS", 1, "X01G07");
    sp3_add_epoch_line(&t, 0, 0, 0);
    sp3_add(&t, "PX01" POS "      1.000000\nPX02" POS "      1.000000\nPG07" POS "      2.000000\nEOF\n");
    ASSERT_OK(parse(&t), diag);
    assert_int_equal(sp3.n_sats, 1);
    assert_int_equal(sp3.sat[0], orr_sat_make('G', 7));
    assert_int_equal(sp3.accuracy_exp[0], 2); // the second place of the list
    ASSERT_NEAR(at(0, 0)->clock_s, 2e-6, 0);
    assert_int_equal(warnings.count, 2);
    assert_true(warned("X01") && warned("2 in all"));
    done(&t);
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        orr_status status;
    } cases[] = {
        {"", ORR_E_KIND},
        {"\n\n", ORR_E_KIND},
        {"     3.05           NAVIGATION DATA     M\n", ORR_E_KIND},
        {"#eP2024  2  4  0  0  0.00000000\n", ORR_E_UNSUPPORTED},
        {"#dX2024  2  4  0  0  0.00000000\n", ORR_E_KIND},
        {"#dP2024  2  4  0  0  0.00000000       1 ORBIT IGS20 FIT TEST\n", ORR_E_FORMAT},
        {"#dP2024  2  4  0  0  0.00000000       1 ORBIT IGS20 FIT TEST\nEOF\n", ORR_E_FORMAT},
        {"#dP2024  2  4  0  0  0.00000000       1 ORBIT IGS20 FIT TEST\n*  2024  2  4  0  0  0.0\nEOF\n",
         ORR_E_FORMAT},
        {"#dP2024  2  4  0  0  0.00000000       1 ORBIT IGS20 FIT TEST\n+    1   Q?1\n", ORR_E_FORMAT},
        {"#dP2024  2  4  0  0  0.00000000       1 ORBIT IGS20 FIT TEST\n@@ what is this\n", ORR_E_FORMAT},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        sp3_text t = {0};
        sp3_add(&t, "%s", cases[i].text);
        orr_status st = parse(&t);
        if (st != cases[i].status) fail_msg("case %zu: %s: %s", i, orr_status_name(st), diag.text);
        assert_true(strlen(diag.text) > 0);
        assert_null(sp3.record);
        done(&t);
    }
}

static void test_limits(void **state)
{
    (void)state;
    sp3_text t = {0};
    sp3_add_header(&t, "#dP", "GPS", 3, "G01G02G03");
    for (int e = 0; e < 3; e++) {
        sp3_add_epoch_line(&t, 0, 15 * e, 0);
        for (int s = 1; s < 4; s++) sp3_add(&t, "PG%02d" POS "      1.000000\n", s);
    }
    sp3_add(&t, "EOF\n");
    const orr_sp3_limits most = orr_sp3_default_limits();
    orr_sp3_limits l[4] = {most, most, most, most};
    l[0].max_bytes = t.n - 1;
    l[1].max_sats = 2;
    l[2].max_epochs = 2;
    l[3].max_comments = 3;
    for (int i = 0; i < 4; i++) {
        diag = (orr_diag){0};
        assert_int_equal(orr_sp3_parse("made", t.text, t.n, &l[i], &sp3, NULL, &diag), ORR_E_LIMIT);
        assert_true(strlen(diag.text) > 0);
    }
    done(&t);
    // Hundreds of satellites over epoch lines without records must not become gigabytes.
    char sats[3 * 700 + 1], *s = sats;
    for (int i = 0; i < 700; i++) s += sprintf(s, "%c%02d", "GRECJISL"[i / 99], 1 + i % 99);
    sp3_add_header(&t, "#dP", "GPS", 1, sats);
    for (int i = 0; i < 20000; i++) sp3_add_epoch_line(&t, i / 3600, i / 60 % 60, i % 60);
    assert_int_equal(parse(&t), ORR_E_LIMIT);
    done(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_plain),
        cmocka_unit_test(test_velocity_and_correlations),
        cmocka_unit_test(test_time_systems),
        cmocka_unit_test(test_version_a),
        cmocka_unit_test(test_many_satellites_and_comments),
        cmocka_unit_test(test_header_lies),
        cmocka_unit_test(test_order),
        cmocka_unit_test(test_damaged_records),
        cmocka_unit_test(test_cut),
        cmocka_unit_test(test_oddities_of_text),
        cmocka_unit_test(test_shifted_columns),
        cmocka_unit_test(test_shifted_epochs),
        cmocka_unit_test(test_no_version_letter),
        cmocka_unit_test(test_unknown_system),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
