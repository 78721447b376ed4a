// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/rng.h"
#include "flights.h"
#include "inertial/motion/analytic.h"
#include "inertial/motion/dubins.h"
#include "inertial/motion/polar.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/sensors.h"

// Every Dubins path ends where and as it should, and none is shorter than the straight line.
static void dubins_paths_arrive(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 5000; k++) {
        double far = k % 2 == 0 ? 10.0 : 1.5; // the close ones need the three-turn words
        orr_pose a = {far * orr_rng_uniform(1, 0, k), far * orr_rng_uniform(1, 1, k),
                      7 * orr_rng_uniform(1, 2, k)};
        orr_pose b = {far * orr_rng_uniform(1, 3, k), far * orr_rng_uniform(1, 4, k),
                      7 * orr_rng_uniform(1, 5, k)};
        orr_path_piece p[3];
        double length = orr_dubins(a, b, 1.0, p);
        orr_pose end = orr_path_at(&p[2], p[2].length_m);
        ASSERT_NEAR(end.east_m, b.east_m, 1e-7);
        ASSERT_NEAR(end.north_m, b.north_m, 1e-7);
        ASSERT_NEAR(remainder(end.course_rad - b.course_rad, 2 * ORR_PI), 0, 1e-7);
        assert_true(length >= hypot(b.east_m - a.east_m, b.north_m - a.north_m) - 1e-9);
        assert_true(length < hypot(b.east_m - a.east_m, b.north_m - a.north_m) + 2 * ORR_PI * 7.0 / 3.0);
    }
}

static orr_motion at(const orr_trajectory *tr, double t_s)
{
    orr_diag diag = {0};
    orr_motion m;
    ASSERT_OK(orr_trajectory_evaluate(tr, t_s, &m, &diag), diag);
    return m;
}

// A calm survey: lines are straight, level, at speed; turns are coordinated at the bank asked for.
static void survey_is_flown_as_planned(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_flight_plan p = test_survey(50, 179.9);
    p.wind_mps.rms = p.heading_rad.rms = p.pitch_osc_rad.rms = p.roll_rad.rms = 0;
    p.survey.tie_lines = 2;
    p.survey.tie_spacing_m = 10e3;
    p.lead_m = 1500;
    orr_trajectory tr;
    orr_flight_summary sum;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, &sum, &diag), diag);
    ASSERT_NEAR(sum.turn_radius_m, 70.0 * 70.0 / (9.80665 * tan(20 * ORR_RAD_PER_DEG)), 1e-6);
    assert_int_equal(sum.lines, 8);
    // The first line, from the lead's end on: northward on the meridian of the start.
    orr_motion m = at(&tr, 1500.0 / 70.0);
    orr_geodetic g = orr_earth_from_ecef(m.r_m);
    ASSERT_NEAR(g.lat_rad * ORR_DEG_PER_RAD, 50, 1e-8);
    ASSERT_NEAR(g.lon_rad * ORR_DEG_PER_RAD, 179.9, 1e-8);
    double max_roll = 0, low = 1e9, high = -1e9;
    for (double t = 0; t < tr.end_s; t += 0.7) {
        m = at(&tr, t);
        orr_angles a = orr_motion_angles(&m);
        max_roll = fmax(max_roll, fabs(a.roll_rad));
        g = orr_earth_from_ecef(m.r_m);
        low = fmin(low, g.height_m);
        high = fmax(high, g.height_m);
        if (t > 30 && t < 400) {                           // on the first line
            ASSERT_NEAR(orr_vec3_norm(m.v_mps), 70, 0.02); // the map's scale, 1e-4
            ASSERT_NEAR(remainder(a.heading_rad, 2 * ORR_PI), 0, 1e-6);
            ASSERT_NEAR(a.roll_rad, 0, 1e-6);
            ASSERT_NEAR(a.pitch_rad, p.pitch_rad, 1e-6);
            ASSERT_NEAR(g.lon_rad * ORR_DEG_PER_RAD, 179.9, 1e-7);
        }
    }
    ASSERT_NEAR(low, 1500, 1e-3); // the spline between knots
    ASSERT_NEAR(high, 1500, 1e-3);
    ASSERT_NEAR(max_roll * ORR_DEG_PER_RAD, 20, 1.0); // smoothing rounds the onset of turns
    orr_trajectory_free(&tr);
}

