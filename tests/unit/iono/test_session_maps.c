// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of a fused session: the field far from the station, field and correction over it.
#include "testing.h"

#include "core/constants.h"
#include "iono/field/tec_files.h"
#include "iono/fusion/session_maps.h"

#define FIELD 20.0
#define MORE 5.0
#define FIRST_HOUR 6

static void a_flat_field_is_corrected_about_the_station(void **state)
{
    (void)state;
    static const double LAT[3] = {87.5, -87.5, -2.5}, LON[3] = {-180, 180, 5}, HEIGHT[3] = {450e3, 450e3, 0};
    orr_diag d = {0};
    orr_time t0;
    orr_ionex flat, maps;
    ASSERT_OK(orr_time_parse("2024-02-04", NULL, &t0, &d), d);
    ASSERT_OK(orr_ionex_alloc(13, t0, 7200, LAT, LON, HEIGHT, false, &flat, &d), d);
    for (size_t i = 0; i < flat.n_epochs * flat.n_lats * flat.n_lons; i++) flat.tec_tecu[i] = FIELD;
    orr_tec_options o = orr_tec_default_options();
    o.spatial = ORR_TEC_BILINEAR;
    orr_session s = {.from = orr_time_add_s(t0, FIRST_HOUR * 3600.0 + 1234),
                     .to = orr_time_add_s(t0, 8 * 3600.0 + 10)};
    ASSERT_OK(orr_tec_field_from_ionex(&flat, "flat", &o, &s.field, &d), d);
    double term[1][ORR_CORRECTION_TERMS] = {{MORE}};
    const double b = 52.5 * ORR_RAD_PER_DEG, l = 15 * ORR_RAD_PER_DEG; // a node of the grid
    s.correction = (orr_correction){.t0 = t0,
                                    .knot_s = 3600,
                                    .n = 1,
                                    .term = term,
                                    .up = {cos(b) * cos(l), cos(b) * sin(l), sin(b)},
                                    .east = {-sin(l), cos(l), 0},
                                    .north = {-sin(b) * cos(l), -sin(b) * sin(l), cos(b)},
                                    .scale = 6.821,
                                    .reach = 1};
    ASSERT_OK(orr_session_maps(&s, 3600, &maps, &d), d);
    assert_int_equal(maps.n_epochs, 3); // the hours 6, 7 and 8
    assert_int_equal(maps.epoch[0], orr_time_add_s(t0, FIRST_HOUR * 3600.0));
    double before = 2 * FIELD;
    for (size_t i = 0; i < maps.n_lats; i++) {
        const size_t column = 39; // 15 degrees East
        ASSERT_NEAR(maps.lon_deg[column], 15, 1e-12);
        const double tec = maps.tec_tecu[orr_ionex_index(&maps, 1, 0, i, column)],
                     apart = fabs(maps.lat_deg[i] - 52.5) * ORR_RAD_PER_DEG * s.correction.scale;
        if (apart < 0.99) ASSERT_NEAR(tec, FIELD + MORE, 1e-9); // within its reach
        if (apart > 3.01) ASSERT_NEAR(tec, FIELD, 1e-9);        // faded
        if (maps.lat_deg[i] < 52.5) assert_true(tec <= before + 1e-9);
        if (maps.lat_deg[i] <= 52.5) before = tec;
    }
    orr_ionex_free(&maps);
    assert_int_equal(orr_session_maps(&s, 0, &maps, &d), ORR_E_ARG);
    s.from = orr_time_add_s(t0, 30 * 3600.0), s.to = orr_time_add_s(t0, 31 * 3600.0);
    assert_int_equal(orr_session_maps(&s, 3600, &maps, &d), ORR_E_RANGE);
    orr_tec_field_free(s.field);
    orr_ionex_free(&flat);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_flat_field_is_corrected_about_the_station)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
