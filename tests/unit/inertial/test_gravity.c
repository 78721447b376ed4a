// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include <unistd.h>

#include "flights.h"
#include "inertial/gravimetry/gravimetry.h"
#include "inertial/motion/dual_unit.h"
#include "inertial/motion/polar.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/sensors.h"

static const orr_navigator reference = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};

static orr_trajectory survey(double duration_s)
{
    orr_diag diag = {0};
    orr_trajectory tr;
    orr_flight_plan p = test_survey(56, 40);
    p.duration_s = duration_s;
    ASSERT_OK(orr_trajectory_flight_plan(orr_time_from_week(2300, 0), &p, &tr, NULL, &diag), diag);
    return tr;
}

// Two bumps of +50 and -30 mGal along the survey's lines.
static orr_gravity *profile(void)
{
    double d[141], mgal[141];
    for (int k = 0; k <= 140; k++) {
        d[k] = (k - 40) * 500.0;
        mgal[k] = 50 * exp(-pow((d[k] - 10e3) / 3e3, 2)) - 30 * exp(-pow((d[k] - 22e3) / 2.5e3, 2));
    }
    orr_gravity_parts p = {.n_profile = 141,
                           .profile_lat_rad = 56 * ORR_RAD_PER_DEG,
                           .profile_lon_rad = 40 * ORR_RAD_PER_DEG,
                           .profile_distance_m = d,
                           .profile_mgal = mgal};
    orr_gravity *g;
    orr_diag diag = {0};
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    return g;
}

static void disturbances_have_their_values(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_gravity *g = profile();
    orr_vec3 r =
        orr_earth_to_ecef((orr_geodetic){(56 + 10e3 / 111195.0) * ORR_RAD_PER_DEG, 40 * ORR_RAD_PER_DEG, 0});
    ASSERT_NEAR(orr_gravity_disturbance_mgal(g, r), 50, 0.1); // a profile's 500 m cells
    orr_gravity_free(g);
    // A point mass straight below: GM / d^2 downward.
    orr_vec3 place = orr_earth_to_ecef((orr_geodetic){0.5, 1.0, 1000});
    orr_point_mass mass = {orr_earth_to_ecef((orr_geodetic){0.5, 1.0, -4000}), 6.0e3};
    orr_gravity_parts p = {.n_masses = 1, .mass = &mass};
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    ASSERT_NEAR(orr_gravity_disturbance_mgal(g, place), 6.0e3 / 25e6 * 1e5, 1e-6);
    orr_gravity_free(g);
    // A map, linear in both, asked across the date line: bicubic keeps planes.
    double lat[5], lon[6], mgal[30];
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 6; k++) {
            lat[i] = (10 + i) * ORR_RAD_PER_DEG;
            lon[k] = (178 + k) * ORR_RAD_PER_DEG;
            mgal[i * 6 + k] = 3.0 * i - 2.0 * k;
        }
    p = (orr_gravity_parts){.n_lat = 5, .n_lon = 6, .map_lat_rad = lat, .map_lon_rad = lon, .map_mgal = mgal};
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    place = orr_earth_to_ecef((orr_geodetic){12.5 * ORR_RAD_PER_DEG, -178.5 * ORR_RAD_PER_DEG, 5000});
    ASSERT_NEAR(orr_gravity_disturbance_mgal(g, place), 3.0 * 2.5 - 2.0 * 3.5, 1e-6);
    // A track that leaves the map is told of.
    orr_trajectory tr = survey(100);
    assert_int_equal(orr_gravity_covers(g, &tr, &diag), ORR_E_RANGE);
    orr_trajectory_free(&tr);
    orr_gravity_free(g);
    lat[2] = lat[1];
    assert_int_equal(orr_gravity_make(&p, &g, &diag), ORR_E_ARG);
    // Steps that ascend, but over which a slope is no number; a place that is not on the Earth.
    lat[2] = 12 * ORR_RAD_PER_DEG;
    lat[0] = 0, lat[1] = 5e-324;
    assert_int_equal(orr_gravity_make(&p, &g, &diag), ORR_E_ARG);
    lat[1] = 11 * ORR_RAD_PER_DEG, lon[5] = 1e308;
    assert_int_equal(orr_gravity_make(&p, &g, &diag), ORR_E_ARG);
    const double along[3] = {0, 5e-324, 1}, rise[3] = {1, 2, 3};
    p = (orr_gravity_parts){.n_profile = 3, .profile_distance_m = along, .profile_mgal = rise};
    assert_int_equal(orr_gravity_make(&p, &g, &diag), ORR_E_ARG);
}

