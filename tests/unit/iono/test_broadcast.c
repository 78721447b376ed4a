// SPDX-License-Identifier: GPL-3.0-or-later
// The models that satellites broadcast, against closed forms and worked values.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/nan.h"
#include "iono/broadcast/bdgim.h"
#include "iono/broadcast/klobuchar.h"
#include "iono/broadcast/nequick_private.h"
#include "testing.h"

static orr_time at(const char *text)
{
    orr_time t;
    assert_int_equal(orr_time_parse(text, NULL, &t, NULL), ORR_OK);
    return t;
}

static void beidou_of_eight(void **state)
{
    (void)state;
    const double c = ORR_LIGHT_MPS;
    const orr_time noon = at("2024-02-04T14:00:14"); // 14 h of BDT
    const orr_klobuchar k = {{2e-8, 1e-8, -3e-8, 0}, {100000, 20000, 0, 0}};
    // The peak at 14 h local: the amplitude alone; South as North.
    const double phi = 0.2, amplitude = 2e-8 + 1e-8 * phi - 3e-8 * phi * phi;
    ASSERT_NEAR(orr_klobuchar_beidou_vertical_m(&k, noon, phi * ORR_PI, 0), c * (5e-9 + amplitude), 1e-9);
    ASSERT_NEAR(orr_klobuchar_beidou_vertical_m(&k, noon, -phi * ORR_PI, 0), c * (5e-9 + amplitude), 1e-9);
    // A sixth of the period later: half of it. Later than a quarter, before noon by the day's wrap: the 5 ns.
    const double period = 100000 + 20000 * phi;
    ASSERT_NEAR(orr_klobuchar_beidou_vertical_m(&k, noon, phi * ORR_PI, period / 6 / 43200 * ORR_PI),
                c * (5e-9 + amplitude / 2), 1e-6);
    ASSERT_NEAR(orr_klobuchar_beidou_vertical_m(&k, noon, phi * ORR_PI, -ORR_PI * 0.75), c * 5e-9, 1e-9);
    // The period is never more than 172800 s.
    const orr_klobuchar slow = {{2e-8, 0, 0, 0}, {400000, 0, 0, 0}};
    ASSERT_NEAR(orr_klobuchar_beidou_vertical_m(&slow, noon, 0, ORR_PI / 3 * 2), c * (5e-9 + 1e-8), 1e-6);
    // Straight up: no obliquity; low down that of a shell at 375 km.
    ASSERT_NEAR(orr_klobuchar_beidou_delay_m(&slow, noon, 0.5, 0, 0, ORR_PI / 2), c * 2.5e-8, 1e-9);
    const double sin_zenith = 6378.0 / 6753.0 * cos(0.3);
    ASSERT_NEAR(orr_klobuchar_beidou_delay_m(&slow, noon, 0.5, 0, 0, 0.3),
                c * 2.5e-8 / sqrt(1 - sin_zenith * sin_zenith), 1e-9);
}

// What changes with each coefficient is its harmonic, normalised over the sphere.
static void bdgim_terms(void **state)
{
    (void)state;
    const orr_time t = at("2024-02-04T09:30:14");
    double sum[9] = {0}, weight = 0, mean = 0;
    const double none[9] = {0};
    for (int i = 0; i < 36; i++)
        for (int j = 0; j < 72; j++) {
            const double lat = (i - 17.5) * 5 * ORR_RAD_PER_DEG, lon = j * 5 * ORR_RAD_PER_DEG;
            const double base = orr_bdgim_vertical_tecu(none, t, lat, lon);
            weight += cos(lat);
            mean += base * cos(lat);
            for (int k = 0; k < 9; k++) {
                double one[9] = {0};
                one[k] = 1;
                const double y = orr_bdgim_vertical_tecu(one, t, lat, lon) - base;
                if (k == 0) ASSERT_NEAR(y, 1, 1e-12);
                sum[k] += y * y * cos(lat);
            }
        }
    for (int k = 0; k < 9; k++) ASSERT_NEAR(sum[k] / weight, 1, 0.01);
    ASSERT_NEAR(mean / weight, 0, 0.01); // the forecast is of degrees 3 to 5
    // The first-degree term about the pole is sqrt(3) sin of the geomagnetic latitude.
    const double second[9] = {0, 1};
    const double pole = 80.27 * ORR_RAD_PER_DEG, east = -72.58 * ORR_RAD_PER_DEG;
    ASSERT_NEAR(orr_bdgim_vertical_tecu(second, t, pole, east) - orr_bdgim_vertical_tecu(none, t, pole, east),
                sqrt(3), 1e-9);
}

