// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/nan.h"
#include "core/rng.h"
#include "flights.h"
#include "inertial/motion/telemetry_fit.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/sensors.h"

typedef struct recorded {
    orr_telemetry_log log;
    double t[4000], h[4000], p[4000], r[4000];
    orr_geodetic place[4000];
    orr_trajectory truth;
} recorded;

// The survey as a recorder at 1 Hz would have it.
static recorded *record(double lat_deg, double lon_deg, size_t n)
{
    orr_diag diag = {0};
    recorded *k = calloc(1, sizeof *k);
    assert_non_null(k);
    orr_flight_plan p = test_survey(lat_deg, lon_deg);
    p.wind_mps.high_hz = p.heading_rad.high_hz = p.pitch_osc_rad.high_hz = p.roll_rad.high_hz = 0.1;
    p.smoothing_s = 4;
    ASSERT_OK(orr_trajectory_flight_plan(0, &p, &k->truth, NULL, &diag), diag);
    for (size_t i = 0; i < n; i++) {
        orr_motion m;
        k->truth.evaluate(k->truth.self, (double)i, &m);
        orr_angles a = orr_motion_angles(&m);
        k->t[i] = (double)i;
        k->place[i] = orr_earth_from_ecef(m.r_m);
        k->h[i] = a.heading_rad;
        k->p[i] = a.pitch_rad;
        k->r[i] = a.roll_rad;
    }
    k->log = (orr_telemetry_log){.n_position = n,
                                 .position_t_s = k->t,
                                 .position = k->place,
                                 .n_attitude = n,
                                 .attitude_t_s = k->t,
                                 .heading_rad = k->h,
                                 .pitch_rad = k->p,
                                 .roll_rad = k->r};
    return k;
}

static void release(recorded *k)
{
    orr_trajectory_free(&k->truth);
    free(k);
}

static double worst_place(const recorded *k, const orr_trajectory *tr, double from_s, double to_s)
{
    double worst = 0;
    for (double t = from_s; t < to_s; t += 0.37) {
        orr_motion a, b;
        k->truth.evaluate(k->truth.self, t, &a);
        tr->evaluate(tr->self, t, &b);
        worst = fmax(worst, orr_vec3_norm(orr_vec3_sub(a.r_m, b.r_m)));
    }
    return worst;
}

// A clean log gives the flight back, across the date line and near a pole, and its null test holds.
static void clean_log(void **state)
{
    (void)state;
    double where[3][2] = {{56, 40}, {-30, 179.98}, {89.85, 10}};
    for (int w = 0; w < 3; w++) {
        orr_diag diag = {0};
        recorded *k = record(where[w][0], where[w][1], 1200);
        orr_fit_options o = orr_fit_options_default();
        orr_trajectory tr;
        orr_fit_report rep;
        ASSERT_OK(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), diag);
        for (size_t i = 0; i < rep.n_excluded; i++)
            print_message("%d %s %g\n", rep.excluded[i].attitude, orr_fault_name(rep.excluded[i].fault),
                          rep.excluded[i].t_s);
        assert_int_equal(rep.n_excluded, 0);
        assert_int_equal(rep.positions_used, 1200);
        ASSERT_NEAR(rep.position_knot_s, 1.0, 1e-12);
        ASSERT_NEAR(worst_place(k, &tr, 5, 1190), 0,
                    0.2); // a cubic through 1 Hz, motion of up to 0.1 Hz in turns
        orr_imu imu;
        orr_imu_request q = {.duration_s = 1190, .rate_hz = 100, .mode = {.approach = 2, .order = 3}};
        ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
        orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
        orr_null_report r;
        ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
        ASSERT_NEAR(r.max_3d_m, 0, 1e-4);
        orr_imu_free(&imu);
        orr_fit_report_free(&rep);
        orr_trajectory_free(&tr);
        release(k);
    }
}

