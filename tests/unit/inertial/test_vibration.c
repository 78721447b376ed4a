// SPDX-License-Identifier: GPL-3.0-or-later
// Vibration at alignment: the motion of (28)-(29), the errors of attitude algorithms against the prototype's values, the
// limits of (31), their closed form to second order, and the counterpart of velocity.
#include "testing.h"

#include <stdio.h>
#include <string.h>

#include "core/nan.h"
#include "inertial/study/vibration.h"
#include "inertial/study/vibration_broadband.h"
#include "inertial/study/vibration_motion.h"

static orr_attitude_method builtin(const char *name)
{
    orr_attitude_method m;
    orr_diag diag = {0};
    ASSERT_OK(orr_attitude_method_builtin(name, &m, &diag), diag);
    return m;
}

static const orr_vibration_study source = {.readings_hz = 100, .product_hz = 1e-5, .duration_s = 2};

static double error_of(const orr_vibration_study *study, const char *name, double ratio)
{
    orr_vibration_error e;
    orr_diag diag = {0};
    const orr_attitude_method m = builtin(name);
    ASSERT_OK(orr_vibration_error_of(study, &m, ratio, &e, &diag), diag);
    return e.normalised;
}

static void near_relative(double value, double expected, double relative)
{
    if (!(fabs(value / expected - 1) <= relative))
        fail_msg("%.9e is not %.9e within %g of it", value, expected, relative);
}

// The prototype's normalised errors at f_m = 100 Hz and f_v beta^2 = 1e-5, of which two or three digits are known: 2 %, and
// half a digit of the last where it is below 1e-6.
static void prototype(void **state)
{
    (void)state;
    static const struct {
        double ratio, one, two, four;
    } c[] = {{0.01, 6.6e-4, 5.2e-7, 1.3e-11},
             {0.1, 6.5e-2, 5.0e-3, 3.5e-5},
             {0.25, 0.36, 0.15, 0.030},
             {10.3, 0.985, 0.979, 0.974}};
    for (size_t k = 0; k < sizeof c / sizeof c[0]; k++) {
        near_relative(error_of(&source, "1-step", c[k].ratio), c[k].one, 0.02);
        near_relative(error_of(&source, "2-step", c[k].ratio), c[k].two, 0.02);
        near_relative(error_of(&source, "4-step", c[k].ratio), c[k].four, 0.02);
    }
}

// (28) as it stands is the motion; (29) is its rate and the derivative of that; the trajectory says the same.
static void motion(void **state)
{
    (void)state;
    const orr_vibration v = {.frequency_hz = 3.0, .amplitude_rad = 0.2, .start_s = 0.05};
    const orr_geodetic place = {0.97, 0.65, 200.0};
    const orr_angles attitude = {2.0, 0.1, -0.2};
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_vibrating(0, 0, 10, place, attitude, &v, &tr, &diag), diag);
    const double h = 1e-5;
    for (double t = 0.01; t < 0.4; t += 0.07) {
        const double a = 2 * ORR_PI * v.frequency_hz * (t - v.start_s);
        const orr_mat3 R3 = orr_mat3_rot3(a), R1 = orr_mat3_rot1(v.amplitude_rad), back = orr_mat3_rot3(-a);
        const orr_mat3 A = orr_mat3_mul(&R1, &R3), expected = orr_mat3_mul(&back, &A);
        const orr_mat3 got = orr_mat3_from_quat(orr_vibration_attitude(&v, t));
        for (int i = 0; i < 9; i++) ASSERT_NEAR((&got.m[0][0])[i], (&expected.m[0][0])[i], 1e-14);
        orr_motion m, before, after;
        ASSERT_OK(orr_trajectory_evaluate(&tr, t, &m, &diag), diag);
        ASSERT_OK(orr_trajectory_evaluate(&tr, t - h, &before, &diag), diag);
        ASSERT_OK(orr_trajectory_evaluate(&tr, t + h, &after, &diag), diag);
        const orr_mat3 A0 = orr_mat3_from_quat(before.q_be), A1 = orr_mat3_from_quat(after.q_be);
        const orr_mat3 A0t = orr_mat3_transpose(&A0), step = orr_mat3_mul(&A1, &A0t);
        const orr_vec3 w = orr_vec3_scale(1 / (2 * h), orr_rotvec_from_mat3(&step));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(w, m.w_radps)), 0,
                    1e-7); // h^2 w^3 beta / 6, and rounding over h
        const orr_vec3 dw = orr_vec3_scale(1 / (2 * h), orr_vec3_sub(after.w_radps, before.w_radps));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(dw, m.wdot_radps2)), 0, 1e-6);
        ASSERT_NEAR(orr_vec3_norm(m.v_mps) + orr_vec3_norm(m.a_mps2), 0, 0);
    }
    orr_trajectory_free(&tr);
    ASSERT_NEAR(orr_vibration_drift(&v) / (-ORR_PI * 3.0 * 0.04), 1, 0.04 / 12); // (31) is its first order
    const orr_vibration wide = {.frequency_hz = 1, .amplitude_rad = 4};
    assert_int_equal(orr_trajectory_vibrating(0, 0, 1, place, attitude, &wide, &tr, &diag), ORR_E_ARG);
}

