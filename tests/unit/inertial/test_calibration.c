// SPDX-License-Identifier: GPL-3.0-or-later
// Turntable calibration: the stand's readings against the program's other sensors and navigators, what the source's literal
// forms cost, parameters returned from ideal readings to rounding, covariances tested from both sides, and plans that see
// less.
#include "testing.h"

#include <string.h>

#include "flights.h"
#include "inertial/motion/dual_unit.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/measured.h"
#include "inertial/sense/sensors.h"
#include "inertial/study/calibration.h"

#define DEG ORR_RAD_PER_DEG

// Turns with stops, two rates and both directions, ripple; `scale` of the times.
static const orr_stand_segment turns[] = {
    {10, 0}, {2, 30 * DEG}, {24, 30 * DEG}, {2, 0},         {8, 0}, {2, -60 * DEG}, {12, -60 * DEG},
    {2, 0},  {8, 0},        {1, 10 * DEG},  {18, 10 * DEG}, {1, 0}, {10, 0}};
static const orr_stand_profile profile = {
    .n = sizeof turns / sizeof turns[0], .segment = turns, .ripple = 0.02, .ripple_per_turn = 6};

// The three orders of the source: axis 1, 2, 3 of the unit along the stand's axis 2.
static orr_mat3 order(int axis)
{
    static const orr_mat3 o[3] = {{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
                                  {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                  {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}};
    return o[axis];
}

static orr_stand make_stand(double elevation_deg, bool literal_mounting, bool literal_forces)
{
    const orr_stand_setup setup = {.place = {56 * DEG, 38 * DEG, 150},
                                   .azimuth_rad = 25 * DEG,
                                   .elevation_rad = elevation_deg * DEG,
                                   .literal_mounting = literal_mounting,
                                   .literal_forces = literal_forces};
    orr_stand s;
    orr_diag diag = {0};
    ASSERT_OK(orr_stand_prepare(&setup, &s, &diag), diag);
    return s;
}

static orr_stand_cycle make_cycle(int axis)
{
    static const double mount[3][3] = {
        {0.004, -0.002, 0.003}, {-0.001, 0.002, 0.005}, {0.003, 0.001, -0.002}};
    return (orr_stand_cycle){.order = order(axis),
                             .mounting_rad = {mount[axis][0], mount[axis][1], mount[axis][2]},
                             .start_rad = 0.03 * (axis - 1) + 0.01,
                             .outer_m = {0.10 - 0.02 * axis, 0.03 + 0.05 * axis, -0.04},
                             .profile = profile};
}

// --- The stand ---

static const orr_stand *the_stand;
static const orr_stand_cycle *the_cycle;
static void evaluate(const void *self, double t_s, orr_motion *out)
{
    (void)self;
    orr_stand_motion(the_stand, the_cycle, t_s, out);
}

// Three accelerometers at places of their own read what units mounted there would: (23)-(27) with all cross terms against the
// program's sensors, which know nothing of stands.
static void against_sensors(void **state)
{
    (void)state;
    const orr_stand stand = make_stand(35, false, false);
    const orr_stand_cycle cycle = make_cycle(1);
    the_stand = &stand;
    the_cycle = &cycle;
    const orr_vec3 inner[3] = {{0.05, 0.01, -0.02}, {-0.03, 0.04, 0.02}, {0.01, -0.02, 0.06}};
    orr_trajectory tr = {
        .begin_s = 0, .end_s = 100, .knot_step_s = 1, .knot_degree = 3, .evaluate = evaluate};
    orr_imu imu;
    orr_diag diag = {0};
    ASSERT_OK(orr_stand_readings(&stand, &cycle, inner, 0, 20, &imu, &diag), diag);
    for (int axis = 0; axis < 3; axis++) {
        const orr_mounting at = {.arm_m = inner[axis], .C_21 = orr_mat3_identity()};
        orr_trajectory there;
        ASSERT_OK(orr_trajectory_mounted(&tr, &at, &there, &diag), diag);
        for (size_t j = 0; j < imu.n; j += 37) {
            orr_vec3 dtheta, dv;
            test_increment(&there, NULL, ORR_QUADRATURE_GAUSS, 5, (double)j / 20, (double)(j + 1) / 20,
                           &dtheta, &dv);
            const double got[3] = {imu.dv_mps[j].x, imu.dv_mps[j].y, imu.dv_mps[j].z},
                         want[3] = {dv.x, dv.y, dv.z};
            ASSERT_NEAR(got[axis], want[axis], 2e-14);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(imu.dtheta_rad[j], dtheta)), 0, 1e-15);
        }
        orr_trajectory_free(&there);
    }
    orr_imu_free(&imu);
}

