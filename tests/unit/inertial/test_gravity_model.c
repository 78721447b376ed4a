// SPDX-License-Identifier: GPL-3.0-or-later
// Spherical harmonics as gravity: against fields known in closed form, against their own derivatives, and as
// the one gravity of generator, navigator and gravimetry.
#include "testing.h"

#include <unistd.h>

#include "core/rng.h"
#include "flights.h"
#include "gravity_model.h"
#include "inertial/gravimetry/gravimetry.h"
#include "inertial/nav/null_test.h"
#include "inertial/readings/imu_file.h"
#include "inertial/sense/sensors.h"

#define DEG ORR_RAD_PER_DEG

static char folder[] = "gravity-model-XXXXXX";
static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}
static int remove_folder(void **state)
{
    (void)state;
    return rmdir(folder);
}

static orr_gravity_model *open_model(const test_model *made)
{
    orr_gravity_model *m;
    orr_diag diag = {0};
    test_model_write(folder, "made", made);
    ASSERT_OK(orr_gravity_model_open("made", folder, &m, &diag), diag);
    test_model_remove(folder, "made");
    return m;
}

static orr_vec3 random_place(uint64_t k, double low_m, double high_m)
{
    double z = 2 * orr_rng_uniform(3, 0, k) - 1, l = 2 * ORR_PI * orr_rng_uniform(3, 1, k),
           r = low_m + (high_m - low_m) * orr_rng_uniform(3, 2, k), w = sqrt(1 - z * z);
    return orr_vec3_make(r * w * cos(l), r * w * sin(l), r * z);
}

static double apart(orr_vec3 a, orr_vec3 b) { return orr_vec3_norm(orr_vec3_sub(a, b)); }

// J2 of a level ellipsoid (Heiskanen and Moritz 1967, eq. 2-90 with 2-58, q0 as a series since its closed
// form loses ten digits).
static double level_j2(double a_m, double f, double gm_m3ps2, double rate_radps)
{
    double e2 = f * (2 - f), x = sqrt(e2 / (1 - e2)), q0 = 0, b = a_m * (1 - f),
           m = rate_radps * rate_radps * a_m * a_m * b / gm_m3ps2;
    for (int j = 20; j >= 1; j--)
        q0 += (j % 2 == 0 ? -2.0 : 2.0) * j * pow(x, 2 * j + 1) / ((2.0 * j + 1) * (2.0 * j + 3));
    return e2 / 3 * (1 - 2.0 / 15 * m * x / q0);
}

// A dozen zonals are the closed normal gravitation to rounding: two ways to one field, everywhere outside.
static void zonals_of_wgs84_are_normal_gravitation(void **state)
{
    (void)state;
    double j2 = level_j2(ORR_WGS84_A_M, ORR_WGS84_F, ORR_WGS84_GM, 7.292115e-5);
    // NIMA TR8350.2, chapter 3: the normalised second zonal of the ellipsoid is -0.484166774985e-3
    ASSERT_NEAR(j2, 0.484166774985e-3 * sqrt(5), 1.5e-15);
    test_model made;
    test_model_zonals(&made, ORR_WGS84_GM, ORR_WGS84_A_M, ORR_WGS84_E2, j2, 24);
    orr_gravity_model *m = open_model(&made);
    for (uint64_t k = 0; k < 2000; k++) {
        orr_vec3 r = random_place(k, 6.3785e6, k % 2 == 0 ? 6.5e6 : 4e7);
        ASSERT_NEAR(apart(orr_gravity_model_gravitation(m, r), orr_earth_normal_gravitation(r)), 0,
                    2e-14); // 9.8 m/s^2 in doubles
    }
    // as a room's gravity it has no disturbance anywhere
    orr_gravity *g;
    orr_diag diag = {0};
    orr_gravity_parts p = {.model = m};
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    for (int lat = -90; lat <= 90; lat += 10) {
        orr_vec3 r = orr_earth_to_ecef((orr_geodetic){lat * DEG, lat * DEG, 1000});
        ASSERT_NEAR(orr_gravity_disturbance_mgal(g, r), 0, 2e-9);
    }
    orr_gravity_free(g);
    orr_gravity_model_free(m);
}

