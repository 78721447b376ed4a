// SPDX-License-Identifier: GPL-3.0-or-later
// Pierce point, mapping functions, delays, the sun-fixed frame and the broadcast model.
#include "core/nan.h"
#include "iono/broadcast/klobuchar.h"
#include "iono/field/pierce.h"
#include "iono/field/sun_frame.h"
#include "testing.h"

static orr_iono_site site_at(double lat_deg, double lon_deg, double h)
{
    orr_iono_site s;
    orr_diag d = {0};
    ASSERT_OK(orr_iono_site_at(
                  orr_earth_to_ecef((orr_geodetic){lat_deg * ORR_RAD_PER_DEG, lon_deg * ORR_RAD_PER_DEG, h}),
                  &s, &d),
              d);
    return s;
}

static void test_pierce_point(void **state)
{
    (void)state;
    orr_diag d = {0};
    for (double lat = -85; lat < 90; lat += 17)
        for (double az = 0; az < 360; az += 40)
            for (double el = 0; el <= 90; el += 15) {
                orr_iono_site s = site_at(lat, 21, 300);
                orr_pierce p, q;
                ASSERT_OK(orr_pierce_direction(&s, az * ORR_RAD_PER_DEG, el * ORR_RAD_PER_DEG,
                                               ORR_SHELL_RADIUS_M, &p, &d),
                          d);
                ASSERT_NEAR(orr_vec3_norm(p.unit), 1, 1e-14);
                ASSERT_NEAR(p.el_rad, el * ORR_RAD_PER_DEG, 1e-12);
                // The point lies on the ray: a satellite far behind it is seen the same way and pierces at
                // the same place.
                orr_vec3 at = orr_vec3_scale(ORR_SHELL_RADIUS_M, p.unit);
                orr_vec3 sat = orr_vec3_axpy(30, orr_vec3_sub(at, s.pos_m), s.pos_m);
                ASSERT_OK(orr_pierce_ray(&s, sat, ORR_SHELL_RADIUS_M, &q, &d), d);
                ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(p.unit, q.unit)), 0, 1e-12);
                if (el < 90) ASSERT_NEAR(remainder(q.az_rad - az * ORR_RAD_PER_DEG, 2 * ORR_PI), 0, 1e-9);
            }
    // Spherical law of sines at a receiver where the vertical is the radius (a pole): psi = z - asin(r/R sin
    // z).
    orr_iono_site pole = site_at(90, 0, 0);
    double r = orr_vec3_norm(pole.pos_m);
    for (double el = 5; el < 90; el += 10) {
        orr_pierce p;
        double z = (90 - el) * ORR_RAD_PER_DEG;
        ASSERT_OK(orr_pierce_direction(&pole, 1, el * ORR_RAD_PER_DEG, ORR_SHELL_RADIUS_M, &p, &d), d);
        ASSERT_NEAR(ORR_PI / 2 - p.lat_rad, z - asin(r / ORR_SHELL_RADIUS_M * sin(z)), 1e-12);
    }
}

static void test_refused_rays(void **state)
{
    (void)state;
    orr_diag d = {0};
    orr_pierce p;
    orr_iono_site s = site_at(52, 17, 100);
    assert_int_equal(orr_pierce_direction(&s, 0, -0.01, ORR_SHELL_RADIUS_M, &p, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "below the horizon"));
    orr_iono_site high = site_at(52, 17, 600e3);
    assert_int_equal(orr_pierce_direction(&high, 0, 1, ORR_SHELL_RADIUS_M, &p, &d), ORR_E_RANGE);
    assert_non_null(strstr(d.text, "above the shell"));
    assert_int_equal(orr_iono_site_at((orr_vec3){0, 0, 0}, &s, &d), ORR_E_ARG);
    assert_int_equal(orr_iono_site_at((orr_vec3){ORR_NAN, 0, 0}, &s, &d), ORR_E_ARG);
}

static void test_mapping(void **state)
{
    (void)state;
    static const char *const name[] = {"none", "thin-shell", "mslm"};
    for (int k = 0; k < 3; k++) {
        orr_mapping m = orr_mapping_published((orr_mapping_kind)k);
        ASSERT_NEAR(orr_mapping_factor(&m, ORR_PI / 2), 1, 1e-15);
        assert_true(isnan(orr_mapping_factor(&m, -1e-9)));
        assert_true(isnan(orr_mapping_factor(&m, 1.6)));
        double before = 1e9;
        for (double el = 0; el <= 1.57; el += 0.01) {
            double f = orr_mapping_factor(&m, el);
            assert_true(f >= 1 && f <= before);
            before = f;
        }
        orr_mapping_kind again;
        assert_int_equal(orr_mapping_parse(name[k], &again, NULL), ORR_OK);
        assert_int_equal(again, k);
    }
    assert_int_equal(orr_mapping_parse("cosz", &(orr_mapping_kind){0}, NULL), ORR_E_ARG);
    // 1/cos z' with sin z' = 6371/6821 sin z at z = 60 degrees, worked by hand: sin z' = 0.808893, cos z' =
    // 0.587959.
    orr_mapping thin = orr_mapping_published(ORR_MAPPING_THIN_SHELL);
    ASSERT_NEAR(orr_mapping_factor(&thin, 30 * ORR_RAD_PER_DEG), 1 / 0.587959, 3e-6);
    // MSLM, R = 6371, H = 506.7, alpha = 0.9782, z = 80: sin z' = 0.926328 sin(78.256 deg) = 0.906934, cos z'
    // = 0.421268.
    orr_mapping mslm = orr_mapping_published(ORR_MAPPING_MSLM);
    ASSERT_NEAR(orr_mapping_factor(&mslm, 10 * ORR_RAD_PER_DEG), 1 / 0.421268, 3e-6);
}