static double null_test(const orr_stand *stand, const orr_stand_cycle *cycle)
{
    orr_imu imu;
    orr_diag diag = {0};
    orr_null_report report;
    ASSERT_OK(orr_stand_readings(stand, cycle, NULL, 0, 50, &imu, &diag), diag);
    const orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &report, &diag), diag);
    assert_true(report.duration_s > 599);
    orr_imu_free(&imu);
    return report.final_3d_m;
}

// 600 s of turning are navigated to well below a millimetre; the source's first-order mounting of half a degree moves the
// unit by tens of metres, its forces without cross terms by millimetres.
static void null_tests(void **state)
{
    (void)state;
    static const orr_stand_segment long_turns[] = {{10, 0},          {2, 30 * DEG}, {276, 30 * DEG},
                                                   {2, 0},           {20, 0},       {2, -20 * DEG},
                                                   {276, -20 * DEG}, {2, 0},        {10, 0}};
    orr_stand_cycle c = make_cycle(1);
    c.profile = (orr_stand_profile){.n = 9, .segment = long_turns};
    c.mounting_rad =
        (orr_vec3){0, 0.5 * DEG, 0}; // about the stand's axis: gravity is lengthened by half its square
    c.outer_m = (orr_vec3){0.1, 0, 0};
    const orr_stand exact = make_stand(0, false, false), mounting = make_stand(0, true, false),
                    forces = make_stand(0, false, true);
    const double a = null_test(&exact, &c), b = null_test(&mounting, &c), d = null_test(&forces, &c);
    print_message("null test: exact %.3g m, literal mounting %.3g m, literal forces %.3g m\n", a, b, d);
    assert_true(a < 1e-3);
    // By the square's half of gravity upwards, 67 m, and what the vertical channel makes of that.
    const double more = 0.5 * 9.8156 * pow(0.5 * DEG, 2), k = sqrt(2 * 9.8156 / 6.378e6);
    ASSERT_NEAR(0.5 * more * 600 * 600, 67.3, 0.1);
    ASSERT_NEAR(b, more * (cosh(k * 600) - 1) / (k * k), 1.0);
    assert_true(d > 1e-3 && d < 0.1);
}

// --- Calibration ---

static const orr_calibration_truth sensors = {
    .accel_bias_mps2 = {1.2e-3, -8e-4, 5e-4},
    .gyro_bias_radps = {4.8e-7, -3.1e-7, 6.6e-7}, // rates of 1 rad/s as doubles resolve 1e-16
    .accel = {{{1 + 2.1e-4, 0, 0}, {3.3e-4, 1 - 1.7e-4, 0}, {-2.2e-4, 1.1e-4, 1 + 0.9e-4}}},
    .gyro = {{{1 - 1.3e-4, 2.5e-4, -1.4e-4}, {3.6e-4, 1 + 0.8e-4, 1.9e-4}, {-2.7e-4, 0.7e-4, 1 + 1.6e-4}}},
    .inner_m = {{0.021, -0.013, 0.008}, {-0.011, 0.025, 0.017}, {0.009, -0.006, -0.031}},
};