// At f_v / f_m >> 1 every method drifts by (31); at whole numbers of periods a reading nothing else is left.
static void limits(void **state)
{
    (void)state;
    for (size_t k = 0; orr_attitude_method_name(k) != NULL; k++) {
        const char *name = orr_attitude_method_name(k);
        ASSERT_NEAR(error_of(&source, name, 3.0), 1, 1e-6); // beta^2 / 4 is left of the second order
        // 1 / (2 pi ratio) times twice the largest sum of coefficients, 40 of eight samples'
        ASSERT_NEAR(error_of(&source, name, 1000.37), 1, 0.02);
    }
}

// The closed form of the second order: what the runs differ from it by falls with f_v beta^2, and twice the number of
// samples is the order in frequency of the coefficients that are made for coning.
static void second_order(void **state)
{
    (void)state;
    for (size_t k = 0; orr_attitude_method_name(k) != NULL; k++) {
        const orr_attitude_method m = builtin(orr_attitude_method_name(k));
        for (int i = 0; i < 3; i++) {
            static const double ratio[] = {0.07, 0.31, 1.7};
            const double e = orr_attitude_method_response(&m, ratio[i]);
            double off[2];
            for (int j = 0; j < 2; j++) {
                orr_vibration_study s = source;
                s.product_hz = j == 0 ? 1e-3 : 1e-4;
                off[j] = fabs(error_of(&s, m.name, ratio[i]) - e);
            }
            // beta^2 is its scale; at higher ratios what is periodic in a run is of that size too
            assert_true(off[0] < 2 * 1e-3 / (ratio[i] * 100) && off[1] < 2 * 1e-4 / (ratio[i] * 100));
            if (i < 2) assert_true(off[1] < 0.13 * off[0]);
        }
        if (m.samples == 1) ASSERT_NEAR(orr_attitude_method_consistency(&m), 0, 0);
        if (m.samples > 1) ASSERT_NEAR(orr_attitude_method_consistency(&m), 1, 1e-12);
    }
    for (int n = 1; n <= 5; n++) {
        char name[16];
        snprintf(name, sizeof name, "%d-step", n);
        const orr_attitude_method m = builtin(name);
        const double slope =
            log2(orr_attitude_method_response(&m, 0.02) / orr_attitude_method_response(&m, 0.01));
        ASSERT_NEAR(slope, 2 * n, 0.02 * n);
    }
}

// Iteration solves the kinematic equation for the polynomial exactly: in the second order it is the polynomial's own
// coefficients, and for wide and slow motions it is far better than these are.
static void iteration(void **state)
{
    (void)state;
    const orr_attitude_method a = builtin("iteration-4"), b = builtin("polynomial-4");
    for (double r = 0.01; r < 2; r *= 1.7)
        near_relative(orr_attitude_method_response(&a, r), orr_attitude_method_response(&b, r), 1e-9);
    orr_vibration_study wide = source;
    wide.product_hz = 0.05; // 0.22 rad at 1 Hz
    const double second = orr_attitude_method_response(&a, 0.01);
    assert_true(fabs(error_of(&wide, "iteration-4", 0.01) - second) < 0.1 * fabs(second));
    assert_true(fabs(error_of(&wide, "polynomial-4", 0.01) - second) > 5 * fabs(second));
    assert_true(fabs(error_of(&wide, "iteration-8", 0.01)) < 1e-11);
}

