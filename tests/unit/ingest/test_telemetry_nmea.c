// SPDX-License-Identifier: GPL-3.0-or-later
// Dates and heights of NMEA logs, as recorders leave them: receivers without a fix, pauses, leap seconds, no date.
#include "testing.h"

#include <stdarg.h>

#include "core/vec.h"
#include "ingest/telemetry/telemetry.h"

typedef struct text {
    char *p;
    size_t n;
} text;

static void add(text *t, const char *before, const char *fmt, ...)
{
    char body[200];
    va_list args;
    va_start(args, fmt);
    vsnprintf(body, sizeof body, fmt, args);
    va_end(args);
    unsigned sum = 0;
    for (const char *q = body; *q != '\0'; q++) sum ^= (unsigned char)*q;
    t->p = realloc(t->p, t->n + 300);
    assert_non_null(t->p);
    t->n += (size_t)snprintf(t->p + t->n, 300, "%s$%s*%02X\r\n", before, body, sum);
}

// A second of a log: a place (east by 10 m a second) and, with a date (ddmmyy), a dated sentence of this status.
static void second(text *t, int clock_s, const char *date, char status)
{
    int day_s = clock_s % 86400, h = day_s / 3600, m = day_s / 60 % 60, s = day_s % 60;
    if (date != NULL)
        add(t, "", "GPRMC,%02d%02d%02d.00,%c,0000.000,N,00000.000,E,0.0,90.0,%s,,", h, m, s, status, date);
    add(t, "", "GPGGA,%02d%02d%02d.00,0000.0000,N,%09.5f,E,1,08,1.0,100.0,M,47.0,M,,", h, m, s,
        clock_s % 1000 * 0.0054);
}

static orr_telemetry read(text *t, orr_warnings *w)
{
    orr_diag diag = {0};
    orr_telemetry out;
    ASSERT_OK(orr_telemetry_read_bytes("made.nmea", t->p, t->n, NULL, NULL, &out, w, &diag), diag);
    assert_int_equal(out.kind, ORR_TELEMETRY_NMEA);
    free(t->p);
    *t = (text){0};
    return out;
}

// The instant of a place, as UTC.
static const char *when(const orr_telemetry *t, size_t k)
{
    static char buf[ORR_TIME_TEXT];
    assert_true(t->absolute && k < t->n_position);
    return orr_time_format(orr_time_add_s(t->t0, t->position_t_s[k]), ORR_SCALE_UTC, 0, NULL, buf);
}

static bool told(const orr_warnings *w, const char *words)
{
    for (size_t k = 0; k < w->kept; k++)
        if (strstr(w->item[k].text, words) != NULL) return true;
    return false;
}

static void dates_of_valid_sentences_alone(void **state)
{
    (void)state;
    text t = {0};
    for (int k = 0; k < 60; k++) second(&t, 36000 + k, k < 30 ? "060180" : "150824", k < 30 ? 'V' : 'A');
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_string_equal(when(&log, 0), "2024-08-15T10:00:00Z");
    assert_string_equal(when(&log, 59), "2024-08-15T10:00:59Z");
    assert_int_equal(w.count, 0);
    orr_telemetry_free(&log);
    // ZDA has no status: it counts where nothing else does, and never against a valid RMC.
    add(&t, "", "GPZDA,100000.00,06,01,1980,00,00");
    for (int k = 0; k < 60; k++) second(&t, 36000 + k, k == 59 ? "150824" : NULL, 'A');
    log = read(&t, &w);
    assert_string_equal(when(&log, 0), "2024-08-15T10:00:00Z");
    orr_telemetry_free(&log);
    add(&t, "", "GPZDA,100000.00,15,08,2024,00,00");
    for (int k = 0; k < 20; k++) second(&t, 36000 + k, NULL, 'A');
    log = read(&t, &w);
    assert_string_equal(when(&log, 19), "2024-08-15T10:00:19Z");
    orr_telemetry_free(&log);
}

