// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "flights.h"
#include "inertial/motion/analytic.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/sensors.h"

static orr_null_report run(const orr_trajectory *tr, double duration_s, double rate_hz, orr_imu_mode mode,
                           orr_navigator nav)
{
    orr_diag diag = {0};
    orr_imu imu;
    orr_null_report r;
    orr_imu_request q = {.duration_s = duration_s, .rate_hz = rate_hz, .mode = mode, .gravity = nav.gravity};
    ASSERT_OK(orr_imu_generate(tr, &q, &imu, &diag), diag);
    ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
    orr_imu_free(&imu);
    return r;
}

static const orr_imu_mode physical = {.approach = 2, .order = 2};
static const orr_imu_mode physical3 = {.approach = 2, .order = 3};
static const orr_navigator reference = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};

static orr_trajectory survey(double lat_deg, double lon_deg)
{
    orr_diag diag = {0};
    orr_trajectory tr;
    orr_flight_plan p = test_survey(lat_deg, lon_deg);
    p.duration_s = 3600.0;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
    return tr;
}

// An hour of free navigation on physical readings, at mid-latitude, across the date line and beside a pole.
static void null_test_of_an_hour(void **state)
{
    (void)state;
    double where[3][2] = {{56, 40}, {-65, 179.95}, {89.9, 0}};
    for (int k = 0; k < 3; k++) {
        orr_trajectory tr = survey(where[k][0], where[k][1]);
        orr_null_report r = run(&tr, 3600, 100, physical, reference);
        ASSERT_NEAR(r.duration_s, 3600, 1e-9);
        ASSERT_NEAR(r.max_3d_m, 0,
                    2e-5); // rounding alone, magnified some 500-fold by the free vertical channel
        ASSERT_NEAR(r.max_attitude_rad, 0, 1e-11);
        r = run(&tr, 3600, 10, physical3, reference);
        ASSERT_NEAR(r.max_3d_m, 0, 5e-3);
        orr_trajectory_free(&tr);
    }
}

// The navigator of an approach returns its trajectory; a closed loop does so bit for bit.
static void approach_1_with_its_own_navigator(void **state)
{
    (void)state;
    orr_trajectory tr = survey(56, 40);
    for (int frame = 0; frame < 3; frame++)
        for (int mid = 0; mid < 2; mid++)
            for (int closed = 0; closed < 2; closed++) {
                orr_imu_mode mode = {
                    .approach = 1, .frame = (orr_nav_frame)frame, .project_mid = mid, .closed_loop = closed};
                orr_navigator nav = {
                    .kind = ORR_NAVIGATOR_ONE_STEP, .frame = (orr_nav_frame)frame, .project_mid = mid};
                orr_null_report r = run(&tr, 900, 100, mode, nav);
                ASSERT_NEAR(r.max_3d_m, 0, 5e-5);
                ASSERT_NEAR(r.max_attitude_rad, 0, 1e-12);
                assert_int_equal(r.replayed, closed);
                if (closed) assert_true(r.bit_identical);
            }
    orr_trajectory_free(&tr);
}

// The source's Figs 1-2 (its own pairing): mid-step projection is what makes the null test hold, and the
// error of projection at t_j is of first order in the step.
static void projection_at_mid_step(void **state)
{
    (void)state;
    orr_trajectory tr = survey(56, 40);
    double xi1[2][2];
    for (int mid = 0; mid < 2; mid++)
        for (int fast = 0; fast < 2; fast++) {
            orr_imu_mode mode = {.approach = 1, .frame = ORR_FRAME_INERTIAL, .project_mid = mid};
            orr_navigator nav = {.kind = ORR_NAVIGATOR_ONE_STEP, .frame = ORR_FRAME_BODY, .project_mid = mid};
            xi1[mid][fast] = run(&tr, 3600, fast ? 100 : 50, mode, nav).max_xi1_m;
        }
    assert_true(xi1[0][1] > 1e3 * xi1[1][1]);
    ASSERT_NEAR(xi1[0][0] / xi1[0][1], 2.0, 0.2); // first order
    ASSERT_NEAR(xi1[1][0] / xi1[1][1], 4.0, 0.8); // second order
    orr_trajectory_free(&tr);
}

