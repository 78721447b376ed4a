// SPDX-License-Identifier: GPL-3.0-or-later
// The product's file: back bit for bit, readable by others, and no harm from files that lie.
#include "testing.h"

#include <dirent.h>
#include <errno.h>
#include <netcdf.h>
#include <sys/stat.h>
#include <unistd.h>

#include "orbit/ephemeris/ephemeris_parts.h"
#include "unit/orbit/made_orbit.h"

static char folder[256];

static int make_folder(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "%s/ephemeris-XXXXXX",
             getenv("TMPDIR") != NULL ? getenv("TMPDIR") : "/tmp");
    return mkdtemp(folder) == NULL;
}

static size_t files_in_folder(bool remove_them)
{
    size_t n = 0;
    DIR *d = opendir(folder);
    assert_non_null(d);
    for (struct dirent *entry; (entry = readdir(d)) != NULL;) {
        if (entry->d_name[0] == '.') continue;
        n++;
        char path[600];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (remove_them) unlink(path);
    }
    closedir(d);
    return n;
}

static int remove_folder(void **state)
{
    (void)state;
    files_in_folder(true);
    return rmdir(folder);
}

static const char *in_folder(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static orr_ephemeris *built(const orr_orbit_solution *s)
{
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_build(s, &e, &diag), diag);
    return e;
}

static void same_states(const orr_ephemeris *a, const orr_ephemeris *b)
{
    orr_sat_state x[40], y[40];
    orr_time from, to, from2, to2;
    orr_ephemeris_span(a, &from, &to);
    orr_ephemeris_span(b, &from2, &to2);
    assert_true(from == from2 && to == to2);
    for (orr_time t = from; t <= to; t += 37 * ORR_NS_PER_S + 1234567) {
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        size_t n = orr_ephemeris_eval_all(a, t, x, 40);
        assert_int_equal(n, orr_ephemeris_eval_all(b, t, y, 40));
        assert_memory_equal(x, y, n * sizeof *x);
    }
}

