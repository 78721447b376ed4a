// SPDX-License-Identifier: GPL-3.0-or-later
// The SP3 writer against files whose layout comes from elsewhere (tests/fuzz/make_input_seeds.py follows the
// format's column tables): what is read from them must be written as the same bytes. And what a version
// cannot hold is refused.
#include "testing.h"

#include <unistd.h>

#include "ingest/input/input.h"
#include "ingest/sp3/sp3.h"

static orr_diag diag;

static char *print(const orr_sp3 *s, orr_status expected)
{
    char *text = NULL;
    size_t n = 0;
    FILE *f = open_memstream(&text, &n);
    assert_non_null(f);
    diag = (orr_diag){0};
    orr_status st = orr_sp3_print(s, f, &diag);
    fclose(f);
    if (st != expected) fail_msg("%s, not %s: %s", orr_status_name(st), orr_status_name(expected), diag.text);
    return text;
}

static void test_same_bytes(void **state)
{
    (void)state;
    static const char *const names[] = {"a", "b", "c", "cv", "d", "dv"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[512];
        snprintf(path, sizeof path, ORR_SOURCE_DIR "/tests/golden/ingest/%s.sp3", names[i]);
        orr_bytes b;
        orr_sp3 s;
        orr_warnings w = {0};
        ASSERT_OK(orr_input_read_all(path, NULL, &b, &diag), diag);
        ASSERT_OK(orr_sp3_parse(names[i], b.text, b.n, NULL, &s, &w, &diag), diag);
        assert_int_equal(w.count, 0);
        assert_int_equal(s.version, names[i][0]);
        char *text = print(&s, ORR_OK);
        assert_string_equal(text, b.text);
        free(text);
        orr_sp3_free(&s);
        orr_bytes_free(&b);
        orr_warnings_free(&w);
    }
}

static orr_sp3 made(size_t sats, size_t epochs)
{
    orr_sp3 s;
    ASSERT_OK(orr_sp3_alloc(sats, epochs, &s, &diag), diag);
    for (size_t i = 0; i < sats; i++) s.sat[i] = orr_sat_make("GREC"[i / 90], (int)(1 + i % 90));
    for (size_t e = 0; e < epochs; e++)
        s.epoch[e] = orr_time_from_week(2300, 0) + (int64_t)e * 900 * ORR_NS_PER_S;
    return s;
}

// All that may be NAN stays so, and numbers come back on the format's last decimal.
static void test_round_trip(void **state)
{
    (void)state;
    orr_sp3 s = made(3, 2), t;
    s.has_velocity = true;
    s.pos_vel_base = 1.25;
    s.clock_base = 1.025;
    s.record[0].pos_m[0] = 12345678.9014; // the fourth decimal of a metre is below the format's
    s.record[0].pos_m[1] = -0.0004;
    s.record[0].pos_m[2] = 1;
    s.record[0].clock_s = -1.25e-12;
    s.record[0].vel_mps[0] = 3000.12345678;
    s.record[0].vel_mps[1] = s.record[0].vel_mps[2] = 0;
    s.record[0].clock_rate_sps = 1e-12;
    s.record[0].pos_sdev_m[0] = 0.05f;
    s.record[0].pos_sdev_m[1] = INFINITY;
    s.record[3].flags = ORR_SP3_MANOEUVRE;
    char *text = print(&s, ORR_OK);
    ASSERT_OK(orr_sp3_parse("made", text, strlen(text), NULL, &t, NULL, &diag), diag);
    ASSERT_NEAR(t.record[0].pos_m[0], 12345678.901, 0);
    ASSERT_NEAR(t.record[0].pos_m[1], 0, 0);
    ASSERT_NEAR(t.record[0].clock_s, -1e-12, 0);
    ASSERT_NEAR(t.record[0].vel_mps[0], 3000.1234568, 0);
    ASSERT_NEAR(t.record[0].clock_rate_sps, 1e-12, 0);
    ASSERT_NEAR(t.record[0].pos_sdev_m[0], 0.05, 0.05 * 0.125); // the powers are 25 % apart
    assert_true(isinf(t.record[0].pos_sdev_m[1]) && isnan(t.record[0].pos_sdev_m[2]));
    assert_int_equal(t.record[3].flags, ORR_SP3_MANOEUVRE);
    assert_true(isnan(t.record[4].pos_m[1]) && isnan(t.record[4].clock_s) && isnan(t.record[4].vel_mps[0]));
    assert_string_equal(t.file_type, "G");
    ASSERT_NEAR(t.interval_s, 900, 0);
    free(text);
    orr_sp3_free(&s);
    orr_sp3_free(&t);
}