static orr_imu_errors errors_of(const orr_calibration_truth *t, double gyro_white, double accel_white,
                                uint64_t seed)
{
    orr_imu_errors e = {.seed = seed};
    for (int i = 0; i < 3; i++) {
        e.accel.bias[i] = t->accel_bias_mps2[i];
        e.gyro.bias[i] = t->gyro_bias_radps[i];
        e.accel.scale[i] = t->accel.m[i][i] - 1;
        e.gyro.scale[i] = t->gyro.m[i][i] - 1;
        e.gyro.white[i] = gyro_white;
        e.accel.white[i] = accel_white;
        for (int k = 0; k < 3; k++) {
            if (k == i) continue;
            e.accel.cross[i][k] = t->accel.m[i][k] / t->accel.m[i][i];
            e.gyro.cross[i][k] = t->gyro.m[i][k] / t->gyro.m[i][i];
        }
    }
    return e;
}

typedef struct bench {
    orr_stand stand;
    orr_stand_cycle cycle[3];
    orr_imu imu[3];
    orr_calibration_plan plan;
} bench;

static void set_up(bench *b, double elevation_deg, const orr_vec3 *inner, double rate_hz)
{
    orr_diag diag = {0};
    b->stand = make_stand(elevation_deg, false, false);
    for (int k = 0; k < 3; k++) {
        b->cycle[k] = make_cycle(k);
        ASSERT_OK(orr_stand_readings(&b->stand, &b->cycle[k], inner, 0, rate_hz, &b->imu[k], &diag), diag);
    }
    b->plan = (orr_calibration_plan){.stand = &b->stand,
                                     .n_cycles = 3,
                                     .cycle = b->cycle,
                                     .block_s = 1,
                                     .gyro_white_radps_s = 1e-6,
                                     .accel_white_mps2_s = 1e-4};
}
static void tear_down(bench *b)
{
    for (int k = 0; k < 3; k++) orr_imu_free(&b->imu[k]);
}

static void know_along(bench *b, const orr_calibration_truth *truth)
{
    for (int k = 0; k < 3; k++) b->plan.along_m[k] = orr_calibration_along(&b->cycle[k], truth);
}

static void measure(bench *b, const orr_imu_errors *e)
{
    orr_diag diag = {0};
    for (int k = 0; k < 3; k++) {
        orr_imu_errors mine = *e;
        mine.seed = e->seed * 16 + (uint64_t)k;
        ASSERT_OK(orr_imu_add_errors(&mine, &b->imu[k], NULL, &diag), diag);
    }
}

// Ideal readings with deterministic errors return them to rounding: 21 without arms, 27 with.
static void to_rounding(void **state)
{
    (void)state;
    for (int arms = 0; arms < 3; arms++) {
        bench b;
        orr_diag diag = {0};
        orr_calibration_truth truth = sensors;
        if (arms == 0) memset(truth.inner_m, 0, sizeof truth.inner_m);
        set_up(&b, 0, truth.inner_m, 10);
        b.plan.arms = arms > 0;
        b.plan.offsets_known = arms == 2;
        know_along(&b, &truth);
        const orr_imu_errors e = errors_of(&truth, 0, 0, 1);
        measure(&b, &e);
        orr_calibration_data data;
        orr_calibration_result r;
        double want[ORR_CALIBRATION_MOST];
        ASSERT_OK(orr_calibration_sum(&b.plan, b.imu, true, &data, &diag), diag);
        ASSERT_OK(orr_calibration_solve(&b.plan, &data, NULL, 12, &r, &diag), diag);
        orr_calibration_true_values(&b.plan, &truth, want);
        const size_t n = orr_calibration_parameters(&b.plan);
        assert_int_equal(n, arms == 0 ? 21 : arms == 1 ? 27 : 30);
        double worst = 0;
        for (size_t k = 0; k < r.n; k++) {
            const double off = fabs(r.value[k] / want[k] - 1);
            if (!(off < 1e-9))
                print_message("%zu %s: %.15g for %.15g, %.2e\n", k, orr_calibration_name(&b.plan, k, NULL),
                              r.value[k], want[k], off);
            worst = fmax(worst, off);
        }
        print_message("%zu parameters: %.2e relative at worst, condition %.3g, %d iterations\n", n, worst,
                      r.condition, r.iterations);
        assert_true(worst < 1e-9);
        orr_calibration_result_free(&r);
        orr_calibration_data_free(&data);
        tear_down(&b);
    }
}

