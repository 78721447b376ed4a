// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of known truth: constants, a bump that follows the Sun, refits of what is a low-degree expansion,
// holes, clipped cells, epochs and refusals.
#include "core/nan.h"
#include "core/rng.h"
#include "iono/broadcast/bdgim.h"
#include "iono/field/sun_frame.h"
#include "iono/field/tec_field.h"
#include "iono/field/tec_field_nc.h"
#include "testing.h"

enum { ROWS = 71, COLS = 73 };

typedef struct made {
    orr_tec_maps maps;
    double *tec, *rms;
    orr_time *t;
} made;

// A degree-2 field fixed to the Sun (geographic pole): 20 + 15 cos(lat) cos(lon - sun) + 3 sin(lat).
static double truth(double lat, double lon, orr_time t)
{
    return 20 + 15 * cos(lat) * cos(lon - orr_mean_sun_lon(t, NULL)) + 3 * sin(lat);
}

static made make(size_t n, double hours, bool rounded)
{
    made m = {.tec = malloc(n * ROWS * COLS * sizeof(double)),
              .rms = malloc(n * ROWS * COLS * sizeof(double)),
              .t = malloc(n * sizeof(orr_time))};
    orr_time t0;
    assert_int_equal(orr_time_parse("2024-02-04T00:00:00Z", NULL, &t0, NULL), ORR_OK);
    for (size_t k = 0; k < n; k++) {
        m.t[k] = orr_time_add_s(t0, 3600 * hours * (double)k);
        for (size_t i = 0; i < ROWS * COLS; i++) {
            double lat = (87.5 - 2.5 * (double)(i / COLS)) * ORR_RAD_PER_DEG;
            double lon = (-180 + 5 * (double)(i % COLS)) * ORR_RAD_PER_DEG, v = truth(lat, lon, m.t[k]);
            m.tec[k * ROWS * COLS + i] = rounded ? round(10 * v) / 10 : v;
            m.rms[k * ROWS * COLS + i] = 2 + (double)k;
        }
    }
    m.maps = (orr_tec_maps){n,   ROWS, COLS,  87.5,  -2.5,  -180, 5, ORR_SHELL_RADIUS_M,
                            0.1, m.t,  m.tec, m.rms, "made"};
    return m;
}

static void drop(made *m)
{
    free(m->tec);
    free(m->rms);
    free(m->t);
}

static orr_vec3 unit(double lat, double lon)
{
    return (orr_vec3){cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)};
}

static double vtec(const orr_tec_field *f, orr_time t, double lat, double lon)
{
    orr_tec_instant *at = malloc(sizeof *at);
    orr_tec_value v;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_at(f, t, at, &d), d);
    ASSERT_OK(orr_tec_vertical(at, unit(lat, lon), &v, &d), d);
    free(at);
    return v.vtec_tecu;
}

// A field goes by the run's table of leap seconds, also when it comes back from a product: with a second more the mean Sun stands
// 15" further East, and so does a field that is fixed to it.
static void leap_seconds_are_the_runs(void **state)
{
    (void)state;
    const orr_leap_entry one_more[] = {{41317, 10}, {60000, 38}};
    const orr_leap_table table = {2, one_more, 70000};
    made m = make(2, 2, false);
    orr_tec_options o = orr_tec_default_options();
    orr_diag d = {0};
    orr_tec_field *f, *plain, *back;
    o.degree = 4;
    o.pole_lat_deg = 90; // the Earth's: a turn with the Sun is one of longitude
    o.pole_lon_deg = 0;
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &plain, &d), d);
    o.leap = &table;
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
    orr_nc_writer w;
    orr_nc_reader nc;
    ASSERT_OK(orr_nc_create("leap-field.nc", &w, &d), d);
    ASSERT_OK(orr_tec_field_put(&w, plain, &d), d);
    ASSERT_OK(orr_nc_commit(&w, &d), d);
    ASSERT_OK(orr_nc_open("leap-field.nc", &nc, &d), d);
    ASSERT_OK(orr_tec_field_get(&nc, &table, &back, &d), d);
    orr_nc_close(&nc);
    // Coefficients that were fitted in one Sun's axes, read in another's: the map turns by 15" to the East (UTC is a second
    // earlier), 7.3e-5 rad of 15 TECU cos(lat).
    const double lon = -1, step = 15.0 / 3600 * ORR_RAD_PER_DEG;
    const double turned = truth(0.3, lon - step, m.t[0]) - truth(0.3, lon, m.t[0]);
    const double change = vtec(back, m.t[0], 0.3, lon) - vtec(plain, m.t[0], 0.3, lon);
    assert_true(fabs(turned) > 1e-4);
    ASSERT_NEAR(change / turned, 1, 1e-3);
    // Fitted and read by the same table nothing turns at the epochs.
    ASSERT_NEAR(vtec(f, m.t[0], 0.3, lon), vtec(plain, m.t[0], 0.3, lon), 1e-9);
    orr_tec_field_free(f);
    orr_tec_field_free(plain);
    orr_tec_field_free(back);
    drop(&m);
}

