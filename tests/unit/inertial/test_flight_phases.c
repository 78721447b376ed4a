// SPDX-License-Identifier: GPL-3.0-or-later
// A flight as a sequence of phases, from rest to rest, and what speeds and heights do at the ends of legs.
#include "testing.h"

#include "flights.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/sensors.h"

#define DEG ORR_RAD_PER_DEG

static orr_motion at(const orr_trajectory *tr, double t_s)
{
    orr_motion m;
    tr->evaluate(tr->self, t_s, &m);
    return m;
}

static double height(const orr_motion *m) { return orr_earth_from_ecef(m->r_m).height_m; }

static const orr_phase sequence[] = {
    {.kind = ORR_PHASE_REST, .duration_s = 120},
    {.kind = ORR_PHASE_TAXI, .length_m = 400},
    {.kind = ORR_PHASE_TURN, .angle_rad = 0.5 * ORR_PI, .radius_m = 40},
    {.kind = ORR_PHASE_TAXI, .length_m = 200, .stop = true},
    {.kind = ORR_PHASE_REST, .duration_s = 60},
    {.kind = ORR_PHASE_TAKEOFF},
    {.kind = ORR_PHASE_CLIMB, .height_m = 600},
    {.kind = ORR_PHASE_SURVEY,
     .at = {52.1 * DEG, 13.2 * DEG, 0},
     .survey = {.azimuth_rad = 30 * DEG, .length_m = 5000, .spacing_m = 2000, .lines = 2}},
    {.kind = ORR_PHASE_TO, .at = {52.0 * DEG, 13.3 * DEG, 0}, .azimuth_rad = 1.5 * ORR_PI},
    {.kind = ORR_PHASE_LANDING, .height_m = 120, .speed_mps = 45, .rate_mps = 4},
    {.kind = ORR_PHASE_REST, .duration_s = 60},
};

static orr_flight_plan plan_of(const orr_phase *phase, size_t n)
{
    orr_flight_plan p = test_flight_plan();
    p.phase = phase;
    p.n_phases = n;
    p.start = (orr_geodetic){52 * DEG, 13 * DEG, 100};
    p.course_rad = 250 * DEG;
    p.knot_step_s = 0.5;
    p.pitch_rad = 2 * DEG;
    return p;
}

static void from_rest_to_rest(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_flight_plan p = plan_of(sequence, sizeof sequence / sizeof sequence[0]);
    orr_trajectory tr;
    orr_flight_summary sum;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, &sum, &diag), diag);
    assert_int_equal(sum.lines, 2);
    ASSERT_NEAR(tr.end_s, sum.duration_s, 1e-9);
    // Rest is rest, some knots off the joints: nothing moves, the heading is the course, nothing tilts.
    const double still[][2] = {{0, 95}, {tr.end_s - 35, tr.end_s}};
    for (int k = 0; k < 2; k++)
        for (double t = still[k][0]; t <= still[k][1]; t += 0.37) {
            orr_motion m = at(&tr, t), first = at(&tr, still[k][0]);
            orr_angles a = orr_motion_angles(&m);
            ASSERT_NEAR(orr_vec3_norm(m.v_mps), 0, 1e-7);
            ASSERT_NEAR(orr_vec3_norm(m.a_mps2), 0, 1e-7);
            ASSERT_NEAR(orr_vec3_norm(m.w_radps), 0, 1e-8);
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(m.r_m, first.r_m)), 0, 1e-6);
            ASSERT_NEAR(a.pitch_rad, 0, 1e-8);
            ASSERT_NEAR(a.roll_rad, 0, 1e-8);
            if (k == 0) ASSERT_NEAR(a.heading_rad, 250 * DEG, 1e-8);
        }
    orr_motion first = at(&tr, 0), last = at(&tr, tr.end_s);
    ASSERT_NEAR(height(&first), 100, 1e-6);
    ASSERT_NEAR(height(&last), 120, 1e-6);
    // Acceleration and rate run on at every instant, joints included: no step over a millisecond is more than the
    // change that the smoothing allows (some 2 m/s^3); speeds change by 2 m/s^2 at most.
    double highest = 0, fastest = 0;
    orr_motion before = at(&tr, 0);
    for (double t = 0.1; t <= tr.end_s; t += 0.1) {
        orr_motion m = at(&tr, t), next = at(&tr, fmin(t + 1e-3, tr.end_s));
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(next.a_mps2, m.a_mps2)), 0, 4e-3);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(next.w_radps, m.w_radps)), 0, 2e-3);
        double v = orr_vec3_norm(m.v_mps);
        ASSERT_NEAR((v - orr_vec3_norm(before.v_mps)) / 0.1, 0,
                    2.02); // and 0.02 of lines that bend with the Earth
        highest = fmax(highest, height(&m));
        fastest = fmax(fastest, v);
        before = m;
    }
    ASSERT_NEAR(highest, 600, 0.1);
    ASSERT_NEAR(fastest, hypot(60, 5), 0.02); // over the ground, and the climb
    // The readings of all of it navigate back.
    orr_imu imu;
    orr_imu_request q = {.duration_s = tr.end_s, .rate_hz = 100, .mode = {.approach = 2, .order = 2}};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    orr_null_report r;
    ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
    print_message("%.0f s, %.2g m\n", r.duration_s, r.max_3d_m);
    ASSERT_NEAR(r.max_3d_m, 0, 1e-4);
    orr_imu_free(&imu);
    orr_trajectory_free(&tr);
}

