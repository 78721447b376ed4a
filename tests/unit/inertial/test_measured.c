// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of sensors: each term alone against its closed form, noises against their statistics and Allan deviations.
#include "testing.h"

#include "inertial/motion/analytic.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/allan.h"
#include "inertial/sense/measured.h"
#include "inertial/sense/sensors.h"

#define HZ 10.0

// Steady rates and forces, which sensors see as they are.
static orr_imu steady(size_t n, orr_vec3 rate, orr_vec3 force)
{
    orr_imu imu = {0};
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_allocate(&imu, n, 1, false, false, &diag), diag);
    imu.rate_hz = HZ;
    for (size_t k = 0; k < n; k++) {
        imu.dtheta_rad[k] = orr_vec3_scale(1.0 / HZ, rate);
        imu.dv_mps[k] = orr_vec3_scale(1.0 / HZ, force);
    }
    return imu;
}

static void measure(const orr_imu_errors *e, orr_imu *imu)
{
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_add_errors(e, imu, NULL, &diag), diag);
}

static void no_errors_are_no_change(void **state)
{
    (void)state;
    orr_imu imu = steady(100, orr_vec3_make(0.1, -0.2, 0.3), orr_vec3_make(1, 2, 9));
    const orr_imu_errors none = {.seed = 5};
    measure(&none, &imu);
    for (size_t k = 0; k < imu.n; k++) {
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(imu.measured_dtheta_rad[k], imu.dtheta_rad[k])), 0, 1e-16);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(imu.measured_dv_mps[k], imu.dv_mps[k])), 0, 1e-15);
    }
    orr_imu_free(&imu);
}

static void steady_terms_have_their_closed_forms(void **state)
{
    (void)state;
    const orr_vec3 w = {0.1, -0.2, 0.3}, f = {1, -2, 9};
    orr_imu imu = steady(50, w, f);
    orr_imu_errors e = {.gyro = {.bias = {1e-5, 2e-5, 3e-5},
                                 .ramp = {0, 1e-6, 0},
                                 .scale = {1e-3, 0, 0},
                                 .asymmetry = {0, 5e-4, 5e-4},
                                 .quadratic = {0, 0, 1e-3},
                                 .cubic = {0, 2e-3, 0},
                                 .cross = {{0, 1e-3, -2e-3}, {0, 0, 0}, {3e-3, 0, 0}},
                                 .by_force = {{1e-6, 0, 0}, {0, 0, 2e-6}, {0, 0, 0}},
                                 .by_force_squared = {0, 0, 1e-7}},
                        .accel = {.bias = {0, 0, 1e-3}, .quadratic = {0, 0, 1e-5}, .cross = {{0, 0, 1e-4}}}};
    measure(&e, &imu);
    for (size_t k = 0; k < imu.n; k++) {
        orr_vec3 m = orr_vec3_scale(HZ, imu.measured_dtheta_rad[k]),
                 a = orr_vec3_scale(HZ, imu.measured_dv_mps[k]);
        const double x = w.x + 1e-3 * w.y - 2e-3 * w.z, z = w.z + 3e-3 * w.x, t = ((double)k + 0.5) / HZ;
        ASSERT_NEAR(m.x, x * 1.001 + 1e-5 + 1e-6 * f.x, 1e-15);
        ASSERT_NEAR(m.y, w.y + 5e-4 * 0.2 + 2e-3 * w.y * w.y * w.y + 2e-5 + 2e-6 * f.z + 1e-6 * t, 1e-15);
        ASSERT_NEAR(m.z, z + 5e-4 * z + 1e-3 * z * z + 3e-5 + 1e-7 * f.z * f.z, 1e-15);
        ASSERT_NEAR(a.x, f.x + 1e-4 * f.z, 1e-13);
        ASSERT_NEAR(a.y, f.y, 1e-13);
        ASSERT_NEAR(a.z, f.z + 1e-5 * 81 + 1e-3, 1e-13);
    }
    orr_imu_free(&imu);
}