// Noise of known strength: the normalised squared error of the first 21 (27) parameters has their number as its mean, over 200
// seeds within the 99 % interval of chi-square.
static void from_noise(void **state)
{
    (void)state;
    enum { SEEDS = 200 };
    for (int arms = 0; arms < 2; arms++) {
        bench b;
        orr_diag diag = {0};
        set_up(&b, 0, sensors.inner_m, 5);
        b.plan.arms = arms > 0;
        orr_calibration_truth truth = sensors;
        if (arms == 0) {
            memset(truth.inner_m, 0, sizeof truth.inner_m);
            tear_down(&b);
            set_up(&b, 0, truth.inner_m, 5);
        }
        know_along(&b, &truth);
        orr_calibration_data clean, noisy;
        orr_calibration_linear l;
        double want[ORR_CALIBRATION_MOST], found[ORR_CALIBRATION_MOST], sum = 0, one;
        const orr_imu_errors ideal = errors_of(&truth, 0, 0, 1);
        measure(&b, &ideal);
        ASSERT_OK(orr_calibration_sum(&b.plan, b.imu, true, &clean, &diag), diag);
        orr_calibration_true_values(&b.plan, &truth, want);
        ASSERT_OK(orr_calibration_linearise(&b.plan, &clean, want, &l, &diag), diag);
        const size_t n = orr_calibration_parameters(&b.plan);
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            const orr_imu_errors e = errors_of(&truth, 1e-6, 1e-4, seed);
            measure(&b, &e);
            ASSERT_OK(orr_calibration_sum(&b.plan, b.imu, true, &noisy, &diag), diag);
            orr_calibration_linear_step(&b.plan, &l, &noisy, found);
            ASSERT_OK(orr_calibration_nees(&l.at, found, want, n, &one, &diag), diag);
            sum += one / SEEDS;
            if (seed == 1) { // the step is what the whole solution comes to
                orr_calibration_result r;
                ASSERT_OK(orr_calibration_solve(&b.plan, &noisy, NULL, 12, &r, &diag), diag);
                for (size_t k = 0; k < r.n; k++) ASSERT_NEAR((r.value[k] - found[k]) / r.sigma[k], 0, 0.01);
                ASSERT_NEAR(r.residual_rms, 1, 0.1);
                orr_calibration_result_free(&r);
            }
            orr_calibration_data_free(&noisy);
        }
        print_message("%zu parameters: mean normalised squared error %.2f\n", n, sum);
        ASSERT_NEAR(sum, (double)n, 2.576 * sqrt(2.0 * (double)n / SEEDS)); // 19.8 to 22.2 of 21
        orr_calibration_linear_free(&l);
        orr_calibration_data_free(&clean);
        tear_down(&b);
    }
}