// Distances along a profile are those of the ellipsoid's geodesic: 26 km at 67.7 N on a sphere would be 100 m off.
// Carried elsewhere, profile and map have their values where their places went.
static void profiles_follow_geodesics(void **state)
{
    (void)state;
    orr_diag diag = {0};
    double d[61], mgal[61], lat[5], lon[6], grid[30];
    for (int k = 0; k <= 60; k++) {
        d[k] = -4000.0 + k * 500.0;
        mgal[k] = 13e-3 * d[k]; // a plane slope, which any spline keeps: 13 mGal a kilometre
    }
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 6; k++) {
            lat[i] = (67 + 0.5 * i) * ORR_RAD_PER_DEG;
            lon[k] = (178 + k) * ORR_RAD_PER_DEG;
            grid[i * 6 + k] = 3.0 * i - 2.0 * k;
        }
    for (int azimuth = 0; azimuth < 360; azimuth += 45) {
        double at_rad = azimuth * ORR_RAD_PER_DEG;
        orr_gravity_parts p = {.n_profile = 61,
                               .profile_lat_rad = 67.7 * ORR_RAD_PER_DEG,
                               .profile_lon_rad = 179.9 * ORR_RAD_PER_DEG,
                               .profile_azimuth_rad = at_rad,
                               .profile_distance_m = d,
                               .profile_mgal = mgal};
        orr_gravity_parts m = {
            .n_lat = 5, .n_lon = 6, .map_lat_rad = lat, .map_lon_rad = lon, .map_mgal = grid};
        orr_vec3 home = orr_earth_to_ecef((orr_geodetic){p.profile_lat_rad, p.profile_lon_rad, 0});
        orr_mat3 C = orr_polar_rotation(home, orr_vec3_make(1e3, 2e3, -6.3e6), 1.0);
        for (int carried = 0; carried < 2; carried++) {
            p.carried = m.carried = carried == 1;
            p.carried_by = m.carried_by = C;
            orr_gravity *g, *map;
            ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
            ASSERT_OK(orr_gravity_make(&m, &map, &diag), diag);
            for (double s = -4000; s <= 26000; s += 1000) {
                double lat2, lon2, az2;
                orr_earth_geodesic_direct(p.profile_lat_rad, p.profile_lon_rad, at_rad, s, &lat2, &lon2,
                                          &az2);
                orr_vec3 r = orr_earth_to_ecef((orr_geodetic){lat2, lon2, 3000});
                if (carried) r = orr_polar_place(&C, r);
                ASSERT_NEAR(orr_gravity_disturbance_mgal(g, r), 13e-3 * s, 2e-6); // 0.1 mm
                double turn = lon2 < 0 ? lon2 + 2 * ORR_PI : lon2;
                ASSERT_NEAR(orr_gravity_disturbance_mgal(map, r),
                            3.0 * (lat2 - lat[0]) / (0.5 * ORR_RAD_PER_DEG) -
                                2.0 * (turn - lon[0]) * ORR_DEG_PER_RAD,
                            1e-5);
            }
            orr_gravity_free(g);
            orr_gravity_free(map);
        }
    }
    // Half around the Earth.
    double far[5] = {0, 4e6, 9e6, 14e6, 18e6}, value[5] = {0, 4, 9, 14, 18};
    orr_gravity_parts p = {.n_profile = 5,
                           .profile_lat_rad = 0.5,
                           .profile_azimuth_rad = 1.2,
                           .profile_distance_m = far,
                           .profile_mgal = value};
    orr_gravity *g;
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    for (double s = 0; s <= 18e6; s += 7e5) {
        double lat2, lon2, az2;
        orr_earth_geodesic_direct(0.5, 0, 1.2, s, &lat2, &lon2, &az2);
        ASSERT_NEAR(orr_gravity_disturbance_mgal(g, orr_earth_to_ecef((orr_geodetic){lat2, lon2, 0})),
                    1e-6 * s, 2e-6);
    }
    orr_gravity_free(g);
}

