// SPDX-License-Identifier: GPL-3.0-or-later
// What sensors do in time and space, each against its closed form: temperature with lag, places of the accelerometers,
// bandwidth, delay and jitter, vibration made a bias.
#include "testing.h"

#include "inertial/motion/analytic.h"
#include "inertial/motion/dual_unit.h"
#include "inertial/sense/measured.h"
#include "inertial/sense/sensors.h"

#define PI ORR_PI

static orr_imu run_of(size_t n, double hz)
{
    orr_imu imu = {0};
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_allocate(&imu, n, 1, false, false, &diag), diag);
    imu.rate_hz = hz;
    for (size_t k = 0; k < n; k++) imu.dtheta_rad[k] = imu.dv_mps[k] = orr_vec3_make(0, 0, 0);
    return imu;
}

static void measure(const orr_imu_errors *e, orr_imu *imu)
{
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_add_errors(e, imu, NULL, &diag), diag);
}

// Outside it warms from 20 by 0.02 K/s for 1000 s and stays: the sensors lag by L = 100 s, T = 20 + 0.02 (t - L + L exp(-t / L)).
static void sensors_follow_temperature_with_a_lag(void **state)
{
    (void)state;
    const double at[] = {0, 1000, 2000}, warm[] = {20, 40, 40}, L = 100;
    orr_imu imu = run_of(20000, 10.0);
    const orr_imu_errors e = {
        .gyro = {.by_temperature = {1e-6, 0, 0},
                 .by_temperature_squared = {0, 1e-7, 0},
                 .by_temperature_rate = {0, 0, 1e-4}},
        .accel = {.scale_by_temperature = {1e-5, 0, 0}, .bias = {0}},
        .temperature = {.n = 3, .t_s = at, .celsius = warm, .reference_c = 20, .lag_s = L}};
    for (size_t k = 0; k < imu.n; k++) imu.dv_mps[k].x = 0.1 * 9.0;
    measure(&e, &imu);
    for (size_t k = 999; k < imu.n; k += 1000) {
        const double t = (double)(k + 1) / 10.0, up = t < 1000 ? t : 1000;
        double over = 0.02 * (up - L - -L * exp(-up / L)), rate = 0.02 * (1 - exp(-up / L));
        if (t > 1000) {
            rate = (20 - over) / L * exp(-(t - 1000) / L);
            over = 20 - (20 - over) * exp(-(t - 1000) / L);
        }
        ASSERT_NEAR(imu.measured_dtheta_rad[k].x * 10, 1e-6 * over, 1e-14);
        ASSERT_NEAR(imu.measured_dtheta_rad[k].y * 10, 1e-7 * over * over, 1e-13);
        ASSERT_NEAR(imu.measured_dtheta_rad[k].z * 10, 1e-4 * rate, 2e-9); // the mean of a step, 0.1 s of 100
        ASSERT_NEAR(imu.measured_dv_mps[k].x, 0.9 * (1 + 1e-5 * over), 1e-14);
    }
    orr_diag diag = {0};
    orr_imu_errors wrong = e;
    wrong.temperature.n = 2;
    assert_int_equal(orr_imu_add_errors(&wrong, &imu, NULL, &diag), ORR_E_RANGE);
    assert_non_null(strstr(diag.text, "covers 0 to 1000 s"));
    wrong = e;
    wrong.temperature.lag_s = -1;
    assert_int_equal(orr_imu_add_errors(&wrong, &imu, NULL, &diag), ORR_E_ARG);
    const double back[] = {0, 0, 2000};
    wrong = e;
    wrong.temperature.t_s = back;
    assert_int_equal(orr_imu_add_errors(&wrong, &imu, NULL, &diag), ORR_E_ARG);
    orr_imu_free(&imu);
}

static orr_trajectory lively(double seconds)
{
    const orr_analytic_plan p = {
        .origin = {0.9, 0.5, 300},
        .n_terms = 3,
        .term = {{.kind = ORR_ANALYTIC_SINE, .period_s = 2.0, .amplitude = {0.2, 0.1, 0.0}},
                 {.kind = ORR_ANALYTIC_SINE, .period_s = 3.1, .amplitude = {0, 0.05, 0.3}, .phase_rad = 1.0},
                 {.kind = ORR_ANALYTIC_SINE, .period_s = 5.0, .amplitude_m = {1, 2, 0.5}}}};
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, seconds, &p, &tr, &diag), diag);
    return tr;
}

static orr_imu readings(const orr_trajectory *tr, double begin_s, double seconds, double hz)
{
    const orr_imu_request q = {
        .begin_s = begin_s, .duration_s = seconds, .rate_hz = hz, .mode = {.approach = 2, .order = 5}};
    orr_imu imu = {0};
    orr_diag diag = {0};
    ASSERT_OK(orr_imu_generate(tr, &q, &imu, &diag), diag);
    return imu;
}