// What is an expansion of the degree is met exactly, at any place and, being fixed to the Sun, at any time,
// whichever pole is taken for geomagnetic (the functions of a degree are closed under rotation). 1e-9: normal
// equations.
static void test_refit_exact(void **state)
{
    (void)state;
    made m = make(3, 2, false);
    const double poles[][2] = {{79, -71}, {90, 0}, {-20, 140}};
    for (size_t i = 0; i < 3; i++) {
        orr_tec_options o = orr_tec_default_options();
        orr_diag d = {0};
        o.degree = 4;
        o.pole_lat_deg = poles[i][0];
        o.pole_lon_deg = poles[i][1];
        orr_tec_field *f;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        const orr_tec_fit *fit = orr_tec_field_fit(f);
        assert_true(fit->rms_tecu < 1e-9 && fit->max_tecu < 1e-8 && fit->n_cells == 3 * ROWS * 72);
        for (size_t k = 0; k < 3; k++) ASSERT_NEAR(vtec(f, m.t[k], 0.3, 1), truth(0.3, 1, m.t[k]), 1e-9);
        if (poles[i][0] == 90) { // sun-fixed about the axis that the truth turns about
            orr_time mid = orr_time_add_s(m.t[0], 2345);
            ASSERT_NEAR(vtec(f, mid, 0.3, 1), truth(0.3, 1, mid), 1e-9);
            ASSERT_NEAR(vtec(f, mid, -1.2, -2), truth(-1.2, -2, mid), 1e-9);
        }
        orr_tec_field_free(f);
    }
    drop(&m);
}

// The three ways between epochs, of both kinds of field. cos(lon - sun) between maps 2 h apart, at a node of
// the grid: ROTATED is exact for the harmonics (pole at the Earth's) and to the grid's chord for bilinear;
// LINEAR errs by the chord of 30 degrees.
static void test_between_epochs(void **state)
{
    (void)state;
    made m = make(2, 2, false);
    orr_time mid = orr_time_add_s(m.t[0], 3600), early = orr_time_add_s(m.t[0], 1800);
    for (int bilinear = 0; bilinear < 2; bilinear++) {
        orr_tec_options o = orr_tec_default_options();
        orr_diag d = {0};
        o.spatial = bilinear ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
        o.degree = 3;
        o.pole_lat_deg = 90;
        o.pole_lon_deg = 0;
        const double lat = 0, lon = 2.5 * 5 * ORR_RAD_PER_DEG * 0 + 40 * ORR_RAD_PER_DEG;
        orr_tec_field *f;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        ASSERT_NEAR(vtec(f, mid, lat, lon), truth(lat, lon, mid),
                    bilinear ? 1e-5 : 1e-9); // 15 degrees are 3 cells
        orr_tec_field_free(f);
        o.temporal = ORR_TEC_LINEAR;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        double want = (truth(lat, lon, m.t[0]) + truth(lat, lon, m.t[1])) / 2;
        ASSERT_NEAR(vtec(f, mid, lat, lon), want, bilinear ? 1e-5 : 1e-9);
        orr_tec_field_free(f);
        o.temporal = ORR_TEC_NEAREST;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        ASSERT_NEAR(vtec(f, early, lat, lon), truth(lat, lon, m.t[0]), bilinear ? 1e-5 : 1e-9);
        ASSERT_NEAR(vtec(f, orr_time_add_s(mid, 60), lat, lon), truth(lat, lon, m.t[1]),
                    bilinear ? 1e-5 : 1e-9);
        orr_tec_field_free(f);
        // A fraction of 0 is LINEAR; one in between lies in between here.
        o.temporal = ORR_TEC_ROTATED;
        o.rotation = 0;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        ASSERT_NEAR(vtec(f, mid, lat, lon), want, bilinear ? 1e-5 : 1e-9);
        orr_tec_field_free(f);
    }
    drop(&m);
}