// What most sentences say holds, whichever comes first; a count of weeks that rolled over is no pause of 20 years.
static void contradictions_are_told(void **state)
{
    (void)state;
    text t = {0};
    for (int k = 0; k < 60; k++) second(&t, 36000 + k, k == 20 ? "110203" : "150824", 'A');
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_string_equal(when(&log, 20), "2024-08-15T10:00:20Z");
    assert_true(told(&w, "2003-02-11"));
    assert_int_equal(w.item[0].line, 41);
    orr_warnings_free(&w);
    w = (orr_warnings){0};
    orr_telemetry_free(&log);
    for (int k = 0; k < 60; k++) second(&t, 36000 + k, k < 20 ? "301204" : "150824", 'A'); // 7168 days apart
    log = read(&t, &w);
    assert_string_equal(when(&log, 0), "2024-08-15T10:00:00Z");
    assert_true(told(&w, "contradict"));
    orr_warnings_free(&w);
    orr_telemetry_free(&log);
    // A recorder that looked at the calendar once: its date stands still over midnight.
    w = (orr_warnings){0};
    for (int k = 0; k < 60; k++) second(&t, 86390 + k, "311224", 'A');
    log = read(&t, &w);
    assert_string_equal(when(&log, 0), "2024-12-31T23:59:50Z");
    assert_string_equal(when(&log, 59), "2025-01-01T00:00:49Z");
    assert_true(told(&w, "contradict"));
    orr_warnings_free(&w);
    orr_telemetry_free(&log);
}

// Pauses of any length, whole days too: each session has its own date.
static void sessions_have_their_own_dates(void **state)
{
    (void)state;
    static const struct {
        int pause_s;
        const char *second;
    } c[] = {{7200, "2024-08-15T12:00:59Z"},      {23 * 3600, "2024-08-16T09:00:59Z"},
             {86400, "2024-08-16T10:00:59Z"},     {86340, "2024-08-16T09:59:59Z"},
             {30 * 3600, "2024-08-16T16:00:59Z"}, {5 * 86400 - 60, "2024-08-20T09:59:59Z"}};
    for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
        text t = {0};
        for (int k = 0; k < 60; k++) second(&t, 36000 + k, "150824", 'A');
        int at = 36059 + c[i].pause_s;
        char date[20];
        snprintf(date, sizeof date, "%02d0824", 15 + at / 86400);
        for (int k = 0; k < 60; k++) second(&t, at + k, date, 'A');
        orr_warnings w = {0};
        orr_telemetry log = read(&t, &w);
        assert_int_equal(log.n_position, 120);
        assert_string_equal(when(&log, 59), "2024-08-15T10:00:59Z");
        assert_string_equal(when(&log, 60), c[i].second);
        assert_int_equal(w.count, 0);
        orr_telemetry_free(&log);
    }
    // The later session first in the file, and one between that nothing dates.
    text t = {0};
    for (int k = 0; k < 20; k++) second(&t, 50000 + k, "160824", 'A');
    for (int k = 0; k < 20; k++) second(&t, 36000 + k, "150824", 'A');
    for (int k = 0; k < 20; k++) second(&t, 30000 + k, NULL, 'A');
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_string_equal(when(&log, 0), "2024-08-15T10:00:00Z");
    assert_string_equal(when(&log, 20), "2024-08-16T08:20:00Z");
    assert_string_equal(when(&log, 40), "2024-08-16T13:53:20Z");
    assert_true(told(&w, "no sentence dates the session"));
    orr_warnings_free(&w);
    orr_telemetry_free(&log);
}

// 2016-12-31 had 86401 seconds: the rows are a second apart, the 60th among them, whether or not a date tells.
static void leap_seconds_keep_their_second(void **state)
{
    (void)state;
    for (int dated = 0; dated < 2; dated++) {
        text t = {0};
        const char *clock[] = {"235957", "235958", "235959", "235960", "000000", "000001", "000002"};
        for (int k = 0; k < 7; k++) {
            if (dated)
                add(&t, "", "GNRMC,%s.00,A,0000.0,N,00000.0,E,0.0,90.0,%s,,", clock[k],
                    k < 4 ? "311216" : "010117");
            add(&t, "", "GNGGA,%s.00,0000.0000,N,00000.%04d,E,1,08,1.0,100.0,M,47.0,M,,", clock[k], k);
        }
        orr_warnings w = {0};
        orr_telemetry log = read(&t, &w);
        assert_int_equal(log.absolute, dated == 1);
        for (size_t k = 0; k < 7; k++)
            ASSERT_NEAR(log.position_t_s[k] - log.position_t_s[0], (double)k, 1e-9);
        if (dated) assert_string_equal(when(&log, 3), "2016-12-31T23:59:60Z");
        assert_int_equal(w.count, 0);
        orr_telemetry_free(&log);
    }
    // A day on which the table has none.
    text t = {0};
    add(&t, "", "GNRMC,235959.00,A,0000.0,N,00000.0,E,0.0,90.0,150824,,");
    add(&t, "", "GNGGA,235960.00,0000.0000,N,00000.0001,E,1,08,1.0,100.0,M,47.0,M,,");
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_true(told(&w, "60th second"));
    orr_warnings_free(&w);
    orr_telemetry_free(&log);
}