static void test_round_trip(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(20, 4, 900, 6);
    s.sat[2].arc[0].sample[7].flags = ORR_EPH_PREDICTED;
    s.sat[4].clock[5].flags = ORR_EPH_CLOCK_EVENT;
    s.sat[4].clock[7].flags = ORR_EPH_PREDICTED;
    s.sat[4].clock[7].sigma_s = 2e-9f;
    for (size_t i = 0; i < 20; i++) s.sat[i].clock_noise = (orr_clock_noise){1e-21 * (double)i, 1e-24, 1e-33};
    s.sat[9].clock_noise = (orr_clock_noise){(double)NAN, (double)NAN, (double)NAN}; // not known
    orr_clock_event found[3] = {
        {ORR_CLOCK_EVENT_WRONG, s.sat[1].sat, made_midnight, made_midnight, 1e-7, ""},
        {ORR_CLOCK_EVENT_JUMP, s.sat[4].sat, made_midnight, made_midnight + 5, -1e-6, ""},
        {ORR_CLOCK_EVENT_REFERENCE, ORR_SAT_NONE, made_midnight + 7, made_midnight + 9, 4e-8, "GR"}};
    s.clock_events = (orr_clock_events){3, found};
    s.sat[5].n_events = 0;
    s.sat[6].n_clocks = 0;
    s.sat[7].n_arcs = 0;
    orr_orbit_sample *p =
        s.sat[8].arc[0].sample; // another degree than its neighbours, as an eclipse makes it
    for (int i = 3; i < 97; i++) {
        double t = 150.0 * (i - 3) + 50;
        p[i].pos_m.x += 0.5e-7 * t * t, p[i].vel_mps.x += 1e-7 * t, p[i].acc_mps2.x += 1e-7;
    }
    double mjd[3] = {60000.125, 60000.25, 60001};
    orr_eop eop[3] = {{.xp_rad = 1e-6, .yp_rad = -2e-6, .ut1_utc_s = 0.3},
                      {.xp_rad = 1.1e-6, .yp_rad = -2.2e-6, .ut1_utc_s = 0.31},
                      {.xp_rad = 1.3e-6, .yp_rad = -2.1e-6, .ut1_utc_s = 0.29}};
    s.rotation = (orr_earth_rotation){ORR_ROTATION_ESTIMATED, {3, mjd, eop}, 2e-11, 3e-7};
    orr_ephemeris *a = built(&s), *b = NULL;
    s.rotation = (orr_earth_rotation){0};
    const char *path = in_folder("round.nc");
    ASSERT_OK(orr_ephemeris_save(a, path, "made by a test", &diag), diag);
    ASSERT_OK(orr_ephemeris_load(path, &b, &diag), diag);
    same_states(a, b);
    for (size_t i = 0; i < 20; i++) {
        orr_sat sat = s.sat[i].sat;
        const orr_orbit_node *na, *nb;
        const orr_orbit_event *ea, *eb;
        const orr_clock_node *ca, *cb;
        size_t n = orr_ephemeris_nodes(a, sat, &na);
        assert_int_equal(n, orr_ephemeris_nodes(b, sat, &nb));
        assert_memory_equal(na, nb, n * sizeof *na);
        n = orr_ephemeris_events(a, sat, &ea);
        assert_int_equal(n, orr_ephemeris_events(b, sat, &eb));
        for (size_t k = 0; k < n; k++)
            assert_true(ea[k].kind == eb[k].kind && ea[k].t0 == eb[k].t0 && ea[k].t1 == eb[k].t1 &&
                        ea[k].value == eb[k].value);
        n = orr_ephemeris_clocks(a, sat, &ca);
        assert_int_equal(n, orr_ephemeris_clocks(b, sat, &cb));
        for (size_t k = 0; k < n; k++)
            assert_true(ca[k].t == cb[k].t && ca[k].clock_s == cb[k].clock_s && ca[k].flags == cb[k].flags &&
                        ca[k].sigma_s == cb[k].sigma_s);
    }
    const orr_clock_event *event;
    assert_int_equal(orr_ephemeris_clock_events(b, &event), 3);
    for (size_t k = 0; k < 3; k++) {
        assert_true(event[k].kind == found[k].kind && event[k].sat == found[k].sat &&
                    event[k].t0 == found[k].t0 && event[k].t1 == found[k].t1 &&
                    event[k].value_s == found[k].value_s);
        assert_string_equal(event[k].systems, found[k].systems);
    }
    orr_sat_state at; // between a node and a predicted one: both kinds of sigma
    assert_int_equal(orr_ephemeris_eval(b, s.sat[4].sat, s.sat[4].clock[6].t + 150 * ORR_NS_PER_S, &at),
                     ORR_OK);
    // Half way in 300 s: 1.5 + 0.5 c(300) - 2 c(150), c = 1/4 and 4/9.
    const double between_s2 = 4e-21 * (1.625 - 8.0 / 9) + 1e-24 * 75 + 1e-33 * 2.7e7 / 48,
                 given_s2 = 0.5 * 4e-18;
    ASSERT_NEAR(at.clock_sigma_s, sqrt(between_s2 + given_s2), 1e-15);
    assert_int_equal(orr_ephemeris_eval(b, s.sat[9].sat, made_midnight + 150 * ORR_NS_PER_S, &at), ORR_OK);
    assert_true(isfinite(at.clock_s) && isnan(at.clock_sigma_s));
    s.clock_events = (orr_clock_events){0};
    const orr_earth_rotation *r = orr_ephemeris_rotation(b);
    assert_int_equal(r->source, ORR_ROTATION_ESTIMATED);
    ASSERT_NEAR(r->pole_sigma_rad, 2e-11, 1e-25); // through arc seconds
    assert_true(r->lod_sigma_s == 3e-7 && orr_ephemeris_eop(b) == &r->series && r->series.n == 3);
    assert_memory_equal(r->series.mjd_utc, mjd, sizeof mjd);
    assert_memory_equal(r->series.value, eop, sizeof eop);
    const orr_orbit_source *src;
    assert_int_equal(orr_ephemeris_sources(b, &src), 1);
    assert_string_equal(src[0].name, "made.sp3");
    assert_int_equal(strlen(src[0].sha256), 64);
    assert_string_equal(orr_ephemeris_options(b), "made for a test");
    assert_string_equal(orr_ephemeris_frame(b), "IGS20");
    double pa, va, pb, vb;
    orr_ephemeris_representation(a, &pa, &va);
    orr_ephemeris_representation(b, &pb, &vb);
    assert_true(pa == pb && va == vb && orr_ephemeris_node_step_s(b) == 900);
    orr_ephemeris_free(a);
    orr_ephemeris_free(b);
    s.sat[7].n_arcs = 1;
    made_solution_free(&s);
}

