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
    ASSERT_OK(
        orr_telemetry_read(gps, "-,fix[>=3],tow[ms],week,-,-,lat,lon,-,alt,-,-,-,t[ms]", &g, NULL, &diag),
        diag);
    ASSERT_OK(orr_telemetry_read(att, "-,t[ms],roll,pitch,heading,-,-", &a, NULL, &diag), diag);
    assert_int_equal(g.unreadable, 412); // rows before the first fix
    assert_true(g.absolute);
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