static void bdgim_forecast_and_ray(void **state)
{
    (void)state;
    const double none[9] = {0}, some[9] = {30, 0, 0, 0, 0, 0, 0, 0, 0};
    // The forecast's coefficients hold for two hours, in which its axes follow the Sun: a point that follows it too sees
    // nothing new, but for the step between.
    const orr_time t = at("2024-02-04T08:00:14");
    const double lat = 80.27 * ORR_RAD_PER_DEG,
                 lon = -72.58 * ORR_RAD_PER_DEG; // the pole, where longitude is nothing
    const double first = orr_bdgim_vertical_tecu(none, t, lat, lon);
    ASSERT_NEAR(orr_bdgim_vertical_tecu(none, orr_time_add_s(t, 7199), lat, lon), first, 1e-6);
    assert_true(fabs(orr_bdgim_vertical_tecu(none, orr_time_add_s(t, 7201), lat, lon) - first) > 1e-3);
    // Straight up the slant is the vertical; low down that over the crossing times the shell's obliquity.
    const orr_geodetic site = {0.7, 2, 50};
    ASSERT_NEAR(orr_bdgim_slant_tecu(some, t, site, 1, ORR_PI / 2), orr_bdgim_vertical_tecu(some, t, 0.7, 2),
                1e-9);
    const double z = asin(6378.0 / 6778.0 * cos(0.4)), psi = ORR_PI / 2 - 0.4 - z;
    ASSERT_NEAR(orr_bdgim_slant_tecu(some, t, site, 0, 0.4),
                orr_bdgim_vertical_tecu(some, t, 0.7 + psi, 2) / cos(z), 1e-9);
    const double less[9] = {-200, 0, 0, 0, 0, 0, 0, 0, 0};
    assert_true(orr_bdgim_slant_tecu(less, t, site, 0, 0.4) == 0);
}

static void write_numbers(const char *folder, const char *name, int n, const char *number, const char *tail)
{
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    for (int i = 0; i < n; i++) fprintf(f, "%s%s", number, i % 4 == 3 ? "\n" : " ");
    fputs(tail, f);
    fclose(f);
}

static void remove_folder(const char *folder)
{
    char path[96];
    for (int m = 11; m <= 22; m++) {
        snprintf(path, sizeof path, "%s/ccir%d.asc", folder, m);
        assert_int_equal(unlink(path), 0);
    }
    snprintf(path, sizeof path, "%s/modip.asc", folder);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(folder), 0);
}