// A product of nothing but arcs: no clocks, nodes, events, sources.
static void test_bare_product(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(2, 1, 900, 6);
    for (size_t i = 0; i < 2; i++) s.sat[i].n_clocks = s.sat[i].n_nodes = s.sat[i].n_events = 0;
    s.n_sources = 0;
    orr_ephemeris *a = built(&s), *b = NULL;
    ASSERT_OK(orr_ephemeris_save(a, in_folder("bare.nc"), NULL, &diag), diag);
    ASSERT_OK(orr_ephemeris_load(in_folder("bare.nc"), &b, &diag), diag);
    same_states(a, b);
    orr_ephemeris_free(a);
    orr_ephemeris_free(b);
    made_solution_free(&s);
}

static void save_made(const char *path)
{
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(3, 2, 900, 6);
    orr_ephemeris *e = built(&s);
    ASSERT_OK(orr_ephemeris_save(e, path, "made by a test", &diag), diag);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static void test_truncated(void **state)
{
    (void)state;
    char path[512], cut[512];
    snprintf(path, sizeof path, "%s", in_folder("whole.nc"));
    snprintf(cut, sizeof cut, "%s", in_folder("cut.nc"));
    save_made(path);
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    static char bytes[1 << 20];
    size_t n = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    assert_true(n > 1000 && n < sizeof bytes);
    for (size_t k = 0; k < 40; k++) {
        f = fopen(cut, "wb");
        assert_non_null(f);
        assert_int_equal(fwrite(bytes, 1, n * k / 40, f), n * k / 40);
        fclose(f);
        orr_diag diag = {0};
        orr_ephemeris *e = NULL;
        assert_int_not_equal(orr_ephemeris_load(cut, &e, &diag), ORR_OK);
        assert_null(e);
        assert_true(diag.text[0] != '\0');
    }
}

static void test_wrong_kinds(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    assert_int_equal(orr_ephemeris_load(in_folder("absent.nc"), &e, &diag), ORR_E_IO);
    FILE *f = fopen(in_folder("text.nc"), "w");
    assert_non_null(f);
    fputs("#dP2024  2  4  0  0  0.00000000      97 d+D   IGS20 FIT AIUB\n", f);
    fclose(f);
    assert_int_equal(orr_ephemeris_load(in_folder("text.nc"), &e, &diag), ORR_E_KIND);
    int id; // some other NetCDF file
    assert_int_equal(nc_create(in_folder("other.nc"), NC_NETCDF4, &id), NC_NOERR);
    assert_int_equal(nc_put_att_text(id, NC_GLOBAL, "title", 5, "other"), NC_NOERR);
    assert_int_equal(nc_close(id), NC_NOERR);
    assert_int_equal(orr_ephemeris_load(in_folder("other.nc"), &e, &diag), ORR_E_KIND);
    assert_non_null(strstr(diag.text, "orbit product"));
    int64_t version = 99;
    save_made(in_folder("newer.nc"));
    assert_int_equal(nc_open(in_folder("newer.nc"), NC_WRITE, &id), NC_NOERR);
    assert_int_equal(nc_put_att(id, NC_GLOBAL, "product_version", NC_INT64, 1, &version), NC_NOERR);
    assert_int_equal(nc_close(id), NC_NOERR);
    assert_int_equal(orr_ephemeris_load(in_folder("newer.nc"), &e, &diag), ORR_E_UNSUPPORTED);
}

// Changes one value of a saved product and loads it.
typedef struct lie {
    const char *var;
    size_t index[3];
    double value;
} lie;

static orr_status load_with(const lie *l, orr_diag *diag)
{
    int id, var;
    save_made(in_folder("lie.nc"));
    assert_int_equal(nc_open(in_folder("lie.nc"), NC_WRITE, &id), NC_NOERR);
    assert_int_equal(nc_inq_varid(id, l->var, &var), NC_NOERR);
    nc_type type;
    assert_int_equal(nc_inq_vartype(id, var, &type), NC_NOERR);
    if (type == NC_CHAR) {
        char c = (char)l->value;
        assert_int_equal(nc_put_var1_text(id, var, l->index, &c), NC_NOERR);
    } else if (type == NC_INT64) {
        long long v = l->value > 9e18 ? INT64_MAX : l->value < -9e18 ? INT64_MIN : (long long)l->value;
        assert_int_equal(nc_put_var1_longlong(id, var, l->index, &v), NC_NOERR);
    } else if (type == NC_FLOAT) { // NetCDF has no infinite double become a float
        float v = (float)l->value;
        assert_int_equal(nc_put_var1_float(id, var, l->index, &v), NC_NOERR);
    } else {
        assert_int_equal(nc_put_var1_double(id, var, l->index, &l->value), NC_NOERR);
    }
    assert_int_equal(nc_close(id), NC_NOERR);
    orr_ephemeris *e = NULL;
    orr_status s = orr_ephemeris_load(in_folder("lie.nc"), &e, diag);
    orr_ephemeris_free(e);
    return s;
}

static void test_lies(void **state)
{
    (void)state;
    static const lie lies[] = {
        {"arc_count", {0}, 2},
        {"arc_count", {1}, -1},
        {"arc_count", {2}, 0},
        {"clock_count", {0}, 2e9},
        {"node_count", {1}, 0},
        {"event_count", {2}, 5},
        {"satellite_name", {0, 0}, 'Z'},
        {"satellite_name", {1, 0}, 'G'}, // G01 twice
        {"arc_start", {0}, 9.2e18},
        {"arc_start", {0}, -9.2e18},
        {"arc_start", {0}, 0x1p62 - 1000e9}, // begins within the times, ends beyond
        {"segment_length", {0}, 0},
        {"segment_length", {1}, -900e9},
        {"segment_length", {1}, 9.2e18},
        {"segment_length", {1}, 7}, // not divisible into six samples
        {"segment_count", {0}, 0},
        {"segment_count", {0}, 2147483647},
        {"sample_count", {1}, 48},
        {"sample_count", {1}, -49},
        {"degree", {0}, 255},
        {"degree", {0}, 0},
        {"position_coefficient", {3, 2, 1}, (double)NAN},
        {"position_coefficient", {3, 2, 1}, 1e300},
        {"position_sigma", {4}, -1},
        {"position_sigma", {4}, (double)NAN},
        {"position_sigma", {4}, (double)INFINITY}, // no number between it and its neighbour
        {"clock_time", {1}, 0},
        {"clock_time", {3}, 9.2e18},
        {"clock_bias", {3}, (double)INFINITY},
        {"clock_bias", {3}, 1.7e308}, // no rate between it and its neighbour
        {"node_time", {2}, 0},
        {"node_source", {2}, 1},
        {"event_kind", {2}, 77},
        {"event_start", {2}, 9.2e18},
        {"event_end", {2}, 0},
    };
    for (size_t i = 0; i < sizeof lies / sizeof lies[0]; i++) {
        orr_diag diag = {0};
        orr_status s = load_with(&lies[i], &diag);
        if (s != ORR_E_FORMAT || diag.text[0] == '\0')
            fail_msg("%s[%zu] = %g: status %d, '%s'", lies[i].var, lies[i].index[0], lies[i].value, (int)s,
                     diag.text);
    }
    // The control: the same way without a lie is read.
    orr_diag diag = {0};
    ASSERT_OK(load_with(&(lie){"event_value", {0}, 0.5}, &diag), diag);
}

// A file of some kilobytes whose dimensions claim gigabytes is refused before anything is allocated for them.
static void test_claims(void **state)
{
    (void)state;
    static const char *const dims[] = {"satellite", "arc", "segment", "coefficient", "sample"};
    for (size_t d = 0; d < sizeof dims / sizeof dims[0]; d++) {
        int id, dim;
        assert_int_equal(nc_create(in_folder("claim.nc"), NC_NETCDF4, &id), NC_NOERR);
        int64_t version = 1;
        assert_int_equal(nc_put_att_text(id, NC_GLOBAL, "product", 12, "orrery orbit"), NC_NOERR);
        assert_int_equal(nc_put_att(id, NC_GLOBAL, "product_version", NC_INT64, 1, &version), NC_NOERR);
        for (size_t k = 0; k < sizeof dims / sizeof dims[0]; k++)
            assert_int_equal(nc_def_dim(id, dims[k], k == d ? (size_t)1 << 40 : 8, &dim), NC_NOERR);
        assert_int_equal(nc_def_dim(id, "coordinate", 3, &dim), NC_NOERR);
        assert_int_equal(nc_close(id), NC_NOERR);
        orr_diag diag = {0};
        orr_ephemeris *e = NULL;
        assert_int_equal(orr_ephemeris_load(in_folder("claim.nc"), &e, &diag), ORR_E_LIMIT);
        assert_non_null(strstr(diag.text, dims[d]));
    }
}

// Damage anywhere is found before the NetCDF library sees it (the file is sealed); every 61st byte is tried.
static void test_damage(void **state)
{
    (void)state;
    char path[512];
    snprintf(path, sizeof path, "%s", in_folder("flip.nc"));
    save_made(path);
    struct stat st;
    assert_int_equal(stat(path, &st), 0);
    for (long at = 8; at < st.st_size - 80; at += 61) { // the seal is the last 80 bytes
        FILE *f = fopen(path, "r+b");
        assert_non_null(f);
        fseek(f, at, SEEK_SET);
        int c = fgetc(f);
        fseek(f, at, SEEK_SET);
        fputc(c ^ 0x15, f);
        fclose(f);
        orr_diag diag = {0};
        orr_ephemeris *e = NULL;
        assert_int_equal(orr_ephemeris_load(path, &e, &diag), ORR_E_FORMAT);
        assert_non_null(strstr(diag.text, "damaged"));
        f = fopen(path, "r+b");
        assert_non_null(f);
        fseek(f, at, SEEK_SET);
        fputc(c, f);
        fclose(f);
    }
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    ASSERT_OK(orr_ephemeris_load(path, &e, &diag), diag);
    orr_ephemeris_free(e);
}

// Where a file cannot be written nothing is left, and what stood there stays.
static void test_no_half_file(void **state)
{
    (void)state;
    files_in_folder(true);
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(2, 1, 900, 6);
    orr_ephemeris *e = built(&s);
    assert_int_equal(orr_ephemeris_save(e, in_folder("absent/day.nc"), NULL, &diag), ORR_E_IO);
    assert_int_equal(files_in_folder(false), 0);
    assert_int_equal(mkdir(in_folder("taken"), 0777), 0);
    assert_int_equal(orr_ephemeris_save(e, in_folder("taken"), NULL, &diag), ORR_E_IO);
    assert_int_equal(files_in_folder(false), 1);
    assert_int_equal(rmdir(in_folder("taken")), 0);
    if (geteuid() != 0) { // root may write anywhere
        assert_int_equal(chmod(folder, 0555), 0);
        assert_int_equal(orr_ephemeris_save(e, in_folder("day.nc"), NULL, &diag), ORR_E_IO);
        assert_int_equal(chmod(folder, 0755), 0);
        assert_int_equal(files_in_folder(false), 0);
    }
    ASSERT_OK(orr_ephemeris_save(e, in_folder("day.nc"), NULL, &diag), diag);
    assert_int_equal(files_in_folder(false), 1);
    orr_ephemeris_free(e);
    made_solution_free(&s);
}

static char *whole_file(const char *path, size_t *n)
{
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    assert_int_equal(fseek(f, 0, SEEK_END), 0);
    *n = (size_t)ftell(f);
    rewind(f);
    char *text = malloc(*n + 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, *n, f), *n);
    fclose(f);
    return text;
}