static void test_rms_and_ray(void **state)
{
    (void)state;
    made m = make(2, 1, true);
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, NULL, &f, &d), d);
    assert_true(orr_tec_field_fit(f)->rms_tecu <
                0.03); // rounding to 0.1: 0.0289, less what 256 coefficients take up
    orr_tec_instant *at = malloc(sizeof *at);
    ASSERT_OK(orr_tec_field_at(f, orr_time_add_s(m.t[0], 900), at, &d), d);
    orr_iono_site s;
    ASSERT_OK(orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.9, 0.3, 100}), &s, &d), d);
    for (double el = 0.2; el < 1.57; el += 0.2) {
        orr_pierce p;
        orr_tec_ray r, same;
        ASSERT_OK(orr_pierce_direction(&s, 1, el, ORR_SHELL_RADIUS_M, &p, &d), d);
        ASSERT_OK(orr_tec_look_through(at, &s, &p, &r, &d), d);
        orr_mapping map = orr_mapping_published(ORR_MAPPING_MSLM);
        ASSERT_NEAR(r.mapping, orr_mapping_factor(&map, el), 1e-12);
        ASSERT_NEAR(r.stec_tecu, r.mapping * r.vtec_tecu, 1e-12);
        ASSERT_NEAR(r.sigma_tecu, r.mapping * 2.25, 1e-5); // maps of 2 and 3, a quarter of the way
        ASSERT_NEAR(r.vtec_tecu, truth(p.lat_rad, p.lon_rad, at->t),
                    0.15); // rounding, and a pole that is 11 degrees off
        orr_vec3 sat = orr_vec3_axpy(
            25e6, orr_vec3_unit(orr_vec3_sub(orr_vec3_scale(ORR_SHELL_RADIUS_M, p.unit), s.pos_m)), s.pos_m);
        ASSERT_OK(orr_tec_look(at, &s, sat, &same, &d), d);
        ASSERT_NEAR(same.stec_tecu, r.stec_tecu, 1e-9);
    }
    orr_tec_ray r;
    assert_int_equal(orr_tec_look(at, &s, orr_vec3_scale(-20e6, s.up), &r, &d), ORR_E_RANGE);
    free(at);
    orr_tec_field_free(f);
    drop(&m);
}

// A map of max(0, truth) as centres print it: the zeros do not spoil the rest, and the field is (nearly) 0
// there.
static void test_clipped_cells(void **state)
{
    (void)state;
    made m = make(1, 1, false);
    for (size_t i = 0; i < ROWS * COLS; i++) m.tec[i] = fmax(0, round(10 * (m.tec[i] - 12)) / 10);
    orr_tec_field *f;
    orr_diag d = {0};
    orr_tec_options o = orr_tec_default_options();
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
    const orr_tec_fit *fit = orr_tec_field_fit(f);
    assert_true(fit->n_clipped > 300);
    print_message("clipped %zu, held %zu: rms %.4f max %.3f\n", fit->n_clipped, fit->n_held, fit->rms_tecu,
                  fit->max_tecu);
    assert_true(fit->rms_tecu < 0.03);
    assert_true(fit->max_tecu < 0.12);
    for (size_t i = 0; i < ROWS * COLS; i += 7) {
        double lat = (87.5 - 2.5 * (double)(i / COLS)) * ORR_RAD_PER_DEG,
               lon = (-180 + 5 * (double)(i % COLS)) * ORR_RAD_PER_DEG;
        ASSERT_NEAR(vtec(f, m.t[0], lat, lon), m.tec[i], 0.12);
    }
    orr_tec_field_free(f);
    drop(&m);
}

