// SPDX-License-Identifier: GPL-3.0-or-later
// Every published SP3 file at hand: nothing to complain of, the counts of a plain walk over its lines, every
// number as strtod reads it, and the same again after writing.
#include "testing.h"

#include <dirent.h>
#include <sys/stat.h>

#include "core/nan.h"
#include "ingest/input/input.h"
#include "ingest/inspect/inspect.h"
#include "ingest/sp3/sp3.h"

typedef struct tally {
    size_t files, records;
} tally;

static orr_diag diag;

// What a person with grep would find: no use is made of the cursor or of the header.
typedef struct plain_count {
    size_t epochs, sats, positions;
    char id[999][4];
} plain_count;

static plain_count count_lines(const char *text)
{
    static plain_count c;
    c = (plain_count){0};
    for (const char *p = text; p != NULL && *p != '\0'; p = strchr(p, '\n'), p = p != NULL ? p + 1 : p) {
        if (strncmp(p, "EOF", 3) == 0) break;
        if (*p == '*') c.epochs++;
        if (*p != 'P') continue;
        c.positions++;
        size_t i = 0;
        while (i < c.sats && strncmp(c.id[i], p + 1, 3) != 0) i++;
        if (i == c.sats) strncpy(c.id[c.sats++], p + 1, 3);
    }
    return c;
}

static double number(const char *line, int col, double missing)
{
    char field[15] = {0};
    memcpy(field, line + col - 1, 14);
    double v = strtod(field, NULL);
    return fabs(v) >= missing ? ORR_NAN : v;
}

// a is what we read, b = km or microseconds as strtod reads them, times a power of ten: one more rounding.
static bool agrees(double a, double b) { return (isnan(a) && isnan(b)) || fabs(a - b) <= 4e-16 * fabs(b); }

static void check_numbers(const orr_sp3 *o, const char *text)
{
    size_t e = 0;
    bool first = true;
    for (const char *p = text; p != NULL && *p != '\0'; p = strchr(p, '\n'), p = p != NULL ? p + 1 : p) {
        if (*p == '*') {
            e += first ? 0 : 1;
            first = false;
        }
        if (*p != 'P' && *p != 'V') continue;
        char id[4] = {p[1] == ' ' ? 'G' : p[1], p[2] == ' ' ? '0' : p[2], p[3], '\0'};
        size_t s = 0;
        while (o->sat[s] != orr_sat_parse(id)) s++;
        const orr_sp3_record *r = &o->record[e * o->n_sats + s];
        double x = number(p, 5, 1e9), y = number(p, 19, 1e9), z = number(p, 33, 1e9),
               c = number(p, 47, 999999);
        if (x == 0 && y == 0 && z == 0) x = y = z = ORR_NAN;
        const double *xyz = *p == 'P' ? r->pos_m : r->vel_mps;
        double unit = *p == 'P' ? 1e3 : 0.1;
        if (!agrees(xyz[0], x * unit) || !agrees(xyz[1], y * unit) || !agrees(xyz[2], z * unit) ||
            !agrees(*p == 'P' ? r->clock_s : r->clock_rate_sps, *p == 'P' ? c * 1e-6 : c * 1e-10))
            fail_msg("%.60s: %.17g %.17g %.17g", p, xyz[0], xyz[1], xyz[2]);
    }
}

static void check_again(const orr_sp3 *a)
{
    char *text = NULL;
    size_t n = 0;
    orr_sp3 b;
    FILE *f = open_memstream(&text, &n);
    ASSERT_OK(orr_sp3_print(a, f, &diag), diag);
    fclose(f);
    orr_warnings w = {0};
    ASSERT_OK(orr_sp3_parse("again", text, n, NULL, &b, &w, &diag), diag);
    assert_int_equal(w.count, 0);
    assert_int_equal(b.n_sats, a->n_sats);
    assert_int_equal(b.n_epochs, a->n_epochs);
    assert_memory_equal(b.epoch, a->epoch, a->n_epochs * sizeof *a->epoch);
    assert_memory_equal(b.sat, a->sat, a->n_sats * sizeof *a->sat);
    assert_memory_equal(b.accuracy_exp, a->accuracy_exp, a->n_sats);
    assert_string_equal(b.agency, a->agency);
    for (size_t i = 0; i < a->n_sats * a->n_epochs; i++) {
        const orr_sp3_record *x = &a->record[i], *y = &b.record[i];
        for (int k = 0; k < 3; k++) {
            assert_true(agrees(x->pos_m[k], y->pos_m[k]) && agrees(x->vel_mps[k], y->vel_mps[k]));
            assert_true(agrees((double)x->pos_sdev_m[k], (double)y->pos_sdev_m[k]));
        }
        assert_true(agrees(x->clock_s, y->clock_s) && agrees(x->clock_rate_sps, y->clock_rate_sps));
        assert_true(agrees((double)x->clock_sdev_s, (double)y->clock_sdev_s));
        assert_int_equal(x->flags, y->flags);
    }
    free(text);
    orr_warnings_free(&w);
    orr_sp3_free(&b);
}