// Satellites given one by one, in another order and one of them again, make the product that the solution makes: in memory and
// to the byte in its file.
static void test_parts(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(12, 6, 900, 6), none = s;
    orr_ephemeris *whole = built(&s), *joined = NULL;
    orr_ephemeris_parts *p = NULL;
    ASSERT_OK(orr_ephemeris_parts_begin(folder, &p, &diag), diag);
    orr_orbit_sat other = s.sat[3]; // of which the first is to be forgotten
    other.n_nodes = other.n_clocks = 0;
    assert_int_equal(orr_ephemeris_parts_add(p, &other), ORR_OK);
    for (size_t i = s.n_sats; i-- > 0;) assert_int_equal(orr_ephemeris_parts_add(p, &s.sat[i]), ORR_OK);
    none.n_sats = 0;
    none.sat = NULL;
    ASSERT_OK(orr_ephemeris_parts_join(p, &none, &joined, &diag), diag);
    orr_ephemeris_parts_free(p);
    same_states(whole, joined);
    char *text[2];
    size_t n[2];
    for (int k = 0; k < 2; k++) {
        const char *path = in_folder("same.nc");
        ASSERT_OK(orr_ephemeris_save(k == 0 ? whole : joined, path, "made", &diag), diag);
        text[k] = whole_file(path, &n[k]);
        unlink(path);
    }
    assert_int_equal(n[0], n[1]);
    assert_memory_equal(text[0], text[1], n[0]);
    free(text[0]);
    free(text[1]);
    orr_ephemeris_free(whole);
    orr_ephemeris_free(joined);
    made_solution_free(&s);
}