static void test_holes(void **state)
{
    (void)state;
    made m = make(2, 1, false);
    for (size_t r = 30; r < 34; r++)
        for (size_t c = 10; c < 14; c++) m.tec[r * COLS + c] = ORR_NAN;
    double lat = (87.5 - 2.5 * 31.5) * ORR_RAD_PER_DEG, lon = (-180 + 5 * 11.5) * ORR_RAD_PER_DEG;
    for (int bilinear = 0; bilinear < 2; bilinear++) {
        orr_tec_options o = orr_tec_default_options();
        orr_diag d = {0};
        o.spatial = bilinear ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
        o.degree = 5;
        orr_tec_field *f;
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        orr_tec_instant *at = malloc(sizeof *at);
        orr_tec_value v;
        ASSERT_OK(orr_tec_field_at(f, m.t[0], at, &d), d);
        assert_int_equal(orr_tec_vertical(at, unit(lat, lon), &v, &d), ORR_E_NODATA);
        assert_non_null(strstr(d.text, "hole"));
        ASSERT_OK(orr_tec_vertical(at, unit(lat, lon + 1), &v, &d), d);
        ASSERT_OK(orr_tec_field_at(f, m.t[1], at, &d), d); // the other map is whole
        ASSERT_OK(orr_tec_vertical(at, unit(lat, lon), &v, &d), d);
        free(at);
        orr_tec_field_free(f);
    }
    // Hardly anything left: a sentence, and no field.
    for (size_t i = 0; i < ROWS * COLS; i++)
        if (i % 40 != 0) m.tec[i] = ORR_NAN;
    orr_tec_field *f;
    orr_diag d = {0};
    assert_int_equal(orr_tec_field_from_maps(&m.maps, NULL, &f, &d), ORR_E_NUMERIC);
    assert_non_null(strstr(d.text, "too few"));
    assert_null(f);
    drop(&m);
}

// A cell below zero does not take part in a refit: what is fitted through the others is the same as without it. In maps
// as they are it is 0; far below zero it is a hole.
static void test_negative_cells(void **state)
{
    (void)state;
    made m = make(2, 1, false);
    orr_tec_options o = orr_tec_default_options();
    o.degree = 5;
    const double at_cell[2] = {(87.5 - 2.5 * 20) * ORR_RAD_PER_DEG, (-180 + 5 * 10) * ORR_RAD_PER_DEG};
    double v[2][2];
    for (int spoilt = 0; spoilt < 2; spoilt++)
        for (int bilinear = 0; bilinear < 2; bilinear++) {
            const double good = m.tec[20 * COLS + 10];
            if (spoilt) m.tec[20 * COLS + 10] = -0.3;
            orr_tec_field *f;
            orr_diag d = {0};
            o.spatial = bilinear ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
            ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
            if (!bilinear) assert_int_equal(orr_tec_field_fit(f)->n_negative, spoilt);
            orr_tec_instant *at = malloc(sizeof *at);
            orr_tec_value value;
            ASSERT_OK(orr_tec_field_at(f, m.t[0], at, &d), d);
            ASSERT_OK(orr_tec_vertical(at, unit(at_cell[0], at_cell[1]), &value, &d), d);
            v[spoilt][bilinear] = value.vtec_tecu;
            free(at);
            orr_tec_field_free(f);
            m.tec[20 * COLS + 10] = good;
        }
    // The made maps are harmonics of low degree, so one cell less leaves the fit as it is, to the maps' rounding.
    ASSERT_NEAR(v[1][0], v[0][0], 0.01);
    ASSERT_NEAR(v[1][1], 0, 1e-9);
    assert_true(v[0][1] > 1);
    m.tec[20 * COLS + 10] = -999.9;
    orr_tec_field *f;
    orr_diag d = {0};
    o.spatial = ORR_TEC_BILINEAR;
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
    orr_tec_instant *at = malloc(sizeof *at);
    orr_tec_value value;
    ASSERT_OK(orr_tec_field_at(f, m.t[0], at, &d), d);
    assert_int_equal(orr_tec_vertical(at, unit(at_cell[0], at_cell[1]), &value, &d), ORR_E_NODATA);
    free(at);
    orr_tec_field_free(f);
    drop(&m);
}

