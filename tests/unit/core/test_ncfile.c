// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <netcdf.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/ncfile.h"
#include "core/rng.h"

static const char *const DIMS[] = {"row", "column"};
enum { ROWS = 40, COLUMNS = 70 };

static double grid[ROWS][COLUMNS];

static orr_status write_sample(const char *path, orr_diag *d)
{
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < COLUMNS; j++) grid[i][j] = i * 1000.0 + j / 7.0;
    static const int64_t times[ROWS] = {INT64_MIN, -1, 0, INT64_C(1391040000000000000), INT64_MAX};
    static const uint8_t flags[ROWS] = {1, 2, 255};
    static const char names[ROWS][4] = {"G01", "G02"};
    const double range[2] = {-1.5, 2.5};
    const int64_t step = 900000000000;
    const orr_nc_input inputs[] = {{"/some/where/a.sp3", "00ff"}, {"b.sp3.gz", "11ee"}};
    static const char *const name_dims[] = {"row", "letters"};
    orr_nc_writer w;
    orr_status s = orr_nc_create(path, &w, d);
    if (s != ORR_OK) return s;
    (void)orr_nc_put_provenance(&w, "A sample", "made by a test", inputs, 2, d);
    (void)orr_nc_put_dim(&w, "row", ROWS, d);
    (void)orr_nc_put_dim(&w, "column", COLUMNS, d);
    (void)orr_nc_put_dim(&w, "letters", 4, d);
    (void)orr_nc_put_var(&w, "grid", ORR_NC_DOUBLE, 2, DIMS, grid, "m", "values on a grid", d);
    (void)orr_nc_put_var(&w, "time", ORR_NC_INT64, 1, DIMS, times, "ns", NULL, d);
    (void)orr_nc_put_var(&w, "flag", ORR_NC_UINT8, 1, DIMS, flags, NULL, NULL, d);
    (void)orr_nc_put_var(&w, "name", ORR_NC_CHAR, 2, name_dims, names, NULL, "names", d);
    (void)orr_nc_put_var(&w, "one", ORR_NC_INT32, 0, NULL, &(int32_t){42}, "1", "a scalar", d);
    (void)orr_nc_put_att_double(&w, "grid", "valid_range", range, 2, d);
    (void)orr_nc_put_att_double(&w, NULL, "radius_m", range, 1, d);
    (void)orr_nc_put_att_int64(&w, NULL, "step_ns", &step, 1, d);
    return orr_nc_commit(&w, d);
}

static void round_trip(void **state)
{
    (void)state;
    orr_diag d = {0};
    ASSERT_OK(write_sample("a.nc", &d), d);
    orr_nc_reader r;
    ASSERT_OK(orr_nc_open("a.nc", &r, &d), d);
    size_t shape[2];
    ASSERT_OK(orr_nc_get_dim(&r, "row", 1000, &shape[0], &d), d);
    ASSERT_OK(orr_nc_get_dim(&r, "column", COLUMNS, &shape[1], &d), d);
    assert_int_equal(shape[0], ROWS);
    double back[ROWS][COLUMNS];
    ASSERT_OK(orr_nc_get_var(&r, "grid", ORR_NC_DOUBLE, 2, shape, back, &d), d);
    assert_memory_equal(back, grid, sizeof grid);
    void *fresh;
    ASSERT_OK(orr_nc_alloc_var(&r, "time", ORR_NC_INT64, 1, shape, &fresh, &d), d);
    int64_t *times = fresh;
    assert_true(times[0] == INT64_MIN && times[3] == INT64_C(1391040000000000000) && times[4] == INT64_MAX);
    free(fresh);
    ASSERT_OK(orr_nc_alloc_var(&r, "flag", ORR_NC_UINT8, 1, shape, &fresh, &d), d);
    assert_int_equal(((uint8_t *)fresh)[2], 255);
    free(fresh);
    const size_t text_shape[2] = {ROWS, 4};
    ASSERT_OK(orr_nc_alloc_var(&r, "name", ORR_NC_CHAR, 2, text_shape, &fresh, &d), d);
    assert_string_equal((char *)fresh + 4, "G02");
    free(fresh);
    int32_t one;
    ASSERT_OK(orr_nc_get_var(&r, "one", ORR_NC_INT32, 0, NULL, &one, &d), d);
    assert_int_equal(one, 42);
    char text[64];
    double v;
    int64_t i;
    ASSERT_OK(orr_nc_get_att_text(&r, NULL, "Conventions", text, sizeof text, &d), d);
    assert_string_equal(text, "CF-1.9");
    ASSERT_OK(orr_nc_get_att_text(&r, NULL, "source", text, sizeof text, &d), d);
    assert_string_equal(text, "orrery " ORR_VERSION);
    ASSERT_OK(orr_nc_get_att_text(&r, NULL, "input_files", text, sizeof text, &d), d);
    assert_string_equal(text, "a.sp3\nb.sp3.gz"); // no folders
    ASSERT_OK(orr_nc_get_att_text(&r, NULL, "input_sha256", text, sizeof text, &d), d);
    assert_string_equal(text, "00ff\n11ee");
    ASSERT_OK(orr_nc_get_att_text(&r, "grid", "units", text, sizeof text, &d), d);
    assert_string_equal(text, "m");
    ASSERT_OK(orr_nc_get_att_double(&r, NULL, "radius_m", &v, &d), d);
    ASSERT_NEAR(v, -1.5, 0);
    ASSERT_OK(orr_nc_get_att_int64(&r, NULL, "step_ns", &i, &d), d);
    assert_true(i == INT64_C(900000000000));
    assert_true(orr_nc_has_var(&r, "grid"));
    assert_false(orr_nc_has_var(&r, "nothing"));
    orr_nc_close(&r);
    orr_nc_close(&r);
    remove("a.nc");
}