// On the ground a body neither sways nor banks, whatever the air does.
static void the_air_moves_what_flies(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_flight_plan p = plan_of(sequence, 8);
    p.wind_mps = (orr_spectrum){1.0, 0.02, 0.3, -5.0 / 3.0};
    p.roll_rad = (orr_spectrum){1.0 * DEG, 0.02, 0.3, 0};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
    double most = 0, sway = 0;
    for (double t = 0; t < 100; t += 0.5) {
        orr_motion m = at(&tr, t);
        most = fmax(most, orr_vec3_norm(m.v_mps));
    }
    ASSERT_NEAR(most, 0, 1e-6);
    for (double t = tr.end_s - 60; t < tr.end_s; t += 0.5) {
        orr_motion m = at(&tr, t);
        sway = fmax(sway, fabs(height(&m) - 600));
    }
    assert_true(sway > 0.3);
    orr_trajectory_free(&tr);
}

static void what_does_not_follow(void **state)
{
    (void)state;
    static const struct {
        orr_phase phase[2];
        const char *why;
    } wrong[] = {
        {{{.kind = ORR_PHASE_STRAIGHT, .length_m = 1000}, {.kind = ORR_PHASE_REST, .duration_s = 10}},
         "begins at 60.0 m/s"},
        {{{.kind = ORR_PHASE_REST, .duration_s = 10}, {.kind = ORR_PHASE_CLIMB, .height_m = 500}},
         "take off first"},
        {{{.kind = ORR_PHASE_REST, .duration_s = 10}, {.kind = ORR_PHASE_TURN, .angle_rad = 1}},
         "does not turn"},
        {{{.kind = ORR_PHASE_REST, .duration_s = 10}, {.kind = ORR_PHASE_STRAIGHT, .length_m = 10}},
         "names no speed"},
        {{{.kind = ORR_PHASE_TAKEOFF}, {.kind = ORR_PHASE_TAKEOFF}}, "in the air already"},
        {{{.kind = ORR_PHASE_TAKEOFF}, {.kind = ORR_PHASE_TAXI, .length_m = 10}}, "land first"},
        {{{.kind = ORR_PHASE_TAXI, .length_m = 10, .stop = true}, {.kind = ORR_PHASE_REST, .duration_s = 1}},
         "more than there are"},
        {{{.kind = ORR_PHASE_TAKEOFF}, {.kind = ORR_PHASE_TURN, .angle_rad = 1, .radius_m = 100}},
         "deg of bank"},
        {{{.kind = ORR_PHASE_REST, .duration_s = 10}, {.kind = ORR_PHASE_LANDING}}, "on the ground already"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        orr_diag diag = {0};
        orr_trajectory tr;
        orr_flight_plan p = plan_of(wrong[k].phase, 2);
        assert_int_not_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_OK);
        if (strstr(diag.text, wrong[k].why) == NULL || strstr(diag.text, "phase ") == NULL)
            fail_msg("%s", diag.text);
    }
}

// 120 to 30 m/s at a waypoint: as slowly as the greatest acceleration says, or refused where the leg is too short.
static void speeds_change_within_limits(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_waypoint w[3] = {{{50 * DEG, 20 * DEG, 500}, 120},
                         {{50.2 * DEG, 20 * DEG, 500}, 30},
                         {{50.4 * DEG, 20 * DEG, 500}, 0}};
    orr_flight_plan p = test_flight_plan();
    p.waypoint = w;
    p.n_waypoints = 3;
    static const double limit[] = {0.5, 2.0, 8.0};
    for (int k = 0; k < 3; k++) {
        orr_trajectory tr;
        p.acceleration_mps2 = limit[k];
        ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
        double most = 0;
        for (double t = 0.1; t < tr.end_s; t += 0.1) {
            orr_motion a = at(&tr, t - 0.05), b = at(&tr, t + 0.05);
            most = fmax(most, fabs(orr_vec3_norm(b.v_mps) - orr_vec3_norm(a.v_mps)) / 0.1);
        }
        assert_true(most < 1.001 * limit[k]);
        assert_true(most > 0.9 * limit[k]);
        orr_motion end = at(&tr, tr.end_s);
        ASSERT_NEAR(orr_vec3_norm(end.v_mps), 30, 0.1);
        orr_trajectory_free(&tr);
    }
    orr_trajectory tr;
    w[2].at.lat_rad = 50.3 * DEG;
    p.acceleration_mps2 = 0.5;
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "which takes 13500 m at 0.50 m/s^2"));
}

// A leg that climbs from its first waypoint on begins at that waypoint's height, and ends at the other's.
static void a_climbing_leg_begins_where_it_should(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_waypoint w[2] = {{{50 * DEG, 20 * DEG, 500}, 60}, {{50.1 * DEG, 20 * DEG, 1300}, 0}};
    orr_flight_plan p = test_flight_plan();
    p.waypoint = w;
    p.n_waypoints = 2;
    orr_trajectory tr;
    orr_flight_summary sum;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, &sum, &diag), diag);
    orr_motion first = at(&tr, 0), last = at(&tr, tr.end_s);
    ASSERT_NEAR(height(&first), 500, 1e-3);
    ASSERT_NEAR(height(&last), 1300, 1e-3);
    orr_trajectory_free(&tr);
    // Flown on for longer than the plan, it levels off at the last height.
    p.duration_s = sum.duration_s + 60;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
    last = at(&tr, tr.end_s);
    ASSERT_NEAR(height(&last), 1300, 1e-3);
    orr_trajectory_free(&tr);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(from_rest_to_rest),
        cmocka_unit_test(the_air_moves_what_flies),
        cmocka_unit_test(what_does_not_follow),
        cmocka_unit_test(speeds_change_within_limits),
        cmocka_unit_test(a_climbing_leg_begins_where_it_should),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