static void without_a_date_the_time_of_day_stays(void **state)
{
    (void)state;
    text t = {0};
    for (int k = 0; k < 60; k++) second(&t, 86370 + k, k < 10 ? "060180" : NULL, 'V');
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_false(log.absolute);
    ASSERT_NEAR(log.period_s, 86400.0, 0.0);
    ASSERT_NEAR(log.position_t_s[0], 86370.0, 1e-9);
    ASSERT_NEAR(log.position_t_s[59], 86429.0, 1e-9);
    orr_telemetry_free(&log);
}

// A log that begins inside a sentence, has blank lines, and stamps of the recorder before each sentence.
static void whatever_stands_around_sentences(void **state)
{
    (void)state;
    static const char *const before[] = {
        "", "\r\n", "2024-08-15 10:00:00.123 ", "1723716000.25,", "[12:00:00.5] > ", "\xef\xbb\xbf"};
    for (size_t i = 0; i < sizeof before / sizeof before[0]; i++) {
        text t = {0};
        t.p = strdup("\n\n4.5,W,2,09,0.9,100.0,M,47.0,M,,*7A\r\n\r\n");
        t.n = strlen(t.p);
        add(&t, before[i], "GPRMC,100000.00,A,0000.000,N,00000.000,E,0.0,90.0,150824,,");
        for (int k = 0; k < 10; k++)
            add(&t, before[i], "GPGGA,1000%02d.00,0000.0000,N,00000.0000,E,1,08,1.0,100.0,M,47.0,M,,", k);
        orr_warnings w = {0};
        orr_telemetry log = read(&t, &w);
        assert_int_equal(log.n_position, 10);
        assert_int_equal(log.unreadable, 1);
        assert_int_equal(w.item[0].line, 3);
        assert_string_equal(when(&log, 0), "2024-08-15T10:00:00Z");
        orr_warnings_free(&w);
        orr_telemetry_free(&log);
    }
}

// Two sentences in one line, the first of them cut.
static void sentences_that_share_a_line(void **state)
{
    (void)state;
    text t = {0};
    for (int k = 0; k < 10; k++) {
        add(&t, k == 3 ? "$GPGGA,1000" : "",
            "GPGGA,1000%02d.00,0000.0000,N,00000.0000,E,1,08,1.0,100.0,M,47.0,M,,", k);
        t.n -= 2; // the line goes on
        add(&t, "", "GPRMC,1000%02d.00,A,0000.000,N,00000.000,E,0.0,90.0,150824,,", k);
    }
    orr_warnings w = {0};
    orr_telemetry log = read(&t, &w);
    assert_int_equal(log.n_position, 10);
    assert_string_equal(when(&log, 9), "2024-08-15T10:00:09Z");
    assert_int_equal(w.count, 0);
    orr_telemetry_free(&log);
}

// GNS sentences have places too, and repeat those of GGA where a log has both.
static void places_of_gns(void **state)
{
    (void)state;
    for (int both = 0; both < 2; both++) {
        text t = {0};
        for (int k = 0; k < 10; k++) {
            add(&t, "", "GNGNS,1000%02d.00,0000.0000,N,00000.0000,E,ANN,08,1.0,100.0,47.0,,", k);
            if (both) add(&t, "", "GNGGA,1000%02d.00,0000.0000,N,00000.0000,E,1,08,1.0,100.0,M,47.0,M,,", k);
        }
        orr_telemetry log = read(&t, NULL);
        assert_int_equal(log.n_position, 10);
        ASSERT_NEAR(log.position[9].height_m, 147.0, 1e-9);
        orr_telemetry_free(&log);
    }
}

static void put16(FILE *f, unsigned v)
{
    fputc((int)(v >> 8), f);
    fputc((int)(v & 255), f);
}

