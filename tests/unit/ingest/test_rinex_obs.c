// SPDX-License-Identifier: GPL-3.0-or-later
// Observation files made line by line: columns, flags, events, continuation lines, damage; and the writer.
#include "testing.h"

#include <unistd.h>

#include "core/nan.h"
#include "ingest/rinex/rinex_obs.h"
#include "rinex_text.h"

static orr_rinex_obs *open_text(const text *t, orr_warnings *w)
{
    orr_rinex_obs *r = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_open_memory("made.obs", t->p, t->n, NULL, w, &r, &diag), diag);
    return r;
}

static const orr_rinex_obs_epoch *next(orr_rinex_obs *r)
{
    const orr_rinex_obs_epoch *e = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_next(r, &e, &diag), diag);
    return e;
}

static orr_time at(int y, int mo, int d, int h, int mi, int s, orr_scale scale)
{
    orr_civil c = {y, mo, d, h, mi, s, 0};
    orr_time t = 0;
    assert_int_equal(orr_time_from_civil(&c, scale, NULL, &t), ORR_OK);
    return t;
}

static void header_v3(text *t, const char *version, const char *scale)
{
    char first[64];
    snprintf(first, sizeof first, "%9s           OBSERVATION DATA    M: MIXED", version);
    text_header(t, first, "RINEX VERSION / TYPE");
    text_header(t, "MADE", "MARKER NAME");
    text_header(t, "G    3 C1C L1C D1C", "SYS / # / OBS TYPES");
    text_header(t, "R    2 C1C L1C", "SYS / # / OBS TYPES");
    snprintf(first, sizeof first, "  2024    02    04    00    00    0.0000000     %s", scale);
    text_header(t, first, "TIME OF FIRST OBS");
    text_header(t, "", "END OF HEADER");
}

static void version_3(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "3.05", "GPS");
    text_add(&t, "> 2024 02 04 00 00  0.0000000  0  2      -0.000123456789\n");
    text_add(&t, "G05  20123456.789 8 105750123.45617     -1234.567\n");
    text_add(&t, "R12                 -99999999.99939\n");
    text_add(&t, "> 2024 02 04 00 00 59.9999999  1  0\n");
    text_add(&t, "> 2024 02 04 00 00 60.0000000  0  1\r\n");
    text_add(&t, "G 5          .123\r\n"); // a blank in the number, no digit before the point, CR LF
    orr_rinex_obs *r = open_text(&t, &w);
    const orr_rinex_obs_epoch *e = next(r);
    assert_true(e->t == at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GPS));
    assert_int_equal(e->n_sats, 2);
    ASSERT_NEAR(e->clock_offset_s, -0.000123456789, 0);
    assert_int_equal(e->sat[0], orr_sat_make('G', 5));
    ASSERT_NEAR(e->value[0], 20123456.789, 0);
    assert_int_equal(e->lli[0], 0);
    assert_int_equal(e->ssi[0], 8);
    ASSERT_NEAR(e->value[1], 105750123.456, 0);
    assert_int_equal(e->lli[1], 1);
    assert_int_equal(e->ssi[1], 7);
    ASSERT_NEAR(e->value[2], -1234.567, 0);
    assert_true(isnan(e->value[e->stride]));
    ASSERT_NEAR(e->value[e->stride + 1], -99999999.999, 0);
    assert_int_equal(e->lli[e->stride + 1], 3); // slip and half cycle
    assert_true(e->lli[e->stride + 1] & ORR_OBS_LLI_HALF_CYCLE);
    e = next(r);
    assert_int_equal(e->flag, ORR_OBS_POWER_FAILURE);
    assert_true(e->t == at(2024, 2, 4, 0, 1, 0, ORR_SCALE_GPS) - 100);
    assert_true(isnan(e->clock_offset_s));
    e = next(r);
    assert_true(e->t == at(2024, 2, 4, 0, 1, 0, ORR_SCALE_GPS));
    ASSERT_NEAR(e->value[0], 0.123, 0);
    assert_null(next(r));
    assert_int_equal(w.count, 0);
    orr_rinex_obs_close(r);
    text_free(&t);
}