// What a satellite is refused for is told in its own words, and again when the whole is asked for.
static void test_parts_that_are_refused(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_orbit_solution s = made_solution(2, 6, 900, 6);
    orr_ephemeris *e = NULL;
    orr_ephemeris_parts *p = NULL;
    ASSERT_OK(orr_ephemeris_parts_begin(folder, &p, &diag), diag);
    s.sat[0].arc[0].sample[3].pos_m.y = (double)NAN;
    assert_int_equal(orr_ephemeris_parts_add(p, &s.sat[0]), ORR_E_NUMERIC);
    assert_int_equal(orr_ephemeris_parts_add(p, &s.sat[1]), ORR_E_NUMERIC);
    assert_int_equal(orr_ephemeris_parts_join(p, &s, &e, &diag), ORR_E_NUMERIC);
    assert_non_null(strstr(diag.text, "no number"));
    assert_null(e);
    orr_ephemeris_parts_free(p);
    made_solution_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parts),        cmocka_unit_test(test_parts_that_are_refused),
        cmocka_unit_test(test_round_trip),   cmocka_unit_test(test_bare_product),
        cmocka_unit_test(test_truncated),    cmocka_unit_test(test_wrong_kinds),
        cmocka_unit_test(test_lies),         cmocka_unit_test(test_claims),
        cmocka_unit_test(test_no_half_file), cmocka_unit_test(test_damage),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