static void check_file(const char *path, tally *t)
{
    orr_bytes b;
    if (orr_input_read_all(path, NULL, &b, &diag) != ORR_OK) return; // no text: not of ours
    if (orr_sniff((orr_view){b.text, b.n}).kind == ORR_KIND_SP3) {
        orr_sp3 o;
        orr_warnings w = {0};
        ASSERT_OK(orr_sp3_parse(path, b.text, b.n, NULL, &o, &w, &diag), diag);
        if (w.count > 0) fail_msg("%s: %s", path, w.item[0].text);
        plain_count c = count_lines(b.text);
        size_t with_records = 0, records = 0;
        for (size_t s = 0; s < o.n_sats; s++) {
            with_records += o.n_records[s] > 0;
            records += o.n_records[s];
        }
        if (c.epochs != o.n_epochs || c.sats != with_records || c.positions != records)
            fail_msg("%s: %zu epochs, %zu satellites, %zu records; a count of lines gives %zu, %zu, %zu",
                     path, o.n_epochs, with_records, records, c.epochs, c.sats, c.positions);
        check_numbers(&o, b.text);
        check_again(&o);
        orr_inspection r;
        ASSERT_OK(orr_inspect(path, NULL, &r, &diag), diag);
        assert_int_equal(r.satellites, (int64_t)c.sats);
        assert_int_equal(r.epochs, (int64_t)c.epochs);
        assert_int_equal(r.gaps, 0);
        orr_inspection_free(&r);
        t->files++;
        t->records += records;
        orr_sp3_free(&o);
        orr_warnings_free(&w);
    }
    orr_bytes_free(&b);
}

static void walk(const char *folder, tally *t)
{
    DIR *d = opendir(folder);
    if (d == NULL) return;
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        char path[1024];
        struct stat st;
        // Not all bytes of a folder of a day are orbits; names of orbit files have one of these in them.
        static const char *const words[] = {"SP3", "sp3", "EPH"};
        if (e->d_name[0] == '.' || strcmp(e->d_name, "odd") == 0) continue;
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (stat(path, &st) != 0) continue;
        if (S_ISDIR(st.st_mode)) walk(path, t);
        for (size_t i = 0; S_ISREG(st.st_mode) && i < 3; i++)
            if (strstr(e->d_name, words[i]) != NULL) {
                check_file(path, t);
                break;
            }
    }
    closedir(d);
}

static void test_every_file(void **state)
{
    (void)state;
    char path[512];
    if (!orr_test_data("README.md", path, sizeof path)) SKIP_NO_DATA("README.md");
    *strrchr(path, '/') = '\0';
    tally t = {0};
    walk(path, &t);
    print_message("%zu files, %zu records\n", t.files, t.records);
    assert_true(t.files >= 10);
}

// What is known of single files from other sources.
static void test_known_facts(void **state)
{
    (void)state;
    char path[512];
    const char *name = "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz";
    if (!orr_test_data(name, path, sizeof path)) SKIP_NO_DATA(name);
    orr_sp3 o;
    ASSERT_OK(orr_sp3_read(path, NULL, &o, NULL, &diag), diag);
    assert_true(o.epoch[0] == orr_time_from_week(2300, 0));
    assert_true(o.epoch[288] == orr_time_from_week(2300, 86400 * ORR_NS_PER_S)); // 24:00 inclusive
    assert_string_equal(o.coordinates, "IGS20");
    orr_sp3_free(&o);
    // An ultra-rapid: the second day is predicted, and says so on every record.
    if (!orr_test_data("ultra/igu16295_00.sp3.gz", path, sizeof path)) SKIP_NO_DATA("ultra");
    ASSERT_OK(orr_sp3_read(path, NULL, &o, NULL, &diag), diag);
    for (size_t i = 0; i < o.n_epochs * o.n_sats; i++)
        assert_int_equal((o.record[i].flags & ORR_SP3_ORBIT_PREDICTED) != 0, i / o.n_sats >= 96);
    orr_sp3_free(&o);
    // Velocities are the derivative of the positions.
    if (!orr_test_data("2015-200-velocity/test_input_sp3_nav_2015_200.sp3.gz", path, sizeof path))
        SKIP_NO_DATA("NGA");
    ASSERT_OK(orr_sp3_read(path, NULL, &o, NULL, &diag), diag);
    assert_true(o.has_velocity);
    for (size_t e = 1; e + 1 < o.n_epochs; e++) {
        const orr_sp3_record *r = &o.record[e * o.n_sats];
        for (int k = 0; k < 3; k++) {
            double v = (r[o.n_sats].pos_m[k] - (r - o.n_sats)->pos_m[k]) / 600;
            // Central difference: h^2/6 of the third derivative, 9e4/6 s^2 x 4 km/s (1.5e-4/s)^2 is below 2
            // m/s.
            ASSERT_NEAR(v, r->vel_mps[k], 2);
        }
    }
    orr_sp3_free(&o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_every_file), cmocka_unit_test(test_known_facts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