// An accelerometer at its own place reads what a whole unit there would, but for gravity, which differs by 3e-6 /s^2 of 0.1 m.
static void arms_read_as_units_there(void **state)
{
    (void)state;
    const orr_vec3 arm[3] = {{0.05, 0.02, -0.03}, {-0.04, 0.06, 0.01}, {0.0, -0.03, 0.08}};
    orr_trajectory tr = lively(40);
    orr_imu imu = readings(&tr, 0, 40, 100);
    orr_imu_errors e = {0};
    for (int i = 0; i < 3; i++) {
        e.accel.arm_m[i][0] = arm[i].x;
        e.accel.arm_m[i][1] = arm[i].y;
        e.accel.arm_m[i][2] = arm[i].z;
    }
    measure(&e, &imu);
    double effect = 0;
    for (int i = 0; i < 3; i++) {
        orr_trajectory there;
        orr_diag diag = {0};
        const orr_mounting m = {arm[i], orr_mat3_identity()};
        ASSERT_OK(orr_trajectory_mounted(&tr, &m, &there, &diag), diag);
        orr_imu unit = readings(&there, 0, 40, 100);
        double sum = 0;
        for (size_t k = 2; k + 2 < imu.n; k++) {
            const orr_vec3 d = orr_vec3_sub(imu.measured_dv_mps[k], unit.dv_mps[k]),
                           a = orr_vec3_sub(unit.dv_mps[k], imu.dv_mps[k]);
            const double left = i == 0 ? d.x : i == 1 ? d.y : d.z;
            effect = fmax(effect, fabs(i == 0 ? a.x : i == 1 ? a.y : a.z) * 100);
            // Gravity's gradient; and w at edges, whose fifth difference at 100 Hz and 2 s is left.
            ASSERT_NEAR(left * 100, 0, 3.1e-6 * orr_vec3_norm(arm[i]) + 1e-6);
            sum += left;
        }
        ASSERT_NEAR(sum / 40, 0, 3.1e-6 * orr_vec3_norm(arm[i]) + 2e-8);
        orr_imu_free(&unit);
        orr_trajectory_free(&there);
    }
    assert_true(effect > 0.05);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

// Of a sine comes a sine, with the gain and the phase of w0^2 / (w0^2 - w^2 + 2 i d w0 w), fitted after the swing has died away.
static void bandwidth_has_its_response(void **state)
{
    (void)state;
    const double hz = 2000, band = 40;
    const double dampings[] = {0, 0.3, 1.5};
    for (size_t q = 0; q < 3; q++)
        for (double f = 5; f < 90; f *= 2) {
            orr_imu imu = run_of(8000, hz);
            for (size_t k = 0; k < imu.n; k++) { // integral of cos(w t) over the step
                const double w = 2 * PI * f, a = (double)k / hz, b = (double)(k + 1) / hz;
                imu.dtheta_rad[k].x = (sin(w * b) - sin(w * a)) / w;
            }
            const orr_imu_errors e = {.gyro = {.bandwidth_hz = band, .damping = dampings[q]}};
            measure(&e, &imu);
            double c = 0, s = 0;
            const size_t from = 4000; // a whole number of periods for f = 5, 10, ...
            for (size_t k = from; k < imu.n; k++) {
                const double w = 2 * PI * f, t = ((double)k + 0.5) / hz;
                c += 2 * imu.measured_dtheta_rad[k].x * cos(w * t) / ((double)(imu.n - from) / hz);
                s += 2 * imu.measured_dtheta_rad[k].x * sin(w * t) / ((double)(imu.n - from) / hz);
            }
            const double d = dampings[q] > 0 ? dampings[q] : sqrt(0.5), m = 1 - 2 * d * d,
                         r = f / (band / sqrt(m + sqrt(m * m + 1)));
            const double re = 1 - r * r, im = 2 * d * r, n = re * re + im * im;
            // Readings are means of steps, and steps are what the filter sees: (w / hz)^2 / 12 is lost.
            ASSERT_NEAR(c, re / n, 0.003 + pow(2 * PI * f / hz, 2) / 12);
            ASSERT_NEAR(s, im / n, 0.003 + pow(2 * PI * f / hz, 2) / 12);
            if (fabs(f - band) < 1e-9) ASSERT_NEAR(hypot(c, s), sqrt(0.5), 0.002);
            orr_imu_free(&imu);
        }
    // A ramp is followed late by 2 d / w0, to rounding.
    orr_imu imu = run_of(4000, 100);
    for (size_t k = 0; k < imu.n; k++) imu.dtheta_rad[k].z = 1e-3 * ((double)k + 0.5) / 100;
    const orr_imu_errors e = {.gyro = {.bandwidth_hz = 20}};
    measure(&e, &imu);
    ASSERT_NEAR((imu.dtheta_rad[3999].z - imu.measured_dtheta_rad[3999].z) * 1e3 * 100,
                100 * 2 * sqrt(0.5) / (2 * PI * 20), 1e-9);
    orr_imu_free(&imu);
}

// Late readings are those of a run that begins earlier; jitter makes rate times its difference.
static void late_sampling_is_an_earlier_run(void **state)
{
    (void)state;
    orr_trajectory tr = lively(30);
    const double delay[] = {0.05, 0.0123};
    for (int k = 0; k < 2; k++) {
        orr_imu imu = readings(&tr, 5, 20, 100), early = readings(&tr, 5 - delay[k], 20, 100);
        const orr_imu_errors e = {.delay_s = delay[k]};
        measure(&e, &imu);
        for (size_t j = 10; j < imu.n; j++) {
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(imu.measured_dtheta_rad[j], early.dtheta_rad[j])), 0,
                        2e-9);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(imu.measured_dv_mps[j], early.dv_mps[j])), 0, 2e-8);
        }
        orr_imu_free(&imu);
        orr_imu_free(&early);
    }
    orr_trajectory_free(&tr);
    orr_imu imu = run_of(20000, 100);
    for (size_t j = 0; j < imu.n; j++) {
        imu.dtheta_rad[j].y = 0.5 / 100;
        imu.dv_mps[j].z = 9.8 / 100;
    }
    const orr_imu_errors e = {.jitter_s = 1e-5, .seed = 4};
    measure(&e, &imu);
    double square = 0, sum = 0, both = 0;
    for (size_t j = 0; j < imu.n; j++) {
        const double d = imu.measured_dtheta_rad[j].y - 0.005, v = imu.measured_dv_mps[j].z - 0.098;
        square += d * d / (double)imu.n;
        sum += d;
        both = fmax(both, fabs(d / 0.5 - v / 9.8));
    }
    ASSERT_NEAR(sqrt(square) / (0.5 * sqrt(2.0) * 1e-5), 1, 0.03);
    assert_true(fabs(sum) < 0.5 * 8e-5); // differences of instants: their sum is that of two
    ASSERT_NEAR(both, 0, 1e-15);         // one clock for both triads
    orr_imu_free(&imu);
    orr_diag diag = {0};
    orr_imu one = run_of(10, 10);
    const orr_imu_errors wrong[] = {{.delay_s = -1},
                                    {.jitter_s = -1},
                                    {.delay_s = 2},
                                    {.vibration_mps2 = -1},
                                    {.gyro = {.bandwidth_hz = -1}}};
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++)
        assert_int_equal(orr_imu_add_errors(&wrong[k], &one, NULL, &diag), ORR_E_ARG);
    orr_imu_free(&one);
}