static void what_differs_is_refused_with_its_name(void **state)
{
    (void)state;
    orr_diag d = {0};
    ASSERT_OK(write_sample("a.nc", &d), d);
    orr_nc_reader r;
    ASSERT_OK(orr_nc_open("a.nc", &r, &d), d);
    size_t n, shape[4] = {ROWS, COLUMNS, 1, 1}, swapped[2] = {COLUMNS, ROWS};
    double buf[ROWS * COLUMNS];
    void *p;
    assert_int_equal(orr_nc_get_dim(&r, "nothing", 10, &n, &d), ORR_E_KIND);
    assert_non_null(strstr(d.text, "\"nothing\""));
    assert_int_equal(orr_nc_get_dim(&r, "row", ROWS - 1, &n, &d), ORR_E_LIMIT);
    assert_int_equal(orr_nc_get_var(&r, "nothing", ORR_NC_DOUBLE, 2, shape, buf, &d), ORR_E_KIND);
    assert_int_equal(orr_nc_get_var(&r, "grid", ORR_NC_DOUBLE, 1, shape, buf, &d), ORR_E_FORMAT);
    assert_int_equal(orr_nc_get_var(&r, "grid", ORR_NC_DOUBLE, 2, swapped, buf, &d), ORR_E_FORMAT);
    assert_int_equal(orr_nc_get_var(&r, "grid", ORR_NC_CHAR, 2, shape, buf, &d), ORR_E_FORMAT);
    assert_int_equal(orr_nc_get_var(&r, "name", ORR_NC_DOUBLE, 2, shape, buf, &d), ORR_E_FORMAT);
    assert_int_equal(orr_nc_alloc_var(&r, "time", ORR_NC_UINT8, 1, shape, &p, &d),
                     ORR_E_FORMAT); // does not fit
    assert_null(p);
    char text[64];
    double v;
    assert_int_equal(orr_nc_get_att_text(&r, NULL, "nothing", text, sizeof text, &d), ORR_E_NODATA);
    assert_int_equal(orr_nc_get_att_text(&r, "nothing", "units", text, sizeof text, &d), ORR_E_NODATA);
    assert_int_equal(orr_nc_get_att_text(&r, NULL, "input_files", text, 14, &d), ORR_E_LIMIT);
    ASSERT_OK(orr_nc_get_att_text(&r, NULL, "input_files", text, 15, &d), d);
    assert_int_equal(orr_nc_get_att_text(&r, NULL, "step_ns", text, sizeof text, &d), ORR_E_FORMAT);
    assert_int_equal(orr_nc_get_att_double(&r, "grid", "valid_range", &v, &d), ORR_E_FORMAT); // two numbers
    assert_int_equal(orr_nc_get_att_double(&r, NULL, "title", &v, &d), ORR_E_FORMAT);
    orr_nc_close(&r);
    remove("a.nc");
}

