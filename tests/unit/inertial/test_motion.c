// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "inertial/motion/analytic.h"
#include "inertial/sense/sensors.h"

static const double U = ORR_EARTH_RATE_RADPS;

// Somigliana's closed form with the constants of NIMA TR8350.2.
static double surface_gravity(double lat_rad)
{
    const double s2 = sin(lat_rad) * sin(lat_rad);
    return 9.7803253359 * (1 + 0.00193185265241 * s2) / sqrt(1 - ORR_WGS84_E2 * s2);
}

static void signs_of_angles(void **state)
{
    (void)state;
    orr_mat3 east = orr_body_from_enu((orr_angles){0.5 * ORR_PI, 0, 0});
    ASSERT_NEAR(east.m[1][0], 1.0, 1e-15);  // heading 90 deg, clockwise: forward is East,
    ASSERT_NEAR(east.m[0][1], -1.0, 1e-15); // right is South
    orr_mat3 nose_up = orr_body_from_enu((orr_angles){0, 0.3, 0});
    ASSERT_NEAR(nose_up.m[1][2], sin(0.3), 1e-15);
    orr_mat3 right_down = orr_body_from_enu((orr_angles){0, 0, 0.3});
    ASSERT_NEAR(right_down.m[0][2], -sin(0.3), 1e-15);
}

static void angles_come_back(void **state)
{
    (void)state;
    for (int h = 0; h < 24; h++)
        for (int p = -5; p <= 5; p++)
            for (int r = -11; r <= 11; r++) {
                orr_angles a = {h * 15 * ORR_RAD_PER_DEG, p * 16 * ORR_RAD_PER_DEG, r * 16 * ORR_RAD_PER_DEG};
                orr_mat3 L = orr_body_from_enu(a);
                orr_angles b = orr_angles_from_body_enu(&L);
                ASSERT_NEAR(remainder(b.heading_rad - a.heading_rad, 2 * ORR_PI), 0, 1e-13);
                ASSERT_NEAR(b.pitch_rad, a.pitch_rad, 1e-13);
                ASSERT_NEAR(b.roll_rad, a.roll_rad, 1e-13);
            }
}

// A unit at rest reads +g upward and the Earth's rate in the meridian.
static void rest_reads_gravity_and_earth_rate(void **state)
{
    (void)state;
    orr_diag diag = {0};
    for (int lat = -80; lat <= 80; lat += 20) {
        orr_analytic_plan plan = {.origin = {lat * ORR_RAD_PER_DEG, 2.0, 0.0}};
        orr_trajectory tr;
        ASSERT_OK(orr_trajectory_analytic(0, 0, 10, &plan, &tr, &diag), diag);
        orr_vec3 w, f;
        orr_sensors_instant(&tr, NULL, 5.0, &w, &f);
        // 1 ulp of the position and of GeographicLib's closed forms
        ASSERT_NEAR(f.x, 0, 1e-9);
        ASSERT_NEAR(f.y, 0,
                    1e-7); // u here is 7.292115e-5 in both, but normal gravity's own omega has more digits
        ASSERT_NEAR(f.z, surface_gravity(plan.origin.lat_rad), 1e-7);
        ASSERT_NEAR(w.x, 0, 1e-19);
        ASSERT_NEAR(w.y, U * cos(plan.origin.lat_rad), 1e-19);
        ASSERT_NEAR(w.z, U * sin(plan.origin.lat_rad), 1e-19);
        orr_trajectory_free(&tr);
    }
}

static orr_trajectory lively(double lat_deg, double lon_deg)
{
    orr_diag diag = {0};
    orr_analytic_plan plan = {.origin = {lat_deg * ORR_RAD_PER_DEG, lon_deg * ORR_RAD_PER_DEG, 2000.0},
                              .attitude = {.pitch_rad = 0.1, .roll_rad = -0.2},
                              .follow_course = true,
                              .n_terms = 4};
    plan.term[0] =
        (orr_analytic_term){.kind = ORR_ANALYTIC_CIRCLE, .radius_m = 3000, .period_s = 200, .azimuth_rad = 1};
    plan.term[1] =
        (orr_analytic_term){.kind = ORR_ANALYTIC_EIGHT, .along_m = 500, .across_m = 300, .period_s = 171};
    plan.term[2] = (orr_analytic_term){.kind = ORR_ANALYTIC_STRAIGHT, .velocity_mps = {10, 150, 3}};
    plan.term[3] = (orr_analytic_term){.kind = ORR_ANALYTIC_SINE,
                                       .period_s = 7,
                                       .amplitude_m = {1, 2, 3},
                                       .amplitude = {0.1, 0.2, 0.3},
                                       .phase_rad = 0.5};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, 1000, &plan, &tr, &diag), diag);
    return tr;
}

