// SPDX-License-Identifier: GPL-3.0-or-later
// Linear error equations: closed forms at rest, the same from all formulations, and what is left of the navigator's own errors
// falls with their square.
#include "testing.h"

#include "flights.h"
#include "inertial/motion/analytic.h"
#include "inertial/sense/measured.h"
#include "inertial/sense/sensors.h"
#include "inertial/study/error_modes.h"
#include "inertial/study/error_study.h"

#define HZ 2.0

typedef struct flight {
    orr_trajectory tr;
    orr_imu imu;
    orr_error_flight f;
} flight;

static void take_off(flight *q, double seconds, double hz, const orr_imu_errors *e)
{
    orr_diag diag = {0};
    const orr_imu_request want = {.duration_s = seconds, .rate_hz = hz, .mode = {.approach = 2, .order = 5}};
    ASSERT_OK(orr_imu_generate(&q->tr, &want, &q->imu, &diag), diag);
    ASSERT_OK(orr_imu_add_errors(e, &q->imu, NULL, &diag), diag);
    q->f = (orr_error_flight){.tr = &q->tr, .imu = &q->imu, .every = (size_t)(20.0 * hz)};
}

static void at_rest(flight *q, double lat_deg, double seconds, const orr_imu_errors *e)
{
    memset(q, 0, sizeof *q);
    const orr_analytic_plan plan = {.origin = {lat_deg * ORR_RAD_PER_DEG, 0.3, 0}};
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_analytic(0, 0, seconds, &plan, &q->tr, &diag), diag);
    take_off(q, seconds, HZ, e);
}

static void land(flight *q)
{
    orr_imu_free(&q->imu);
    orr_trajectory_free(&q->tr);
}

static orr_error_state *solve(const flight *q, orr_error_model m)
{
    orr_error_state *x = calloc(orr_error_comparisons(&q->f), sizeof *x);
    orr_diag diag = {0};
    assert_non_null(x);
    ASSERT_OK(orr_error_solve(&q->f, m, ORR_ERROR_RUNGE_KUTTA, q->f.every / 4, x, &diag), diag);
    return x;
}

// At rest on the equator, for a quarter of an hour: a bias b of the northern accelerometer swings position by b / w^2 (1 - cos w t), a
// drift d of the eastern gyro by g d / w^2 (t - sin(w t) / w), a tilt as a bias of g times it; w is Schuler's on the meridian.
static void rest_has_closed_forms(void **state)
{
    (void)state;
    flight q;
    at_rest(&q, 0.0, 3000, &(orr_imu_errors){.accel = {.bias = {0, 1e-4, 0}}});
    q.f.hold_vertical = true;
    orr_error_point p;
    orr_error_point_at(&q.tr, NULL, 0, false, &p);
    const double g = p.gravity.z < 0 ? -p.gravity.z : 0, w = sqrt(g / p.meridian_m);
    for (int m = 0; m < ORR_ERROR_MODELS; m++) {
        orr_error_state *x = solve(&q, (orr_error_model)m);
        for (size_t k = 1; k < orr_error_comparisons(&q.f); k++) {
            const double t = 20.0 * (double)k;
            orr_error_state phi = orr_error_convert((orr_error_model)m, ORR_ERROR_PHI, &p, &x[k]);
            const orr_vec3 d = orr_error_metres(ORR_ERROR_PHI, &p, &phi);
            // The Earth turns by 0.2 rad meanwhile, and shares the swing with East by the square of that at most.
            ASSERT_NEAR(d.y, 1e-4 / (w * w) * (1 - cos(w * t)), 0.02 * 1e-4 / (w * w) + 1e-6);
            ASSERT_NEAR(phi.velocity.y, 1e-4 / w * sin(w * t), 0.03 * 1e-4 / w);
        }
        free(x);
    }
    land(&q);
    at_rest(&q, 0.0, 3000, &(orr_imu_errors){.gyro = {.bias = {1e-8, 0, 0}}});
    q.f.hold_vertical = true;
    orr_error_state *x = solve(&q, ORR_ERROR_PHI);
    for (size_t k = 1; k < orr_error_comparisons(&q.f); k++) {
        const double t = 20.0 * (double)k;
        // phi x f with phi = d t about East takes f = g Up to the South.
        ASSERT_NEAR(orr_error_metres(ORR_ERROR_PHI, &p, &x[k]).y, -p.meridian_m * 1e-8 * (t - sin(w * t) / w),
                    0.02 * p.meridian_m * 1e-8 * t);
    }
    free(x);
    land(&q);
}