// A file whose dimensions promise terabytes, in a few hundred bytes.
static void a_bomb_is_not_unpacked(void **state)
{
    (void)state;
    int id, dim[2], var;
    assert_int_equal(nc_create("bomb.nc", NC_CLOBBER | NC_NETCDF4, &id), NC_NOERR);
    assert_int_equal(nc_def_dim(id, "row", 1u << 20, &dim[0]), NC_NOERR);
    assert_int_equal(nc_def_dim(id, "column", 1u << 20, &dim[1]), NC_NOERR);
    assert_int_equal(nc_def_var(id, "grid", NC_DOUBLE, 2, dim, &var), NC_NOERR);
    const size_t chunk[2] = {1024, 1024}; // chunks that no one has written take no room
    assert_int_equal(nc_def_var_chunking(id, var, NC_CHUNKED, chunk), NC_NOERR);
    assert_int_equal(nc_close(id), NC_NOERR);
    orr_nc_reader r;
    orr_diag d = {0};
    size_t n;
    void *p;
    ASSERT_OK(orr_nc_open("bomb.nc", &r, &d), d);
    assert_int_equal(orr_nc_get_dim(&r, "row", 100000, &n, &d), ORR_E_LIMIT);
    const size_t shape[2] = {1u << 20, 1u << 20};
    assert_int_equal(orr_nc_alloc_var(&r, "grid", ORR_NC_DOUBLE, 2, shape, &p, &d), ORR_E_LIMIT);
    orr_nc_close(&r);
    remove("bomb.nc");
}

static void put(const char *path, const void *bytes, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    if (n > 0) assert_int_equal(fwrite(bytes, 1, n, f), n);
    fclose(f);
}

static void other_kinds_are_named(void **state)
{
    (void)state;
    orr_nc_reader r;
    orr_diag d = {0};
    assert_int_equal(orr_nc_open("absent.nc", &r, &d), ORR_E_IO);
    assert_int_equal(orr_nc_open(".", &r, &d), ORR_E_IO);
    put("x.nc", "", 0);
    assert_int_equal(orr_nc_open("x.nc", &r, &d), ORR_E_KIND);
    put("x.nc", "#dP2024", 7);
    assert_int_equal(orr_nc_open("x.nc", &r, &d), ORR_E_KIND);
    put("x.nc", "\x89HDF\r\n\x1a\n", 8);
    assert_int_equal(orr_nc_open("x.nc", &r, &d), ORR_E_FORMAT);
    put("x.nc", "CDF\x01", 4);
    assert_int_equal(orr_nc_open("x.nc", &r, &d), ORR_E_FORMAT);
    orr_nc_close(&r); // nothing is open
    remove("x.nc");
}

// Opens and reads what the sample has; how it ends is the exit status of a child.
static int read_all(const char *path)
{
    orr_nc_reader r;
    orr_diag d = {0};
    orr_status s = orr_nc_open(path, &r, &d);
    size_t shape[2];
    void *p;
    if (s == ORR_OK) s = orr_nc_get_dim(&r, "row", 10000, &shape[0], &d);
    if (s == ORR_OK) s = orr_nc_get_dim(&r, "column", 10000, &shape[1], &d);
    if (s == ORR_OK) {
        s = orr_nc_alloc_var(&r, "grid", ORR_NC_DOUBLE, 2, shape, &p, &d);
        free(p);
    }
    orr_nc_close(&r);
    if (s != ORR_OK && d.text[0] == '\0') return 99;
    return (int)s;
}

static int read_in_child(const char *path)
{
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        alarm(20);
        _exit(read_all(path));
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!WIFEXITED(status)) fail_msg("%s: died of signal %d", path, WTERMSIG(status));
    return WEXITSTATUS(status);
}

static unsigned char bytes[1 << 20], hurt[1 << 20];

static size_t load(const char *path)
{
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t n = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    assert_true(n > 1000 && n < sizeof bytes);
    return n;
}

// Any byte changed and any cut is found, before HDF5 is let near it.
static void damaged_files_are_refused(void **state)
{
    (void)state;
    orr_diag d = {0};
    ASSERT_OK(write_sample("a.nc", &d), d);
    size_t n = load("a.nc");
    const size_t seal = 80; // the last line
    for (uint64_t k = 0; k < 400; k++) {
        memcpy(hurt, bytes, n);
        hurt[orr_rng_u64(21, 0, k) % (n - seal)] ^= (unsigned char)(1 + orr_rng_u64(21, 1, k) % 255);
        put("hurt.nc", hurt, n);
        orr_nc_reader r;
        orr_status s = orr_nc_open("hurt.nc", &r, &d);
        if (s == ORR_OK) fail_msg("round %d was opened", (int)k);
        assert_true(s == ORR_E_FORMAT || s == ORR_E_KIND); // kind: the first bytes
    }
    for (uint64_t k = 0; k < 60; k++) {
        put("hurt.nc", bytes, (size_t)(orr_rng_u64(22, 0, k) % (n - seal)));
        int s = read_in_child("hurt.nc");
        assert_true(s == ORR_E_FORMAT || s == ORR_E_KIND);
    }
    remove("hurt.nc");
    remove("a.nc");
}

