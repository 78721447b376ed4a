// SPDX-License-Identifier: GPL-3.0-or-later
// A small aircraft's log of three quarters of an hour, as recorded: lost fixes, dropouts, wraps and rolls.
#include "testing.h"

#include "inertial/motion/telemetry_fit.h"
#include "inertial/nav/null_test.h"
#include "inertial/sense/sensors.h"
#include "ingest/telemetry/telemetry.h"

static void aircraft_log_comes_through(void **state)
{
    (void)state;
    char gps[512], att[512];
    if (!orr_test_data("flight-x8/GPS.txt.gz", gps, sizeof gps) ||
        !orr_test_data("flight-x8/ATT.txt.gz", att, sizeof att))
        SKIP_NO_DATA("flight-x8");
    orr_diag diag = {0};
    orr_telemetry g, a;
    ASSERT_OK(orr_telemetry_read(gps, "-,fix[>=3],tow[ms],week,-,-,lat,lon,-,alt,-,-,-,t[ms]", NULL, &g, NULL,
                                 &diag),
              diag);
    ASSERT_OK(orr_telemetry_read(att, "-,t[ms],roll,pitch,heading,-,-", NULL, &a, NULL, &diag), diag);
    assert_int_equal(g.unreadable, 412); // rows before the first fix
    assert_true(g.absolute);
    // The log's own clock against GPS time, over the whole log; angles are on the former.
    print_message("drift %.1f ppm, scatter %.3f s\n", 1e6 * g.tie.drift, g.tie.scatter_s);
    assert_int_equal(g.tie.n, g.n_position);
    assert_true(fabs(g.tie.drift) < 100e-6 && g.tie.scatter_s < 0.1);
    for (size_t k = 0; k < a.n_attitude; k++) a.attitude_t_s[k] = orr_clock_tied_s(&g.tie, a.attitude_t_s[k]);
    orr_telemetry_log log = {.n_position = g.n_position,
                             .position_t_s = g.position_t_s,
                             .position = g.position,
                             .position_row = g.position_line,
                             .n_attitude = a.n_attitude,
                             .attitude_t_s = a.attitude_t_s,
                             .heading_rad = a.heading_rad,
                             .pitch_rad = a.pitch_rad,
                             .roll_rad = a.roll_rad,
                             .attitude_row = a.attitude_line};
    orr_fit_options o = orr_fit_options_default();
    orr_trajectory tr;
    orr_fit_report rep;
    ASSERT_OK(orr_trajectory_from_telemetry(g.t0, &log, &o, &tr, &rep, &diag), diag);
    assert_true(rep.wraps > 10);
    assert_true(rep.residuals.position_rms_m < 0.5); // places come in steps of 0.1 m by 1 m
    assert_true(rep.residuals.attitude_rms_rad < 0.5 * ORR_RAD_PER_DEG);
    // Against the log's own GPS time, read without the other clock.
    orr_telemetry own;
    ASSERT_OK(
        orr_telemetry_read(gps, "-,fix[>=3],tow[ms],week,-,-,lat,lon,-,alt,-,-,-,-", NULL, &own, NULL, &diag),
        diag);
    double sum = 0.0, n = 0.0;
    for (size_t k = 0; k < own.n_position; k++) {
        double t = orr_time_diff_s(orr_time_add_s(own.t0, own.position_t_s[k]), tr.t0);
        orr_motion m;
        if (t < tr.begin_s || t > tr.end_s) continue;
        tr.evaluate(tr.self, t, &m);
        orr_vec3 d = orr_vec3_sub(m.r_m, orr_earth_to_ecef(own.position[k]));
        sum += orr_vec3_dot(d, d);
        n += 1.0;
    }
    print_message("%.3f m r.m.s. of %.0f places at their GPS times\n", sqrt(sum / n), n);
    assert_true(sqrt(sum / n) < 0.21);
    orr_telemetry_free(&own);
    orr_imu imu;
    orr_imu_request q = {.duration_s = tr.end_s, .rate_hz = 100, .mode = {.approach = 2, .order = 3}};
    ASSERT_OK(orr_imu_generate(&tr, &q, &imu, &diag), diag);
    orr_navigator nav = {.kind = ORR_NAVIGATOR_REFERENCE, .samples = 5};
    orr_null_report r;
    ASSERT_OK(orr_null_test(&imu, &nav, NULL, NULL, &r, &diag), diag);
    print_message("%.1f s, %.3g m at most\n", r.duration_s, r.max_3d_m);
    assert_true(r.duration_s > 2600);
    ASSERT_NEAR(r.max_3d_m, 0, 1e-3);
    orr_imu_free(&imu);
    orr_fit_report_free(&rep);
    orr_trajectory_free(&tr);
    orr_telemetry_free(&g);
    orr_telemetry_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(aircraft_log_comes_through)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