static orr_trajectory survey(double seconds)
{
    orr_flight_plan p = test_survey(52, 13);
    p.duration_s = seconds;
    orr_trajectory tr;
    orr_diag diag = {0};
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
    return tr;
}

static const orr_imu_errors all_kinds = {
    .gyro = {.bias = {2e-8, -3e-8, 4e-8}, .scale = {1e-5, -1e-5, 2e-5}, .white = {1e-7, 1e-7, 1e-7}},
    .accel = {.bias = {2e-4, 1e-4, -3e-4}, .scale = {1e-5, 2e-5, -1e-5}},
    .seed = 3};

static void in_flight(flight *q, double seconds, bool held)
{
    memset(q, 0, sizeof *q);
    q->tr = survey(seconds);
    take_off(q, seconds, 10.0, &all_kinds);
    q->f.position_m = orr_vec3_make(20, -30, held ? 0 : 5);
    q->f.velocity_mps = orr_vec3_make(0.1, 0.2, held ? 0 : 0.05);
    q->f.attitude_rad = orr_vec3_make(1e-4, -2e-4, 5e-4);
    q->f.hold_vertical = held;
}

// The three are one solution: carried into each other's quantities they agree to what their integration leaves.
static void formulations_are_equivalent(void **state)
{
    (void)state;
    for (int held = 0; held < 2; held++) {
        flight q;
        in_flight(&q, 1200, held);
        orr_error_state *x[ORR_ERROR_MODELS];
        const size_t n = orr_error_comparisons(&q.f);
        for (int m = 0; m < ORR_ERROR_MODELS; m++) {
            x[m] = calloc(n, sizeof *x[m]);
            orr_diag diag = {0};
            ASSERT_OK(orr_error_solve(&q.f, (orr_error_model)m, ORR_ERROR_RUNGE_KUTTA, 1, x[m], &diag), diag);
        }
        double position = 0, attitude = 0, size = 0;
        for (size_t k = 0; k < n; k++) {
            orr_error_point p;
            orr_error_point_at(&q.tr, NULL, 20.0 * (double)k, false, &p);
            for (int m = 0; m < ORR_ERROR_MODELS; m++) {
                const orr_error_state y = orr_error_convert((orr_error_model)m, ORR_ERROR_PSI, &p, &x[m][k]);
                position =
                    fmax(position, orr_vec3_norm(orr_vec3_sub(y.position, x[ORR_ERROR_PSI][k].position)));
                attitude =
                    fmax(attitude, orr_vec3_norm(orr_vec3_sub(y.attitude, x[ORR_ERROR_PSI][k].attitude)));
                size = fmax(size, orr_vec3_norm(y.position));
            }
        }
        print_message("%s: errors up to %.4g m; the three differ by %.2g m, %.2g rad\n",
                      held ? "held" : "free", size, position, attitude);
        assert_true(size > 200);
        ASSERT_NEAR(position / size, 0,
                    held ? 1e-4 : 1e-6); // the navigator holds at its steps, by whose length the three differ
        ASSERT_NEAR(attitude, 0, 1e-8);
        for (int m = 0; m < ORR_ERROR_MODELS; m++) free(x[m]);
        land(&q);
    }
}

