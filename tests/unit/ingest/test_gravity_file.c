// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <unistd.h>

#include "core/ncfile.h"
#include "core/vec.h"
#include "ingest/tables/gravity_file.h"
#include "read_file.h"

static char path[] = "gravity-file-XXXXXX";
static int make_file(void **state)
{
    (void)state;
    int fd = mkstemp(path);
    return fd < 0 || close(fd) != 0;
}
static int remove_file(void **state)
{
    (void)state;
    return remove(path);
}

static void put(const char *text, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, n, f), n);
    fclose(f);
}

static orr_status read_text(const char *text, orr_gravity_file *g, orr_diag *diag)
{
    *diag = (orr_diag){0};
    put(text, strlen(text));
    return read_gravity(path, g, diag);
}

static void profiles_in_their_shapes(void **state)
{
    (void)state;
    orr_diag diag;
    orr_gravity_file g;
    const char *const texts[] = {
        "0,1.5\n1000,-2\n2500.25,3e1\n",
        "distance_m,mgal\n0,1.5\n1000,-2\n2500.25,3e1\n",
        "# a profile\n\nDistance (m)\tmGal\r\n# more\r\n0\t1.5\r\n1000\t-2\r\n\r\n2500.25\t3e1\r\n",
        "  0   1.5\n 1000  -2 \n2500.25 3e1",
        "0; 1.5\n1000; -2\n2500.25; 3e1\n",
        "\357\273\2770,1.5\n1000,-2\n2500.25,3e1\n", // a byte order mark
    };
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        ASSERT_OK(read_text(texts[k], &g, &diag), diag);
        assert_int_equal(g.n_profile, 3);
        assert_int_equal(g.n_lat, 0);
        const double d[3] = {0, 1000, 2500.25}, v[3] = {1.5, -2, 30};
        for (int i = 0; i < 3; i++) {
            ASSERT_NEAR(g.distance_m[i], d[i], 0);
            ASSERT_NEAR(g.mgal[i], v[i], 0);
        }
        orr_gravity_file_free(&g);
    }
}

// A map's rows in any order; its values are where their places are.
static void maps_in_any_order(void **state)
{
    (void)state;
    orr_diag diag;
    orr_gravity_file g;
    for (int turn = 0; turn < 12; turn++) {
        char text[600] = "lat,lon,mgal\n";
        for (int k = 0; k < 12; k++) { // 5 and 12 have no common factor: a permutation
            int at = (5 * k + turn) % 12, i = at / 4, j = at % 4;
            snprintf(text + strlen(text), 60, "%d,%.1f,%d\n", 60 - i, 179.5 + 0.5 * j, 100 * i + j);
        }
        ASSERT_OK(read_text(text, &g, &diag), diag);
        assert_int_equal(g.n_profile, 0);
        assert_int_equal(g.n_lat, 3);
        assert_int_equal(g.n_lon, 4);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 4; j++) {
                ASSERT_NEAR(g.lat_rad[i], (58 + i) * ORR_RAD_PER_DEG, 1e-15);
                ASSERT_NEAR(g.lon_rad[j], (179.5 + 0.5 * j) * ORR_RAD_PER_DEG, 1e-15);
                ASSERT_NEAR(g.mgal[4 * i + j], 100 * (2 - i) + j, 0);
            }
        orr_gravity_file_free(&g);
    }
}

static void what_is_no_gravity_is_told(void **state)
{
    (void)state;
    const struct {
        const char *text;
        orr_status status;
        int64_t line; // 0: of the whole file
        const char *sentence;
    } bad[] = {
        {"", ORR_E_KIND, 0, "empty"},
        {"# nothing\n\n", ORR_E_FORMAT, 0, "no row"},
        {"distance,mgal\n", ORR_E_FORMAT, 0, "no row"},
        {"0\n1\n", ORR_E_FORMAT, 1, "two numbers"},
        {"0,1\n2,3,4\n", ORR_E_FORMAT, 2, "same in all rows"},
        {"1,2,3,4\n", ORR_E_FORMAT, 1, "two numbers"},
        {"0,1\n1000,\n2000,3\n", ORR_E_FORMAT, 2, "two numbers"},
        {"55,,3\n56,10,3\n", ORR_E_FORMAT, 1, "two numbers"}, // a hole, no profile of 55 m
        {"0,nan\n1,2\n", ORR_E_FORMAT, 1, "two numbers"},     // a number and no number: no header
        {"0,1\n1,inf\n", ORR_E_FORMAT, 2, "two numbers"},
        {"0,1\nhalf,2\n", ORR_E_FORMAT, 2, "two numbers"},
        {"a,b\nc,d\n0,1\n", ORR_E_FORMAT, 2, "two numbers"}, // one header is enough
        {"1,1,1\n1,2,2\n2,1,3\n", ORR_E_FORMAT, 0, "grid"},
        {"1,1,1\n1,2,2\n2,1,3\n2,3,4\n", ORR_E_FORMAT, 0, "grid"},
        {"1,1,1\n1,1,2\n2,1,3\n2,1,4\n", ORR_E_FORMAT, 0, "grid"}, // a place twice
        {"1 2 3 km\n", ORR_E_FORMAT, 1, "two numbers"},
    };
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        orr_gravity_file g;
        orr_diag diag;
        orr_status s = read_text(bad[k].text, &g, &diag);
        if (s != bad[k].status || strstr(diag.text, bad[k].sentence) == NULL || diag.line != bad[k].line)
            fail_msg("'%s': %s, line %lld: %s", bad[k].text, orr_status_name(s), (long long)diag.line,
                     diag.text);
        assert_null(g.mgal);
    }
    orr_gravity_file g;
    orr_diag diag = {0};
    assert_int_equal(read_gravity("no such file", &g, &diag), ORR_E_IO);
    assert_non_null(strstr(diag.file, "no such file"));
    put("\x89HDF\r\n\x1a\n and then nothing of the kind", 38);
    assert_int_equal(read_gravity(path, &g, &diag), ORR_E_FORMAT);
}