static void time_systems_and_leap_second(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int shift_s;
    } scales[] = {{"GPS", 0}, {"GLO", 18}, {"GAL", 0}, {"BDT", 14}, {"QZS", 0}, {"IRN", 0}, {"   ", 0}};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        text t = {0};
        header_v3(&t, "3.04", scales[i].name);
        text_add(&t, "> 2024 02 04 00 00  0.0000000  0  0\n");
        orr_rinex_obs *r = open_text(&t, NULL);
        assert_true(next(r)->t == at(2024, 2, 4, 0, 0, scales[i].shift_s, ORR_SCALE_GPS));
        assert_true(orr_rinex_obs_header_of(r)->first ==
                    at(2024, 2, 4, 0, 0, scales[i].shift_s, ORR_SCALE_GPS));
        orr_rinex_obs_close(r);
        text_free(&t);
    }
    text t = {0};
    header_v3(&t, "3.04", "GLO");
    text_add(&t, "> 2016 12 31 23 59 60.0000000  0  0\n> 2017 01 01 00 00  0.0000000  0  0\n");
    orr_rinex_obs *r = open_text(&t, NULL);
    orr_time a = next(r)->t, b = next(r)->t;
    assert_true(b - a == ORR_NS_PER_S);
    orr_rinex_obs_close(r);
    text_free(&t);
    // Picoseconds of 4.02: five more digits of the seconds, to the nearest nanosecond.
    header_v3(&t, "4.02", "GPS");
    text_add(&t, "> 2024 02 04 00 00  1.0000001  0  0       0.000000000000 23500\n");
    r = open_text(&t, NULL);
    assert_true(next(r)->t == at(2024, 2, 4, 0, 0, 1, ORR_SCALE_GPS) + 124);
    orr_rinex_obs_close(r);
    text_free(&t);
}

static void version_2(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    text_header(&t, "     2.11           OBSERVATION DATA    M (MIXED)", "RINEX VERSION / TYPE");
    text_header(&t, "MADE", "MARKER NAME");
    text_header(&t, "     1     1", "WAVELENGTH FACT L1/2");
    text_header(&t, "     1     2     2   G 9   G12", "WAVELENGTH FACT L1/2");
    text_header(&t, "    11    C1    P1    P2    L1    L2    D1    D2    S1    S2", "# / TYPES OF OBSERV");
    text_header(&t, "          C5    L5", "# / TYPES OF OBSERV");
    text_header(&t, "  2008    10     5     0     0    0.0000000     GPS", "TIME OF FIRST OBS");
    text_header(&t, "", "END OF HEADER");
    text_add(&t, " 08 10  5  0  0 30.0000000  0 14");
    for (int i = 1; i <= 12; i++) text_add(&t, "G%2d", i);
    text_add(&t, "-0.123456789\n%32sR03E11\n", "");
    for (int i = 1; i <= 14; i++) {
        for (int j = 0; j < 11; j++)
            text_add(&t, "%14.3f%c%c%s", 1e7 + 1000.0 * i + j, j == 3 ? '1' : ' ', j == 4 ? '9' : ' ',
                     j % 5 == 4 || j == 10 ? "\n" : "");
    }
    text_add(&t, "%28s4  3\n", ""); // an event without a time
    text_header(&t, "     1    C1", "# / TYPES OF OBSERV");
    text_header(&t, "OTHER", "MARKER NAME");
    text_header(&t, "a comment", "COMMENT");
    text_add(&t, " 08 10  5  0  1  0.0000000  0  1 23\n"); // a blank letter is GPS
    text_add(&t, "  20000000.125\n");
    orr_rinex_obs *r = open_text(&t, &w);
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
    assert_int_equal(h->codes[0].n, 11);
    static const char gps[11][4] = {"C1C", "C1W", "C2W", "L1C", "L2W", "D1C",
                                    "D2W", "S1C", "S2W", "C5X", "L5X"};
    for (size_t j = 0; j < 11; j++) assert_string_equal(h->codes[0].code[j], gps[j]);
    assert_string_equal(h->codes[0].original[2], "P2");
    assert_int_equal(orr_obs_code_index(h, 'R', "C2P"), 2);
    assert_int_equal(orr_obs_code_index(h, 'R', "L2P"), 4);
    assert_int_equal(orr_obs_code_index(h, 'E', "C1X"), 0);
    assert_int_equal(h->sat_wavelength[0][12].l2, 2);
    assert_int_equal(h->sat_wavelength[0][10].l2, 0); // the file's default holds
    const orr_rinex_obs_epoch *e = next(r);
    assert_int_equal(e->n_sats, 14);
    assert_int_equal(e->sat[12], orr_sat_make('R', 3));
    assert_int_equal(e->sat[13], orr_sat_make('E', 11));
    ASSERT_NEAR(e->clock_offset_s, -0.123456789, 0);
    for (size_t i = 0; i < 14; i++)
        for (size_t j = 0; j < 11; j++) {
            ASSERT_NEAR(e->value[i * e->stride + j], 1e7 + 1000.0 * (double)(i + 1) + (double)j, 0);
            assert_int_equal(e->lli[i * e->stride + j], j == 3);
            assert_int_equal(e->ssi[i * e->stride + j], j == 4 ? 9 : 0);
        }
    e = next(r);
    assert_int_equal(e->flag, ORR_OBS_HEADER);
    assert_true(e->t == ORR_TIME_NONE && e->header_changed);
    assert_int_equal(e->n_event_lines, 3);
    assert_string_equal(h->marker_name, "OTHER");
    assert_int_equal(h->codes[0].n, 1);
    e = next(r);
    assert_int_equal(e->sat[0], orr_sat_make('G', 23));
    ASSERT_NEAR(e->value[0], 20000000.125, 0);
    assert_null(next(r));
    assert_int_equal(w.count, 0);
    orr_rinex_obs_close(r);
    text_free(&t);
}