// The injected profile comes back to 0.01 mGal, from a file too, and the null test holds in the disturbed
// field.
static void gravimetry_returns_the_profile(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_trajectory tr = survey(1200);
    orr_gravity *g = profile();
    ASSERT_OK(orr_gravity_covers(g, &tr, &diag), diag);
    orr_imu imu;
    orr_imu_request q = {
        .duration_s = 1200, .rate_hz = 50, .mode = {.approach = 2, .order = 2}, .gravity = g};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_gravimetry truth;
    ASSERT_OK(orr_gravimetry_truth(&tr, g, &imu, 0, &truth, &diag), diag);
    char path[] = "/tmp/orrery-imu-XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    orr_imu_labels labels = {.history = "test", .truth_every = 5};
    ASSERT_OK(orr_imu_write(path, &imu, &truth, g, &labels, &diag), diag);
    orr_imu_file f;
    ASSERT_OK(orr_imu_read(path, NULL, &f, &diag), diag);
    assert_int_equal(f.imu.n, imu.n);
    assert_int_equal(f.imu.t0, imu.t0);
    assert_int_equal(f.imu.truth_every, 5);
    assert_memory_equal(f.imu.dv_mps, imu.dv_mps, imu.n * sizeof *imu.dv_mps);
    orr_gravimetry_result r;
    const orr_gravity_filter filter = {.length_s = 10.0};
    ASSERT_OK(orr_gravimetry_recover(&f.imu, &f.gravimetry, NULL, &filter, &r, &diag), diag);
    double max = 0;
    for (size_t k = 0; k < r.n; k++) max = fmax(max, r.true_mgal[k]);
    assert_true(max > 40); // there was something to find
    ASSERT_NEAR(r.filtered_rms_mgal, 0, 1e-3);
    ASSERT_NEAR(r.raw_rms_mgal, 0, 1e-2); // trapezoidal mean of the truth over 0.1 s
    orr_gravimetry_result_free(&r);
    orr_navigator nav = reference;
    nav.gravity = f.gravity;
    orr_null_report n;
    ASSERT_OK(orr_null_test(&f.imu, &nav, NULL, NULL, &n, &diag), diag);
    ASSERT_NEAR(n.max_3d_m, 0, 1e-4); // bends of the profile's spline
    nav.gravity = NULL;               // and in another field it does not hold
    ASSERT_OK(orr_null_test(&f.imu, &nav, NULL, NULL, &n, &diag), diag);
    assert_true(n.max_3d_m > 1.0);
    orr_imu_file_free(&f);
    unlink(path);
    orr_gravimetry_free(&truth);
    orr_imu_free(&imu);
    orr_gravity_free(g);
    orr_trajectory_free(&tr);
}

// Readings and truth balance: f_up = v_U' - Eotvoes + gravity, at every instant.
static void gravimetry_truth_balances(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_trajectory tr = survey(600);
    orr_gravity *g = profile();
    orr_imu imu;
    orr_imu_request q = {.duration_s = 600, .rate_hz = 10, .mode = {.approach = 2, .order = 3}, .gravity = g};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_gravimetry t;
    ASSERT_OK(orr_gravimetry_truth(&tr, g, &imu, 1, &t, &diag), diag);
    double u = ORR_EARTH_RATE_RADPS;
    for (size_t k = 0; k < t.n; k += 7) {
        orr_motion m;
        orr_vec3 w, f;
        tr.evaluate(tr.self, orr_imu_edge_s(&imu, k), &m);
        orr_sensors_instant(&tr, g, orr_imu_edge_s(&imu, k), &w, &f);
        orr_geodetic at = orr_earth_from_ecef(m.r_m);
        orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad), B = orr_mat3_from_quat(m.q_be);
        double f_up = orr_mat3_apply(&E, orr_mat3_apply_t(&B, f)).z;
        orr_vec3 n = orr_vec3_add(orr_earth_normal_gravitation(m.r_m),
                                  orr_vec3_make(u * u * m.r_m.x, u * u * m.r_m.y, 0));
        double normal = -orr_mat3_apply(&E, n).z;
        ASSERT_NEAR(
            f_up, t.vertical_mps2[k] - 1e-5 * t.eotvos_mgal[k] + normal + 1e-5 * t.disturbance_mgal[k], 1e-9);
    }
    orr_gravimetry_free(&t);
    orr_imu_free(&imu);
    orr_gravity_free(g);
    orr_trajectory_free(&tr);
}