static void test_refusals(void **state)
{
    (void)state;
    made m = make(2, 1, false);
    orr_tec_field *f;
    orr_diag d = {0};
    orr_tec_instant *at = malloc(sizeof *at);
    orr_tec_options o = orr_tec_default_options();
    o.degree = 3;
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
    assert_int_equal(orr_tec_field_at(f, orr_time_add_s(m.t[0], -61), at, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "covers"));
    assert_int_equal(orr_tec_field_at(f, orr_time_add_s(m.t[1], 61), at, &d), ORR_E_RANGE);
    ASSERT_OK(orr_tec_field_at(f, orr_time_add_s(m.t[0], -18), at, &d), d);
    ASSERT_OK(orr_tec_field_at(f, orr_time_add_s(m.t[1], 18), at, &d), d);
    orr_tec_field_free(f);
    m.tec[100] = (double)INFINITY;
    assert_int_equal(orr_tec_field_from_maps(&m.maps, &o, &f, &d), ORR_E_FORMAT);
    m.tec[100] = 1;
    orr_tec_maps region = m.maps;
    region.n_lat = 20;
    o.spatial = ORR_TEC_HARMONIC;
    assert_int_equal(orr_tec_field_from_maps(&region, &o, &f, &d), ORR_E_UNSUPPORTED);
    o.spatial = ORR_TEC_BILINEAR;
    region.n_maps = 1;
    ASSERT_OK(orr_tec_field_from_maps(&region, &o, &f, &d), d);
    orr_tec_value v;
    ASSERT_OK(orr_tec_field_at(f, m.t[0], at, &d), d);
    ASSERT_OK(orr_tec_vertical(at, unit(60 * ORR_RAD_PER_DEG, 1), &v, &d), d);
    assert_int_equal(orr_tec_vertical(at, unit(0, 1), &v, &d), ORR_E_RANGE);
    orr_tec_field_free(f);
    m.t[1] = m.t[0];
    assert_int_equal(orr_tec_field_from_maps(&m.maps, &o, &f, &d), ORR_E_FORMAT);
    o.rotation = 1.5;
    assert_int_equal(orr_tec_field_from_maps(&m.maps, &o, &f, &d), ORR_E_ARG);
    free(at);
    drop(&m);
}

// Maps of a region, by default: as they are and fixed to the Earth, so that no place of theirs is refused between epochs.
static void test_region(void **state)
{
    (void)state;
    enum { LATS = 9, LONS = 5, MAPS = 3 };
    orr_time t[MAPS];
    double tec[MAPS * LATS * LONS];
    assert_int_equal(orr_time_parse("2024-02-04T00:00:00Z", NULL, &t[0], NULL), ORR_OK);
    for (size_t k = 0; k < MAPS; k++) {
        t[k] = orr_time_add_s(t[0], 7200.0 * (double)k);
        for (size_t i = 0; i < LATS * LONS; i++) tec[k * LATS * LONS + i] = 10 + 4 * (double)k;
    }
    orr_tec_maps m = {.n_maps = MAPS,
                      .n_lat = LATS,
                      .n_lon = LONS,
                      .lat0_deg = 60,
                      .dlat_deg = -2.5,
                      .lon0_deg = 5,
                      .dlon_deg = 5,
                      .shell_radius_m = ORR_SHELL_RADIUS_M,
                      .unit_tecu = 0.1,
                      .t = t,
                      .tec = tec};
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_maps(&m, NULL, &f, &d), d);
    assert_string_equal(orr_tec_field_kind(f), "maps");
    for (int minute = 0; minute <= 240; minute += 5)
        for (double lon = 5; lon <= 25; lon += 2.5)
            ASSERT_NEAR(
                vtec(f, orr_time_add_s(t[0], 60 * minute), 50 * ORR_RAD_PER_DEG, lon * ORR_RAD_PER_DEG),
                10 + minute / 30.0, 1e-5);
    orr_tec_field_free(f);
}

// Before the first map and after the last its values are held, whatever the slope between maps, in every mode.
static void test_edges_are_held(void **state)
{
    (void)state;
    made m = make(2, 2, false);
    for (int mode = 0; mode < 6; mode++) {
        orr_tec_options o = orr_tec_default_options();
        orr_diag d = {0};
        orr_tec_field *f;
        o.degree = 3;
        o.spatial = mode % 2 ? ORR_TEC_BILINEAR : ORR_TEC_HARMONIC;
        o.temporal = (orr_tec_temporal)(mode / 2);
        o.rotation = 0; // held at its place
        ASSERT_OK(orr_tec_field_from_maps(&m.maps, &o, &f, &d), d);
        for (int end = 0; end < 2; end++)
            ASSERT_NEAR(vtec(f, orr_time_add_s(m.t[end], end ? 50 : -50), 0.3, 1), vtec(f, m.t[end], 0.3, 1),
                        1e-12);
        orr_tec_field_free(f);
    }
    drop(&m);
}

