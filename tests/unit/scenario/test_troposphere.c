// SPDX-License-Identifier: GPL-3.0-or-later
// Delays of the neutral atmosphere: published values, closed forms, limits, seasons.
#include "src/scenario/troposphere/troposphere.h"

#include <math.h>

#include "core/constants.h"
#include "testing.h"

static orr_time midnight; // 2024-02-04

static int set_up(void **state)
{
    (void)state;
    midnight = orr_time_from_mjd(60344, 0, ORR_SCALE_GPS, NULL);
    return 0;
}

static void tropospheres_of_the_models(void **state)
{
    (void)state;
    const double lat45 = 45 * ORR_RAD_PER_DEG;
    // Saastamoinen: 2.2768 mm a hPa at 45 deg and sea level.
    const orr_weather sea = orr_weather_standard(0, 0.5);
    ASSERT_NEAR(sea.pressure_hpa, 1013.25, 1e-9);
    ASSERT_NEAR(orr_zenith_saastamoinen(sea, lat45, 0).hydrostatic_m, 2.2768e-3 * 1013.25, 1e-9);
    // DO-229 without season, at the pole-ward end of the table: its own constants.
    const orr_zenith_delay d = orr_zenith_do229(lat45, 0, midnight);
    ASSERT_NEAR(d.hydrostatic_m + d.wet_m, 2.4, 0.12);
    // STANAG 4294: the integral of its refractivity, by Simpson's rule in steps of 10 m.
    for (double h0 = 0; h0 < 12000; h0 += 1500) {
        const double ns = 324.8, dn = -7.32 * exp(0.005577 * ns), c = log((ns + dn) / 105) / 8;
        double sum = 0;
        for (double h = h0; h < 120000; h += 10)
            for (int k = 0; k < 3; k++) {
                const double x = (h + 5 * k) / 1e3;
                const double n = x < 1   ? ns + dn * x
                                 : x < 9 ? (ns + dn) * exp(-c * (x - 1))
                                         : 105 * exp(-0.1424 * (x - 9));
                sum += (k == 1 ? 4 : 1) * n * 1e-6 * 10 / 6;
            }
        ASSERT_NEAR(orr_zenith_stanag4294(h0).hydrostatic_m, sum,
                    1e-5); // what is above 120 km: 2e-10 of it
    }
}

// Niell's factors at 100 m.
static void niell(double el_rad, double lat_rad, orr_time t, double *dry, double *wet)
{
    orr_mapping_fractions d, w;
    orr_mapping_niell_at(lat_rad, 100, t, &d, &w);
    *dry = orr_mapping_fraction(&d, el_rad);
    *wet = orr_mapping_fraction(&w, el_rad);
}

static orr_zenith_delay slant(const orr_scenario_troposphere *s, orr_geodetic place, double el_rad)
{
    orr_troposphere *o = NULL;
    orr_diag diag = {0};
    ASSERT_OK(orr_troposphere_open(s, NULL, &o, &diag), diag);
    const orr_troposphere_site site = orr_troposphere_at(o, 0, place, midnight);
    orr_troposphere_close(o);
    return orr_troposphere_slant(&site, 0, el_rad);
}

static void mappings_are_one_above_and_grow(void **state)
{
    (void)state;
    double dry, wet, last = 0.99;
    const double zenith = ORR_PI / 2, lat = 52 * ORR_RAD_PER_DEG;
    niell(zenith, lat, midnight, &dry, &wet);
    ASSERT_NEAR(dry, 1, 1e-12);
    ASSERT_NEAR(wet, 1, 1e-12);
    ASSERT_NEAR(orr_mapping_black_eisner(zenith), 1, 1e-5); // 1.001/sqrt(1.002001)
    ASSERT_NEAR(orr_mapping_cosecant(zenith), 1, 1e-15);
    for (double el = 90; el >= 3; el -= 1) {
        niell(el * ORR_RAD_PER_DEG, lat, midnight, &dry, &wet);
        assert_true(dry > last);
        assert_true(wet >= dry - 1e-12 || el > 15); // water lies lower: closer to 1/sin
        assert_true(dry <= 1 / sin(el * ORR_RAD_PER_DEG) + 1e-12);
        last = dry;
    }
    // North and south have opposite seasons, half a year apart.
    double south, same;
    const orr_time half = orr_time_add_s(midnight, 182.625 * 86400);
    niell(0.1, -lat, half, &south, &wet);
    niell(0.1, lat, midnight, &same, &wet);
    ASSERT_NEAR(south, same, 2e-4); // the calendar's day of year is not 365.25 long
}

