// SPDX-License-Identifier: GPL-3.0-or-later
// Auxiliary outputs: truth where there are no errors, closed forms of what errors do, and sigmas from both sides.
#include "testing.h"

#include "inertial/motion/analytic.h"
#include "inertial/study/auxiliary.h"

#define DEG ORR_RAD_PER_DEG
enum { MOST = 20001 };

typedef struct record {
    size_t n;
    orr_aux_sample *s;
} record;

static orr_status keep(void *user, const orr_aux_sample *s)
{
    record *r = user;
    assert_true(r->n < MOST);
    r->s[r->n++] = *s;
    return ORR_OK;
}

static orr_trajectory circle(double seconds)
{
    const orr_analytic_plan plan = {
        .origin = {48 * DEG, 11 * DEG, 500},
        .attitude = {0, 2 * DEG, -3 * DEG},
        .follow_course = true,
        .n_terms = 1,
        .term = {{.kind = ORR_ANALYTIC_CIRCLE, .radius_m = 2000, .period_s = 600}}};
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(INT64_C(1400000000) * ORR_NS_PER_S, 0, seconds, &plan, &tr, &diag),
              diag);
    return tr;
}

static record observe(const orr_aux_plan *plan)
{
    record r = {0, calloc(MOST, sizeof *r.s)};
    orr_diag diag = {0};
    assert_non_null(r.s);
    ASSERT_OK(orr_auxiliary(plan, keep, &r, &diag), diag);
    return r;
}

// The inverse of the pressure below 11 km with the rounded constants of ISO 2533: geopotential height, then geometric.
static double standard_height_m(double hpa)
{
    const double geopotential = (1 - pow(hpa / 1013.25, 1 / 5.25588)) / 2.25577e-5;
    return 6356766.0 * geopotential / (6356766.0 - geopotential);
}

static void without_errors_they_are_the_truth(void **state)
{
    (void)state;
    orr_trajectory tr = circle(1200);
    const orr_aux_barometer baro = {0};
    const orr_aux_magnetometer mag = {0};
    const orr_aux_odometer odo = {.arm_m = {1, 0, 0}};
    const orr_aux_antennas ant = {.baseline_m = {0, 2, 0}};
    const orr_aux_receiver gnss = {.mask_rad = 5 * DEG};
    const orr_aux_plan plan = {.tr = &tr,
                               .duration_s = 1200,
                               .rate_hz = 10,
                               .barometer = &baro,
                               .magnetometer = &mag,
                               .odometer = &odo,
                               .antennas = &ant,
                               .receiver = &gnss,
                               .sky = orr_aux_nominal_sky};
    record r = observe(&plan);
    assert_int_equal(r.n, 12001);
    for (size_t k = 0; k < r.n; k += 100) {
        const orr_aux_sample *s = &r.s[k];
        orr_motion m;
        tr.evaluate(tr.self, s->t_s, &m);
        const orr_angles a = orr_motion_angles(&m);
        ASSERT_NEAR(s->height_m, orr_earth_from_ecef(m.r_m).height_m, 1e-9);
        ASSERT_NEAR(standard_height_m(s->pressure_hpa), s->height_m, 1e-8);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s->field_nt, s->true_field_nt)), 0, 1e-9);
        ASSERT_NEAR(remainder(s->heading_rad - a.heading_rad, 2 * ORR_PI), 0, 1e-12);
        ASSERT_NEAR(s->pitch_rad, a.pitch_rad, 1e-12);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s->position_m, m.r_m)), 0, 1e-8);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(s->velocity_mps, m.v_mps)), 0, 1e-12);
        assert_true(s->satellites >= 5 && s->satellites <= 14);
    }
    // Once about a circle of 2000 m, clockwise, the wheel a metre to the right, of which a pitch of 2 degrees sees the cosine.
    ASSERT_NEAR(r.s[6000].distance_m / (2 * ORR_PI * 1999 * cos(2 * DEG)), 1, 1e-3);
    free(r.s);
    orr_trajectory_free(&tr);
}