// Halving the step divides the error by 2^order while truncation is above rounding. Orders: the polynomial
// through n increments leaves h^n at least.
static void navigators_converge(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {0.9, 0.5, 1000}, .follow_course = true, .n_terms = 2};
    plan.term[0] = (orr_analytic_term){.kind = ORR_ANALYTIC_CIRCLE, .radius_m = 2000, .period_s = 150};
    plan.term[1] = (orr_analytic_term){
        .kind = ORR_ANALYTIC_SINE, .period_s = 4, .amplitude_m = {1, 1, 1}, .amplitude = {0.05, 0.05, 0.05}};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 200, &plan, &tr, &diag), diag);
    orr_imu_mode exact = {.approach = 2, .order = 5};
    for (int n = 1; n <= 4; n++) {
        orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = n};
        double coarse = run(&tr, 200, 10, exact, nav).max_3d_m, fine = run(&tr, 200, 20, exact, nav).max_3d_m;
        assert_true(coarse > fine * pow(2.0, n < 2 ? 1.5 : n - 0.5));
    }
    for (int n = 2; n <= 5; n++) {
        orr_navigator nav = {.kind = ORR_NAVIGATOR_MULTI_SAMPLE, .samples = n};
        double coarse = run(&tr, 200, 50, exact, nav).max_3d_m,
               fine = run(&tr, 200, 100, exact, nav).max_3d_m;
        assert_true(coarse > 3.0 * fine); // the classical step in velocity and position is of second order
        assert_true(fine < 1e-2);
    }
    orr_trajectory_free(&tr);
}

static void group_and_polynomial(void **state)
{
    (void)state;
    orr_imu imu = {.rate_hz = 10, .n = 25, .knot_step_s = 1.0, .knot_degree = 3};
    size_t expected[] = {3, 3, 4, 3, 3, 4, 2, 3}, j = 0;
    for (size_t k = 0; k < 8; k++) {
        assert_int_equal(orr_navigator_group(&imu, j, 4), expected[k]);
        j += expected[k];
    }
    assert_int_equal(j, 25);
    imu.knot_step_s = 0.25; // knots within samples: groups end at the nearer edge, and always move on
    for (j = 0; j < 25;) {
        size_t g = orr_navigator_group(&imu, j, 4);
        assert_true(g >= 1 && g <= 3);
        j += g;
    }
    imu.knot_degree = 5;
    assert_int_equal(orr_navigator_group(&imu, 0, 4), 4);
    // A cubic is found again from its increments.
    double c[ORR_NAVIGATOR_MAX_SAMPLES][ORR_NAVIGATOR_MAX_SAMPLES];
    orr_increment_polynomial(4, c);
    for (int d = 0; d < 4; d++) {
        double sum = 0;
        for (int i = 0; i < 4; i++) { // increments of 1 + 2x + 3x^2 + 4x^3
            double a = i / 4.0, b = (i + 1) / 4.0;
            sum += c[d][i] * ((b - a) + (b * b - a * a) + (b * b * b - a * a * a) + (pow(b, 4) - pow(a, 4)));
        }
        ASSERT_NEAR(sum, d + 1, 1e-12);
    }
}

// A tilted start: the horizontal error swings as (1 - cos) with Schuler's period, R tilt in amplitude.
static orr_status keep_east(void *user, const orr_null_point *p)
{
    double *out = user;
    double schuler_s = 2 * ORR_PI * sqrt(6378137.0 / 9.78);
    if (fabs(p->t_s - 0.5 * schuler_s) < 2.6) out[0] = p->horizontal_m;
    if (fabs(p->t_s - schuler_s) < 2.6) out[1] = p->horizontal_m;
    return ORR_OK;
}
static void schuler_oscillation(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {0, 0.3, 0}};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 5100, &plan, &tr, &diag), diag);
    orr_imu imu;
    orr_imu_request q = {.duration_s = 5100, .rate_hz = 1, .mode = physical3};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    double tilt = 1e-6, out[2] = {0, 0};
    imu.start_q_bi = orr_quat_mul(imu.start_q_bi, orr_quat_from_rotvec(orr_vec3_make(tilt, 0, 0)));
    orr_null_report r;
    ASSERT_OK(orr_null_test(&imu, &reference, keep_east, out, &r, &diag), diag);
    // 1 % for the Earth's flattening and its turn in an hour and a half
    ASSERT_NEAR(out[0], 2 * 6378137.0 * tilt, 0.02 * 2 * 6378137.0 * tilt);
    ASSERT_NEAR(out[1], 0, 0.15 * 6378137.0 * tilt);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