// A shake of amplitude A has the mean square A^2 / 2; what is too fast is told.
static void vibration_is_rectified(void **state)
{
    (void)state;
    orr_imu imu = run_of(20000, 1000);
    const double A = 5.0, w = 2 * PI * 50;
    for (size_t j = 0; j < imu.n; j++)
        imu.dv_mps[j].x = -A * (cos(w * (double)(j + 1) / 1000) - cos(w * (double)j / 1000)) / w;
    const orr_imu_errors e = {.accel = {.rectification = {1e-4, 2e-4, 0}},
                              .gyro = {.rectification = {1e-7, 0, 0}},
                              .vibration_mps2 = 3};
    measure(&e, &imu);
    double bias = 0, other = 0, gyro = 0;
    for (size_t j = 10000; j < imu.n; j++) {
        bias += (imu.measured_dv_mps[j].x - imu.dv_mps[j].x) / 10;
        other += imu.measured_dv_mps[j].y / 10;
        gyro += imu.measured_dtheta_rad[j].x / 10;
    }
    const double seen = A * A / 2 * pow(sin(w / 2000) / (w / 2000), 2); // means of a millisecond
    ASSERT_NEAR(bias / (1e-4 * (seen + 9)), 1, 1e-3);
    ASSERT_NEAR(other / (2e-4 * 9), 1, 1e-9);
    ASSERT_NEAR(gyro / (1e-7 * (seen + 9)), 1, 1e-3);
    orr_imu_free(&imu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sensors_follow_temperature_with_a_lag),
        cmocka_unit_test(arms_read_as_units_there),
        cmocka_unit_test(bandwidth_has_its_response),
        cmocka_unit_test(late_sampling_is_an_earlier_run),
        cmocka_unit_test(vibration_is_rectified),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
