// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/log.h"
#include "core/status.h"

static void every_status_has_its_name(void **state)
{
    (void)state;
    for (int a = ORR_OK; a <= ORR_E_INTERRUPTED; a++) {
        assert_string_not_equal(orr_status_name((orr_status)a), "unknown status");
        for (int b = ORR_OK; b < a; b++)
            assert_string_not_equal(orr_status_name((orr_status)a), orr_status_name((orr_status)b));
    }
    assert_string_equal(orr_status_name((orr_status)999), "unknown status");
}

static void diagnostic_shows_the_parts_it_has(void **state)
{
    (void)state;
    orr_diag d = {0};
    char buf[1024];
    assert_int_equal(orr_diag_set(&d, ORR_E_ARG, "step %d s is negative", -3), ORR_E_ARG);
    assert_int_equal(d.status, ORR_E_ARG);
    assert_string_equal(orr_diag_format(&d, buf, sizeof buf), "step -3 s is negative");
    orr_diag_at(&d, ORR_E_FORMAT, "a.sp3", 12, 5, "no number");
    assert_string_equal(orr_diag_format(&d, buf, sizeof buf), "a.sp3:12:5: no number");
    orr_diag_at(&d, ORR_E_FORMAT, "a.sp3", 12, 0, "no number");
    assert_string_equal(orr_diag_format(&d, buf, sizeof buf), "a.sp3:12: no number");
    orr_diag_at(&d, ORR_E_IO, "a.sp3", 0, 0, "is gone");
    assert_string_equal(orr_diag_format(&d, buf, sizeof buf), "a.sp3: is gone");
    orr_diag_at(&d, ORR_E_FORMAT, NULL, 7, 0, "no number");
    assert_string_equal(orr_diag_format(&d, buf, sizeof buf), "line 7: no number");
    assert_int_equal(orr_diag_set(NULL, ORR_E_IO, "nobody listens"), ORR_E_IO);
}

static void long_texts_are_cut_and_say_so(void **state)
{
    (void)state;
    orr_diag d = {0};
    char name[1000], buf[64];
    memset(name, 'n', sizeof name - 1);
    memcpy(name + sizeof name - 5, ".sp3", 5);
    orr_diag_at(&d, ORR_E_IO, name, 1, 1, "%s", name);
    assert_int_equal(strlen(d.file), sizeof d.file - 1);
    assert_memory_equal(d.file, "...", 3);
    assert_string_equal(d.file + strlen(d.file) - 4, ".sp3");
    assert_int_equal(strlen(d.text), sizeof d.text - 1);
    assert_string_equal(d.text + strlen(d.text) - 3, "...");
    orr_diag_format(&d, buf, sizeof buf);
    assert_int_equal(strlen(buf), sizeof buf - 1);
}

static void warnings_are_all_counted_and_the_first_kept(void **state)
{
    (void)state;
    orr_warnings w = {0};
    for (int i = 0; i < 200; i++) orr_warnings_add(&w, "f", i + 1, 0, "warning %d", i);
    assert_int_equal(w.count, 200);
    assert_int_equal(w.kept, ORR_WARNINGS_KEPT);
    assert_string_equal(w.item[63].text, "warning 63");
    assert_int_equal(w.item[63].line, 64);
    orr_warnings_free(&w);
    assert_null(w.item);
    orr_warnings_add(NULL, "f", 1, 1, "nobody listens");
}

struct heard {
    int n;
    orr_log_level level;
    char line[2048];
};

static void hear(void *user, orr_log_level level, const char *line)
{
    struct heard *h = user;
    h->n++;
    h->level = level;
    snprintf(h->line, sizeof h->line, "%s", line);
}

static int evaluated;
static int costly(void) { return ++evaluated; }

static void log_looks_at_the_level_before_the_arguments(void **state)
{
    (void)state;
    struct heard h = {0};
    orr_log log = {ORR_LOG_WARN, hear, &h};
    ORR_LOG(&log, ORR_LOG_INFO, "%d", costly());
    ORR_LOG((orr_log *)NULL, ORR_LOG_ERROR, "%d", costly());
    assert_int_equal(evaluated, 0);
    assert_int_equal(h.n, 0);
    ORR_LOG(&log, ORR_LOG_WARN, "disk %s", "full");
    assert_int_equal(h.n, 1);
    assert_int_equal(h.level, ORR_LOG_WARN);
    assert_string_equal(h.line, "disk full");
    char big[1500];
    memset(big, 'x', sizeof big - 1);
    big[sizeof big - 1] = '\0';
    ORR_LOG(&log, ORR_LOG_ERROR, "%s", big);
    assert_int_equal(strlen(h.line), 1023);
    assert_string_equal(h.line + 1020, "...");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_its_name),
        cmocka_unit_test(diagnostic_shows_the_parts_it_has),
        cmocka_unit_test(long_texts_are_cut_and_say_so),
        cmocka_unit_test(warnings_are_all_counted_and_the_first_kept),
        cmocka_unit_test(log_looks_at_the_level_before_the_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