// Coefficients natively: a set of degree 2 gives the closed form; snapshots are linear in time; a set with an
// end holds to it; the sets go out as they came.
static void test_model(void **state)
{
    (void)state;
    double a[9] = {20, 3 / sqrt(3), 15 / sqrt(3)}, b[9] = {30, 0, 15 / sqrt(3)}, back[9], rms[9] = {0.5};
    orr_time t0, t, t1;
    assert_int_equal(orr_time_parse("2024-02-04T00:00:00Z", NULL, &t0, NULL), ORR_OK);
    orr_tec_coefficients sets[2] = {{t0, ORR_TIME_NONE, 2, 2, a, rms},
                                    {orr_time_add_s(t0, 3600), ORR_TIME_NONE, 2, 2, b, rms}};
    orr_tec_model model = {2, sets, 90, 0, ORR_SHELL_RADIUS_M, "made"};
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_model(&model, NULL, &f, &d), d);
    ASSERT_NEAR(vtec(f, t0, 0.4, 1), truth(0.4, 1, t0), 1e-12);
    orr_time mid = orr_time_add_s(t0, 900);
    ASSERT_NEAR(vtec(f, mid, 0.4, 1),
                22.5 + 0.75 * 3 * sin(0.4) + 15 * cos(0.4) * cos(1 - orr_mean_sun_lon(mid, NULL)), 1e-12);
    orr_tec_instant *at = malloc(sizeof *at);
    orr_tec_value v;
    ASSERT_OK(orr_tec_field_at(f, mid, at, &d), d);
    ASSERT_OK(orr_tec_vertical(at, unit(0.4, 1), &v, &d), d);
    ASSERT_NEAR(v.sigma_tecu, 0.5, 1e-6);
    int degree;
    assert_int_equal(orr_tec_field_sets(f, &degree), 2);
    assert_int_equal(degree, 2);
    orr_tec_field_set(f, 1, &t, &t1, back, NULL);
    for (int i = 0; i < 9; i++) ASSERT_NEAR(back[i], b[i], 0);
    orr_tec_field_free(f);
    sets[0].t1 = orr_time_add_s(t0, 1800);
    sets[1].t1 = orr_time_add_s(t0, 7200);
    ASSERT_OK(orr_tec_field_from_model(&model, NULL, &f, &d), d);
    ASSERT_NEAR(vtec(f, mid, 0.4, 1), truth(0.4, 1, mid), 1e-12);
    assert_int_equal(orr_tec_field_at(f, orr_time_add_s(t0, 2700), at, &d), ORR_E_RANGE);
    ASSERT_NEAR(vtec(f, orr_time_add_s(t0, 7000), -1.5707, 0), 30, 0.01);
    orr_tec_field_free(f);
    // A negative expansion is clipped and says so.
    a[0] = -5;
    ASSERT_OK(orr_tec_field_from_model(&model, NULL, &f, &d), d);
    ASSERT_OK(orr_tec_field_at(f, t0, at, &d), d);
    ASSERT_OK(orr_tec_vertical(at, unit(0, 0), &v, &d), d);
    assert_true(v.vtec_tecu == 0 && (v.flags & ORR_TEC_CLIPPED));
    orr_tec_field_free(f);
    free(at);
}

static void test_klobuchar_field(void **state)
{
    (void)state;
    orr_klobuchar k = {{1.0245e-8, 1.4901e-8, -5.9605e-8, -1.1921e-7}, {88064, 49152, -131070, -458750}};
    orr_time t0;
    assert_int_equal(orr_time_parse("2024-02-04T10:00:00", NULL, &t0, NULL), ORR_OK);
    orr_tec_field *f;
    orr_diag d = {0};
    orr_tec_broadcast set = {.t = ORR_TIME_NONE};
    memcpy(set.value, k.alpha, sizeof k.alpha);
    memcpy(set.value + 4, k.beta, sizeof k.beta);
    ASSERT_OK(orr_tec_field_from_broadcast(ORR_TEC_GPS, &set, 1, t0, orr_time_add_s(t0, 86400), "made", NULL,
                                           &f, &d),
              d);
    orr_tec_instant *at = malloc(sizeof *at);
    orr_iono_site s;
    orr_pierce p;
    orr_tec_ray r;
    ASSERT_OK(orr_tec_field_at(f, t0, at, &d), d);
    ASSERT_OK(orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.9, 0.3, 100}), &s, &d), d);
    ASSERT_OK(orr_pierce_direction(&s, 2, 0.5, ORR_SHELL_RADIUS_M, &p, &d), d);
    ASSERT_OK(orr_tec_look_through(at, &s, &p, &r, &d), d);
    ASSERT_NEAR(orr_iono_delay_m(r.stec_tecu, 1575.42e6, ORR_MEASURES_CODE),
                orr_klobuchar_delay_m(&k, t0, 0.9, 0.3, 2, 0.5), 1e-6);
    set.value[6] = ORR_NAN;
    orr_tec_field_free(f);
    assert_int_equal(orr_tec_field_from_broadcast(ORR_TEC_GPS, &set, 1, t0, t0, "made", NULL, &f, &d),
                     ORR_E_FORMAT);
    free(at);
}