// Tables that are the same everywhere: 4 + 2 Azr/100 MHz and a factor of 3, at modip 0.
static void nequick_of_made_tables(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_nequick *n;
    char folder[] = "/tmp/orrery-nequick-XXXXXX";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(orr_nequick_load("nowhere", &n, &d), ORR_E_IO);
    write_numbers(folder, "modip.asc", 39 * 39, "0", "");
    for (int m = 11; m <= 22; m++) {
        char name[16];
        snprintf(name, sizeof name, "ccir%d.asc", m);
        write_numbers(folder, name, 2858, " 0.0E+00", "");
    }
    ASSERT_OK(orr_nequick_load(folder, &n, &d), d);
    assert_true(n->month[3].f2[1][75][12] == 0);
    orr_nequick_free(n);
    write_numbers(folder, "ccir13.asc", 2857, "0", "");
    assert_int_equal(orr_nequick_load(folder, &n, &d), ORR_E_FORMAT);
    assert_non_null(strstr(d.text, "2857 of the 2858"));
    write_numbers(folder, "ccir13.asc", 2858, "0", "1");
    assert_int_equal(orr_nequick_load(folder, &n, &d), ORR_E_FORMAT);
    assert_non_null(strstr(d.text, "more than"));
    write_numbers(folder, "ccir13.asc", 2857, "0", "x");
    assert_int_equal(orr_nequick_load(folder, &n, &d), ORR_E_FORMAT);
    assert_non_null(strstr(d.text, "not a number"));
    remove_folder(folder);

    // The grid of modip: a plane in latitude and longitude is met exactly by the third-order interpolation.
    orr_nequick *made = calloc(1, sizeof *made);
    assert_non_null(made);
    for (int i = 0; i < 39; i++)
        for (int k = 0; k < 39; k++) made->modip_deg[i][k] = 0.5 * (i * 5 - 95) + 0.01 * (k * 10 - 190);
    ASSERT_NEAR(neq_modip_deg(made, 12.3, 47), 0.5 * 12.3 + 0.47, 1e-12);
    ASSERT_NEAR(neq_modip_deg(made, -88.1, 360 - 151), 0.5 * -88.1 - 1.51, 1e-12);
    ASSERT_NEAR(neq_modip_deg(made, 90, 0), 45, 1e-12);

    const double ai[3] = {100, 2, 0.5}, zero[3] = {0};
    ASSERT_NEAR(neq_ionisation(ai, 10), 170, 1e-12);
    ASSERT_NEAR(neq_ionisation(ai, 80), 400, 1e-12);
    ASSERT_NEAR(neq_ionisation(zero, 80), 63.7, 1e-12);

    for (int m = 0; m < 12; m++)
        for (int a = 0; a < 2; a++) {
            made->month[m].f2[a][0][0] = a == 0 ? 4 : 6;
            made->month[m].m3[a][0][0] = 3;
        }
    neq_epoch e;
    neq_profile p;
    neq_epoch_init(made, 4, 0, 63.7, &e);
    ASSERT_NEAR(e.azr, 0, 0.01);
    neq_profile_at(&e, 10, 0, &p); // midnight
    ASSERT_NEAR(p.nm_f2, 0.124 * 16, 2e-3);
    assert_true(p.hm_f2 > 250 && p.hm_f2 < 400);
    ASSERT_NEAR(neq_density(&p, p.hm_f2), p.nm_f2, 0.02 * p.nm_f2);
    ASSERT_NEAR(neq_density(&p, p.hm_f2 + 1e-9), p.nm_f2, 1e-9);
    assert_true(neq_density(&p, 1000) < 0.2 * p.nm_f2 && neq_density(&p, 1000) > 0);
    assert_true(neq_density(&p, 60) < 1e-3);

    // The end of a ray: where a straight line from the site meets the height.
    const orr_geodetic site = {0.5, 1, 0}, up = orr_nequick_upper_end(site, 2, ORR_PI / 2, 2e7);
    ASSERT_NEAR(up.lat_rad, 0.5, 1e-12);
    ASSERT_NEAR(up.lon_rad, 1, 1e-12);
    const orr_geodetic far = orr_nequick_upper_end((orr_geodetic){-0.2, 1, 0}, 0, 0, 6371200);
    ASSERT_NEAR(far.lat_rad, ORR_PI / 3 - 0.2, 1e-9); // at twice the radius, 60 degrees on
    // A straight ray up through the same profile everywhere: the longer way is the richer.
    const orr_time t = at("2024-04-15T00:00:00Z");
    const double vertical = orr_nequick_slant_tecu(made, zero, t, NULL, site, up);
    assert_true(vertical > 3 && vertical < 30);
    assert_true(orr_nequick_slant_tecu(made, zero, t, NULL, site, orr_nequick_upper_end(site, 1, 0.3, 2e7)) >
                1.5 * vertical);
    // A ray is the sum of its parts: from the ground to 400 km and on; and down to its lowest point, 150 km, and up again.
    const double foot = 6371.2 + 150, tilt = 0.4;
    double part[4];
    for (int k = 0; k < 4; k++) {
        static const double from_km[] = {-2500, -2500, 0, 1200}, to_km[] = {20000, 0, 1200, 20000};
        orr_geodetic end[2];
        for (int side = 0; side < 2; side++) {
            const double s = side == 0 ? from_km[k] : to_km[k];
            const orr_vec3 x = {foot * cos(tilt), s, foot * sin(tilt)};
            const double size = orr_vec3_norm(x);
            end[side] = (orr_geodetic){asin(x.z / size), atan2(x.y, x.x), 1e3 * (size - 6371.2)};
        }
        part[k] = orr_nequick_path_tecu(made, zero, t, NULL, end[0], end[1]);
        ASSERT_NEAR(orr_nequick_path_tecu(made, zero, t, NULL, end[1], end[0]), part[k], 2e-3 * part[k]);
        if (k == 3) ASSERT_NEAR(orr_nequick_slant_tecu(made, zero, t, NULL, end[0], end[1]), part[k], 1e-12);
    }
    ASSERT_NEAR(part[0], part[1] + part[2] + part[3], 2e-3 * part[0]); // the integral's own tolerance
    assert_true(part[0] > 5 * vertical);
    assert_true(isnan(
        orr_nequick_path_tecu(made, zero, t, NULL, (orr_geodetic){0, 0, 4e5}, (orr_geodetic){0, 3, 4e5})));
    free(made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(beidou_of_eight), cmocka_unit_test(bdgim_terms),
                                       cmocka_unit_test(bdgim_forecast_and_ray),
                                       cmocka_unit_test(nequick_of_made_tables)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