// Without a separation heights are above sea level: a warning, or the geoid where GeographicLib has one.
static void heights_above_sea_level(void **state)
{
    (void)state;
    char folder[] = "/tmp/orrery-geoid-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    setenv("GEOGRAPHICLIB_GEOID_PATH", folder, 1);
    for (int installed = 0; installed < 2; installed++) {
        snprintf(path, sizeof path, "%s/egm96-15.pgm", folder);
        if (installed) { // a made geoid, 40 m everywhere
            FILE *f = fopen(path, "wb");
            assert_non_null(f);
            fprintf(f,
                    "P5\n# Geoid file in PGM format for the GeographicLib::Geoid class\n# Description made\n"
                    "# DateTime 2024-01-01 00:00:00\n# Offset -100\n# Scale 0.01\n# Origin 90N 0E\n"
                    "# AREA_OR_POINT Point\n# Vertical_Datum WGS84\n12 7\n65535\n");
            for (int k = 0; k < 12 * 7; k++) put16(f, 14000);
            assert_int_equal(fclose(f), 0);
        }
        text t = {0};
        for (int k = 0; k < 10; k++)
            add(&t, "", "GPGGA,1000%02d.00,5200.0000,N,01300.0000,E,1,08,1.0,100.0,M,,M,,", k);
        orr_warnings w = {0};
        orr_telemetry log = read(&t, &w);
        assert_int_equal(w.count, 1);
        assert_true(told(&w, installed ? "egm96-15 adds 40.0 to 40.0 m" : "above sea level"));
        ASSERT_NEAR(log.position[9].height_m, installed ? 140.0 : 100.0, 1e-6);
        orr_warnings_free(&w);
        orr_telemetry_free(&log);
    }
    remove(path);
    remove(folder);
}

// Sentences without checksums, as long as none in the log has one; a log whose places stand before its dates.
static void kinds_of_logs(void **state)
{
    (void)state;
    char bare[4000] = "", blocks[8000] = "";
    for (int k = 0; k < 10; k++) {
        snprintf(bare + strlen(bare), sizeof bare - strlen(bare),
                 "$GPRMC,1000%02d.00,A,5200.0000,N,01300.0%03d,E,1.0,90.0,150824,,,A\r\n"
                 "$GPGGA,1000%02d.00,5200.0000,N,01300.0%03d,E,1,09,1.0,100.0,M,40.0,M,,\r\n",
                 k, k, k, k);
    }
    orr_telemetry t;
    orr_diag d = {0};
    orr_warnings w = {0};
    ASSERT_OK(orr_telemetry_read_bytes("bare", bare, strlen(bare), NULL, NULL, &t, &w, &d), d);
    assert_int_equal(t.n_position, 10);
    assert_int_equal(t.unreadable, 0);
    assert_true(t.absolute && t.t0 == orr_time_from_week(2327, INT64_C(381618000000000)));
    assert_non_null(strstr(w.item[0].text, "no checksums"));
    ASSERT_NEAR(t.position[0].height_m, 140, 1e-9);
    orr_telemetry_free(&t);
    orr_warnings_free(&w);
    // One flight, places first: the dates behind are of the same day, not of the next one.
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 10; k++) {
            char body[100];
            unsigned sum = 0;
            if (pass == 0)
                snprintf(body, sizeof body,
                         "GPGGA,1000%02d.00,5200.0000,N,01300.0%03d,E,1,09,1.0,100.0,M,40.0,M,,", k, k);
            else
                snprintf(body, sizeof body,
                         "GPRMC,1000%02d.00,A,5200.0000,N,01300.0%03d,E,1.0,90.0,150824,,,A", k, k);
            for (const char *p = body; *p != '\0'; p++) sum ^= (unsigned char)*p;
            snprintf(blocks + strlen(blocks), sizeof blocks - strlen(blocks), "$%s*%02X\r\n", body, sum);
        }
    ASSERT_OK(orr_telemetry_read_bytes("blocks", blocks, strlen(blocks), NULL, NULL, &t, NULL, &d), d);
    assert_int_equal(t.n_position, 10);
    assert_true(orr_time_add_s(t.t0, t.position_t_s[0]) ==
                orr_time_from_week(2327, INT64_C(381618000000000)));
    orr_telemetry_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinds_of_logs),
        cmocka_unit_test(dates_of_valid_sentences_alone),
        cmocka_unit_test(contradictions_are_told),
        cmocka_unit_test(sessions_have_their_own_dates),
        cmocka_unit_test(leap_seconds_keep_their_second),
        cmocka_unit_test(without_a_date_the_time_of_day_stays),
        cmocka_unit_test(whatever_stands_around_sentences),
        cmocka_unit_test(places_of_gns),
        cmocka_unit_test(sentences_that_share_a_line),
        cmocka_unit_test(heights_above_sea_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