// GRS 80 (Moritz 2000, Geodetic Reference System 1980): derived constants as published.
static void grs80_as_published(void **state)
{
    (void)state;
    const double a = 6378137, b = 6356752.3141, gm = 3986005e8, u = 7292115e-11, j2 = 108263e-8,
                 e2 = 0.00669438002290;
    ASSERT_NEAR(test_zonal(1, e2, j2), j2, 1e-18); // the formula returns what it was given
    ASSERT_NEAR(test_zonal(2, e2, j2), -0.00000237091222, 5e-15);
    ASSERT_NEAR(test_zonal(3, e2, j2), 0.00000000608347, 5e-15);
    ASSERT_NEAR(test_zonal(4, e2, j2), -0.00000000001427, 5e-15);
    ASSERT_NEAR(level_j2(a, 1 / 298.257222101, gm, u), j2, 1e-14); // the published flattening has 12 digits
    test_model made;
    test_model_zonals(&made, gm, a, e2, j2, 20);
    orr_gravity_model *m = open_model(&made);
    orr_vec3 equator = orr_gravity_model_gravitation(m, orr_vec3_make(0, -a, 0)),
             pole = orr_gravity_model_gravitation(m, orr_vec3_make(0, 0, b));
    ASSERT_NEAR(equator.y - u * u * a, 9.7803267715, 1e-10);
    ASSERT_NEAR(equator.x, 0, 1e-15);
    ASSERT_NEAR(-pole.z, 9.8321863685, 3e-10); // the published b has a tenth of a millimetre
    ASSERT_NEAR(hypot(pole.x, pole.y), 0, 1e-15);
    orr_gravity_model_free(m);
}

// Degree 0 is Newton's point, at any distance, inside the model's sphere too.
static void degree_zero_is_the_central_field(void **state)
{
    (void)state;
    test_model made = {.degree = 2, .gm_m3ps2 = 3.986e14, .radius_m = 6.378e6};
    orr_gravity_model *m = open_model(&made);
    for (uint64_t k = 0; k < 300; k++) {
        orr_vec3 r = random_place(k, 1e3, k % 3 == 0 ? 1e5 : 4e8);
        double n = orr_vec3_norm(r);
        orr_vec3 g = orr_gravity_model_gravitation(m, r),
                 newton = orr_vec3_scale(-made.gm_m3ps2 / (n * n * n), r);
        ASSERT_NEAR(apart(g, newton) / orr_vec3_norm(newton), 0, 2e-15);
    }
    orr_gravity_model_free(m);
}

static void seeded(test_model *made, int degree)
{
    *made = (test_model){.degree = degree, .gm_m3ps2 = 3.986e14, .radius_m = 6.378e6};
    uint64_t k = 0;
    for (int n = 2; n <= degree; n++) // Kaula's rule: 1e-5 / n^2
        for (int o = 0; o <= n; o++, k += 2) {
            made->c[n][o] = 1e-5 / (n * n) * (2 * orr_rng_uniform(11, 0, k) - 1);
            made->s[n][o] = o == 0 ? 0.0 : 1e-5 / (n * n) * (2 * orr_rng_uniform(11, 0, k + 1) - 1);
        }
}

// Gravitation is a gradient (its Jacobian is symmetric) of a harmonic function (and has no trace), outside
// the model's sphere and inside, where the series goes on.
static void a_model_is_a_harmonic_potential_field(void **state)
{
    (void)state;
    test_model made;
    seeded(&made, 30);
    orr_gravity_model *m = open_model(&made);
    const double h = 500;
    for (uint64_t k = 0; k < 200; k++) {
        orr_vec3 r = random_place(k, k % 2 == 0 ? 6.2e6 : 6.378e6, 7e6);
        double j[3][3];
        for (int i = 0; i < 3; i++) {
            orr_vec3 e = {i == 0 ? h : 0, i == 1 ? h : 0, i == 2 ? h : 0}, two = orr_vec3_scale(2, e);
            // five points: errs by h^4 over the fourth power of the shortest wave / 2 pi, 2e5 m
            orr_vec3 near = orr_vec3_sub(orr_gravity_model_gravitation(m, orr_vec3_add(r, e)),
                                         orr_gravity_model_gravitation(m, orr_vec3_sub(r, e))),
                     far = orr_vec3_sub(orr_gravity_model_gravitation(m, orr_vec3_add(r, two)),
                                        orr_gravity_model_gravitation(m, orr_vec3_sub(r, two)));
            orr_vec3 d = orr_vec3_scale(1 / (12 * h), orr_vec3_sub(orr_vec3_scale(8, near), far));
            j[0][i] = d.x;
            j[1][i] = d.y;
            j[2][i] = d.z;
        }
        // 1e-14 m/s2 of rounding over 500 m is 2e-17; the Jacobian is 3e-6
        ASSERT_NEAR(j[0][0] + j[1][1] + j[2][2], 0, 1e-15);
        ASSERT_NEAR(j[0][1] - j[1][0], 0, 1e-15);
        ASSERT_NEAR(j[0][2] - j[2][0], 0, 1e-15);
        ASSERT_NEAR(j[1][2] - j[2][1], 0, 1e-15);
    }
    // The centre of the Earth is no place, but no crash either.
    orr_vec3 centre = orr_gravity_model_gravitation(m, orr_vec3_make(0, 0, 0));
    assert_false(orr_vec3_norm(centre) < 1e3);
    orr_gravity_model_free(m);
}

