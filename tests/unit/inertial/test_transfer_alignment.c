// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer alignment over many draws: the filter's covariance is that of its errors, its residuals are white, heading is seen in
// manoeuvres and not in straight flight, and a bending arm is no more than noise.
#include "testing.h"

#include <gsl/gsl_cdf.h>

#include "inertial/motion/analytic.h"
#include "inertial/sense/sensors.h"
#include "inertial/study/flexure.h"
#include "inertial/study/transfer_alignment.h"

#define DEG ORR_RAD_PER_DEG
#define SECONDS 100.0
#define HZ 20.0

static const orr_imu_errors first_errors = {.gyro = {.bias_sigma = 1.5e-8, .white = {6e-7, 6e-7, 6e-7}},
                                            .accel = {.bias_sigma = 2.5e-4, .white = {1e-4, 1e-4, 1e-4}}};
static const orr_imu_errors second_errors = {
    .gyro = {.bias_sigma = 5e-6, .white = {2e-5, 2e-5, 2e-5}, .n_processes = 1, .process = {{1.5e-6, 100}}},
    .accel = {.bias_sigma = 3e-3, .white = {5e-4, 5e-4, 5e-4}, .n_processes = 1, .process = {{5e-4, 60}}}};
static const orr_flexure bends = {.sigma_rad = 2e-3, .beta_radps = 8};

typedef struct body {
    orr_trajectory tr, second;
    orr_imu imu[2];
    orr_mounting mounting;
} body;

// 80 m/s to the North-East; with turns a weave of +-200 m in 40 s, banked by nothing.
static void fly(body *b, bool turns, bool flexed, uint64_t seed)
{
    memset(b, 0, sizeof *b);
    const orr_analytic_plan plan = {
        .origin = {50 * DEG, 20 * DEG, 1000},
        .follow_course = true,
        .n_terms = turns ? 2 : 1,
        .term = {{.kind = ORR_ANALYTIC_STRAIGHT, .velocity_mps = {60, 60, 0}},
                 {.kind = ORR_ANALYTIC_SINE, .period_s = 40, .amplitude_m = {140, -140, 0}}}};
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, SECONDS, &plan, &b->tr, &diag), diag);
    orr_flexure arm = bends;
    arm.seed = seed;
    b->mounting =
        (orr_mounting){{0.5, -2.0, 1.2}, orr_body_from_enu((orr_angles){10 * DEG, 1 * DEG, -2 * DEG})};
    if (flexed)
        ASSERT_OK(orr_trajectory_flexed(&b->tr, &b->mounting, &arm, &b->second, &diag), diag);
    else
        ASSERT_OK(orr_trajectory_mounted(&b->tr, &b->mounting, &b->second, &diag), diag);
    const orr_imu_request q = {.duration_s = SECONDS, .rate_hz = HZ, .mode = {.approach = 2, .order = 3}};
    ASSERT_OK(orr_imu_generate(&b->tr, &q, &b->imu[0], &diag), diag);
    ASSERT_OK(orr_imu_generate(&b->second, &q, &b->imu[1], &diag), diag);
}

static void land(body *b)
{
    for (int k = 0; k < 2; k++) orr_imu_free(&b->imu[k]);
    orr_trajectory_free(&b->second);
    orr_trajectory_free(&b->tr);
}

static orr_transfer_result align(body *b, uint64_t seed, orr_vec3 flexure_mps)
{
    orr_diag diag = {0};
    orr_imu_errors e[2] = {first_errors, second_errors};
    for (int k = 0; k < 2; k++) {
        e[k].seed = 2 * seed + (uint64_t)k;
        ASSERT_OK(orr_imu_add_errors(&e[k], &b->imu[k], NULL, &diag), diag);
    }
    const orr_transfer_plan plan = {.first_tr = &b->tr,
                                    .second_tr = &b->second,
                                    .first = &b->imu[0],
                                    .second = &b->imu[1],
                                    .mounting = b->mounting,
                                    .interval = 20,
                                    .velocity_noise_mps = 0.02,
                                    .flexure_mps = flexure_mps,
                                    .mounting_sigma_rad = {0.3 * DEG, 0.3 * DEG, 1.0 * DEG},
                                    .start_velocity_mps = 0.1,
                                    .first_attitude_rad = {1e-4, 1e-4, 5e-4},
                                    .gyro = orr_transfer_noise_of(&first_errors.gyro, &second_errors.gyro),
                                    .accel = orr_transfer_noise_of(&first_errors.accel, &second_errors.accel),
                                    .seed = seed};
    orr_transfer_result r;
    ASSERT_OK(orr_transfer_align(&plan, NULL, NULL, &r, &diag), diag);
    return r;
}