// Sets that change: the latest of the past holds, before the first that one.
static void test_broadcast_sets(void **state)
{
    (void)state;
    orr_time t0;
    assert_int_equal(orr_time_parse("2024-02-04T00:00:00", NULL, &t0, NULL), ORR_OK);
    orr_tec_broadcast set[3] = {{.t = t0}, {.t = orr_time_add_s(t0, 7200)}, {.t = orr_time_add_s(t0, 14400)}};
    for (int k = 0; k < 3; k++) set[k].value[0] = 20 + 10 * k;
    const orr_time from = orr_time_add_s(t0, -86400), to = orr_time_add_s(t0, 86400);
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_broadcast(ORR_TEC_BDGIM, set, 3, from, to, "made", NULL, &f, &d), d);
    assert_string_equal(orr_tec_field_kind(f), "bdgim");
    const orr_time *epochs;
    assert_int_equal(orr_tec_field_epochs(f, &epochs), 0);
    orr_tec_instant *at = malloc(sizeof *at);
    const struct {
        double after_s;
        int k;
    } seen[] = {{-3600, 0}, {0, 0}, {7199, 0}, {7200, 1}, {14400, 2}, {86400, 2}};
    for (size_t i = 0; i < sizeof seen / sizeof *seen; i++) {
        const orr_time t = orr_time_add_s(t0, seen[i].after_s);
        orr_tec_value v;
        ASSERT_OK(orr_tec_field_at(f, t, at, &d), d);
        ASSERT_OK(orr_tec_vertical(at, unit(0.35, 1.7), &v, &d), d);
        ASSERT_NEAR(v.vtec_tecu, orr_bdgim_vertical_tecu(set[seen[i].k].value, t, 0.35, 1.7), 1e-9);
    }
    // As a file and back.
    orr_nc_writer w;
    orr_nc_reader nc;
    orr_tec_field *g;
    ASSERT_OK(orr_nc_create("broadcast-field.nc", &w, &d), d);
    ASSERT_OK(orr_tec_field_put(&w, f, &d), d);
    ASSERT_OK(orr_nc_commit(&w, &d), d);
    ASSERT_OK(orr_nc_open("broadcast-field.nc", &nc, &d), d);
    ASSERT_OK(orr_tec_field_get(&nc, NULL, &g, &d), d);
    orr_nc_close(&nc);
    assert_string_equal(orr_tec_field_kind(g), "bdgim");
    for (double after_s = -3600; after_s < 20000; after_s += 1800)
        assert_true(vtec(g, orr_time_add_s(t0, after_s), 0.35, 1.7) ==
                    vtec(f, orr_time_add_s(t0, after_s), 0.35, 1.7));
    orr_tec_field_free(g);
    orr_tec_field_free(f);

    // BeiDou's eight in BeiDou's formula, as electron content whatever the carrier.
    orr_tec_broadcast eight = {ORR_TIME_NONE, {2e-8, 1e-8, -3e-8, 0, 100000, 20000, 0, 0}};
    const orr_klobuchar k = {{2e-8, 1e-8, -3e-8, 0}, {100000, 20000, 0, 0}};
    ASSERT_OK(orr_tec_field_from_broadcast(ORR_TEC_BEIDOU, &eight, 1, from, to, "made", NULL, &f, &d), d);
    assert_string_equal(orr_tec_field_kind(f), "klobuchar");
    orr_iono_site s;
    orr_pierce p;
    orr_tec_ray r;
    ASSERT_OK(orr_tec_field_at(f, t0, at, &d), d);
    ASSERT_OK(orr_iono_site_at(orr_earth_to_ecef((orr_geodetic){0.7, 2, 100}), &s, &d), d);
    ASSERT_OK(orr_pierce_direction(&s, 2, 0.5, ORR_SHELL_RADIUS_M, &p, &d), d);
    ASSERT_OK(orr_tec_look_through(at, &s, &p, &r, &d), d);
    ASSERT_NEAR(orr_iono_delay_m(r.stec_tecu, 1561.098e6, ORR_MEASURES_CODE),
                orr_klobuchar_beidou_delay_m(&k, t0, 0.7, 2, 2, 0.5), 1e-6);
    ASSERT_NEAR(r.mapping * r.vtec_tecu, r.stec_tecu, 1e-9);
    orr_tec_field_free(f);

    assert_int_equal(orr_tec_field_from_broadcast(ORR_TEC_BDGIM, set, 0, from, to, "made", NULL, &f, &d),
                     ORR_E_NODATA);
    assert_int_equal(orr_tec_field_from_broadcast(ORR_TEC_AUTO, set, 3, from, to, "made", NULL, &f, &d),
                     ORR_E_ARG);
    assert_int_equal(orr_tec_field_from_broadcast(ORR_TEC_NEQUICK, set, 3, from, to, "made", NULL, &f, &d),
                     ORR_E_NODATA);
    set[2].t = set[1].t;
    assert_int_equal(orr_tec_field_from_broadcast(ORR_TEC_BDGIM, set, 3, from, to, "made", NULL, &f, &d),
                     ORR_E_FORMAT);
    free(at);
}

