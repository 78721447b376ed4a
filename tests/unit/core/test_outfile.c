// SPDX-License-Identifier: GPL-3.0-or-later
// Files whole or not at all, and their SHA-256.
#include "testing.h"

#include <dirent.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/outfile.h"
#include "core/sha256.h"

static char folder[64];

static int enter(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "outfile-XXXXXX");
    return mkdtemp(folder) != NULL && chdir(folder) == 0 ? 0 : -1;
}

static int count_files(void)
{
    int n = 0;
    DIR *d = opendir(".");
    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d)) != NULL;) n += e->d_name[0] != '.' ? 1 : 0;
    closedir(d);
    return n;
}

static int leave(void **state)
{
    (void)state;
    DIR *d = opendir(".");
    if (d == NULL) return -1;
    for (struct dirent *e; (e = readdir(d)) != NULL;)
        if (e->d_name[0] != '.' && unlink(e->d_name) != 0) rmdir(e->d_name);
    closedir(d);
    return chdir("..") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

static void put(const char *path, const char *text)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void assert_holds(const char *path, const char *text)
{
    char buf[256] = "";
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t n = fread(buf, 1, sizeof buf - 1, f);
    buf[n] = '\0';
    fclose(f);
    assert_string_equal(buf, text);
}

static void old_file_stands_until_commit(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    put("a.txt", "old");
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    fputs("new", f.stream);
    fflush(f.stream);
    assert_holds("a.txt", "old");
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    assert_holds("a.txt", "new");
    assert_int_equal(count_files(), 1);
    orr_outfile_abort(&f); // harmless after commit
    assert_holds("a.txt", "new");
}

static void abort_leaves_nothing(void **state)
{
    (void)state;
    orr_outfile f, g;
    orr_diag d = {0};
    put("a.txt", "old");
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    ASSERT_OK(orr_outfile_open("a.txt", &g, &d), d); // two at a time do not meet
    assert_string_not_equal(f.temp, g.temp);
    fputs("half", f.stream);
    orr_outfile_abort(&f);
    orr_outfile_abort(&f);
    orr_outfile_abort(&g);
    assert_holds("a.txt", "old");
    assert_int_equal(count_files(), 1);
    ASSERT_OK(orr_outfile_open("fresh.txt", &f, &d), d);
    orr_outfile_abort(&f);
    assert_int_equal(access("fresh.txt", F_OK), -1);
}

static void an_end_is_by_the_status_of_writing(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    put("a.txt", "old");
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    fputs("half", f.stream);
    assert_int_equal(orr_outfile_end(&f, ORR_E_RANGE, &d), ORR_E_RANGE);
    assert_holds("a.txt", "old");
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    fputs("new", f.stream);
    ASSERT_OK(orr_outfile_end(&f, ORR_OK, &d), d);
    assert_holds("a.txt", "new");
    assert_int_equal(orr_outfile_end(&f, ORR_OK, &d), ORR_E_ARG); // it has ended
    assert_int_equal(count_files(), 1);
}

static void modes_follow_the_umask_or_the_old_file(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    struct stat st;
    mode_t old = umask(027);
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    umask(old);
    assert_int_equal(stat("a.txt", &st), 0);
    assert_int_equal(st.st_mode & 0777, 0640);
    assert_int_equal(chmod("a.txt", 0600), 0);
    ASSERT_OK(orr_outfile_open("a.txt", &f, &d), d);
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    assert_int_equal(stat("a.txt", &st), 0);
    assert_int_equal(st.st_mode & 0777, 0600);
}

static void a_link_stays_a_link(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    struct stat st;
    put("real.txt", "old");
    assert_int_equal(symlink("real.txt", "link.txt"), 0);
    ASSERT_OK(orr_outfile_open("link.txt", &f, &d), d);
    fputs("new", f.stream);
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    assert_int_equal(lstat("link.txt", &st), 0);
    assert_true(S_ISLNK(st.st_mode));
    assert_holds("real.txt", "new");
}

static void a_device_is_written_and_not_replaced(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    struct stat st;
    ASSERT_OK(orr_outfile_open("/dev/null", &f, &d), d);
    fputs("gone", f.stream);
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    assert_int_equal(stat("/dev/null", &st), 0);
    assert_true(S_ISCHR(st.st_mode));
    assert_int_equal(orr_outfile_reserve("/dev/null", &f, &d), ORR_E_IO);
}

static void full_disk_is_an_error_and_not_a_file(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    if (access("/dev/full", W_OK) != 0) skip();
    ASSERT_OK(orr_outfile_open("/dev/full", &f, &d), d);
    fputs("more than fits", f.stream);
    assert_int_equal(orr_outfile_commit(&f, &d), ORR_E_IO);
    assert_non_null(strstr(d.text, "cannot be written"));
}

static void reserved_name_for_a_library(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    ASSERT_OK(orr_outfile_reserve("a.bin", &f, &d), d);
    assert_null(f.stream);
    put(f.temp, "by a library");
    assert_int_equal(access("a.bin", F_OK), -1);
    ASSERT_OK(orr_outfile_commit(&f, &d), d);
    assert_holds("a.bin", "by a library");
    ASSERT_OK(orr_outfile_reserve("a.bin", &f, &d), d);
    unlink(f.temp); // the library failed and cleaned up
    assert_int_equal(orr_outfile_commit(&f, &d), ORR_E_IO);
    assert_holds("a.bin", "by a library");
    assert_int_equal(orr_outfile_reserve("-", &f, &d), ORR_E_UNSUPPORTED);
}

static void impossible_places_get_a_sentence(void **state)
{
    (void)state;
    orr_outfile f;
    orr_diag d = {0};
    assert_int_equal(orr_outfile_open("no/such/folder/a.txt", &f, &d), ORR_E_IO);
    assert_string_equal(d.file, "no/such/folder/a.txt");
    assert_non_null(strstr(d.text, "No such file or directory"));
    assert_int_equal(orr_outfile_open(".", &f, &d), ORR_E_IO);
    assert_non_null(strstr(d.text, "is a folder"));
    assert_int_equal(orr_outfile_open("", &f, &d), ORR_E_ARG);
    assert_int_equal(orr_outfile_commit(&f, &d), ORR_E_ARG);
    orr_outfile_abort(&f);
}

static int without_permission(void)
{
    orr_outfile f;
    orr_diag d = {0};
    if (geteuid() == 0 && setuid(65534) != 0) return 77;
    if (orr_outfile_open("locked/a.txt", &f, &d) != ORR_E_IO || strstr(d.text, "Permission denied") == NULL)
        return 1;
    if (orr_outfile_open("kept.txt", &f, &d) != ORR_E_IO || strstr(d.text, "cannot be replaced") == NULL)
        return 2;
    return 0;
}

// In a child that has given up root's rights, where it had them.
static void forbidden_places_get_a_sentence(void **state)
{
    (void)state;
    assert_int_equal(mkdir("locked", 0555), 0);
    assert_int_equal(chmod(".", 0777), 0);
    put("kept.txt", "read only");
    assert_int_equal(chmod("kept.txt", 0444), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) _exit(without_permission());
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) skip();
    assert_int_equal(WEXITSTATUS(status), 0);
}