// What is rounded off is carried on: the sum is never off by more than half a quantum.
static void quantisation_keeps_the_sum(void **state)
{
    (void)state;
    orr_imu imu = steady(5000, orr_vec3_make(0.0123, -7e-6, 0), orr_vec3_make(0, 0, 9.80665));
    orr_imu_errors e = {.gyro = {.quantum = 5e-6}, .accel = {.quantum = 1e-3}};
    measure(&e, &imu);
    orr_vec3 th = {0, 0, 0}, dv = {0, 0, 0};
    for (size_t k = 0; k < imu.n; k++) {
        orr_vec3 m = imu.measured_dtheta_rad[k];
        ASSERT_NEAR(remainder(m.x, 5e-6), 0, 1e-15);
        th = orr_vec3_add(th, orr_vec3_sub(m, imu.dtheta_rad[k]));
        dv = orr_vec3_add(dv, orr_vec3_sub(imu.measured_dv_mps[k], imu.dv_mps[k]));
        assert_true(fabs(th.x) <= 2.5e-6 + 1e-9 && fabs(th.y) <= 2.5e-6 + 1e-9 && fabs(dv.z) <= 5e-4 + 1e-9);
    }
    orr_imu_free(&imu);
}

static void limits_cut_and_are_counted(void **state)
{
    (void)state;
    orr_imu imu = steady(100, orr_vec3_make(0.5, -2, 0), orr_vec3_make(0, 0, 9.8));
    imu.dtheta_rad[7].y = 0;
    orr_imu_errors e = {.gyro = {.limit = 1}};
    orr_errors_report report;
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_add_errors(&e, &imu, &report, &diag), diag);
    assert_int_equal(report.saturated[0], 99);
    assert_int_equal(report.saturated[1], 0);
    ASSERT_NEAR(imu.measured_dtheta_rad[3].y, -1 / HZ, 1e-16);
    imu.dtheta_rad[7].y = 1;
    assert_int_equal(orr_imu_add_errors(&e, &imu, &report, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "throughout"));
    orr_imu_free(&imu);
    // What is no model.
    imu = steady(10, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 9.8));
    const orr_imu_errors wrong[] = {{.gyro = {.white = {-1, -1, -1}}},
                                    {.accel = {.bias_sigma = -1}},
                                    {.gyro = {.n_processes = 1, .process = {{1, 0}}}},
                                    {.accel = {.n_processes = 1, .process = {{-1, 1}}}},
                                    {.accel = {.n_processes = 9}}};
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++)
        assert_int_equal(orr_imu_add_errors(&wrong[k], &imu, NULL, &diag), ORR_E_ARG);
    orr_imu_free(&imu);
}

// The same seed gives the same bits, another one others; channels are independent of each other.
static void seeds(void **state)
{
    (void)state;
    orr_imu a = steady(2000, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 0)),
            b = steady(2000, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 0));
    orr_imu_errors e = {
        .gyro = {.white = {1, 1, 1}, .bias_sigma = 0.1}, .accel = {.white = {1, 1, 1}}, .seed = 3};
    measure(&e, &a);
    measure(&e, &b);
    assert_memory_equal(a.measured_dtheta_rad, b.measured_dtheta_rad, a.n * sizeof *a.measured_dtheta_rad);
    e.seed = 4;
    measure(&e, &b);
    double same = 0, xy = 0, gyro_accel = 0;
    for (size_t k = 0; k < a.n; k++) {
        same += a.measured_dtheta_rad[k].x * b.measured_dtheta_rad[k].x * HZ / (double)a.n;
        xy += a.measured_dv_mps[k].x * a.measured_dv_mps[k].y * HZ / (double)a.n;
        gyro_accel += a.measured_dtheta_rad[k].z * a.measured_dv_mps[k].z * HZ / (double)a.n;
    }
    // correlations of 2000 normal pairs: 1 / sqrt(2000) = 0.022
    assert_true(fabs(same) < 0.1 && fabs(xy) < 0.1 && fabs(gyro_accel) < 0.1);
    orr_imu_free(&a);
    orr_imu_free(&b);
}