// Far away only the central term is left; turned about the axis by lambda, a sectorial of order m turns by m
// lambda.
static void degrees_and_orders_have_their_shapes(void **state)
{
    (void)state;
    for (int n = 2; n <= 6; n++)
        for (int o = 1; o <= n; o++) {
            test_model made = {.degree = n, .gm_m3ps2 = 3.986e14, .radius_m = 6.378e6};
            made.c[n][o] = 1e-6;
            orr_gravity_model *cosine = open_model(&made);
            made.c[n][o] = 0;
            made.s[n][o] = 1e-6;
            orr_gravity_model *sine = open_model(&made);
            double turn = ORR_PI / (2 * o), ct = cos(turn), st = sin(turn);
            for (uint64_t k = 0; k < 20; k++) {
                orr_vec3 r = random_place(k, 6.4e6, 7e6), q = {ct * r.x - st * r.y, st * r.x + ct * r.y, r.z};
                orr_vec3 a = orr_gravity_model_gravitation(cosine, r),
                         b = orr_gravity_model_gravitation(sine, q);
                orr_vec3 turned = {ct * a.x - st * a.y, st * a.x + ct * a.y, a.z};
                ASSERT_NEAR(apart(turned, b), 0, 2e-14);
                // n + 2 powers of the distance
                orr_vec3 far = orr_gravity_model_gravitation(cosine, orr_vec3_scale(10, r));
                double d = orr_vec3_norm(r), f = made.gm_m3ps2 / (d * d * d);
                orr_vec3 extra = orr_vec3_axpy(f, r, a), rest = orr_vec3_axpy(f / 100, r, far);
                ASSERT_NEAR(apart(orr_vec3_scale(pow(10, -n - 2), extra), rest), 0, 2e-16); // of 0.1 m/s2
            }
            orr_gravity_model_free(cosine);
            orr_gravity_model_free(sine);
        }
}

// A model, masses and a map add up, in whatever company.
static void parts_add_up(void **state)
{
    (void)state;
    orr_diag diag = {0};
    test_model made;
    seeded(&made, 12);
    orr_gravity_model *m = open_model(&made);
    orr_point_mass mass = {orr_earth_to_ecef((orr_geodetic){0.5, 1.0, -9000}), 4e3};
    double lat[4], lon[4], mgal[16];
    for (int i = 0; i < 4; i++) {
        lat[i] = 0.4 + 0.1 * i;
        lon[i] = 0.9 + 0.1 * i;
        for (int k = 0; k < 4; k++) mgal[4 * i + k] = 10 * i - 7 * k;
    }
    orr_gravity_parts map = {
        .n_lat = 4, .n_lon = 4, .map_lat_rad = lat, .map_lon_rad = lon, .map_mgal = mgal};
    orr_gravity_parts p[4] = {{.model = m}, {.n_masses = 1, .mass = &mass}, map, map};
    p[3].model = m;
    p[3].n_masses = 1;
    p[3].mass = &mass;
    orr_gravity *g[4];
    for (int k = 0; k < 4; k++) ASSERT_OK(orr_gravity_make(&p[k], &g[k], &diag), diag);
    for (int k = 0; k < 25; k++) {
        orr_vec3 r = orr_earth_to_ecef((orr_geodetic){0.41 + 0.05 * (k % 5), 0.92 + 0.05 * (k / 5), 2000});
        double sum = 0;
        for (int i = 0; i < 3; i++) sum += orr_gravity_disturbance_mgal(g[i], r);
        ASSERT_NEAR(orr_gravity_disturbance_mgal(g[3], r), sum, 1e-8);
        assert_true(fabs(orr_gravity_disturbance_mgal(g[0], r)) > 1e-3); // each has a share
    }
    for (int k = 0; k < 4; k++) orr_gravity_free(g[k]);
    orr_gravity_model_free(m);
}