// Rest readings with the Earth's rate (section 5.1): at rest in every attitude and latitude the same normalised error is
// left, and heading has the part of it that the vertical has of the cone's axis.
static void on_the_earth(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        static const double lat[] = {0.0, 0.97, -1.5};
        orr_vibration_study s = source;
        s.earth = true;
        s.lat_rad = lat[k];
        s.attitude = (orr_angles){1.0 + k, k == 2 ? 0.4 : 0.0, 0.0};
        orr_vibration_error e;
        orr_diag diag = {0};
        const orr_attitude_method m = builtin("2-step");
        ASSERT_OK(orr_vibration_error_of(&s, &m, 0.25, &e, &diag), diag);
        // the Earth's rate along the cone's axis adds to the vibration's, u / w = 5e-7 of it
        near_relative(e.normalised, error_of(&source, "2-step", 0.25), 1e-5);
        near_relative(e.heading_rad / (e.drift_radps * e.duration_s),
                      e.normalised * cos(s.attitude.pitch_rad), 1e-3);
        ASSERT_OK(orr_vibration_error_of(&s, &m, 40.3, &e, &diag), diag);
        assert_true(e.heading_rad > 0); // clockwise: psi of (31) falls
    }
}

// Sculling is coning's counterpart: the same error in the second order (Roscoe 2001).
static void sculling(void **state)
{
    (void)state;
    for (size_t k = 0; orr_attitude_method_name(k) != NULL; k++) {
        const orr_attitude_method m = builtin(orr_attitude_method_name(k));
        for (double r = 0.06; r < 3; r *= 1.9) {
            double e;
            orr_diag diag = {0};
            ASSERT_OK(orr_sculling_error_of(&source, &m, r, &e, &diag), diag);
            ASSERT_NEAR(e, orr_attitude_method_response(&m, r), 1e-5); // beta^2, and the ends of the run
        }
    }
}

// What a study refuses, and coefficients of the user's.
static void refused(void **state)
{
    (void)state;
    orr_attitude_method m;
    orr_diag diag = {0};
    assert_int_equal(orr_attitude_method_builtin("6-step", &m, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "iteration-8"));
    const double four[] = {54.0 / 105, 92.0 / 105, 214.0 / 105},
                 all[] = {0, 0, 54.0 / 105, 0, 92.0 / 105, 214.0 / 105};
    assert_int_equal(orr_attitude_method_make("mine", 4, four, 2, &m, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "need 3"));
    assert_int_equal(orr_attitude_method_make("mine", 9, four, 3, &m, &diag), ORR_E_ARG);
    const double bad[] = {1, ORR_NAN, 2};
    assert_int_equal(orr_attitude_method_make("mine", 4, bad, 3, &m, &diag), ORR_E_ARG);
    for (int k = 0; k < 2; k++) {
        ASSERT_OK(orr_attitude_method_make("mine", 4, k == 0 ? four : all, k == 0 ? 3 : 6, &m, &diag), diag);
        orr_vibration_error e;
        ASSERT_OK(orr_vibration_error_of(&source, &m, 0.1, &e, &diag), diag);
        near_relative(e.normalised, error_of(&source, "4-step", 0.1), 1e-9);
    }
    orr_vibration_error e;
    orr_vibration_study s = source;
    assert_int_equal(orr_vibration_error_of(&s, &m, 0.0, &e, &diag), ORR_E_ARG);
    s.product_hz = 100;
    assert_int_equal(orr_vibration_error_of(&s, &m, 0.01, &e, &diag), ORR_E_ARG);
    s = source;
    s.duration_s = 0.03;
    assert_int_equal(orr_vibration_error_of(&s, &m, 0.1, &e, &diag), ORR_E_ARG);
}