// What is put in comes back: white noise and a Gauss-Markov process from the Allan deviation, and the spread of a drawn
// bias over seeds.
static void noises_come_back(void **state)
{
    (void)state;
    orr_imu imu = steady(200000, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 0));
    orr_imu_errors e = {.gyro = {.white = {1e-4, 1e-4, 1e-4}, .n_processes = 1, .process = {{5e-5, 10}}},
                        .accel = {.white = {1e-3, 1e-3, 1e-3}, .walk = {2e-4, 2e-4, 2e-4}},
                        .seed = 11};
    measure(&e, &imu);
    double *x = malloc(imu.n * sizeof *x);
    orr_allan_fit g, a;
    orr_diag diag = {0};
    for (size_t k = 0; k < imu.n; k++) x[k] = imu.measured_dtheta_rad[k].x;
    ASSERT_OK(orr_allan_coefficients(x, imu.n, 1 / HZ, &g, &diag), diag);
    for (size_t k = 0; k < imu.n; k++) x[k] = imu.measured_dv_mps[k].z;
    ASSERT_OK(orr_allan_coefficients(x, imu.n, 1 / HZ, &a, &diag), diag);
    ASSERT_NEAR(g.noise[ORR_ALLAN_WHITE].value / 1e-4, 1, 0.02);
    assert_true(g.gauss_markov);
    ASSERT_NEAR(g.sigma / 5e-5, 1, 0.1);
    ASSERT_NEAR(g.correlation_s / 10, 1, 0.3);
    ASSERT_NEAR(a.noise[ORR_ALLAN_WHITE].value / 1e-3, 1, 0.02);
    ASSERT_NEAR(a.noise[ORR_ALLAN_RATE_WALK].value / 2e-4, 1, 0.1);
    free(x);
    orr_imu_free(&imu);
    imu = steady(1, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 0));
    double sum = 0;
    for (uint64_t seed = 0; seed < 1000; seed++) {
        orr_imu_errors drawn = {.gyro = {.bias_sigma = 2}, .seed = seed};
        measure(&drawn, &imu);
        sum += pow(imu.measured_dtheta_rad[0].y * HZ, 2) / 1000;
    }
    ASSERT_NEAR(sqrt(sum), 2, 0.15); // 2 / sqrt(2000), three times
    orr_imu_free(&imu);
}

// An accelerometer's bias of b at rest: the navigator swings by b / w^2 (1 - cos w t) with Schuler's w.
static orr_status at_half_period(void *user, const orr_null_point *p)
{
    double *most = user;
    *most = fmax(*most, p->horizontal_m);
    return ORR_OK;
}
static void a_bias_swings_as_schuler_says(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {0.0, 0.3, 0}};
    orr_trajectory tr;
    orr_imu imu;
    orr_imu_request q = {.duration_s = 3000, .rate_hz = 2, .mode = {.approach = 2, .order = 3}};
    ASSERT_OK(orr_trajectory_analytic(0, 0, 3000, &plan, &tr, &diag), diag);
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_imu_errors e = {.accel = {.bias = {0, 1e-4, 0}}};
    measure(&e, &imu);
    memcpy(imu.dv_mps, imu.measured_dv_mps, imu.n * sizeof *imu.dv_mps);
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5, .hold_vertical = true};
    orr_null_report r;
    double most = 0, w2 = 9.78 / 6378137.0; // half a period is 2537 s
    ASSERT_OK(orr_null_test(&imu, &nav, at_half_period, &most, &r, &diag), diag);
    ASSERT_NEAR(most / (2e-4 / w2), 1,
                0.02); // the flattening, and the Earth's turn in three quarters of an hour
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_errors_are_no_change),
        cmocka_unit_test(steady_terms_have_their_closed_forms),
        cmocka_unit_test(quantisation_keeps_the_sum),
        cmocka_unit_test(limits_cut_and_are_counted),
        cmocka_unit_test(seeds),
        cmocka_unit_test(noises_come_back),
        cmocka_unit_test(a_bias_swings_as_schuler_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