static void sums_of_the_standard(void **state)
{
    (void)state;
    char hex[ORR_SHA256_HEX];
    orr_diag d = {0};
    // FIPS 180-4 examples
    ASSERT_OK(orr_sha256_bytes("abc", 3, hex, &d), d);
    assert_string_equal(hex, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    ASSERT_OK(orr_sha256_bytes("", 0, hex, &d), d);
    assert_string_equal(hex, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    FILE *f = fopen("million.txt", "wb"); // a million letters a
    assert_non_null(f);
    for (int i = 0; i < 1000000; i++) putc('a', f);
    fclose(f);
    ASSERT_OK(orr_sha256_file("million.txt", hex, &d), d);
    assert_string_equal(hex, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    assert_int_equal(orr_sha256_file("absent", hex, &d), ORR_E_IO);
    assert_int_equal(orr_sha256_file(".", hex, &d), ORR_E_IO); // a folder opens, and cannot be read
}

#define IN_FOLDER(f) cmocka_unit_test_setup_teardown(f, enter, leave)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(old_file_stands_until_commit),
        IN_FOLDER(abort_leaves_nothing),
        IN_FOLDER(an_end_is_by_the_status_of_writing),
        IN_FOLDER(modes_follow_the_umask_or_the_old_file),
        IN_FOLDER(a_link_stays_a_link),
        IN_FOLDER(a_device_is_written_and_not_replaced),
        IN_FOLDER(full_disk_is_an_error_and_not_a_file),
        IN_FOLDER(reserved_name_for_a_library),
        IN_FOLDER(impossible_places_get_a_sentence),
        IN_FOLDER(forbidden_places_get_a_sentence),
        IN_FOLDER(sums_of_the_standard),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