// What a formulation leaves of the direct difference falls with the square of the errors: to a quarter at half of them.
static void what_is_left_is_of_second_order(void **state)
{
    (void)state;
    for (int held = 0; held < 2; held++) {
        flight q;
        in_flight(&q, 900, held);
        const size_t n = orr_error_comparisons(&q.f);
        orr_error_state *direct[2][ORR_ERROR_MODELS];
        orr_diag diag = {0};
        const double sizes[2] = {40, 20};
        for (int i = 0; i < 2; i++) {
            for (int m = 0; m < ORR_ERROR_MODELS; m++) direct[i][m] = calloc(n, sizeof **direct[i]);
            ASSERT_OK(orr_error_differ(&q.f, sizes[i], direct[i], &diag), diag);
        }
        static const char *const model_name[] = {"phi", "psi", "dynamic"};
        for (int m = 0; m < ORR_ERROR_MODELS; m++) {
            orr_error_state *x = calloc(n, sizeof *x);
            ASSERT_OK(orr_error_solve(&q.f, (orr_error_model)m, ORR_ERROR_RUNGE_KUTTA, 1, x, &diag), diag);
            orr_error_hold h[2], mistaken;
            for (int i = 0; i < 2; i++)
                orr_error_compare(&q.f, (orr_error_model)m, x, sizes[i], (orr_error_model)m, direct[i][m],
                                  &h[i]);
            // h is relative: half the errors, half of what is left of them.
            const double ratio[] = {h[0].position / h[1].position, h[0].velocity / h[1].velocity,
                                    h[0].attitude / h[1].attitude};
            print_message("%s %s: left at size %g %.2g %.2g %.2g of position, velocity, attitude; half of it "
                          "%.3f %.3f %.3f\n",
                          held ? "held" : "free", model_name[m], sizes[1], h[1].position, h[1].velocity,
                          h[1].attitude, ratio[0], ratio[1], ratio[2]);
            for (int i = 0; i < 3; i++) assert_true(ratio[i] > 1.7 && ratio[i] < 2.3);
            assert_true(h[1].position < 0.1 && h[1].velocity < 0.1 && h[1].attitude < 0.1);
            // The usual mistake: psi or the dynamic parts held against differences of geographic coordinates.
            orr_error_compare(&q.f, (orr_error_model)m, x, sizes[1], ORR_ERROR_PHI, direct[1][ORR_ERROR_PHI],
                              &mistaken);
            if (m == ORR_ERROR_PSI) assert_true(mistaken.attitude > 5 * h[1].attitude);
            if (m == ORR_ERROR_DYNAMIC) assert_true(mistaken.position > 1);
            free(x);
        }
        for (int i = 0; i < 2; i++)
            for (int m = 0; m < ORR_ERROR_MODELS; m++) free(direct[i][m]);
        land(&q);
    }
}

// A round Earth's dynamic parts do not feel the attitude: an alignment error moves the kinematic parts alone.
static void dynamic_parts_do_not_feel_the_attitude(void **state)
{
    (void)state;
    flight q;
    in_flight(&q, 600, false);
    orr_error_point p;
    orr_error_point_at(&q.tr, NULL, 300, false, &p);
    const double big = orr_vec3_norm(
        orr_vec3_sub(p.gravity, orr_vec3_scale(-1, orr_vec3_cross(p.earth, orr_vec3_cross(p.earth, p.r)))));
    // An exactly round field: attraction along r, its gradient -g/r across and 2 g/r along it.
    const orr_vec3 up = orr_vec3_unit(p.r);
    const double r = orr_vec3_norm(p.r);
    for (int i = 0; i < 3; i++) {
        const double a[3] = {up.x, up.y, up.z};
        for (int k = 0; k < 3; k++) p.gradient.m[i][k] = big / r * (3 * a[i] * a[k] - (i == k));
    }
    p.gravity = orr_vec3_sub(orr_vec3_scale(-big, up), orr_vec3_cross(p.earth, orr_vec3_cross(p.earth, p.r)));
    const orr_error_state tilted = {.attitude = {1e-3, -2e-3, 3e-3}};
    const orr_error_state d =
        orr_error_rate(ORR_ERROR_DYNAMIC, &p, &tilted, orr_vec3_make(0, 0, 0), orr_vec3_make(0, 0, 0));
    ASSERT_NEAR(orr_vec3_norm(d.position), 0, 1e-15);
    ASSERT_NEAR(orr_vec3_norm(d.velocity), 0, 1e-14);
    land(&q);
}