// The second unit: its own null test holds, with gravity at its own place; its readings differ as the lever
// arm says.
static void second_unit_on_a_lever_arm(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_trajectory tr = survey(3600), second;
    orr_mounting mounting = {{0.5, -2.0, 1.2}, orr_body_from_enu((orr_angles){0.3, 0.2, -0.1})};
    ASSERT_OK(orr_trajectory_mounted(&tr, &mounting, &second, &diag), diag);
    for (double t = 1; t < 3600; t += 333) {
        const double h = 1e-3;
        orr_motion a, m, b, one;
        second.evaluate(second.self, t - h, &a);
        second.evaluate(second.self, t, &m);
        second.evaluate(second.self, t + h, &b);
        tr.evaluate(tr.self, t, &one);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(m.r_m, one.r_m)), sqrt(0.25 + 4 + 1.44), 1e-8);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_vec3_scale(0.5 / h, orr_vec3_sub(b.r_m, a.r_m)), m.v_mps)),
                    0, 2e-6);
        ASSERT_NEAR(
            orr_vec3_norm(orr_vec3_sub(orr_vec3_scale(0.5 / h, orr_vec3_sub(b.v_mps, a.v_mps)), m.a_mps2)), 0,
            1e-6);
        ASSERT_NEAR(orr_vec3_norm(m.w_radps), orr_vec3_norm(one.w_radps), 1e-15);
    }
    orr_imu imu;
    orr_imu_request q = {.duration_s = 3600, .rate_hz = 100, .mode = {.approach = 2, .order = 2}};
    ASSERT_OK(orr_imu_generate(&second, &q, &imu, &diag), diag);
    orr_null_report r;
    ASSERT_OK(orr_null_test(&imu, &reference, NULL, NULL, &r, &diag), diag);
    ASSERT_NEAR(r.max_3d_m, 0, 2e-5);
    orr_imu_free(&imu);
    orr_trajectory_free(&second);
    mounting.C_21.m[0][0] = 2;
    assert_int_equal(orr_trajectory_mounted(&tr, &mounting, &second, &diag), ORR_E_ARG);
    orr_trajectory_free(&tr);
}

// The generator's short cut for gravitation agrees with asking the field at every node.
static void whole_runs_agree_with_single_increments(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_trajectory tr = survey(60);
    orr_imu imu;
    orr_imu_request q = {.duration_s = 60, .rate_hz = 100, .mode = {.approach = 2, .order = 2}};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_vec3 sum = {0, 0, 0};
    for (size_t j = 0; j < imu.n; j++) {
        orr_vec3 th, dv;
        test_increment(&tr, NULL, ORR_QUADRATURE_GAUSS, 2, orr_imu_edge_s(&imu, j),
                       orr_imu_edge_s(&imu, j + 1), &th, &dv);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(dv, imu.dv_mps[j])), 0,
                    2e-15); // rounding of 10 m/s^2 over 10 ms
        sum = orr_vec3_add(sum, dv);
    }
    orr_vec3 th, whole = {0, 0, 0}, part; // increments add up; the source's sum approaches the same
    for (int k = 0; k < 60; k++) {
        test_increment(&tr, NULL, ORR_QUADRATURE_GAUSS, 5, k, k + 1, &th, &part);
        whole = orr_vec3_add(whole, part);
    }
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(whole, sum)), 0, 1e-9);
    test_increment(&tr, NULL, ORR_QUADRATURE_RIEMANN, 1000, 0, 1, &th, &part);
    test_increment(&tr, NULL, ORR_QUADRATURE_GAUSS, 5, 0, 1, &th, &whole);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(whole, part)), 0, 1e-6);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disturbances_have_their_values),
        cmocka_unit_test(profiles_follow_geodesics),
        cmocka_unit_test(gravimetry_returns_the_profile),
        cmocka_unit_test(gravimetry_truth_balances),
        cmocka_unit_test(second_unit_on_a_lever_arm),
        cmocka_unit_test(whole_runs_agree_with_single_increments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
