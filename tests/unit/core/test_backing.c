// SPDX-License-Identifier: GPL-3.0-or-later
// Memory in a file without a name: what was written stays when its pages are let go of, and nothing is left in the folder.
#include "testing.h"

#include <dirent.h>
#include <unistd.h>

#include "core/backing.h"

static char folder[256];

static size_t entries(void)
{
    size_t n = 0;
    DIR *d = opendir(folder);
    assert_non_null(d);
    while (readdir(d) != NULL) n++;
    closedir(d);
    return n;
}

static long resident_pages(void)
{
    long all, resident;
    FILE *f = fopen("/proc/self/statm", "r");
    if (f == NULL) return -1;
    const int n = fscanf(f, "%ld %ld", &all, &resident);
    fclose(f);
    return n == 2 ? resident : -1;
}

static void what_was_written_stays(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_backing *b;
    snprintf(folder, sizeof folder, "%s/backing-XXXXXX",
             getenv("TMPDIR") != NULL ? getenv("TMPDIR") : "/tmp");
    assert_non_null(mkdtemp(folder));
    const size_t before = entries(), n = (size_t)4 << 20;
    ASSERT_OK(orr_backing_open(folder, &b, &d), d);
    assert_int_equal(entries(), before);
    uint32_t *first = orr_backing_take(b, n * sizeof *first),
             *second = orr_backing_take(b, n * sizeof *second);
    assert_non_null(first);
    assert_non_null(second);
    for (size_t i = 0; i < n; i += 1000) assert_true(first[i] == 0 && second[i] == 0);
    for (size_t i = 0; i < n; i++) first[i] = (uint32_t)i, second[i] = ~(uint32_t)i;
    const long full = resident_pages();
    orr_backing_rest(b);
    const long rested = resident_pages();
    if (full > 0)
        assert_true((full - rested) * sysconf(_SC_PAGESIZE) > (long)(n * sizeof *first)); // of 32 MB
    for (size_t i = 0; i < n; i += 7) assert_true(first[i] == (uint32_t)i && second[i] == ~(uint32_t)i);
    orr_backing_free(b);
    assert_int_equal(entries(), before);
    assert_int_equal(rmdir(folder), 0);
}

static void a_folder_that_is_not_there_is_told(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_backing *b;
    assert_int_equal(orr_backing_open("/no/such/folder", &b, &d), ORR_E_IO);
    assert_non_null(strstr(d.text, "/no/such/folder"));
    assert_null(b);
    orr_backing_rest(NULL);
    orr_backing_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_stays),
        cmocka_unit_test(a_folder_that_is_not_there_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