// Readings made in a model navigate back in it, from a file whose model has moved meanwhile; gravimetry finds
// the model's own disturbance; and whole runs agree with single increments.
static void one_gravity_for_generator_and_navigator(void **state)
{
    (void)state;
    orr_diag diag = {0};
    test_model made;
    seeded(&made, 36);
    test_model_write(folder, "flown", &made);
    orr_gravity_model *m;
    ASSERT_OK(orr_gravity_model_open("flown", folder, &m, &diag), diag);
    orr_gravity *g;
    orr_gravity_parts p = {.model = m};
    ASSERT_OK(orr_gravity_make(&p, &g, &diag), diag);
    orr_trajectory tr;
    orr_flight_plan plan = test_survey(56, 40);
    plan.duration_s = 300;
    ASSERT_OK(orr_trajectory_flight_plan(orr_time_from_week(2300, 0), &plan, &tr, NULL, &diag), diag);
    ASSERT_OK(orr_gravity_covers(g, &tr, &diag), diag); // a model is everywhere
    orr_imu imu;
    orr_imu_request q = {
        .duration_s = 300, .rate_hz = 100, .mode = {.approach = 2, .order = 2}, .gravity = g};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    for (size_t j = 0; j < imu.n; j += 37) {
        orr_vec3 th, dv;
        test_increment(&tr, g, ORR_QUADRATURE_GAUSS, 2, orr_imu_edge_s(&imu, j), orr_imu_edge_s(&imu, j + 1),
                       &th, &dv);
        ASSERT_NEAR(apart(dv, imu.dv_mps[j]), 0, 4e-15); // rounding of 10 m/s2 over 10 ms
    }
    orr_gravimetry truth;
    ASSERT_OK(orr_gravimetry_truth(&tr, g, &imu, 0, &truth, &diag), diag);
    char path[64];
    snprintf(path, sizeof path, "%s/imu.nc", folder);
    orr_imu_labels labels = {.history = "test",
                             .gravity_model_name = "flown",
                             .gravity_model_dir = "no such folder",
                             .truth_every = 5};
    ASSERT_OK(orr_imu_write(path, &imu, &truth, g, &labels, &diag), diag);
    orr_imu_file f;
    assert_int_equal(orr_imu_read(path, NULL, &f, &diag), ORR_E_IO);
    assert_non_null(strstr(diag.text, "flown"));
    assert_non_null(strstr(diag.text, "no such folder"));
    ASSERT_OK(orr_imu_read(path, folder, &f, &diag), diag);
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5, .gravity = f.gravity};
    orr_null_report n;
    ASSERT_OK(orr_null_test(&f.imu, &nav, NULL, NULL, &n, &diag), diag);
    ASSERT_NEAR(n.max_3d_m, 0, 1e-5);
    nav.gravity = NULL;
    ASSERT_OK(orr_null_test(&f.imu, &nav, NULL, NULL, &n, &diag), diag);
    assert_true(n.max_3d_m > 1.0); // and normal gravity is another field
    orr_gravimetry_result r;
    const orr_gravity_filter filter = {.length_s = 10.0};
    ASSERT_OK(orr_gravimetry_recover(&f.imu, &f.gravimetry, NULL, &filter, &r, &diag), diag);
    assert_true(fabs(r.true_mgal[0]) > 1);
    // Recovered over 0.1 s; what pulls sideways, in a vertical that turns by 4e-6 in half that time, stays.
    ASSERT_NEAR(r.filtered_rms_mgal, 0, 1e-2);
    orr_gravimetry_result_free(&r);
    orr_imu_file_free(&f);
    unlink(path);
    test_model_remove(folder, "flown");
    orr_gravimetry_free(&truth);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
    orr_gravity_free(g);
    orr_gravity_model_free(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zonals_of_wgs84_are_normal_gravitation),
        cmocka_unit_test(grs80_as_published),
        cmocka_unit_test(degree_zero_is_the_central_field),
        cmocka_unit_test(a_model_is_a_harmonic_potential_field),
        cmocka_unit_test(degrees_and_orders_have_their_shapes),
        cmocka_unit_test(parts_add_up),
        cmocka_unit_test(one_gravity_for_generator_and_navigator),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