// The same instants through the labels of every time system, a leap second among them.
static void test_time_systems(void **state)
{
    (void)state;
    const orr_scale scales[] = {ORR_SCALE_GPS, ORR_SCALE_UTC, ORR_SCALE_TAI, ORR_SCALE_GLO,
                                ORR_SCALE_GAL, ORR_SCALE_BDT, ORR_SCALE_QZS, ORR_SCALE_IRN};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        orr_sp3 s = made(1, 40), t;
        orr_civil midnight = {.year = 2017, .month = 1, .day = 1};
        orr_time leap;
        assert_int_equal(orr_time_from_civil(&midnight, ORR_SCALE_UTC, NULL, &leap), ORR_OK);
        for (int e = 0; e < 40; e++) s.epoch[e] = leap + (e - 20) * ORR_NS_PER_S / 4 + 10;
        s.record[0].pos_m[0] = s.record[0].pos_m[1] = s.record[0].pos_m[2] = 2e7;
        s.scale = scales[i];
        char *text = print(&s, ORR_OK);
        ASSERT_OK(orr_sp3_parse("made", text, strlen(text), NULL, &t, NULL, &diag), diag);
        assert_int_equal(t.scale, scales[i]);
        assert_int_equal(t.n_epochs, 40);
        assert_memory_equal(t.epoch, s.epoch, 40 * sizeof *s.epoch);
        free(text);
        orr_sp3_free(&s);
        orr_sp3_free(&t);
    }
}

static void expect_refusal(orr_sp3 *s, const char *words)
{
    free(print(s, ORR_E_ARG));
    if (strstr(diag.text, words) == NULL) fail_msg("'%s' says nothing of '%s'", diag.text, words);
    orr_sp3_free(s);
}

static void test_refusals(void **state)
{
    (void)state;
    orr_sp3 s = made(86, 1);
    s.version = 'c';
    expect_refusal(&s, "85");
    s = made(91, 1);
    s.version = 'a';
    expect_refusal(&s, "85");
    s = made(1, 1);
    s.version = 'a';
    s.sat[0] = orr_sat_make('R', 1);
    expect_refusal(&s, "GPS satellites alone");
    s = made(1, 1);
    s.version = 'e';
    expect_refusal(&s, "versions");
    s = made(1, 2);
    s.epoch[1] = s.epoch[0];
    expect_refusal(&s, "ascend");
    s = made(1, 1);
    s.epoch[0]++;
    expect_refusal(&s, "10 ns");
    s = made(1, 1);
    s.record[0].pos_m[0] = s.record[0].pos_m[1] = s.record[0].pos_m[2] = 1e10;
    expect_refusal(&s, "wider");
    s = made(1, 1);
    s.record[0].clock_s = 1.5;
    expect_refusal(&s, "wider");
    s = made(1, 1);
    s.record[0].pos_sdev_m[0] = 0.01f; // no base was told
    expect_refusal(&s, "bases");
    char long_comment[100];
    memset(long_comment, 'x', 58);
    long_comment[58] = '\0';
    char *comment[5] = {long_comment, long_comment, long_comment, long_comment, long_comment};
    for (int version = 'c'; version <= 'd'; version++) {
        s = made(1, 1);
        s.version = (char)version;
        s.comment = comment;
        s.n_comments = 1;
        free(print(&s, version == 'c' ? ORR_E_ARG : ORR_OK));
        s.comment = NULL;
        s.n_comments = 0;
        orr_sp3_free(&s);
    }
    assert_int_equal(orr_sp3_alloc(0, 1, &s, &diag), ORR_E_ARG);
    assert_int_equal(orr_sp3_alloc(1000, 1, &s, &diag), ORR_E_ARG);
}

static void test_file_is_whole_or_not_there(void **state)
{
    (void)state;
    const char *path = ORR_BINARY_DIR "/test_sp3_write.tmp";
    orr_sp3 s = made(2, 2), t;
    s.record[0].pos_m[0] = s.record[0].pos_m[1] = s.record[0].pos_m[2] = 1e10;
    unlink(path);
    assert_int_equal(orr_sp3_write(&s, path, &diag), ORR_E_ARG);
    assert_int_equal(access(path, F_OK), -1);
    s.record[0].pos_m[0] = s.record[0].pos_m[1] = s.record[0].pos_m[2] = 1e7;
    ASSERT_OK(orr_sp3_write(&s, path, &diag), diag);
    ASSERT_OK(orr_sp3_read(path, NULL, &t, NULL, &diag), diag);
    assert_true(t.record[0].pos_m[2] == 1e7);
    unlink(path);
    orr_sp3_free(&s);
    orr_sp3_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_bytes),
        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_time_systems),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_file_is_whole_or_not_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