// RINEX 2.20: a factor of all types, then another of some, with a line that goes on; a type that is not there is refused.
static void scale_factors_of_version_2(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    text_header(&t, "     2.20           OBSERVATION DATA    G", "RINEX VERSION / TYPE");
    text_header(&t, "MADE", "MARKER NAME");
    text_header(&t, "     5    L1    L2    C1    P2    LA", "# / TYPES OF OBSERV");
    text_header(&t, "    10", "OBS SCALE FACTOR");
    text_header(&t, "  1000     2    C1", "OBS SCALE FACTOR");
    text_header(&t, "                P2", "OBS SCALE FACTOR");
    text_header(&t, "  2002     3    24     0     0    0.0000000     GPS", "TIME OF FIRST OBS");
    text_header(&t, "", "END OF HEADER");
    text_add(&t, " 02  3 24  0  0  0.0000000  0  1G05\n");
    for (int i = 0; i < 5; i++) text_add(&t, "%14.3f  ", 5000.0 + i);
    text_add(&t, "\n");
    orr_rinex_obs *r = open_text(&t, &w);
    const orr_rinex_obs_epoch *e = NULL;
    orr_diag d;
    ASSERT_OK(orr_rinex_obs_next(r, &e, &d), d);
    assert_non_null(e);
    assert_int_equal(w.count, 0);
    ASSERT_NEAR(e->value[0], 500.0, 1e-12);
    ASSERT_NEAR(e->value[1], 500.1, 1e-12);
    ASSERT_NEAR(e->value[2], 5.002, 1e-14);
    ASSERT_NEAR(e->value[3], 5.003, 1e-14);
    ASSERT_NEAR(e->value[4], 500.4, 1e-12);
    ASSERT_NEAR(orr_rinex_obs_header_of(r)->codes[0].scale[3], 1000, 0);
    orr_rinex_obs_close(r);
    char *bad = strstr(t.p, "  1000     2    C1");
    assert_non_null(bad);
    memcpy(bad, "  1000     2    C9", 18);
    assert_int_equal(orr_rinex_obs_open_memory("made", t.p, t.n, NULL, NULL, &r, &d), ORR_E_FORMAT);
    assert_non_null(strstr(d.text, "scaled observation type"));
    assert_int_equal(d.line, 5);
    text_free(&t);
}

