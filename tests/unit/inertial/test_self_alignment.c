// SPDX-License-Identifier: GPL-3.0-or-later
// Self-alignment at rest: exact on ideal readings, its closed forms to first order, and quiet under vibration.
#include "testing.h"

#include "inertial/motion/analytic.h"
#include "inertial/sense/measured.h"
#include "inertial/sense/sensors.h"
#include "inertial/study/self_alignment.h"

#define ARCSEC (ORR_RAD_PER_DEG / 3600.0)

// A unit at latitude 56 with heading 37, pitch and roll as told; `coning_rad` is the amplitude of heading and pitch
// in quadrature at 3 Hz, a cone about the forward axis.
static orr_imu rest(double pitch_deg, double roll_deg, double coning_rad, double seconds)
{
    const double deg = ORR_RAD_PER_DEG;
    orr_analytic_plan p = {
        .origin = {56.0 * deg, 40.0 * deg, 150.0},
        .attitude = {37.0 * deg, pitch_deg * deg, roll_deg * deg},
        .n_terms = coning_rad > 0.0 ? 2 : 0,
        .term = {{.kind = ORR_ANALYTIC_SINE, .period_s = 1.0 / 3.0, .amplitude = {coning_rad, 0, 0}},
                 {.kind = ORR_ANALYTIC_SINE,
                  .period_s = 1.0 / 3.0,
                  .amplitude = {0, coning_rad, 0},
                  .phase_rad = 90.0 * deg}}};
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, seconds, &p, &tr, &diag), diag);
    const orr_imu_request want = {.duration_s = seconds, .rate_hz = 100, .mode = {.approach = 2, .order = 3}};
    orr_imu imu = {0};
    ASSERT_OK(orr_imu_generate(&tr, &want, &imu, &diag), diag);
    orr_trajectory_free(&tr);
    return imu;
}

static orr_self_alignment align(const orr_imu *imu, orr_self_method how)
{
    orr_self_alignment a;
    orr_diag diag = {0};
    ASSERT_OK(orr_self_align(imu, how, 0, imu->n, NULL, &a, &diag), diag);
    return a;
}

static double worst(orr_angles a)
{
    return fmax(fabs(a.heading_rad), fmax(fabs(a.pitch_rad), fabs(a.roll_rad)));
}

static void ideal_readings_give_the_attitude(void **state)
{
    (void)state;
    orr_imu imu = rest(2.0, -5.0, 0.0, 120.0);
    ASSERT_NEAR(worst(align(&imu, ORR_SELF_AVERAGE).error), 0, 1e-11);
    // Gravity turns by 5e-3 rad in this time, and rounding is seen through that.
    ASSERT_NEAR(worst(align(&imu, ORR_SELF_INERTIAL).error), 0, 1e-9);
    orr_imu_free(&imu);
}

// Constant errors make what the closed forms say, and what is left falls with their square.
static void closed_forms_hold_to_first_order(void **state)
{
    (void)state;
    orr_imu imu = rest(0.0, 0.0, 0.0, 120.0);
    for (int how = 0; how < 2; how++) {
        double left[2];
        for (int k = 0; k < 2; k++) {
            const double size = k == 0 ? 2.0 : 1.0;
            const orr_imu_errors e = {.gyro = {.bias = {1e-8 * size, -2e-8 * size, 3e-8 * size}},
                                      .accel = {.bias = {3e-4 * size, 5e-4 * size, -2e-4 * size}}};
            orr_diag diag = {0};
            ASSERT_OK(orr_imu_add_errors(&e, &imu, NULL, &diag), diag);
            const orr_self_alignment a = align(&imu, (orr_self_method)how);
            const orr_angles d = {a.error.heading_rad - a.closed_form.heading_rad,
                                  a.error.pitch_rad - a.closed_form.pitch_rad,
                                  a.error.roll_rad - a.closed_form.roll_rad};
            left[k] = worst(d);
            assert_true(worst(a.closed_form) > 1e-4 * size);
        }
        // Of the inertial method gyro drift over the window tells in first order too: 3e-8 rad/s by 120 s.
        if (how == 0) {
            assert_true(left[0] > 3.5 * left[1] && left[0] < 4.5 * left[1]);
        } else {
            assert_true(left[0] < 2.5 * 3e-8 * 120.0 * 2.0);
        }
    }
    orr_imu_free(&imu);
}

// A cone of 3 Hz and 2 mrad about the forward axis: its rate's mean along that axis is (2 pi 3 Hz) (2 mrad)^2 / 2, half the
// Earth's, and stands in the averages as a drift. A cone about the vertical would not be seen, as no vertical drift is.
static void coning_spoils_averages_alone(void **state)
{
    (void)state;
    orr_imu imu = rest(0.0, 0.0, 2e-3, 120.0);
    const double inertial = worst(align(&imu, ORR_SELF_INERTIAL).error),
                 average = worst(align(&imu, ORR_SELF_AVERAGE).error);
    print_message("heading error: inertial %.2f arcsec, average %.3g rad\n", inertial / ARCSEC, average);
    // The algorithm with the increment before leaves (w h)^4 / 60 of the cone's drift, and that makes heading.
    const double w = 6.0 * acos(-1.0), left = 0.5 * w * 4e-6 * pow(w * 0.01, 4.0) / 60.0 /
                                              (ORR_EARTH_RATE_RADPS * cos(56.0 * ORR_RAD_PER_DEG));
    assert_true(inertial < 1.5 * left);
    assert_true(average > 0.1);
    orr_imu_free(&imu);
}

static void what_tells_no_heading_is_refused(void **state)
{
    (void)state;
    orr_imu imu = rest(0.0, 0.0, 0.0, 1.0);
    orr_self_alignment a;
    orr_diag diag = {0};
    assert_int_equal(orr_self_align(&imu, ORR_SELF_AVERAGE, 5, 6, NULL, &a, &diag), ORR_E_ARG);
    imu.truth_every = 2;
    assert_int_equal(orr_self_align(&imu, ORR_SELF_AVERAGE, 0, 50, NULL, &a, &diag), ORR_E_ARG);
    orr_imu_free(&imu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ideal_readings_give_the_attitude),
        cmocka_unit_test(closed_forms_hold_to_first_order),
        cmocka_unit_test(coning_spoils_averages_alone),
        cmocka_unit_test(what_tells_no_heading_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