// Plans that see less say of what; the whole one sees all.
static void observability(void **state)
{
    (void)state;
    bench b;
    orr_diag diag = {0};
    orr_calibration_result r;
    set_up(&b, 0, NULL, 1);
    b.plan.arms = true;
    ASSERT_OK(orr_calibration_observe(&b.plan, NULL, &r, &diag), diag);
    assert_int_equal(r.unseen, 0);
    assert_true(r.condition < 1e4);
    orr_calibration_result_free(&r);
    // One cycle leaves the accelerometer along the axis without gravity, and the gyros across it without a rate.
    b.plan.n_cycles = 1;
    ASSERT_OK(orr_calibration_observe(&b.plan, NULL, &r, &diag), diag);
    assert_true(r.unseen > 0);
    assert_false(r.seen[3]); // scale of the accelerometer along the axis
    assert_true(r.seen[4] && r.seen[5]);
    assert_true(isinf(r.sigma[3]));
    orr_calibration_result_free(&r);
    orr_calibration_data data;
    assert_int_equal(orr_calibration_sum(&b.plan, b.imu, false, &data, &diag), ORR_OK);
    assert_int_equal(orr_calibration_solve(&b.plan, &data, NULL, 5, &r, &diag), ORR_E_NUMERIC);
    assert_non_null(strstr(diag.text, "accelerometer scale x"));
    orr_calibration_data_free(&data);
    // Without turns there are no arms, and of the gyros nothing but biases.
    static const orr_stand_segment rest = {60, 0};
    b.plan.n_cycles = 3;
    for (int k = 0; k < 3; k++) b.cycle[k].profile = (orr_stand_profile){.n = 1, .segment = &rest};
    ASSERT_OK(orr_calibration_observe(&b.plan, NULL, &r, &diag), diag);
    for (size_t k = 21; k < 27; k++) assert_false(r.seen[k]);
    orr_calibration_result_free(&r);
    tear_down(&b);
    // About a vertical axis gravity is the same all the time: accelerometers see their biases and scales as one.
    set_up(&b, 90, NULL, 1);
    ASSERT_OK(orr_calibration_observe(&b.plan, NULL, &r, &diag), diag);
    for (size_t k = 0; k < 6; k++) assert_false(r.seen[k]);
    assert_true(r.seen[12] && r.seen[16] && r.seen[20]); // scales of the gyros by the stand's rate
    orr_calibration_result_free(&r);
    tear_down(&b);
}

// Sensors in any axes are the same sensors in the accelerometers' own: readings of a body that is turned back.
static void own_axes(void **state)
{
    (void)state;
    orr_calibration_truth t = sensors, q;
    orr_diag diag = {0};
    t.accel.m[0][1] = 3e-3;
    t.accel.m[1][2] = -2e-3;
    t.accel.m[0][2] = 1e-3;
    q = t;
    orr_mat3 R;
    ASSERT_OK(orr_calibration_own_axes(&q, &R, &diag), diag);
    ASSERT_NEAR(fabs(q.accel.m[0][1]) + fabs(q.accel.m[0][2]) + fabs(q.accel.m[1][2]), 0, 1e-15);
    const orr_vec3 f = {1, -7, 5}, turned = orr_mat3_apply(&R, f);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_mat3_apply(&t.accel, f), orr_mat3_apply(&q.accel, turned))), 0,
                1e-14);
    ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_mat3_apply(&t.gyro, f), orr_mat3_apply(&q.gyro, turned))), 0,
                1e-14);
    for (int k = 0; k < 3; k++) t.accel.m[1][k] = t.accel.m[0][k];
    assert_int_equal(orr_calibration_own_axes(&t, &R, &diag), ORR_E_NUMERIC);
}

// What cannot be a stand or a cycle.
static void refused(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_stand stand;
    const orr_stand_setup steep = {.elevation_rad = 2};
    assert_int_equal(orr_stand_prepare(&steep, &stand, &diag), ORR_E_ARG);
    stand = make_stand(0, false, false);
    orr_imu imu;
    orr_stand_cycle c = make_cycle(0);
    assert_int_equal(orr_stand_readings(&stand, &c, NULL, 0, 1.7, &imu, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "whole numbers"));
    const orr_stand_segment negative = {-1, 0};
    c.profile = (orr_stand_profile){.n = 1, .segment = &negative};
    assert_int_equal(orr_stand_cycle_check(&c, &diag), ORR_E_ARG);
    c = make_cycle(0);
    c.order.m[0][1] = -1;
    assert_int_equal(orr_stand_cycle_check(&c, &diag), ORR_E_ARG);
    c = make_cycle(0);
    c.mounting_rad.x = 1;
    assert_int_equal(orr_stand_cycle_check(&c, &diag), ORR_E_ARG);
    c = make_cycle(0);
    c.profile.ripple = 1.5;
    assert_int_equal(orr_stand_cycle_check(&c, &diag), ORR_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(against_sensors), cmocka_unit_test(null_tests),
                                       cmocka_unit_test(to_rounding),     cmocka_unit_test(from_noise),
                                       cmocka_unit_test(observability),   cmocka_unit_test(own_axes),
                                       cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