// Every derivative is that of the value, by central differences at two places, one across the date line.
static void derivatives_are_consistent(void **state)
{
    (void)state;
    double where[2][2] = {{56, 40}, {-71, 179.999}};
    for (int k = 0; k < 2; k++) {
        orr_trajectory tr = lively(where[k][0], where[k][1]);
        for (double t = 1; t < 900; t += 37.7) {
            const double h = 1e-3; // cubes of it times jerks of some 10 m/s^3 give the tolerances
            orr_motion a, m, b;
            tr.evaluate(tr.self, t - h, &a);
            tr.evaluate(tr.self, t, &m);
            tr.evaluate(tr.self, t + h, &b);
            orr_vec3 v = orr_vec3_scale(0.5 / h, orr_vec3_sub(b.r_m, a.r_m));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(v, m.v_mps)), 0, 1e-5);
            orr_vec3 acc = orr_vec3_scale(0.5 / h, orr_vec3_sub(b.v_mps, a.v_mps));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(acc, m.a_mps2)), 0, 1e-5);
            orr_mat3 A = orr_mat3_from_quat(a.q_be), B = orr_mat3_from_quat(b.q_be),
                     T = orr_mat3_transpose(&A);
            orr_mat3 D = orr_mat3_mul(&B, &T);
            orr_vec3 w = orr_vec3_scale(0.5 / h, orr_rotvec_from_mat3(&D));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(w, m.w_radps)), 0, 1e-6);
            orr_vec3 wd = orr_vec3_scale(0.5 / h, orr_vec3_sub(b.w_radps, a.w_radps));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(wd, m.wdot_radps2)), 0, 1e-6);
            // The absolute rate of the body is that relative to the Earth and the Earth's own.
            orr_vec3 rate, force;
            orr_motion_sense(&m, (orr_vec3){0, 0, 0}, &rate, &force);
            orr_mat3 M = orr_mat3_from_quat(m.q_be);
            orr_vec3 earth = orr_mat3_apply(&M, orr_vec3_make(0, 0, U));
            ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(orr_vec3_sub(rate, m.w_radps), earth)), 0, 1e-15);
        }
        orr_trajectory_free(&tr);
    }
}

// A level turn: the force is centripetal, v^2 / R, besides gravity, Coriolis and the Earth's roundness.
static void circle_has_its_closed_form(void **state)
{
    (void)state;
    orr_diag diag = {0};
    double R = 1000, T = 100, w = 2 * ORR_PI / T;
    orr_analytic_plan plan = {.origin = {0.7, 0.3, 0}, .follow_course = true, .n_terms = 1};
    plan.term[0] = (orr_analytic_term){.kind = ORR_ANALYTIC_CIRCLE, .radius_m = R, .period_s = T};
    orr_trajectory tr;
    ASSERT_OK(orr_trajectory_analytic(0, 0, T, &plan, &tr, &diag), diag);
    for (double t = 0; t < T; t += 9.3) {
        orr_motion m;
        orr_vec3 gyro, f;
        tr.evaluate(tr.self, t, &m);
        orr_sensors_instant(&tr, NULL, t, &gyro, &f);
        // Clockwise, nose on the course: the centre is to the right; Coriolis 2 u v sin(lat) (0.6 cm/s^2)
        // pushes right of it, so the unit feels that much more to the right; what is left is R/R_earth of
        // v^2/R and R's size of tilt (1e-5 g).
        double v = R * w, coriolis = -2 * U * v * sin(0.7);
        ASSERT_NEAR(f.x, v * v / R + coriolis, 2e-3);
        ASSERT_NEAR(orr_vec3_norm(m.v_mps), v, 1e-3 * v);
        // clockwise seen from above is negative about up; the meridians' turn v tan(lat) / R is 8e-6 rad/s
        ASSERT_NEAR(gyro.z, -w + U * sin(0.7), 1e-5);
        ASSERT_NEAR(orr_motion_angles(&m).pitch_rad, 0, 1e-12);
    }
    orr_trajectory_free(&tr);
}

// Level flight weighs less by the Eotvoes term and by nothing else, whatever the direction.
static void level_flight_shows_the_eotvos_term(void **state)
{
    (void)state;
    orr_diag diag = {0};
    for (int k = 0; k < 8; k++) {
        double course = k * 0.25 * ORR_PI;
        orr_analytic_plan plan = {.origin = {-0.6, 1.0, 3000}, .n_terms = 1};
        plan.term[0] = (orr_analytic_term){.kind = ORR_ANALYTIC_STRAIGHT,
                                           .velocity_mps = {100 * sin(course), 100 * cos(course), 0}};
        orr_trajectory tr;
        ASSERT_OK(orr_trajectory_analytic(0, 0, 1000, &plan, &tr, &diag), diag);
        orr_motion m;
        tr.evaluate(tr.self, 700, &m);
        orr_geodetic at = orr_earth_from_ecef(m.r_m);
        ASSERT_NEAR(at.height_m, 3000, 1e-8);
        orr_mat3 E = orr_earth_enu_from_ecef(at.lat_rad, at.lon_rad), B = orr_mat3_from_quat(m.q_be);
        orr_vec3 G = orr_earth_normal_gravitation(m.r_m);
        orr_vec3 rate, force;
        orr_motion_sense(&m, G, &rate, &force);
        orr_vec3 f = orr_mat3_apply(&E, orr_mat3_apply_t(&B, force));
        orr_vec3 g = orr_vec3_add(G, orr_vec3_make(U * U * m.r_m.x, U * U * m.r_m.y, 0));
        double gamma = -orr_mat3_apply(&E, g).z;
        double round_mps2;
        ASSERT_NEAR(f.z, gamma - orr_motion_eotvos(&m, &round_mps2), 1e-9);
        ASSERT_NEAR(round_mps2, 100.0 * 100.0 / 6.37e6, 1e-5); // radii from 6.34 to 6.40 thousand km
        orr_trajectory_free(&tr);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_of_angles),
        cmocka_unit_test(angles_come_back),
        cmocka_unit_test(rest_reads_gravity_and_earth_rate),
        cmocka_unit_test(derivatives_are_consistent),
        cmocka_unit_test(circle_has_its_closed_form),
        cmocka_unit_test(level_flight_shows_the_eotvos_term),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
