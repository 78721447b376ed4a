// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/sat.h"

static void text_and_back_for_every_satellite(void **state)
{
    (void)state;
    orr_sat before = ORR_SAT_NONE;
    for (const char *s = ORR_SYSTEMS; *s != '\0'; s++) {
        for (int n = 1; n <= 99; n++) {
            orr_sat sat = orr_sat_make(*s, n);
            char buf[ORR_SAT_TEXT];
            assert_true(sat > before); // the order of values is the order of tables
            before = sat;
            assert_int_equal(orr_sat_parse(orr_sat_text(sat, buf)), sat);
            assert_int_equal(orr_sat_parse3(buf, 0), sat);
            assert_int_equal(orr_sat_system(sat), *s);
            assert_int_equal(orr_sat_number(sat), n);
            assert_int_equal(ORR_SYSTEMS[orr_sat_system_index(sat)], *s);
        }
    }
    char buf[ORR_SAT_TEXT];
    assert_string_equal(orr_sat_text(ORR_SAT_NONE, buf), "---");
    assert_string_equal(orr_sat_text((orr_sat)0xffff, buf), "---");
    assert_int_equal(orr_sat_system(ORR_SAT_NONE), '?');
    assert_string_equal(orr_system_name('R'), "GLONASS");
    assert_string_equal(orr_system_name('X'), "?");
    assert_string_equal(orr_system_name('\0'), "?");
}

static void what_is_no_satellite_is_none(void **state)
{
    (void)state;
    const char *bad[] = {"", "G", "G0", "G00", "G100", "X05", "05", "G5x", "G 5", "G-5", "GG5", " G05"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_int_equal(orr_sat_parse(bad[i]), ORR_SAT_NONE);
    assert_int_equal(orr_sat_make('G', 0), ORR_SAT_NONE);
    assert_int_equal(orr_sat_make('G', 100), ORR_SAT_NONE);
    assert_int_equal(orr_sat_make('\0', 5), ORR_SAT_NONE);
    assert_int_equal(orr_sat_parse("g5"), orr_sat_make('G', 5));
}

static void three_columns_as_files_have_them(void **state)
{
    (void)state;
    assert_int_equal(orr_sat_parse3("G05", 0), orr_sat_make('G', 5));
    assert_int_equal(orr_sat_parse3("G 5", 0), orr_sat_make('G', 5));
    assert_int_equal(orr_sat_parse3("  5", 'G'), orr_sat_make('G', 5)); // SP3-a, RINEX 2
    assert_int_equal(orr_sat_parse3(" 15", 'R'), orr_sat_make('R', 15));
    assert_int_equal(orr_sat_parse3("  5", 0), ORR_SAT_NONE);
    assert_int_equal(orr_sat_parse3("G00", 0), ORR_SAT_NONE);
    assert_int_equal(orr_sat_parse3("  0", 'G'), ORR_SAT_NONE); // SP3 fills its list with zeros
    assert_int_equal(orr_sat_parse3("G5 ", 0), ORR_SAT_NONE);
    assert_int_equal(orr_sat_parse3("\0\0\0", 0), ORR_SAT_NONE);
}

static int count(const orr_sat_set *set, char system)
{
    int n = 0;
    for (int i = 1; i <= 99; i++) n += orr_sat_set_has(set, orr_sat_make(system, i)) ? 1 : 0;
    return n;
}

static void lists_of_users(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_sat_set set;
    ASSERT_OK(orr_sat_set_parse("G05,R,E01-E09, e12-14 ,C60", &set, &d), d);
    assert_int_equal(count(&set, 'G'), 1);
    assert_int_equal(count(&set, 'R'), 99);
    assert_int_equal(count(&set, 'E'), 12);
    assert_int_equal(count(&set, 'C'), 1);
    assert_int_equal(count(&set, 'J'), 0);
    assert_true(orr_sat_set_has(&set, orr_sat_make('C', 60)));
    assert_false(orr_sat_set_has(&set, ORR_SAT_NONE));
    ASSERT_OK(orr_sat_set_parse("all", &set, &d), d);
    for (const char *s = ORR_SYSTEMS; *s != '\0'; s++) assert_int_equal(count(&set, *s), 99);

    const char *bad[] = {"", ",", "G05,", "X", "G05;R", "E09-E01", "E01-G05", "G0", "G100", "E01-", "all5"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        d = (orr_diag){0};
        assert_int_equal(orr_sat_set_parse(bad[i], &set, &d), ORR_E_ARG);
        assert_non_null(strstr(d.text, "satellite list"));
    }
    orr_sat_set empty = {0};
    assert_int_equal(count(&empty, 'G'), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_and_back_for_every_satellite),
        cmocka_unit_test(what_is_no_satellite_is_none),
        cmocka_unit_test(three_columns_as_files_have_them),
        cmocka_unit_test(lists_of_users),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