// The vertical channel diverges by itself and does not where it is held.
static void held_vertical_channel(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {0.8, 0.3, 100}};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 3600, &plan, &tr, &diag), diag);
    for (int frame = 0; frame < 3; frame++) {
        orr_imu imu;
        orr_imu_request q = {.duration_s = 3600,
                             .rate_hz = 2,
                             .mode = {.approach = 1, .frame = (orr_nav_frame)frame, .project_mid = true}};
        ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
        imu.start_r_m = orr_vec3_scale(1 + 1e-7, imu.start_r_m); // 0.6 m too high
        orr_navigator nav = {
            .kind = ORR_NAVIGATOR_ONE_STEP, .frame = (orr_nav_frame)frame, .project_mid = true};
        orr_null_report r;
        ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
        // growth cosh(t sqrt(2 g / R)) = cosh(6.3)
        double growth = cosh(3600 * sqrt(2 * 9.81 / 6.37e6));
        ASSERT_NEAR(r.max_vertical_m / (0.637 * growth), 1.0, 0.1);
        nav.hold_vertical = true;
        ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
        assert_true(r.max_vertical_m < 0.7);
        orr_imu_free(&imu);
    }
    orr_trajectory_free(&tr);
}

// The same of the reference and the multi-sample navigators, with truth at every fifth sample alone: held there, the
// error is what the channel grows by in between.
static void held_between_truths(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {0.8, 0.3, 100}};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 3600, &plan, &tr, &diag), diag);
    orr_imu imu;
    orr_imu_request q = {.duration_s = 3600, .rate_hz = 2, .mode = physical3};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    for (size_t k = 0; 5 * k <= imu.n; k++) {
        imu.r_m[k] = imu.r_m[5 * k];
        imu.v_mps[k] = imu.v_mps[5 * k];
        imu.q_be[k] = imu.q_be[5 * k];
    }
    imu.truth_every = 5;
    imu.start_r_m = orr_vec3_scale(1 + 1e-7, imu.start_r_m); // 0.637 m too high
    for (int samples = 2; samples <= 5; samples++)
        for (int kind = 0; kind < 2; kind++) {
            orr_navigator nav = {.kind = kind == 0 ? ORR_NAVIGATOR_REFERENCE : ORR_NAVIGATOR_MULTI_SAMPLE,
                                 .samples = samples};
            orr_null_report r;
            ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
            double growth = cosh(3600 * sqrt(2 * 9.81 / 6.37e6)); // e-fold 570 s
            // Steps of 1 to 2.5 s by one rectangle of gravitation add an error of their own in the other kind.
            if (kind == 0) ASSERT_NEAR(r.max_vertical_m / (0.637 * growth), 1.0, 0.1);
            double free_m = r.max_vertical_m;
            nav.hold_vertical = true;
            ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
            assert_true(free_m > 100.0 * r.max_vertical_m);
            assert_int_equal(r.compared, 1 + imu.n / 5);
            ASSERT_NEAR(r.max_vertical_m, 0.637, 0.01); // the start itself
            assert_true(r.max_horizontal_m < 0.05); // 1e-7 of gravity's direction, and the turn of 1 s steps
        }
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_test_of_an_hour),   cmocka_unit_test(approach_1_with_its_own_navigator),
        cmocka_unit_test(projection_at_mid_step), cmocka_unit_test(navigators_converge),
        cmocka_unit_test(group_and_polynomial),   cmocka_unit_test(schuler_oscillation),
        cmocka_unit_test(held_vertical_channel),  cmocka_unit_test(held_between_truths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