static void waypoints_climb_and_turn(void **state)
{
    (void)state;
    orr_diag diag = {0};
    double deg = ORR_RAD_PER_DEG;
    orr_waypoint w[3] = {{{10 * deg, 20 * deg, 500}, 60},
                         {{10.2 * deg, 20 * deg, 1500}, 80},
                         {{10.2 * deg, 20.2 * deg, 1500}, 0}};
    orr_flight_plan p = test_flight_plan();
    p.waypoint = w;
    p.n_waypoints = 3;
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), diag);
    orr_motion m = at(&tr, 0);
    orr_geodetic g = orr_earth_from_ecef(m.r_m);
    ASSERT_NEAR(g.lat_rad / deg, 10, 1e-6);
    ASSERT_NEAR(orr_vec3_norm(m.v_mps), 60, 0.1);
    m = at(&tr, tr.end_s);
    g = orr_earth_from_ecef(m.r_m);
    ASSERT_NEAR(g.lon_rad / deg, 20.2, 1e-6);
    ASSERT_NEAR(g.height_m, 1500, 0.1);
    ASSERT_NEAR(orr_motion_angles(&m).heading_rad / deg, 90, 0.1);
    ASSERT_NEAR(orr_vec3_norm(m.v_mps), 80, 0.1);
    orr_trajectory_free(&tr);
}

static void bad_plans_get_a_sentence(void **state)
{
    (void)state;
    orr_trajectory tr;
    orr_diag diag = {0};
    orr_flight_plan p = test_survey(50, 10);
    p.turn_radius_m = 200;
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "too tight"));
    p = test_survey(95, 10);
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "95"));
    p = test_survey(50, 10);
    p.wind_mps.high_hz = 5;
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    double deg = ORR_RAD_PER_DEG;
    orr_waypoint w[3] = {{{0, 0, 500}, 0}, {{0.001 * deg, 0, 500}, 0}, {{0, 0.001 * deg, 500}, 0}};
    p = test_flight_plan();
    p.waypoint = w;
    p.n_waypoints = 3;
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "turns"));
    w[1].at = (orr_geodetic){0.1 * deg, 0, 5000};
    w[2].at = (orr_geodetic){0.1 * deg, 0.1 * deg, 5000};
    assert_int_equal(orr_trajectory_flight_plan(0, &p, &tr, NULL, &diag), ORR_E_ARG);
    assert_non_null(strstr(diag.text, "climb"));
}

// The same seed gives the same flight, another one another.
static void turbulence_is_seeded(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_flight_plan p = test_survey(56, 40);
    orr_trajectory a, b, c;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &a, NULL, &diag), diag);
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &b, NULL, &diag), diag);
    p.seed = 2;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &c, NULL, &diag), diag);
    orr_motion ma = at(&a, 1234.5), mb = at(&b, 1234.5), mc = at(&c, 1234.5);
    assert_memory_equal(&ma, &mb, sizeof ma);
    assert_true(orr_vec3_norm(orr_vec3_sub(ma.r_m, mc.r_m)) > 0.01);
    // r.m.s. of the vertical velocity is what was asked for; 3000 s hold some 100 independent values
    double sum = 0;
    int n = 0;
    for (double t = 5; t < 3200; t += 1, n++) {
        orr_motion m = at(&a, t);
        double u = orr_motion_velocity_enu(&m).z;
        sum += u * u;
    }
    ASSERT_NEAR(sqrt(sum / n), 0.5, 0.1);
    orr_trajectory_free(&a);
    orr_trajectory_free(&b);
    orr_trajectory_free(&c);
}