static void scale_factors_and_other_headers(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    text_header(&t, "     3.04           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
    text_header(&t, "MADE", "MARKER NAME");
    text_header(&t, "G   15 C1C L1C D1C S1C C2W L2W D2W S2W C5Q L5Q D5Q S5Q C1L", "SYS / # / OBS TYPES");
    text_header(&t, "       L1L S1L", "SYS / # / OBS TYPES");
    text_header(&t, "R    2 C1C L1C", "SYS / # / OBS TYPES");
    text_header(&t, "G  100   2 C1C L5Q", "SYS / SCALE FACTOR");
    text_header(&t, "R   10", "SYS / SCALE FACTOR");
    text_header(&t, "G L2W -0.25000", "SYS / PHASE SHIFT");
    text_header(&t, "  3 R01  1 R02 -4 R24  2", "GLONASS SLOT / FRQ #");
    text_header(&t, " C1C  -71.940 C1P  -71.940 C2C  -71.940 C2P  -71.940", "GLONASS COD/PHS/BIS");
    text_header(&t, "  3738358.1345  1148174.0090  5021815.9357", "APPROX POSITION XYZ");
    text_header(&t, "        0.0624        0.0010        0.0020", "ANTENNA: DELTA H/E/N");
    text_header(&t, "    30.000", "INTERVAL");
    text_header(&t, "    18", "LEAP SECONDS");
    text_header(&t, "  2024     2     4     0     0    0.0000000     GPS", "TIME OF FIRST OBS");
    text_header(&t, "", "END OF HEADER");
    text_add(&t, "> 2024 02 04 00 00  0.0000000  0  2\n");
    text_add(&t, "G01%14.3f  %14.3f  %112s%14.3f\n", 2e7, 1.0, "", 100.0);
    text_add(&t, "R02%14.3f  %14.3f\n", 100.0, 100.0);
    orr_rinex_obs *r = open_text(&t, &w);
    const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
    assert_int_equal(h->codes[0].n, 15);
    assert_string_equal(h->codes[0].code[14], "S1L");
    ASSERT_NEAR(h->codes[0].phase_shift_cyc[5], -0.25, 0);
    assert_true(isnan(h->codes[0].phase_shift_cyc[1]));
    assert_int_equal(h->glonass_channel[2], -4);
    assert_int_equal(h->glonass_channel[24], 2);
    assert_int_equal(h->glonass_channel[3], ORR_OBS_NO_CHANNEL);
    ASSERT_NEAR(h->glonass_bias[3].bias_m, -71.94, 0);
    ASSERT_NEAR(h->position_m.z, 5021815.9357, 0);
    ASSERT_NEAR(h->antenna_n_m, 0.002, 0);
    ASSERT_NEAR(h->interval_s, 30, 0);
    assert_int_equal(h->leap_s, 18);
    const orr_rinex_obs_epoch *e = next(r);
    ASSERT_NEAR(e->value[0], 200000, 0);
    ASSERT_NEAR(e->value[1], 1, 0);
    ASSERT_NEAR(e->value[9], 1, 0);
    ASSERT_NEAR(e->value[e->stride], 10, 0);
    assert_int_equal(w.count, 0);
    orr_rinex_obs_close(r);
    text_free(&t);
}

// Header lines that were edited by hand, a column beside where the format has them: nothing is ambiguous, so they are read. A factor
// of one for a type that the file does not have changes nothing; any other may be of a type whose name is damaged.
static void headers_beside_their_columns(void **state)
{
    (void)state;
    for (int factor = 1; factor <= 10; factor += 9) {
        text t = {0};
        orr_warnings w = {0};
        char scale[64];
        text_header(&t, "     3.04           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
        text_header(&t, "MADE", "MARKER NAME");
        text_header(&t, "G    2 C1C L1C", "SYS / # / OBS TYPES");
        snprintf(scale, sizeof scale, "G %4d   3 L1C S1C D1C", factor);
        text_header(&t, scale, "SYS / SCALE FACTOR");
        text_header(&t, "   3738358.1345   1148174.0090   5021815.9357", "APPROX POSITION XYZ");
        text_header(&t, "  2024     2     4     0     0     0.0000000     GAL", "TIME OF FIRST OBS");
        text_header(&t, "", "END OF HEADER");
        text_add(&t, "> 2024 02 04 00 00  0.0000000  0  1\n");
        text_add(&t, "G01%14.3f  %14.3f\n", 2e7, 1.0);
        if (factor != 1) {
            orr_rinex_obs *r = NULL;
            orr_diag d = {0};
            assert_int_equal(orr_rinex_obs_open_memory("made", t.p, t.n, NULL, &w, &r, &d), ORR_E_FORMAT);
            assert_int_equal(d.line, 4);
            assert_int_equal(d.column, 16);
            text_free(&t);
            continue;
        }
        orr_rinex_obs *r = open_text(&t, &w);
        const orr_rinex_obs_header *h = orr_rinex_obs_header_of(r);
        ASSERT_NEAR(h->position_m.x, 3738358.1345, 0);
        ASSERT_NEAR(h->position_m.z, 5021815.9357, 0);
        assert_int_equal(h->scale, ORR_SCALE_GAL);
        ASSERT_NEAR(next(r)->value[0], 2e7, 0);
        assert_int_equal(w.count, 0);
        orr_rinex_obs_close(r);
        text_free(&t);
    }
}

// Damage of one epoch is told and does not reach the next.
static void damage(void **state)
{
    (void)state;
    text t = {0};
    orr_warnings w = {0};
    header_v3(&t, "3.04", "GPS"); // 6 lines
    text_add(&t, "> 2024 02 04 00 00  0.0000000  0  2\n");
    text_add(&t, "G05  20123456.789 8 1057501x3.45617\n"); // line 8, column 20
    text_add(&t, "X07  20123456.789\n");                   // line 9: no such system
    text_add(&t, "> 2024 02 04 00 00 30.0000000  0  3\n"); // announces three, has one
    text_add(&t, "G05  20123456.789\n");
    text_add(&t, "> 2024 02 04 00 0133.0000000  0  1\n"); // line 12: columns slipped
    text_add(&t, "G05  20123456.789\n");
    text_add(&t, "> 2024 02 04 00 01 30.0000000  8  1\n"); // line 14: no such flag
    text_add(&t, "G05  20123456.789\n");
    text_add(&t, "> 2024 02 04 00 02  0.0000000  0  1\n");
    text_add(&t, "G05  20123456.789       123.4\n"); // line 17: cut off
    text_add(&t, "> 2024 02 04 00 02 30.0000000  0  2\nG05  20123456.789\n");
    orr_rinex_obs *r = open_text(&t, &w);
    const orr_rinex_obs_epoch *e = next(r);
    assert_int_equal(e->n_sats, 1);
    ASSERT_NEAR(e->value[0], 20123456.789, 0);
    assert_true(isnan(e->value[1]));
    e = next(r);
    assert_true(e->t == at(2024, 2, 4, 0, 2, 0, ORR_SCALE_GPS));
    assert_true(isnan(e->value[1]));
    assert_null(next(r));
    assert_int_equal(orr_rinex_obs_skipped(r), 4);
    static const int64_t lines[] = {8, 9, 11, 12, 14, 17, 19};
    assert_int_equal(w.count, 7);
    for (size_t i = 0; i < 7; i++) assert_int_equal(w.item[i].line, lines[i]);
    assert_int_equal(w.item[0].column, 20);
    orr_rinex_obs_close(r);
    orr_warnings_free(&w);
    text_free(&t);
}

static void cut_anywhere(void **state)
{
    (void)state;
    text t = {0};
    header_v3(&t, "3.04", "GPS");
    size_t header = t.n;
    for (int i = 0; i < 3; i++)
        text_add(&t,
                 "> 2024 02 04 00 %02d  0.0000000  0  2\nG05  20123456.789 8 105750123.45617     -1234.567\n"
                 "R12  20123456.789    99999999.999\n",
                 i);
    for (size_t n = header; n < t.n; n++) {
        text cut = {t.p, n, 0};
        orr_rinex_obs *r = open_text(&cut, NULL);
        const orr_rinex_obs_epoch *e = NULL;
        orr_status s = ORR_OK;
        size_t n_epochs = 0;
        while ((s = orr_rinex_obs_next(r, &e, NULL)) == ORR_OK && e != NULL) {
            n_epochs++;
            assert_true(isnan(e->value[0]) || e->value[0] == 20123456.789);
            assert_true(isnan(e->value[1]) || e->value[1] == 105750123.456);
            if (e->n_sats > 1)
                assert_true(isnan(e->value[e->stride + 1]) || e->value[e->stride + 1] == 99999999.999);
        }
        assert_true(s == ORR_OK || (s == ORR_E_FORMAT && n_epochs == 0)); // nothing readable: refused
        orr_rinex_obs_close(r);
    }
    text_free(&t);
}

static void refusals(void **state)
{
    (void)state;
    static const struct {
        const char *first, *types, *time;
        orr_status status;
        int line;
    } bad[] = {
        {"     3.04           NAVIGATION DATA     M", "G    1 C1C", "GPS", ORR_E_KIND, 1},
        {"     3.04           OBSERVATION DATA    T", "G    1 C1C", "GPS", ORR_E_UNSUPPORTED, 1},
        {"     3.04           OBSERVATION DATA    M", "G    1 C1C", "XYZ", ORR_E_UNSUPPORTED, 3},
        {"     3.04           OBSERVATION DATA    M", "G    3 C1C", "GPS", ORR_E_FORMAT, 2},
        {"     3.04           OBSERVATION DATA    M", "G  999 C1C", "GPS", ORR_E_FORMAT, 2},
        {"     3.04           OBSERVATION DATA    M", "G    x C1C", "GPS", ORR_E_FORMAT, 2},
        {"     9.04           OBSERVATION DATA    M", "G    1 C1C", "GPS", ORR_E_UNSUPPORTED, 1},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        text t = {0};
        char time[64];
        snprintf(time, sizeof time, "  2024    02    04    00    00    0.0000000     %s", bad[i].time);
        text_header(&t, bad[i].first, "RINEX VERSION / TYPE");
        text_header(&t, bad[i].types, "SYS / # / OBS TYPES");
        text_header(&t, time, "TIME OF FIRST OBS");
        text_header(&t, "", "END OF HEADER");
        orr_rinex_obs *r = NULL;
        orr_diag diag = {0};
        assert_int_equal(orr_rinex_obs_open_memory("bad", t.p, t.n, NULL, NULL, &r, &diag), bad[i].status);
        assert_null(r);
        assert_int_equal(diag.line, bad[i].line);
        text_free(&t);
    }
    text t = {0};
    header_v3(&t, "3.04", "GPS");
    for (int i = 0; i < 5; i++) text_add(&t, "> 2024 02 04 00 %02d  0.0000000  0  0\n", i);
    orr_rinex_obs_limits few = orr_rinex_obs_default_limits();
    few.max_epochs = 3;
    orr_rinex_obs *r = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_rinex_obs_open_memory("many", t.p, t.n, &few, NULL, &r, &diag), diag);
    const orr_rinex_obs_epoch *e = NULL;
    orr_status s = ORR_OK;
    while (s == ORR_OK) s = orr_rinex_obs_next(r, &e, &diag);
    assert_int_equal(s, ORR_E_LIMIT);
    orr_rinex_obs_close(r);
    text_free(&t);
}

// What is read all the same is told: a version that was never published, text behind column 80.
static void told_and_read(void **state)
{
    (void)state;
    static const struct {
        const char *version, *behind, *words;
    } cases[] = {
        {"3.33", "", "there is no RINEX version 3.33"},
        {"3.04", "  and more", "behind column 80"},
        {"3.05", "", NULL},
        {"4.02", "", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        text t = {0};
        orr_warnings w = {0};
        char first[64];
        snprintf(first, sizeof first, "%9s           OBSERVATION DATA    M: MIXED", cases[i].version);
        text_header(&t, first, "RINEX VERSION / TYPE");
        text_add(&t, "%-60s%-20s%s\n", "G    1 C1C", "SYS / # / OBS TYPES", cases[i].behind);
        text_header(&t, "  2024    02    04    00    00    0.0000000     GPS", "TIME OF FIRST OBS");
        text_header(&t, "", "END OF HEADER");
        text_add(&t, "> 2024 02 04 00 00  0.0000000  0  1\nG05  20123456.789\n");
        orr_rinex_obs *r = open_text(&t, &w);
        assert_non_null(next(r));
        size_t found = 0;
        for (size_t k = 0; k < w.kept; k++)
            found += cases[i].words != NULL && strstr(w.item[k].text, cases[i].words) != NULL;
        assert_int_equal(found, cases[i].words != NULL);
        if (cases[i].words == NULL) assert_true(w.count <= 1); // no marker's name
        orr_warnings_free(&w);
        orr_rinex_obs_close(r);
        text_free(&t);
    }
}

static void codes_that_there_are(void **state)
{
    (void)state;
    static const char *const good[] = {"GC1C", "GL2W", "GS5Q", "RC1P", "RD3X", "EC1B", "EL5Q", "EC6Z", "CC2I",
                                       "CL1P", "CC7D", "CC1I", "JL5P", "IC5A", "SC1C", "CX1",  "GL1"},
                             *const bad[] = {"CC9Z", "CC3I", "CL2W", "GC1Z", "RC5I",
                                             "EC2C", "SC2C", "GQ1C", "IC2A"};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++)
        if (!orr_obs_code_is_known(good[i][0], good[i] + 1)) fail_msg("%s is not known", good[i]);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        if (orr_obs_code_is_known(bad[i][0], bad[i] + 1)) fail_msg("%s is known", bad[i]);
}

static void written_and_read_back(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "test_rinex_obs.%ld.rnx", (long)getpid());
    orr_rinex_obs_header h;
    orr_diag diag = {0};
    orr_rinex_obs_header_init(&h);
    strcpy(h.program, "test");
    strcpy(h.marker_name, "MADE");
    strcpy(h.receiver_type, "SIMULATOR");
    strcpy(h.signal_unit, "DBHZ");
    h.has_position = true;
    h.position_m = (orr_vec3){3738358.1345, 1148174.009, -5021815.9357};
    h.antenna_h_m = 0.0624, h.antenna_e_m = 0, h.antenna_n_m = -0.001;
    h.first = at(2024, 2, 4, 0, 0, 0, ORR_SCALE_GPS);
    h.interval_s = 0.1;
    h.glonass_channel[7] = -5;
    h.has_glonass_bias = true;
    strcpy(h.glonass_bias[0].code, "C1C");
    h.glonass_bias[0].bias_m = -1.5;
    static const char codes[20][4] = {"C1C", "L1C", "D1C", "S1C", "C2W", "L2W", "D2W", "S2W", "C5Q", "L5Q",
                                      "D5Q", "S5Q", "C1L", "L1L", "D1L", "S1L", "C2L", "L2L", "D2L", "S2L"};
    for (size_t i = 0; i < 20; i++) ASSERT_OK(orr_rinex_obs_header_add_code(&h, 'G', codes[i], &diag), diag);
    ASSERT_OK(orr_rinex_obs_header_add_code(&h, 'R', "C1C", &diag), diag);
    assert_int_equal(orr_rinex_obs_header_add_code(&h, 'X', "C1C", &diag), ORR_E_ARG);
    assert_int_equal(orr_rinex_obs_header_add_code(&h, 'G', "C1", &diag), ORR_E_ARG);
    h.codes[0].phase_shift_cyc[1] = 0.25;
    orr_rinex_obs_writer *w = NULL;
    assert_int_equal(orr_rinex_obs_create(path, 2.11, &h, &w, &diag), ORR_E_ARG);
    // 4.02 has given two header lines up.
    ASSERT_OK(orr_rinex_obs_create(path, 4.02, &h, &w, &diag), diag);
    ASSERT_OK(orr_rinex_obs_commit(w, &diag), diag);
    orr_rinex_obs *of_4 = NULL;
    ASSERT_OK(orr_rinex_obs_open(path, NULL, NULL, &of_4, &diag), diag);
    ASSERT_NEAR(orr_rinex_obs_header_of(of_4)->version, 4.02, 0);
    assert_int_equal(orr_rinex_obs_header_of(of_4)->glonass_channel[7], -5);
    assert_false(orr_rinex_obs_header_of(of_4)->has_glonass_bias);
    orr_rinex_obs_close(of_4);
    unlink(path);
    ASSERT_OK(orr_rinex_obs_create(path, 3.05, &h, &w, &diag), diag);
    orr_sat sat[2] = {orr_sat_make('G', 5), orr_sat_make('R', 7)};
    double value[40];
    uint8_t lli[40], ssi[40];
    for (int i = 0; i < 40; i++) {
        value[i] = i == 3 ? ORR_NAN : (i % 2 ? -1 : 1) * (1e7 * i + 0.001 * i + 1);
        lli[i] = (uint8_t)(i % 4);
        ssi[i] = (uint8_t)(i % 10);
    }
    value[20] = 9999999999.999;
    orr_rinex_obs_epoch e = {.t = h.first + 123456700,
                             .clock_offset_s = 1.5e-4,
                             .n_sats = 2,
                             .stride = 20,
                             .sat = sat,
                             .value = value,
                             .lli = lli,
                             .ssi = ssi};
    ASSERT_OK(orr_rinex_obs_write(w, &e, &diag), diag);
    const char *lines[] = {"a remark                                                    COMMENT"};
    orr_rinex_obs_epoch event = {
        .t = ORR_TIME_NONE, .flag = ORR_OBS_HEADER, .n_event_lines = 1, .event_line = lines};
    ASSERT_OK(orr_rinex_obs_write(w, &event, &diag), diag);
    value[0] = 1e10; // one digit too many
    assert_int_equal(orr_rinex_obs_write(w, &e, &diag), ORR_E_RANGE);
    orr_rinex_obs_abort(w);
    assert_int_equal(access(path, F_OK), -1); // nothing is left of it

    value[0] = 1;
    ASSERT_OK(orr_rinex_obs_create(path, 3.05, &h, &w, &diag), diag);
    ASSERT_OK(orr_rinex_obs_write(w, &e, &diag), diag);
    ASSERT_OK(orr_rinex_obs_write(w, &event, &diag), diag);
    ASSERT_OK(orr_rinex_obs_commit(w, &diag), diag);
    orr_rinex_obs *r = NULL;
    orr_warnings warnings = {0};
    ASSERT_OK(orr_rinex_obs_open(path, NULL, &warnings, &r, &diag), diag);
    unlink(path);
    const orr_rinex_obs_header *g = orr_rinex_obs_header_of(r);
    ASSERT_NEAR(g->version, 3.05, 0);
    assert_string_equal(g->marker_name, "MADE");
    ASSERT_NEAR(g->position_m.z, h.position_m.z, 0);
    ASSERT_NEAR(g->antenna_n_m, -0.001, 0);
    assert_true(g->first == h.first);
    assert_int_equal(g->codes[0].n, 20);
    assert_string_equal(g->codes[0].code[19], "S2L");
    ASSERT_NEAR(g->codes[0].phase_shift_cyc[1], 0.25, 0);
    assert_int_equal(g->glonass_channel[7], -5);
    ASSERT_NEAR(g->glonass_bias[0].bias_m, -1.5, 0);
    const orr_rinex_obs_epoch *b = next(r);
    assert_true(b->t == e.t);
    ASSERT_NEAR(b->clock_offset_s, 1.5e-4, 0);
    assert_int_equal(b->n_sats, 2);
    for (size_t i = 0; i < 20; i++) {
        if (i == 3)
            assert_true(isnan(b->value[i]));
        else
            ASSERT_NEAR(b->value[i], value[i],
                        1e-6); // three decimals were printed of numbers that have three
        assert_int_equal(b->lli[i], lli[i]);
        assert_int_equal(b->ssi[i], ssi[i]);
    }
    ASSERT_NEAR(b->value[b->stride], 9999999999.999, 0);
    b = next(r);
    assert_int_equal(b->n_event_lines, 1);
    assert_string_equal(b->event_line[0], lines[0]);
    assert_null(next(r));
    assert_int_equal(warnings.count, 0);
    orr_rinex_obs_close(r);
    orr_rinex_obs_header_free(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_3),
        cmocka_unit_test(time_systems_and_leap_second),
        cmocka_unit_test(version_2),
        cmocka_unit_test(scale_factors_of_version_2),
        cmocka_unit_test(scale_factors_and_other_headers),
        cmocka_unit_test(headers_beside_their_columns),
        cmocka_unit_test(damage),
        cmocka_unit_test(cut_anywhere),
        cmocka_unit_test(refusals),
        cmocka_unit_test(told_and_read),
        cmocka_unit_test(codes_that_there_are),
        cmocka_unit_test(written_and_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
