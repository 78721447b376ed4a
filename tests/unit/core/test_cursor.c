// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/cursor.h"

static orr_view V(const char *s) { return orr_view_of(s); }

static void test_lines(void **state)
{
    (void)state;
    static const char text[] = "one\r\n\ntwo\0x\nlast";
    orr_cursor c;
    orr_view v;
    orr_cursor_init(&c, "t", text, sizeof text - 1);
    assert_true(orr_cursor_next(&c, &v) && orr_view_equals(v, "one"));
    assert_true(orr_cursor_next(&c, &v) && v.n == 0);
    assert_true(orr_cursor_next(&c, &v) && v.n == 5 && memcmp(v.p, "two\0x", 5) == 0);
    assert_false(c.unterminated);
    assert_true(orr_cursor_next(&c, &v) && orr_view_equals(v, "last"));
    assert_true(c.unterminated);
    assert_int_equal(c.line, 4);
    assert_false(orr_cursor_next(&c, &v));
    assert_int_equal(orr_cursor_status(&c, NULL), ORR_OK);
    orr_cursor_init(&c, "t", "", 0);
    assert_false(orr_cursor_next(&c, &v));
}

static void test_long_line(void **state)
{
    (void)state;
    orr_cursor c;
    orr_view v;
    orr_diag d = {0};
    orr_cursor_init(&c, "t", "1234\n12345\n1", 12);
    c.max_line = 4;
    assert_true(orr_cursor_next(&c, &v));
    assert_false(orr_cursor_next(&c, &v));
    assert_false(orr_cursor_next(&c, &v)); // and stays so
    assert_int_equal(orr_cursor_status(&c, &d), ORR_E_LIMIT);
    assert_int_equal(d.line, 2);
}

static void test_columns(void **state)
{
    (void)state;
    orr_view l = V("PG01  1.5\t2");
    assert_true(orr_view_equals(orr_view_cols(l, 2, 3), "G01"));
    assert_true(orr_view_equals(orr_view_cols(l, 7, 100), "1.5\t2"));
    assert_int_equal(orr_view_cols(l, 12, 3).n, 0);
    assert_int_equal(orr_view_cols(l, 500, 3).n, 0);
    assert_int_equal(orr_view_char(l, 1), 'P');
    assert_int_equal(orr_view_char(l, 10), ' ');
    assert_int_equal(orr_view_char(l, 99), ' ');
    char buf[4];
    assert_string_equal(orr_view_copy(V("a\x1b"
                                        "bcd"),
                                      buf, sizeof buf),
                        "a?b");
}

static void test_words(void **state)
{
    (void)state;
    orr_view rest = V("  a\tbb  "), w;
    assert_true(orr_view_word(&rest, &w) && orr_view_equals(w, "a"));
    assert_true(orr_view_word(&rest, &w) && orr_view_equals(w, "bb"));
    assert_false(orr_view_word(&rest, &w));
    rest = V("x,,y,");
    const char *expected[] = {"x", "", "y", ""};
    for (int i = 0; i < 4; i++)
        assert_true(orr_view_split(&rest, ',', &w) && orr_view_equals(w, expected[i]));
    assert_false(orr_view_split(&rest, ',', &w));
}

static void test_integers(void **state)
{
    (void)state;
    int64_t v = 7;
    assert_int_equal(orr_view_int(V("  -012 "), &v), ORR_FIELD_OK);
    assert_int_equal(v, -12);
    assert_int_equal(orr_view_int(V("9223372036854775807"), &v), ORR_FIELD_OK);
    assert_true(v == INT64_MAX);
    assert_int_equal(orr_view_int(V("-9223372036854775808"), &v), ORR_FIELD_OK);
    assert_true(v == INT64_MIN);
    v = 7;
    const char *bad[] = {"9223372036854775808",
                         "-9223372036854775809",
                         "99999999999999999999",
                         "1 2",
                         "1.",
                         "+",
                         "-",
                         "x",
                         "0x1",
                         "--1"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(orr_view_int(V(bad[i]), &v), ORR_FIELD_BAD);
    assert_int_equal(orr_view_int(V(" \t"), &v), ORR_FIELD_BLANK);
    assert_int_equal(orr_view_int((orr_view){NULL, 0}, &v), ORR_FIELD_BLANK);
    assert_int_equal(v, 7);
    int i = 0;
    assert_int_equal(orr_field_int_in(V("  61"), 3, 2, 0, 60, &i), ORR_FIELD_BAD);
    assert_int_equal(orr_field_int_in(V("  60"), 3, 2, 0, 60, &i), ORR_FIELD_OK);
}

static void test_reals(void **state)
{
    (void)state;
    double x = 7;
    static const struct {
        const char *text;
        double value;
    } good[] = {{"1", 1},
                {" -0.5\t", -0.5},
                {".5", .5},
                {"5.", 5},
                {"1.5D+02", 150},
                {"1.5d-2", 0.015},
                {"1.5E 02", 150},
                {"+1e0", 1},
                {"0.000000000000D+00", 0},
                {"-9.999999e-310", -9.999999e-310},
                {"1e-400", 0},
                {"0000000000000000000000000001.25", 1.25},
                {"123456789012345678901234567890", 123456789012345678901234567890.}};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_int_equal(orr_view_real(V(good[i].text), &x), ORR_FIELD_OK);
        assert_true(x == good[i].value);
    }
    x = 7;
    const char *bad[] = {"1 2", "1.2.3", "*****", "nan",   "inf",   "1e",  "1e+",
                         "D2",  ".",     "-",     "0x1p3", "1e999", "1,5", "1.5-3"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(orr_view_real(V(bad[i]), &x), ORR_FIELD_BAD);
    assert_int_equal(orr_view_real(V("   "), &x), ORR_FIELD_BLANK);
    char nul[3] = {'1', '\0', '2'};
    assert_int_equal(orr_view_real((orr_view){nul, 3}, &x), ORR_FIELD_BAD);
    char wide[130];
    memset(wide, '1', sizeof wide);
    assert_int_equal(orr_view_real((orr_view){wide, sizeof wide}, &x), ORR_FIELD_BAD);
    assert_true(x == 7);
}

// Every result must be the very double that the C library reads, whatever the number of digits and the
// exponent.
static void test_reals_round_as_strtod(void **state)
{
    (void)state;
    uint64_t s = 88172645463325252u; // xorshift: any spread-out numbers do
    for (int i = 0; i < 200000; i++) {
        s ^= s << 13;
        s ^= s >> 7;
        s ^= s << 17;
        char text[64];
        int digits = 1 + (int)(s % 21), exponent = (int)((s >> 8) % 80) - 50;
        if (i % 4 == 0) exponent = (int)((s >> 8) % 700) - 370;
        snprintf(text, sizeof text, "%.*e", digits - 1, (double)(s >> 11));
        char *e = strchr(text, 'e');
        snprintf(e, sizeof text - (size_t)(e - text), "e%d", exponent);
        double expected = strtod(text, NULL), x = 0;
        orr_field f = orr_view_real(V(text), &x);
        if (isinf(expected))
            assert_int_equal(f, ORR_FIELD_BAD);
        else if (f != ORR_FIELD_OK || x != expected)
            fail_msg("%s: %.17g, not %.17g", text, x, expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_long_line),
        cmocka_unit_test(test_columns),
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_integers),
        cmocka_unit_test(test_reals),
        cmocka_unit_test(test_reals_round_as_strtod),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
