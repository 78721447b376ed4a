// SPDX-License-Identifier: GPL-3.0-or-later
// Who may read the pages, and the lines that are kept for them.
#include "src/service/http/http_server.h"
#include "src/service/http/journal.h"
#include "testing.h"

static void own_names_alone(void **state)
{
    (void)state;
    static const char *const own[] = {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080", "[::1]:8080"};
    static const char *const others[] = {"",
                                         "127.0.0.1",
                                         "127.0.0.1:80",
                                         "127.0.0.1:80800",
                                         "127.0.0.1.example.com:8080",
                                         "localhost.example.com:8080",
                                         "example.com:8080",
                                         "127.0.0.2:8080",
                                         "null",
                                         " localhost:8080"};
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) assert_true(orr_http_is_own(own[k], 8080));
    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++)
        assert_false(orr_http_is_own(others[k], 8080));
    assert_true(orr_http_is_own("localhost", 80)); // browsers leave the usual port out
}

static void other_addresses_are_refused(void **state)
{
    (void)state;
    static const char *const bad[] = {"0.0.0.0:0", "*:0", "192.0.2.1:0", "127.0.0.1", "", "127.0.0.1:x"};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        orr_http_server *s = NULL;
        orr_diag diag = {0};
        assert_int_equal(orr_http_server_listen(bad[k], &s, &diag), ORR_E_ARG);
        assert_null(s);
        assert_true(diag.text[0] != '\0');
    }
}

// Each reader gets every line once, in order; who comes late gets what is kept.
static void lines_are_kept(void **state)
{
    (void)state;
    orr_journal *j = orr_journal_open();
    orr_journal_line l;
    assert_non_null(j);
    assert_false(orr_journal_next(j, 0, &l));
    for (int k = 1; k <= ORR_JOURNAL_LINES + 5; k++) {
        char text[32];
        snprintf(text, sizeof text, "line %d", k);
        orr_journal_write(j, ORR_LOG_WARN, text);
    }
    assert_true(orr_journal_next(j, 0, &l));
    assert_int_equal(l.number, 6);
    assert_string_equal(l.text, "line 6");
    uint64_t seen = 0, n = 0;
    for (; orr_journal_next(j, seen, &l); n++) {
        assert_true(l.number > seen);
        assert_int_equal(l.level, ORR_LOG_WARN);
        seen = l.number;
    }
    assert_int_equal(n, ORR_JOURNAL_LINES);
    assert_int_equal(seen, ORR_JOURNAL_LINES + 5);
    orr_journal_close(j);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(own_names_alone),
                                       cmocka_unit_test(other_addresses_are_refused),
                                       cmocka_unit_test(lines_are_kept)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