// The seal is one line that others read past; a file without one, from another program, is read as well.
static void seals_do_not_keep_others_out(void **state)
{
    (void)state;
    orr_diag d = {0};
    ASSERT_OK(write_sample("a.nc", &d), d);
    size_t n = load("a.nc");
    assert_memory_equal(bytes + n - 80, "\norrery-sha256 ", 15);
    assert_int_equal(bytes[n - 1], '\n');
    put("open.nc", bytes, n - 80);
    assert_int_equal(read_in_child("open.nc"), ORR_OK);
    assert_true(orr_nc_is_sealed("a.nc") && !orr_nc_is_sealed("open.nc"));
    for (size_t left = 1; left < 80;
         left += 13) { // a part of a seal is none that could be missing: the file is cut
        put("cut.nc", bytes, n - 80 + left);
        assert_true(orr_nc_is_sealed("cut.nc"));
        assert_int_equal(read_in_child("cut.nc"), ORR_E_FORMAT);
    }
    remove("cut.nc");
    int id;
    assert_int_equal(nc_open("a.nc", NC_NOWRITE, &id), NC_NOERR); // the library alone
    assert_int_equal(nc_close(id), NC_NOERR);
    // changed on purpose by another program, it loses its seal and is still read
    assert_int_equal(nc_open("a.nc", NC_WRITE, &id), NC_NOERR);
    assert_int_equal(nc_put_att_text(id, NC_GLOBAL, "title", 8, "Replaced"), NC_NOERR);
    assert_int_equal(nc_close(id), NC_NOERR);
    assert_int_equal(read_in_child("a.nc"), ORR_OK);
    if (system("command -v ncdump >/dev/null") == 0) {
        put("a.nc", bytes, n);
        assert_int_equal(system("ncdump a.nc > dump.txt"), 0);
        remove("dump.txt");
    }
    remove("open.nc");
    remove("a.nc");
}

static void failures_leave_nothing(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_nc_writer w;
    assert_int_equal(orr_nc_create("no/such/folder/a.nc", &w, &d), ORR_E_IO);
    orr_nc_abort(&w);
    put("old.nc", "old", 3);
    ASSERT_OK(orr_nc_create("old.nc", &w, &d), d);
    char temp[256];
    snprintf(temp, sizeof temp, "%s", w.file.temp);
    assert_int_equal(orr_nc_put_dim(&w, "row", 0, &d), ORR_E_ARG);
    orr_diag first = d;
    // the first failure stands, and the file is not put in place
    assert_int_equal(orr_nc_put_dim(&w, "column", 5, &d), ORR_E_ARG);
    assert_int_equal(orr_nc_commit(&w, &d), ORR_E_ARG);
    assert_string_equal(d.text, first.text);
    assert_int_equal(access(temp, F_OK), -1);
    assert_int_equal(access("old.nc", F_OK), 0);
    ASSERT_OK(orr_nc_create("old.nc", &w, &d), d);
    ASSERT_OK(orr_nc_put_dim(&w, "row", 3, &d), d);
    assert_int_equal(orr_nc_put_var(&w, "v", ORR_NC_DOUBLE, 2, DIMS, grid, NULL, NULL, &d),
                     ORR_E_IO); // no "column"
    assert_non_null(strstr(d.text, "column"));
    orr_nc_abort(&w);
    orr_nc_abort(&w);
    assert_int_equal(orr_nc_put_dim(&w, "row", 3, &d), ORR_E_ARG);
    remove("old.nc");
}

static int enter(void **state)
{
    (void)state;
    static char folder[] = "ncfile-XXXXXX";
    *state = mkdtemp(folder);
    return *state != NULL && chdir(*state) == 0 ? 0 : -1;
}

static int leave(void **state) { return chdir("..") == 0 && rmdir(*state) == 0 ? 0 : -1; }

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_trip),
        cmocka_unit_test(what_differs_is_refused_with_its_name),
        cmocka_unit_test(a_bomb_is_not_unpacked),
        cmocka_unit_test(other_kinds_are_named),
        cmocka_unit_test(damaged_files_are_refused),
        cmocka_unit_test(seals_do_not_keep_others_out),
        cmocka_unit_test(failures_leave_nothing),
    };
    return cmocka_run_group_tests(tests, enter, leave);
}