// A field of 20 TECU everywhere, seen from space: what the shell of 450 km has, by the angle at which rays cross it.
static void rays_of_space_cross_the_shell(void **state)
{
    (void)state;
    made m = make(2, 2, false);
    for (size_t i = 0; i < (size_t)2 * ROWS * COLS; i++) m.tec[i] = 20;
    orr_tec_field *f;
    orr_diag d = {0};
    ASSERT_OK(orr_tec_field_from_maps(&m.maps, NULL, &f, &d), d);
    orr_tec_instant *at = malloc(sizeof *at);
    ASSERT_OK(orr_tec_field_at(f, m.t[0], at, &d), d);
    for (double height = 300e3; height < 3e6; height += 1036e3)
        for (double lowest = 50e3; lowest < 300e3;
             lowest += 100e3) { // of the ray, above the sphere of the shell's own centre
            const double R = 6378e3 + height, foot = 6378e3 + lowest, down = -acos(foot / R);
            const orr_vec3 r = {R, 0, 0}, along = {sin(down), cos(down), 0}; // in the equator's plane
            orr_iono_site s;
            orr_tec_ray ray;
            ASSERT_OK(orr_iono_site_at(r, &s, &d), d);
            const orr_status got = orr_tec_look(at, &s, orr_vec3_axpy(40e6, along, r), &ray, &d);
            assert_int_equal(got, lowest < 100e3 ? ORR_E_RANGE : ORR_OK); // through the air, or not
            if (got != ORR_OK) continue;
            const double sine = foot / ORR_SHELL_RADIUS_M, once = 20 / sqrt(1 - sine * sine);
            ASSERT_NEAR(ray.stec_tecu, R > ORR_SHELL_RADIUS_M ? 2 * once : once, 1e-6);
            ASSERT_NEAR(ray.mapping * 20, ray.stec_tecu, 1e-6);
            ASSERT_NEAR(ray.pierce.el_rad, down, 1e-12);
            ASSERT_OK(orr_tec_look(at, &s, (orr_vec3){30e6, 1e6, 2e6}, &ray, &d), d); // upward
            if (R > ORR_SHELL_RADIUS_M) assert_true(ray.stec_tecu == 0 && ray.mapping == 0);
            if (R < ORR_SHELL_RADIUS_M) ASSERT_NEAR(ray.stec_tecu, 20, 0.2); // nearly vertical
            const double half =
                sqrt(R * R - foot * foot); // a satellite at the ray's lowest point: the way down alone
            ASSERT_OK(orr_tec_look(at, &s, orr_vec3_axpy(half, along, r), &ray, &d), d);
            ASSERT_NEAR(ray.stec_tecu, R > ORR_SHELL_RADIUS_M ? once : 0, 1e-6);
        }
    free(at);
    orr_tec_field_free(f);
    drop(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refit_exact),    cmocka_unit_test(leap_seconds_are_the_runs),
        cmocka_unit_test(test_between_epochs), cmocka_unit_test(test_rms_and_ray),
        cmocka_unit_test(test_clipped_cells),  cmocka_unit_test(test_holes),
        cmocka_unit_test(test_negative_cells), cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_region),         cmocka_unit_test(test_edges_are_held),
        cmocka_unit_test(test_model),          cmocka_unit_test(test_klobuchar_field),
        cmocka_unit_test(test_broadcast_sets), cmocka_unit_test(rays_of_space_cross_the_shell)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