// Schuler's, Foucault's and the Earth's periods. The swing is faster North than East, because the meridian is more curved:
// of the two pairs the mean lies between both, and half the difference is the root of the sum of the squares of u sin(lat)
// and of half their difference.
static void modes_are_schuler_s_foucault_s_and_the_day(void **state)
{
    (void)state;
    const double u = ORR_EARTH_RATE_RADPS;
    for (double lat = 5; lat < 88; lat += 20) {
        flight q;
        at_rest(&q, lat, 100, &(orr_imu_errors){0});
        orr_error_point p;
        orr_error_modes held, free_;
        orr_diag diag = {0};
        orr_error_point_at(&q.tr, NULL, 0, false, &p);
        ASSERT_OK(orr_error_modes_at(&p, true, &held, &diag), diag);
        ASSERT_OK(orr_error_modes_at(&p, false, &free_, &diag), diag);
        const double g = -p.gravity.z, north = sqrt(g / p.meridian_m), east = sqrt(g / p.normal_m),
                     s = u * sin(lat * ORR_RAD_PER_DEG);
        print_message("latitude %2.0f: Schuler %.3f min, Foucault %.3f h, Earth %.4f h, vertical %.1f s\n",
                      lat, held.schuler_s / 60, held.foucault_s / 3600, held.earth_s / 3600, free_.growth_s);
        ASSERT_NEAR(2 * ORR_PI / held.schuler_s / (0.5 * (north + east)), 1, 2e-3);
        ASSERT_NEAR(2 * ORR_PI / held.foucault_s / hypot(s, 0.5 * (north - east)), 1, 0.01);
        ASSERT_NEAR(held.earth_s / 86164.1, 1, 0.01); // shifted by (u / Schuler's)^2 = 0.0035
        ASSERT_NEAR(free_.growth_s * sqrt(2 * g / p.normal_m), 1, 0.01);
        for (size_t k = 0; k < held.n; k++) ASSERT_NEAR(held.real[k], 0, 1e-9); // nothing grows
        // The same field from the round Earth's gradient: the pairs move by the flattening.
        orr_error_point_at(&q.tr, NULL, 0, true, &p);
        orr_error_modes round;
        ASSERT_OK(orr_error_modes_at(&p, true, &round, &diag), diag);
        ASSERT_NEAR(round.schuler_s / held.schuler_s, 1, 5e-3);
        land(&q);
    }
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    flight q;
    at_rest(&q, 10, 100, &(orr_imu_errors){0});
    orr_error_state x[8];
    orr_diag diag = {0};
    assert_int_equal(orr_error_solve(&q.f, ORR_ERROR_PHI, ORR_ERROR_EULER, 7, x, &diag), ORR_E_ARG);
    q.f.every = 3;
    orr_error_state room[ORR_ERROR_MODELS][80], *const out[] = {room[0], room[1], room[2]};
    assert_int_equal(orr_error_differ(&q.f, 1, out, &diag), ORR_E_ARG);
    land(&q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rest_has_closed_forms),
        cmocka_unit_test(formulations_are_equivalent),
        cmocka_unit_test(what_is_left_is_of_second_order),
        cmocka_unit_test(dynamic_parts_do_not_feel_the_attitude),
        cmocka_unit_test(modes_are_schuler_s_foucault_s_and_the_day),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