// At crossings both runs have errors of one size, and the better method changes.
static void crossings(void **state)
{
    (void)state;
    const orr_attitude_method m[] = {builtin("1-step"), builtin("2-step"), builtin("4-step")};
    orr_vibration_crossing c[64];
    const size_t n = orr_vibration_crossings(m, 3, 0.01, 3.0, c, 64);
    assert_true(n >= 3);
    for (size_t k = 0; k < n; k++) {
        assert_true(k == 0 || c[k].ratio >= c[k - 1].ratio);
        const double a = fabs(error_of(&source, m[c[k].first].name, c[k].ratio)),
                     b = fabs(error_of(&source, m[c[k].second].name, c[k].ratio));
        ASSERT_NEAR(a, b, 1e-5);
        ASSERT_NEAR(a, c[k].normalised, 1e-5);
    }
    // Below its first crossing with one step, two steps are better.
    for (double r = 0.01; r < c[0].ratio; r += 0.05)
        assert_true(fabs(error_of(&source, "2-step", r)) <= fabs(error_of(&source, "1-step", r)));
}

// A spectrum of a narrow band is its tone; a broad one is the sum, and runs on made vibrations show it.
static void broadband(void **state)
{
    (void)state;
    orr_diag diag = {0};
    const double at[] = {24.0, 26.0}, flat[] = {1e-4, 1e-4};
    const orr_vibration_psd narrow = {.n = 2, .frequency_hz = at, .rate = flat, .coherence = 1};
    const orr_attitude_method two = builtin("2-step");
    const double drift = orr_vibration_psd_drift(&narrow);
    near_relative(drift, 1e-4 * log(26.0 / 24.0) / (2 * ORR_PI), 1e-8);
    near_relative(orr_vibration_psd_error(&narrow, &two, 100) / drift,
                  orr_attitude_method_response(&two, 0.25), 0.005);

    const double f[] = {5, 20, 200, 800}, s[] = {1e-6, 1e-4, 1e-4, 1e-6};
    orr_vibration_psd wide = {.n = 4, .frequency_hz = f, .rate = s, .coherence = 1};
    near_relative(orr_vibration_psd_at(&wide, 10), 1e-5, 1e-9); // half way in logarithms
    ASSERT_NEAR(orr_vibration_psd_at(&wide, 801), 0, 0);
    const orr_attitude_method m[] = {builtin("1-step"), builtin("4-step")};
    const double readings[] = {100, 2000};
    for (int j = 0; j < 2; j++) {
        // The mean of three runs, which scatters by a part of the whole drift: tones differ from each other in a run of
        // a second, and what is left of their differences has no mean.
        double sum[2] = {0, 0};
        enum { RUNS = 3 };
        for (int k = 0; k < RUNS; k++) {
            double one[2];
            ASSERT_OK(orr_vibration_psd_run(&wide, m, 2, readings[j], 1.0, 7 + (uint64_t)k, one, &diag),
                      diag);
            for (int i = 0; i < 2; i++) sum[i] += one[i] / RUNS;
        }
        const double all = orr_vibration_psd_drift(&wide);
        for (int i = 0; i < 2; i++) {
            const double expected = orr_vibration_psd_error(&wide, &m[i], readings[j]);
            ASSERT_NEAR(sum[i], expected, (j == 0 ? 0.06 : 0.006) * all);
            assert_true(j == 0 ? expected > 0.5 * all : expected < 0.03 * all);
        }
    }
    wide.coherence = -2;
    assert_int_equal(orr_vibration_psd_check(&wide, &diag), ORR_E_ARG);
    const double down[] = {24.0, 20.0}, negative[] = {1, -1};
    const orr_vibration_psd bad[] = {{.n = 1, .frequency_hz = f, .rate = s},
                                     {.n = 2, .frequency_hz = down, .rate = flat},
                                     {.n = 2, .frequency_hz = at, .rate = negative}};
    for (int k = 0; k < 3; k++) assert_int_equal(orr_vibration_psd_check(&bad[k], &diag), ORR_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(prototype), cmocka_unit_test(motion),
                                       cmocka_unit_test(limits),    cmocka_unit_test(second_order),
                                       cmocka_unit_test(iteration), cmocka_unit_test(on_the_earth),
                                       cmocka_unit_test(sculling),  cmocka_unit_test(refused),
                                       cmocka_unit_test(crossings), cmocka_unit_test(broadband)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