// Each kind of fault is found, named and left out, and the flight is hardly worse for it.
static void faults_are_found(void **state)
{
    (void)state;
    orr_diag diag = {0};
    recorded *k = record(56, 40, 1500);
    k->place[100].lat_rad += 1e-4; // 600 m
    k->place[101].height_m -= 80;
    k->r[200] += 2.0; // 115 deg of roll
    k->t[300] = 5000; // a clock that leaps ahead
    k->t[400] = 10;   // and one that falls back
    k->place[501] = k->place[500];
    k->t[501] = k->t[500];                                        // a repeated row (both halves: angles)
    for (int i = 601; i <= 605; i++) k->place[i] = k->place[600]; // frozen
    k->place[700].lat_rad = ORR_NAN;
    orr_fit_options o = orr_fit_options_default();
    orr_trajectory tr;
    orr_fit_report rep;
    ASSERT_OK(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), diag);
    assert_int_equal(rep.count[0][ORR_FAULT_CLOCK], 2);
    assert_int_equal(rep.count[1][ORR_FAULT_CLOCK] + rep.count[1][ORR_FAULT_OUTSIDE],
                     3); // the leap is past the last place
    assert_int_equal(rep.count[0][ORR_FAULT_REPEATED], 1);
    assert_int_equal(rep.count[0][ORR_FAULT_FROZEN], 5);
    assert_int_equal(rep.count[0][ORR_FAULT_NOT_FINITE], 1);
    assert_true(rep.count[0][ORR_FAULT_JUMP] >= 2 && rep.count[0][ORR_FAULT_JUMP] <= 6);
    assert_true(rep.count[1][ORR_FAULT_JUMP] >= 1 && rep.count[1][ORR_FAULT_JUMP] <= 6);
    bool found[2] = {false, false};
    for (size_t i = 0; i < rep.n_excluded; i++) {
        found[0] = found[0] || (!rep.excluded[i].attitude && rep.excluded[i].fault == ORR_FAULT_JUMP &&
                                rep.excluded[i].row == 101);
        found[1] = found[1] || (rep.excluded[i].attitude && rep.excluded[i].fault == ORR_FAULT_JUMP &&
                                rep.excluded[i].row == 201);
    }
    assert_true(found[0] && found[1]); // rows count from 1 where the log does not say
    ASSERT_NEAR(worst_place(k, &tr, 5, 595), 0, 5.0);
    assert_true(rep.n_gaps >= 1); // the frozen seconds
    orr_fit_report_free(&rep);
    orr_trajectory_free(&tr);
    release(k);
}

// A long silence parts the log; wraps of heading and roll are nothing special.
static void gaps_and_wraps(void **state)
{
    (void)state;
    orr_diag diag = {0};
    recorded *k = record(56, 40, 1500);
    for (int i = 0; i < 1500; i++) {
        if (i >= 300) k->t[i] += 60;
        k->h[i] = fmod(0.05 * i, 2 * ORR_PI);      // turns round and round
        k->r[i] = remainder(0.03 * i, 2 * ORR_PI); // and rolls over
    }
    orr_fit_options o = orr_fit_options_default();
    orr_trajectory tr;
    orr_fit_report rep;
    ASSERT_OK(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), diag);
    ASSERT_NEAR(rep.from_s, 360, 1e-9);
    assert_int_equal(rep.count[0][ORR_FAULT_OUTSIDE], 300);
    assert_true(rep.wraps >= 15);
    assert_int_equal(rep.count[1][ORR_FAULT_JUMP], 0);
    ASSERT_NEAR(rep.residuals.attitude_max_rad, 0, 1e-3);
    orr_motion m;
    tr.evaluate(tr.self, 700.5, &m);
    orr_angles a = orr_motion_angles(&m);
    ASSERT_NEAR(remainder(a.heading_rad - 0.05 * 1000.5, 2 * ORR_PI), 0, 1e-3);
    ASSERT_NEAR(remainder(a.roll_rad - 0.03 * 1000.5, 2 * ORR_PI), 0, 1e-3);
    orr_fit_report_free(&rep);
    orr_trajectory_free(&tr);
    release(k);
}

// Without angles they follow from the motion.
static void angles_from_motion(void **state)
{
    (void)state;
    orr_diag diag = {0};
    recorded *k = record(56, 40, 1200);
    k->log.n_attitude = 0;
    orr_fit_options o = orr_fit_options_default();
    orr_trajectory tr;
    orr_fit_report rep;
    ASSERT_OK(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), diag);
    assert_true(rep.attitude_from_motion);
    for (double t = 50; t < 1100; t += 13) {
        orr_motion m;
        tr.evaluate(tr.self, t, &m);
        orr_vec3 v = orr_motion_velocity_enu(&m);
        ASSERT_NEAR(remainder(orr_motion_angles(&m).heading_rad - atan2(v.x, v.y), 2 * ORR_PI), 0, 0.02);
    }
    orr_fit_report_free(&rep);
    orr_trajectory_free(&tr);
    release(k);
}

static void too_little_is_told(void **state)
{
    (void)state;
    orr_diag diag = {0};
    recorded *k = record(56, 40, 100);
    orr_fit_options o = orr_fit_options_default();
    orr_trajectory tr;
    orr_fit_report rep;
    k->log.n_position = 2;
    assert_int_equal(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), ORR_E_NODATA);
    assert_non_null(strstr(diag.text, "2 rows"));
    k->log.n_position = 50;
    k->log.attitude_t_s = k->t + 50; // other clocks
    k->log.n_attitude = 50;
    assert_int_equal(orr_trajectory_from_telemetry(0, &k->log, &o, &tr, &rep, &diag), ORR_E_NODATA);
    release(k);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clean_log),          cmocka_unit_test(faults_are_found),
        cmocka_unit_test(gaps_and_wraps),     cmocka_unit_test(angles_from_motion),
        cmocka_unit_test(too_little_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