static void the_troposphere_thins_with_height(void **state)
{
    (void)state;
    for (int model = ORR_TROPOSPHERE_SAASTAMOINEN; model <= ORR_TROPOSPHERE_STANAG4294; model++) {
        const orr_scenario_troposphere s = {
            .model = model, .mapping = ORR_TROPO_MAPPING_NIELL, .humidity = 0.7};
        double last = 100;
        for (double h = 0; h <= 9000; h += 1000) {
            const orr_zenith_delay d = slant(&s, (orr_geodetic){0.9, 0.3, h}, 30 * ORR_RAD_PER_DEG);
            assert_true(d.hydrostatic_m + d.wet_m < last && d.hydrostatic_m > 0);
            last = d.hydrostatic_m + d.wet_m;
        }
        for (double h = 10000; h <= 90000; h += 10000) {
            const orr_zenith_delay d = slant(&s, (orr_geodetic){0.9, 0.3, h}, 30 * ORR_RAD_PER_DEG);
            // At 20, 30, 40 km and more 5.4, 1.2, 0.28 % of the air and less are above (ICAO's tables), of a delay of 4.6 m.
            const double most_m = h < 15000 ? 1.3 : h < 25000 ? 0.4 : h < 35000 ? 0.12 : 0.05;
            assert_true(d.hydrostatic_m + d.wet_m <= last && d.hydrostatic_m + d.wet_m < most_m);
            last = d.hydrostatic_m + d.wet_m;
        }
        const orr_zenith_delay up = slant(&s, (orr_geodetic){0.9, 0.3, 150e3}, 0.5);
        ASSERT_NEAR(up.hydrostatic_m + up.wet_m, 0, 0);
    }
}

// Factors of the Global Mapping Function.
static void gmf(double el_rad, orr_geodetic place, orr_time t, double *dry, double *wet)
{
    orr_mapping_fractions d, w;
    orr_mapping_gmf_at(place, t, &d, &w);
    *dry = orr_mapping_fraction(&d, el_rad);
    *wet = orr_mapping_fraction(&w, el_rad);
}

// The test case that the IERS Conventions print with their routine GMF.F: Green Bank, MJD 55055.
static void global_mapping_is_the_published_one(void **state)
{
    (void)state;
    double dry, wet;
    const orr_geodetic green_bank = {0.6708665767, -1.393397187, 844.715};
    gmf(ORR_PI / 2 - 1.278564131, green_bank, orr_time_from_mjd(55055, 0, ORR_SCALE_UTC, NULL), &dry, &wet);
    ASSERT_NEAR(dry, 3.425245519339138678, 1e-12);
    ASSERT_NEAR(wet, 3.449589116182419257, 1e-12);
}

// Both mappings describe one atmosphere. At 5 deg the hydrostatic factor is 10.15, and a per cent of the delay there (0.23 m) is
// a fifth of that in height, 5 cm: more than a season that a mapping lacks can do, while a wrong sign of a season or of a latitude
// is. At the poles all meridians agree.
static void global_mapping_is_close_to_niells(void **state)
{
    (void)state;
    const double el = 5 * ORR_RAD_PER_DEG;
    for (int lat = -90; lat <= 90; lat += 15)
        for (int lon = -180; lon < 180; lon += 30)
            for (int month = 0; month < 12; month++) {
                const orr_geodetic place = {lat * ORR_RAD_PER_DEG, lon * ORR_RAD_PER_DEG, 100};
                const orr_time t = orr_time_add_s(midnight, month * 30.4 * 86400);
                double dry, wet, dry_n, wet_n, dry_0, wet_0;
                gmf(el, place, t, &dry, &wet);
                niell(el, place.lat_rad, t, &dry_n, &wet_n);
                ASSERT_NEAR(dry / dry_n, 1, 0.01);
                ASSERT_NEAR(wet / wet_n, 1, 0.02);
                gmf(ORR_PI / 2, place, t, &dry_0, &wet_0);
                ASSERT_NEAR(dry_0, 1, 1e-12);
                ASSERT_NEAR(wet_0, 1, 1e-12);
                if (abs(lat) < 90) continue;
                gmf(el, (orr_geodetic){place.lat_rad, 0, 100}, t, &dry_0, &wet_0);
                ASSERT_NEAR(dry, dry_0, 1e-10);
                ASSERT_NEAR(wet, wet_0, 1e-10);
            }
}

// By the scenario's word the slant delay is zenith delay times these factors.
static void a_scenario_chooses_its_mapping(void **state)
{
    (void)state;
    const orr_geodetic place = {0.9, 0.3, 200};
    const double el = 20 * ORR_RAD_PER_DEG;
    orr_scenario_troposphere s = {
        .model = ORR_TROPOSPHERE_SAASTAMOINEN, .mapping = ORR_TROPO_MAPPING_GMF, .humidity = 0.7};
    const orr_zenith_delay d = slant(&s, place, el);
    const orr_zenith_delay zenith =
        orr_zenith_saastamoinen(orr_weather_standard(200, 0.7), place.lat_rad, 200);
    double dry, wet;
    gmf(el, place, midnight, &dry, &wet);
    ASSERT_NEAR(d.hydrostatic_m, dry * zenith.hydrostatic_m, 1e-12);
    ASSERT_NEAR(d.wet_m, wet * zenith.wet_m, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tropospheres_of_the_models),
        cmocka_unit_test(mappings_are_one_above_and_grow),
        cmocka_unit_test(the_troposphere_thins_with_height),
        cmocka_unit_test(global_mapping_is_the_published_one),
        cmocka_unit_test(global_mapping_is_close_to_niells),
        cmocka_unit_test(a_scenario_chooses_its_mapping),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