// The standard atmosphere's own table (ISO 2533), by geometric height: 0, 1000, 5000 m.
static void air_and_field_have_published_values(void **state)
{
    (void)state;
    ASSERT_NEAR(orr_aux_pressure_hpa(0), 1013.25, 1e-9);
    ASSERT_NEAR(orr_aux_pressure_hpa(1000), 898.76, 0.01);
    ASSERT_NEAR(orr_aux_pressure_hpa(5000), 540.48, 0.02);
    // The dipole: its axis leaves the surface at 80.65 N, 72.68 W in 2020 (Alken et al. 2021), where it is vertical and 59.5 uT; half
    // of that on its equator, along it.
    const double M = sqrt(29404.8 * 29404.8 + 1450.9 * 1450.9 + 4652.5 * 4652.5);
    const orr_vec3 axis =
        orr_vec3_scale(6371.2e3, orr_vec3_make(cos(80.65 * DEG) * cos(-72.68 * DEG),
                                               cos(80.65 * DEG) * sin(-72.68 * DEG), sin(80.65 * DEG)));
    const orr_geodetic pole = orr_earth_from_ecef(axis);
    const orr_mat3 enu = orr_earth_enu_from_ecef(pole.lat_rad, pole.lon_rad);
    const orr_vec3 b = orr_mat3_apply_t(&enu, orr_magnetic_field_nt(NULL, 2020, pole));
    ASSERT_NEAR(orr_vec3_dot(b, orr_vec3_unit(axis)), -2 * M, 0.05);
    ASSERT_NEAR(orr_vec3_norm(b), 2 * M, 0.05);
    const orr_vec3 across =
        orr_vec3_scale(6371.2e3, orr_vec3_unit(orr_vec3_cross(axis, orr_vec3_make(0, 0, 1))));
    ASSERT_NEAR(orr_vec3_norm(orr_magnetic_field_nt(NULL, 2020, orr_earth_from_ecef(across))), M, 0.05);
    // Without GeographicLib's files a model says so.
    orr_magnetic *m = NULL;
    orr_diag diag = {0};
    if (orr_magnetic_open("wmm2020", NULL, &m, &diag) == ORR_OK) {
        // The model's own test value: 2020.0, 80 N, 0 E, 0 km: X 6570.4, Y -146.3, Z 54606.0 nT (WMM2020 report, table 3).
        const orr_vec3 v = orr_magnetic_field_nt(m, 2020, (orr_geodetic){80 * DEG, 0, 0});
        ASSERT_NEAR(v.y, 6570.4, 0.1);
        ASSERT_NEAR(v.x, -146.3, 0.1);
        ASSERT_NEAR(v.z, -54606.0, 0.1);
        orr_magnetic_free(m);
    } else {
        assert_non_null(strstr(diag.text, "wmm2020"));
    }
}

// What is told of the receiver's errors is true: chi-square of 3 for position and velocity, their correlations included, and for white ranges nothing
// remembers anything.
static void geometry_s_covariance_is_that_of_the_errors(void **state)
{
    (void)state;
    orr_trajectory tr = circle(20000);
    const orr_aux_receiver gnss = {.mask_rad = 10 * DEG,
                                   .range_m = 1.5,
                                   .rate_mps = 0.05,
                                   .range_walking_m = 1,
                                   .range_correlation_s = 5};
    const orr_aux_plan plan = {.tr = &tr,
                               .duration_s = 20000,
                               .rate_hz = 0.2,
                               .seed = 4,
                               .receiver = &gnss,
                               .sky = orr_aux_nominal_sky};
    record r = observe(&plan);
    double position = 0, velocity = 0, up = 0, flat = 0;
    for (size_t k = 0; k < r.n; k++) {
        const orr_aux_sample *s = &r.s[k];
        position +=
            orr_vec3_dot(s->position_error_m, orr_mat3_solve(&s->position_covariance, s->position_error_m)) /
            (double)r.n;
        velocity += orr_vec3_dot(s->velocity_error_mps,
                                 orr_mat3_solve(&s->velocity_covariance, s->velocity_error_mps)) /
                    (double)r.n;
        up += s->position_covariance.m[2][2] / (double)r.n;
        flat += 0.5 * (s->position_covariance.m[0][0] + s->position_covariance.m[1][1]) / (double)r.n;
    }
    print_message("normalised squares %.3f, %.3f of 3; sigma %.2f m horizontal, %.2f m vertical\n", position,
                  velocity, sqrt(flat), sqrt(up));
    ASSERT_NEAR(position, 3,
                3.0 * sqrt(6.0 / (double)r.n) * 1.6); // samples of the process are correlated by 1/e
    ASSERT_NEAR(velocity, 3, 3.0 * sqrt(6.0 / (double)r.n));
    assert_true(up > flat && up < 100); // satellites are above alone
    free(r.s);
    orr_trajectory_free(&tr);
}