typedef struct map {
    const char *lat, *lon, *value;
    bool southward, as_float;
    size_t n_lat, n_lon;
} map;

static void put_netcdf(const map *m)
{
    orr_nc_writer w;
    orr_diag diag = {0};
    double lat[20], lon[20], value[400];
    float single[400];
    for (size_t i = 0; i < m->n_lat; i++) lat[i] = m->southward ? 40.0 - (double)i : 31.0 + (double)i;
    for (size_t j = 0; j < m->n_lon; j++) lon[j] = 10.0 + 0.5 * (double)j;
    for (size_t k = 0; k < m->n_lat * m->n_lon; k++) {
        value[k] = 2.0 * lat[k / m->n_lon] - lon[k % m->n_lon];
        single[k] = (float)value[k];
    }
    ASSERT_OK(orr_nc_create(path, &w, &diag), diag);
    const char *const dims[2] = {m->lat, m->lon};
    (void)orr_nc_put_dim(&w, m->lat, m->n_lat, &diag);
    (void)orr_nc_put_dim(&w, m->lon, m->n_lon, &diag);
    (void)orr_nc_put_var(&w, m->lat, ORR_NC_DOUBLE, 1, &dims[0], lat, "degrees_north", NULL, &diag);
    (void)orr_nc_put_var(&w, m->lon, ORR_NC_DOUBLE, 1, &dims[1], lon, "degrees_east", NULL, &diag);
    if (m->as_float)
        (void)orr_nc_put_var(&w, m->value, ORR_NC_FLOAT, 2, dims, single, "mGal", NULL, &diag);
    else
        (void)orr_nc_put_var(&w, m->value, ORR_NC_DOUBLE, 2, dims, value, "mGal", NULL, &diag);
    ASSERT_OK(orr_nc_commit(&w, &diag), diag);
}

static void netcdf_maps(void **state)
{
    (void)state;
    const map good[] = {{"lat", "lon", "disturbance", false, false, 10, 5},
                        {"latitude", "longitude", "gravity_disturbance", true, false, 10, 6},
                        {"y", "x", "mgal", true, true, 10, 7}};
    for (size_t k = 0; k < 3; k++) {
        orr_gravity_file g;
        orr_diag diag = {0};
        put_netcdf(&good[k]);
        ASSERT_OK(read_gravity(path, &g, &diag), diag);
        assert_int_equal(g.n_lat, good[k].n_lat);
        assert_int_equal(g.n_lon, good[k].n_lon);
        for (size_t i = 0; i < g.n_lat; i++)
            for (size_t j = 0; j < g.n_lon; j++) {
                ASSERT_NEAR(g.lat_rad[i] * ORR_DEG_PER_RAD, 31.0 + (double)i, 1e-13);
                ASSERT_NEAR(g.mgal[i * g.n_lon + j],
                            2 * g.lat_rad[i] * ORR_DEG_PER_RAD - g.lon_rad[j] * ORR_DEG_PER_RAD, 1e-5);
            }
        orr_gravity_file_free(&g);
    }
    const map bad[] = {{"lat", "lon", "height", false, false, 4, 4},
                       {"phi", "lon", "mgal", false, false, 4, 4},
                       {"lat", "lambda", "mgal", false, false, 4, 4}};
    for (size_t k = 0; k < 3; k++) {
        orr_gravity_file g;
        orr_diag diag = {0};
        put_netcdf(&bad[k]);
        assert_int_equal(read_gravity(path, &g, &diag), ORR_E_KIND);
        assert_true(diag.text[0] != '\0');
        assert_null(g.mgal);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(profiles_in_their_shapes),
        cmocka_unit_test(maps_in_any_order),
        cmocka_unit_test(what_is_no_gravity_is_told),
        cmocka_unit_test(netcdf_maps),
    };
    return cmocka_run_group_tests(tests, make_file, remove_file);
}