// Over the pole: heights stay, lengths stay within the ratio of the radii, the null test is as good as at
// home.
static void polar_transfer_keeps_the_flight(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_flight_plan p = test_survey(56, 40);
    p.duration_s = 3600;
    orr_trajectory home, pole;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &home, NULL, &diag), diag);
    orr_mat3 C = orr_polar_rotation(orr_trajectory_middle(&home), orr_vec3_make(0, 0, 6.4e6), 0);
    orr_mat3 T = orr_mat3_transpose(&C), E = orr_mat3_mul(&C, &T);
    ASSERT_NEAR(E.m[0][0] + E.m[1][1] + E.m[2][2], 3, 1e-14);
    ASSERT_OK(orr_polar_transfer(&home, &C, ORR_POLAR_LEVEL, 0, &pole, &diag), diag);
    double nearest = 1e9;
    for (double t = 0; t <= 3600; t += 0.5) { // the knots of both
        orr_motion a = at(&home, t), b = at(&pole, t);
        ASSERT_NEAR(orr_earth_from_ecef(b.r_m).height_m, orr_earth_from_ecef(a.r_m).height_m, 1e-4);
        ASSERT_NEAR(orr_vec3_norm(b.v_mps) / orr_vec3_norm(a.v_mps), 1, 7e-3);
        // The same samples, but bound differently at the very ends; and levelled, by an angle between verticals that
        // changes by up to 0.0067 rad a radian of way: 6e-8 rad/s.
        ASSERT_NEAR(orr_vec3_norm(b.w_radps), orr_vec3_norm(a.w_radps), t > 10 && t < 3590 ? 1e-7 : 1e-5);
        // The same attitude against the ellipsoid's vertical, but for the turn of 200 km of meridians.
        orr_angles x = orr_motion_angles(&a), y = orr_motion_angles(&b);
        ASSERT_NEAR(y.pitch_rad, x.pitch_rad, 1e-7); // each spline smooths its own samples
        ASSERT_NEAR(remainder(y.roll_rad - x.roll_rad, 2 * ORR_PI), 0, 1e-7);
        nearest = fmin(nearest, hypot(b.r_m.x, b.r_m.y));
    }
    assert_true(nearest < 2000);
    orr_imu imu;
    orr_imu_request q = {.duration_s = 3600, .rate_hz = 100, .mode = {.approach = 2, .order = 2}};
    ASSERT_OK(orr_imu_generate(&pole, &q, &imu, &diag), diag);
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    orr_null_report r;
    ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
    ASSERT_NEAR(r.max_3d_m, 0, 2e-5); // as at home
    orr_imu_free(&imu);
    orr_trajectory_free(&home);
    orr_trajectory_free(&pole);
}

// Level flight stays level, unless (20) is taken at its word: then the verticals' angle of 0.19 deg shows. Places come
// back from where they went.
static void carried_level_or_literally(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {45 * ORR_RAD_PER_DEG, 0.3, 5000},
                              .n_terms = 1,
                              .term = {{.kind = ORR_ANALYTIC_STRAIGHT, .velocity_mps = {30, 60, 0}}}};
    orr_trajectory home, there;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 200, &plan, &home, &diag), diag);
    static const double to[4][2] = {{90, 0}, {0, 120}, {-60, 10}, {45, -100}};
    for (int k = 0; k < 4; k++) {
        orr_vec3 place =
            orr_earth_to_ecef((orr_geodetic){to[k][0] * ORR_RAD_PER_DEG, to[k][1] * ORR_RAD_PER_DEG, 0});
        orr_mat3 C = orr_polar_rotation(orr_trajectory_middle(&home), place, 0.7);
        for (int literal = 0; literal < 2; literal++) {
            ASSERT_OK(orr_polar_transfer(&home, &C, literal ? ORR_POLAR_LITERAL : ORR_POLAR_LEVEL, 0, &there,
                                         &diag),
                      diag);
            double most = 0.0;
            for (double t = 0; t <= 200; t += 0.2) { // the knots
                orr_motion a = at(&home, t), b = at(&there, t);
                orr_angles angles = orr_motion_angles(&b);
                most = fmax(most, hypot(angles.pitch_rad, angles.roll_rad));
                ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_polar_home(&C, b.r_m), a.r_m)), 0, 1e-6);
            }
            if (literal == 0)
                ASSERT_NEAR(most, 0, 1e-9);
            else if (k < 2) // at 45 deg the verticals are 0.1924 deg apart, at pole and equator not at all
                ASSERT_NEAR(most * ORR_DEG_PER_RAD, 0.1924, 0.001);
            orr_trajectory_free(&there);
        }
    }
    orr_trajectory_free(&home);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dubins_paths_arrive),        cmocka_unit_test(survey_is_flown_as_planned),
        cmocka_unit_test(waypoints_climb_and_turn),   cmocka_unit_test(bad_plans_get_a_sentence),
        cmocka_unit_test(turbulence_is_seeded),       cmocka_unit_test(polar_transfer_keeps_the_flight),
        cmocka_unit_test(carried_level_or_literally),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