static void errors_are_as_told(void **state)
{
    (void)state;
    orr_trajectory tr = circle(2000);
    const orr_aux_barometer baro = {.height_m = {.bias = 3, .walking = 2, .correlation_s = 10, .white = 0.5},
                                    .scale = 0.01};
    const orr_aux_magnetometer mag = {.hard_nt = {100, -200, 300},
                                      .soft = {{{0.01, 0, 0}, {0, -0.02, 0}, {0.005, 0, 0}}}};
    const orr_aux_odometer odo = {.scale = 2e-3, .quantum_m = 0.1};
    const orr_aux_antennas ant = {
        .baseline_m = {0, 1.5, 0}, .across_m = 0.005, .up_m = 0.01, .heading_rad = {.bias = 0.01}};
    const orr_aux_plan plan = {.tr = &tr,
                               .duration_s = 2000,
                               .rate_hz = 10,
                               .seed = 2,
                               .barometer = &baro,
                               .magnetometer = &mag,
                               .odometer = &odo,
                               .antennas = &ant};
    record r = observe(&plan);
    double mean = 0, square = 0, heading = 0, off = 0, pitch = 0;
    for (size_t k = 0; k < r.n; k++) {
        const orr_aux_sample *s = &r.s[k];
        const double d = s->height_m - s->true_height_m * 1.01 - 3;
        mean += d / (double)r.n;
        square += d * d / (double)r.n;
        const orr_vec3 b = s->true_field_nt;
        ASSERT_NEAR(s->field_nt.x, 1.01 * b.x + 100, 1e-6);
        ASSERT_NEAR(s->field_nt.y, 0.98 * b.y - 200, 1e-6);
        ASSERT_NEAR(s->field_nt.z, b.z + 0.005 * b.x + 300, 1e-6);
        ASSERT_NEAR(remainder(s->distance_m, 0.1), 0, 1e-6);
        const double h = remainder(s->heading_rad - s->true_heading_rad, 2 * ORR_PI) - 0.01;
        off += h / (double)r.n;
        heading += h * h / (s->heading_sigma_rad * s->heading_sigma_rad) / (double)r.n;
        pitch += pow((s->pitch_rad - s->true_pitch_rad) / (0.01 / 1.5), 2) / (double)r.n;
    }
    ASSERT_NEAR(mean, 0, 3 * 2 * sqrt(2 * 10.0 / 2000)); // a process of 10 s over 2000 s
    ASSERT_NEAR(sqrt(square), sqrt(4.25), 0.15);
    ASSERT_NEAR(heading, 1, 0.03);
    ASSERT_NEAR(off, 0, 3 * 0.005 / 1.5 / sqrt((double)r.n));
    ASSERT_NEAR(sqrt(pitch), 1, 0.02); // cos of two degrees
    const double speed = 2 * ORR_PI * 2000 / 600 * cos(2 * DEG);
    ASSERT_NEAR(r.s[r.n - 1].distance_m / (speed * 2000 * 1.002), 1, 1e-3);
    free(r.s);
    orr_trajectory_free(&tr);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    orr_trajectory tr = circle(10);
    const orr_aux_barometer baro = {.height_m = {.white = -1}}, still = {.height_m = {.walking = 1}};
    const orr_aux_antennas none = {.baseline_m = {0, 0, 1}};
    const orr_aux_receiver gnss = {.range_m = -1};
    const orr_aux_plan plans[] = {{.tr = &tr, .rate_hz = 1, .barometer = &baro},
                                  {.tr = &tr, .rate_hz = 1, .barometer = &still},
                                  {.tr = &tr, .rate_hz = 1, .antennas = &none},
                                  {.tr = &tr, .rate_hz = 1, .receiver = &gnss, .sky = orr_aux_nominal_sky},
                                  {.tr = &tr, .rate_hz = 0}};
    record r = {0, calloc(MOST, sizeof *r.s)};
    orr_diag diag = {0};
    for (size_t k = 0; k < sizeof plans / sizeof plans[0]; k++)
        assert_int_equal(orr_auxiliary(&plans[k], keep, &r, &diag), ORR_E_ARG);
    const orr_aux_plan beyond = {.tr = &tr, .rate_hz = 1, .duration_s = 20};
    assert_int_equal(orr_auxiliary(&beyond, keep, &r, &diag), ORR_E_RANGE);
    free(r.s);
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_errors_they_are_the_truth),
        cmocka_unit_test(air_and_field_have_published_values),
        cmocka_unit_test(geometry_s_covariance_is_that_of_the_errors),
        cmocka_unit_test(errors_are_as_told),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