// 8 draws, 200 where ORRERY_LONG is set: mean chi-square of 6, its 99 % interval; residuals of 1, their correlation 0.
static void many(bool turns, bool flexed, double *heading_seen)
{
    const size_t n = getenv("ORRERY_LONG") != NULL ? 200 : 8;
    body b;
    fly(&b, turns, flexed, 1);
    double nees = 0, white = 0, size = 0, heading = 0, sigma = 0;
    const orr_vec3 flexure =
        flexed ? orr_flexure_velocity_mps(&bends, b.mounting.arm_m) : orr_vec3_make(0, 0, 0);
    for (size_t k = 0; k < n; k++) {
        if (flexed && k > 0) { // bends in another way each time
            land(&b);
            fly(&b, turns, flexed, k + 1);
        }
        const orr_transfer_result r = align(&b, k + 1, flexure);
        nees += r.nees / (double)n;
        for (int i = 0; i < 3; i++) {
            white += r.whiteness[i] / (3.0 * (double)n);
            size += r.residual_rms[i] * r.residual_rms[i] / (3.0 * (double)n);
        }
        heading += r.last.attitude_rad.z * r.last.attitude_rad.z / (double)n;
        sigma = r.last.attitude_sigma_rad.z;
        *heading_seen = r.last.attitude_sigma_rad.z / r.first.attitude_sigma_rad.z;
    }
    const double dof = 6.0 * (double)n, low = gsl_cdf_chisq_Pinv(0.005, dof) / (double)n,
                 high = gsl_cdf_chisq_Qinv(0.005, dof) / (double)n;
    print_message("%s%s, %zu draws: mean NEES %.2f of 6 (%.2f to %.2f), residuals %.4f, correlation %+.4f (1 "
                  "sigma %.4f); heading %.3f deg, "
                  "sigma %.3f deg, %.0f %% of the start's\n",
                  turns ? "turns" : "straight", flexed ? ", bending arm" : "", n, nees, low, high, sqrt(size),
                  white, 1 / sqrt(3.0 * (double)n * SECONDS), sqrt(heading) / DEG, sigma / DEG,
                  100 * *heading_seen);
    assert_true(nees > low && nees < high);
    const double values = 3.0 * (double)n * SECONDS;
    assert_true(fabs(white) < 2.58 / sqrt(values) + 1.0 / SECONDS);
    ASSERT_NEAR(size, 1, 2.58 * sqrt(2.0 / values) + 0.002);
    land(&b);
}

static void turns_show_the_heading(void **state)
{
    (void)state;
    double seen;
    many(true, false, &seen);
    assert_true(seen < 0.3);
}

static void straight_flight_does_not(void **state)
{
    (void)state;
    double seen;
    many(false, false, &seen);
    assert_true(seen > 0.9);
}

static void a_bending_arm_is_noise(void **state)
{
    (void)state;
    double seen;
    many(true, true, &seen);
    assert_true(seen < 0.3);
}

// Bending has the standard deviations that it was given, of angle and velocity.
static void bending_is_as_told(void **state)
{
    (void)state;
    body b;
    fly(&b, false, true, 5);
    double angle = 0, velocity = 0;
    const double step = 0.1;
    for (double t = 0; t < SECONDS; t += step) {
        orr_motion m, f, stiff;
        orr_trajectory rigid;
        orr_diag diag = {0};
        ASSERT_OK(orr_trajectory_mounted(&b.tr, &b.mounting, &rigid, &diag), diag);
        rigid.evaluate(rigid.self, t, &stiff);
        b.second.evaluate(b.second.self, t, &f);
        b.tr.evaluate(b.tr.self, t, &m);
        const orr_mat3 A = orr_mat3_from_quat(stiff.q_be), B = orr_mat3_from_quat(f.q_be),
                       At = orr_mat3_transpose(&A), d = orr_mat3_mul(&B, &At);
        angle += pow(orr_vec3_norm(orr_rotvec_from_mat3(&d)), 2) * step / SECONDS;
        velocity += pow(orr_vec3_norm(orr_vec3_sub(f.v_mps, stiff.v_mps)), 2) * step / SECONDS;
        orr_trajectory_free(&rigid);
    }
    ASSERT_NEAR(sqrt(angle / 3) / bends.sigma_rad, 1, 0.1); // 100 s of 1/8 s: some 400 times
    ASSERT_NEAR(sqrt(velocity) / orr_vec3_norm(orr_flexure_velocity_mps(&bends, b.mounting.arm_m)), 1, 0.1);
    land(&b);
    orr_diag diag = {0};
    orr_trajectory none;
    const orr_flexure stiff = {0, 1, 1};
    assert_int_equal(orr_trajectory_flexed(&b.tr, &b.mounting, &stiff, &none, &diag), ORR_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_show_the_heading),
        cmocka_unit_test(straight_flight_does_not),
        cmocka_unit_test(a_bending_arm_is_noise),
        cmocka_unit_test(bending_is_as_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