static void test_delay(void **state)
{
    (void)state;
    double f1 = 1575.42e6, f5 = 1176.45e6;
    // One TECU on L1 is 16.2 cm (the figure of every textbook).
    ASSERT_NEAR(orr_iono_delay_m(1, f1, ORR_MEASURES_CODE), 0.16237, 1e-5);
    ASSERT_NEAR(orr_iono_delay_m(20, f1, ORR_MEASURES_PHASE), -orr_iono_delay_m(20, f1, ORR_MEASURES_CODE),
                0);
    ASSERT_NEAR(orr_iono_delay_m(20, f5, ORR_MEASURES_CODE) / orr_iono_delay_m(20, f1, ORR_MEASURES_CODE),
                (154.0 / 115) * (154.0 / 115), 1e-14);
}

static void test_sun_frame(void **state)
{
    (void)state;
    orr_time noon;
    assert_int_equal(orr_time_parse("2024-03-20T12:00:00Z", NULL, &noon, NULL), ORR_OK);
    ASSERT_NEAR(orr_mean_sun_lon(noon, NULL), 0, 1e-12);
    for (int h = 1; h < 12; h++) {
        ASSERT_NEAR(orr_mean_sun_lon(orr_time_add_s(noon, h * 3600), NULL), -h * ORR_PI / 12, 1e-12);
        ASSERT_NEAR(orr_mean_sun_lon(orr_time_add_s(noon, -h * 3600), NULL), h * ORR_PI / 12, 1e-12);
    }
    orr_mat3 g = orr_geomagnetic_axes(79 * ORR_RAD_PER_DEG, -71 * ORR_RAD_PER_DEG);
    orr_mat3 t = orr_mat3_transpose(&g), one = orr_mat3_mul(&g, &t);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) ASSERT_NEAR(one.m[i][j], i == j, 1e-15);
    double lat = 79 * ORR_RAD_PER_DEG, lon = -71 * ORR_RAD_PER_DEG;
    orr_vec3 pole = orr_mat3_apply(&g, (orr_vec3){cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)});
    ASSERT_NEAR(pole.z, 1, 1e-15);
    // With the pole at the Earth's own, geomagnetic is geographic.
    orr_mat3 plain = orr_geomagnetic_axes(ORR_PI / 2, 0);
    ASSERT_NEAR(orr_geomagnetic_lon_of_equator(&plain, 1.234), 1.234, 1e-15);
    // Turned to the Sun, the sub-solar point has longitude 0.
    double sun = 2.5, from = orr_geomagnetic_lon_of_equator(&g, sun);
    orr_mat3 s = orr_axes_turned(&g, from);
    orr_vec3 v = orr_mat3_apply(&s, (orr_vec3){cos(sun), sin(sun), 0});
    ASSERT_NEAR(atan2(v.y, v.x), 0, 1e-15);
}

// The broadcast model: 5 ns at night whatever the coefficients; at local 14 h the amplitude's bump; obliquity
// 1 + 16 (0.53 - E)^3; azimuth along the meridian moves the pierce point's latitude by psi.
static void test_klobuchar(void **state)
{
    (void)state;
    const double c = 299792458.0;
    orr_klobuchar k = {{1.0245e-8, 1.4901e-8, -5.9605e-8, -1.1921e-7}, {88064, 49152, -131070, -458750}};
    orr_time t;
    assert_int_equal(orr_time_parse("2024-02-04T02:00:00", NULL, &t, NULL), ORR_OK);
    ASSERT_NEAR(orr_klobuchar_vertical_m(&k, t, 0.9, 0), 5e-9 * c, 1e-12);
    assert_int_equal(orr_time_parse("2024-02-04T14:00:00", NULL, &t, NULL), ORR_OK);
    double phi = 0.2 + 0.064 * cos(-1.617 * ORR_PI);
    double amp = 1.0245e-8 + phi * (1.4901e-8 + phi * (-5.9605e-8 + phi * -1.1921e-7));
    ASSERT_NEAR(orr_klobuchar_vertical_m(&k, t, 0.2 * ORR_PI, 0), c * (5e-9 + amp), 1e-9);
    // Zenith: psi = 0.0137/0.61 - 0.022 = 0.000459 semicircles and obliquity 1 + 16 0.03^3.
    double psi = 0.0137 / 0.61 - 0.022;
    ASSERT_NEAR(orr_klobuchar_delay_m(&k, t, 0.2 * ORR_PI, 0, 0, ORR_PI / 2),
                (1 + 16 * 0.03 * 0.03 * 0.03) * orr_klobuchar_vertical_m(&k, t, (0.2 + psi) * ORR_PI, 0),
                1e-9);
    assert_true(orr_klobuchar_delay_m(&k, t, 0.9, 0.3, 1, 0.1) >
                2 * orr_klobuchar_delay_m(&k, t, 0.9, 0.3, 1, 1.5));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pierce_point), cmocka_unit_test(test_refused_rays),
        cmocka_unit_test(test_mapping),      cmocka_unit_test(test_delay),
        cmocka_unit_test(test_sun_frame),    cmocka_unit_test(test_klobuchar)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
