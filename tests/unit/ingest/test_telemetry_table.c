// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of telemetry as other programs write them: times, commas, units, quaternions, autopilots, two clocks.
#include "testing.h"

#include "core/rng.h"
#include "core/vec.h"
#include "ingest/telemetry/telemetry.h"

static orr_telemetry read(const char *text, const char *columns, orr_warnings *w)
{
    orr_diag diag = {0};
    orr_telemetry t;
    ASSERT_OK(orr_telemetry_read_bytes("made.csv", text, strlen(text), columns, NULL, &t, w, &diag), diag);
    return t;
}

static bool told(const orr_warnings *w, const char *words)
{
    for (size_t k = 0; k < w->kept; k++)
        if (strstr(w->item[k].text, words) != NULL) return true;
    return false;
}

// A spreadsheet's first line, which names the separator.
static void a_note_of_the_separator(void **state)
{
    (void)state;
    orr_telemetry t = read("sep=;\ntime;lat;lon;alt\n1;52;13;100\n2;52;13;100\n", NULL, NULL);
    assert_int_equal(t.n_position, 2);
    orr_telemetry_free(&t);
}

// One instant in the ways it is written, under any name of a time.
static void instants_as_text(void **state)
{
    (void)state;
    static const char *const same[] = {"time\n2024-08-15T10:00:00Z",
                                       "time\n2024-08-15T10:00:00+00:00",
                                       "time\n2024-08-15 10:00:00",
                                       "time\n\"2024-08-15T10:00:00\"",
                                       "timestamp\n2024-08-15T12:00:00+02:00",
                                       "utc\n2024-08-15T04:30:00-0530",
                                       "datetime\n2024/08/15 10:00:00.0",
                                       "t\n15.08.2024 10:00:00",
                                       "time\n2024-08-15T10:00:00,000 UTC",
                                       "\"Time\"\n2024-08-15T10:00Z",
                                       "time[utc]\n2024-08-15T12:00:00+02",
                                       "t_gps\n2024-08-15T10:00:18",
                                       "time\n2024-08-15T10:00:18 GPS",
                                       "time\n2024-08-15T10:00:37 TAI",
                                       "t[unix]\n1723716000",
                                       "time_utc_usec\n1723716000000000",
                                       "time\n2024-228T10:00:00Z",
                                       "instant\n1723716000.0",
                                       "time\n20240815T100000Z",
                                       "utc time\n2024-08-15T10:00:00.000000000001Z",
                                       "sod;date\n36000.0;2024-08-15",
                                       "gps time\n2024-08-15 10:00:18",
                                       "time;date\n10:00:00;2024-08-15",
                                       "date;time\n20240815;36000"};
    for (size_t k = 0; k < sizeof same / sizeof same[0]; k++) {
        char text[200], *row;
        strcpy(text, same[k]);
        row = strchr(text, '\n');
        *row++ = '\0';
        char whole[400];
        snprintf(whole, sizeof whole, "lat;lon;height;%s\n50;20;300;%s\n", text, row);
        orr_telemetry t = read(whole, NULL, NULL);
        char at[ORR_TIME_TEXT];
        assert_true(t.absolute);
        assert_string_equal(
            orr_time_format(orr_time_add_s(t.t0, t.position_t_s[0]), ORR_SCALE_UTC, 3, NULL, at),
            "2024-08-15T10:00:00.000Z");
        orr_telemetry_free(&t);
    }
    // The 60th second, in any zone; and nonsense, which is told.
    orr_warnings w = {0};
    orr_telemetry t =
        read("time,lat,lon,h\n2016-12-31T23:59:59Z,1,2,3\n2016-12-31T23:59:60.0Z,1,2,3\n"
             "2017-01-01T01:59:60+02:00,1,2,3\n2017-01-01T00:00:00Z,1,2,3\n2016-12-31T12:59:60Z,1,2,3\n"
             "2017-02-30T00:00:00Z,1,2,3\n2017-02-03T25:00:00Z,1,2,3\n2017-02-03T00:00:00+99:00,1,2,3\n",
             NULL, &w);
    assert_int_equal(t.n_position, 4);
    static const double at[] = {0, 1, 1, 2};
    for (int k = 0; k < 4; k++) ASSERT_NEAR(t.position_t_s[k], at[k], 1e-9);
    assert_true(told(&w, "no ISO 8601"));
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
    // A time of day alone runs on over midnight and is dated by nothing.
    t = read("time,lat,lon,h\n23:59:59.5,1,2,3\n00:00:00.5,1,2,3\n", NULL, NULL);
    assert_false(t.absolute);
    ASSERT_NEAR(t.period_s, 86400, 0);
    ASSERT_NEAR(t.position_t_s[0], 86399.5, 1e-9);
    ASSERT_NEAR(t.position_t_s[1], 86400.5, 1e-9);
    orr_telemetry_free(&t);
}

// Seconds of a day or of a week start again: the flight goes on. A clock that was set back is left to the fit.
static void seconds_that_start_again(void **state)
{
    (void)state;
    orr_warnings w = {0};
    orr_telemetry t = read("t,lat,lon,h\n86398,1,2,3\n86399,1,2,3\n0,1,2,3\n1,1,2,3\n", NULL, &w);
    for (int k = 0; k < 4; k++) ASSERT_NEAR(t.position_t_s[k], 86398.0 + k, 1e-9);
    assert_true(told(&w, "next day"));
    ASSERT_NEAR(t.period_s, 86400, 0);
    orr_telemetry_free(&t);
    orr_warnings_free(&w);
    t = read("tow,lat,lon,h\n604799.8,1,2,3\n0.0,1,2,3\n0.2,1,2,3\n", NULL, NULL);
    ASSERT_NEAR(t.period_s, 604800, 0);
    for (int k = 0; k < 3; k++) ASSERT_NEAR(t.position_t_s[k], 604799.8 + 0.2 * k, 1e-6);
    orr_telemetry_free(&t);
    t = read("sod_ms,lat,lon,h\n86399000,1,2,3\n86399500,1,2,3\n0,1,2,3\n", NULL, NULL);
    ASSERT_NEAR(t.period_s, 86400, 0);
    ASSERT_NEAR(t.position_t_s[2], 86400, 1e-9);
    orr_telemetry_free(&t);
    w = (orr_warnings){0};
    t = read("t,lat,lon,h\n5000,1,2,3\n5001,1,2,3\n0,1,2,3\n1,1,2,3\n", NULL, &w);
    ASSERT_NEAR(t.position_t_s[2], 0, 0);
    assert_int_equal(w.count, 0);
    orr_telemetry_free(&t);
}

static void decimal_commas(void **state)
{
    (void)state;
    static const char *const same[] = {
        "t;lat;lon;height\n0,5;48,25;-11,5;100,75\n", "t\tlat\tlon\theight\n0,5\t48,25\t-11,5\t100,75\n",
        "t,lat,lon,height\n\"0,5\",\"48,25\",\"-11,5\",\"100,75\"\n", "0,5;48,25;-11,5;100,75;0;0;0\n"};
    for (size_t k = 0; k < sizeof same / sizeof same[0]; k++) {
        orr_telemetry t = read(same[k], NULL, NULL);
        ASSERT_NEAR(t.position_t_s[0], 0.5, 1e-12);
        ASSERT_NEAR(t.position[0].lat_rad, 48.25 * ORR_RAD_PER_DEG, 1e-12);
        ASSERT_NEAR(t.position[0].lon_rad, -11.5 * ORR_RAD_PER_DEG, 1e-12);
        ASSERT_NEAR(t.position[0].height_m, 100.75, 1e-12);
        orr_telemetry_free(&t);
    }
    // With commas between fields too nobody can tell them apart: that is named, not read as 0, 5, 48 and 25.
    orr_diag diag = {0};
    orr_telemetry t;
    const char *text = "t,lat,lon,height\n0,5,48,25,11,5,100,75\n";
    assert_int_equal(orr_telemetry_read_bytes("made.csv", text, strlen(text), NULL, NULL, &t, NULL, &diag),
                     ORR_E_FORMAT);
    assert_non_null(strstr(diag.text, "decimal commas"));
}

// Units that are declared, and those of autopilots that a header leaves out.
static void units_of_autopilots(void **state)
{
    (void)state;
    orr_telemetry t =
        read("1000000 523456789 -134567890 123456\n", "t[us],lat[degE7],lon[degE7],height[mm]", NULL);
    ASSERT_NEAR(t.position_t_s[0], 1.0, 1e-12);
    ASSERT_NEAR(t.position[0].lat_rad, 52.3456789 * ORR_RAD_PER_DEG, 1e-14);
    ASSERT_NEAR(t.position[0].height_m, 123.456, 1e-9);
    orr_telemetry_free(&t);
    orr_warnings w = {0};
    t = read("t,lat,lon,height\n0,523456789,-134567890,123456\n1,523456790,-134567890,123456\n", NULL, &w);
    ASSERT_NEAR(t.position[1].lat_rad, 52.345679 * ORR_RAD_PER_DEG, 1e-14);
    ASSERT_NEAR(t.position[1].lon_rad, -13.456789 * ORR_RAD_PER_DEG, 1e-14);
    ASSERT_NEAR(t.position[1].height_m, 123.456, 1e-9);
    assert_true(told(&w, "1e-7 deg"));
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
}

// Times that name no unit: milliseconds or microseconds where seconds would have the body creep, and told; a ship's rows
// a minute apart, and a body at rest, stay what they are.
static void clocks_without_a_unit(void **state)
{
    (void)state;
    static const struct {
        double step, metres, seconds;
    } c[] = {{200, 2, 0.2}, {200000, 2, 0.2}, {60, 300, 60}, {1, 0.1, 1}, {200, 0, 200}, {20, 1, 0.02}};
    for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
        char text[2000] = "time,x,y,z\n";
        for (int k = 0; k < 12; k++)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%.0f,6378137,%.3f,0\n",
                     1e6 + c[i].step * k, c[i].metres * k);
        orr_warnings w = {0};
        orr_telemetry t = read(text, NULL, &w);
        ASSERT_NEAR(t.position_t_s[11] - t.position_t_s[10], c[i].seconds, 1e-6);
        assert_int_equal(told(&w, "name no unit"), c[i].seconds != c[i].step);
        orr_warnings_free(&w);
        orr_telemetry_free(&t);
    }
}

// Two tables of PX4 and two messages of ArduPilot: time, place and attitude by the names of their columns.
static void columns_of_autopilots(void **state)
{
    (void)state;
    orr_telemetry t =
        read("timestamp,time_utc_usec,lat,lon,alt,alt_ellipsoid,s_variance_m_s,eph,fix_type,heading\n"
             "120000000,0,520000000,130000000,100000,147000,0.3,1,2,nan\n"
             "120200000,1723716000200000,520000001,130000000,100000,147000,0.3,1,3,nan\n"
             "120400000,1723716000400000,520000002,130000000,100000,147001,0.3,1,3,nan\n",
             NULL, NULL);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.n_attitude, 0);
    assert_int_equal(t.tie.n, 2);
    ASSERT_NEAR(t.position[1].height_m, 147.001, 1e-9);
    ASSERT_NEAR(t.position_t_s[0], 120.2, 1e-6);
    orr_telemetry_free(&t);
    t = read("timestamp,timestamp_sample,q[0],q[1],q[2],q[3],delta_q_reset[0],quat_reset_counter\n"
             "1000000,999000,0.7071067811865476,0,0,0.7071067811865476,1,0\n",
             NULL, NULL);
    ASSERT_NEAR(t.attitude_t_s[0], 1.0, 1e-12);
    ASSERT_NEAR(t.heading_rad[0], 0.5 * ORR_PI, 1e-9);
    orr_telemetry_free(&t);
    orr_warnings w = {0};
    t = read("timestamp,TimeUS,I,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ,Yaw,U\n"
             "1357044034.3,5000000,0,1,0,0,4,9.9,0,0,0,0,0,0,0,1\n"
             "1357044035.3,6000000,0,3,518400000,1770,9,0.9,-35.5,149.25,584.5,0,0,0,0,1\n"
             "1357044036.3,7000000,0,4,518401000,1770,9,0.9,-35.5,149.25,584.5,0,0,0,0,1\n",
             NULL, &w);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.n_attitude, 0); // a yaw of 0 is that of a receiver with one antenna
    ASSERT_NEAR(t.position_t_s[1], 7.0, 1e-9);
    assert_int_equal(t.t0, orr_time_from_week(1770, INT64_C(518394000000000)));
    assert_true(told(&w, "above sea level"));
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
    t = read("TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw,AEKF\n2000000,1,-3.5,1,2.25,1,270,3\n", NULL,
             NULL);
    ASSERT_NEAR(t.attitude_t_s[0], 2.0, 1e-12);
    ASSERT_NEAR(t.roll_rad[0], -3.5 * ORR_RAD_PER_DEG, 1e-12);
    ASSERT_NEAR(t.heading_rad[0], 1.5 * ORR_PI, 1e-12);
    orr_telemetry_free(&t);
}

// Heading, pitch and roll by elementary turns: q = qz(heading) qy(pitch) qx(roll), body (forward, right, down) into NED.
static void quaternions(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        double h = 2.0 * ORR_PI * orr_rng_uniform(3, 0, (uint64_t)k),
               p = 3.0 * (orr_rng_uniform(3, 1, (uint64_t)k) - 0.5),
               r = 6.0 * (orr_rng_uniform(3, 2, (uint64_t)k) - 0.5);
        orr_quat a = {cos(h / 2), 0, 0, sin(h / 2)}, b = {cos(p / 2), 0, sin(p / 2), 0},
                 c = {cos(r / 2), sin(r / 2), 0, 0};
        orr_quat ab = orr_quat_mul(a, b), q = orr_quat_mul(ab, c);
        char text[300];
        snprintf(text, sizeof text, "t,qw,qx,qy,qz\n0,%.12f,%.12f,%.12f,%.12f\n", q.w, q.x, q.y, q.z);
        orr_telemetry t = read(text, NULL, NULL);
        ASSERT_NEAR(remainder(t.heading_rad[0] - h, 2.0 * ORR_PI), 0, 1e-9);
        ASSERT_NEAR(t.pitch_rad[0], p, 1e-9);
        ASSERT_NEAR(t.roll_rad[0], r, 1e-9);
        orr_telemetry_free(&t);
        // The same attitude as forward, left, up into East, North, Up: yaw 90 deg - heading, pitch nose down.
        double y = 0.5 * ORR_PI - h;
        a = (orr_quat){cos(y / 2), 0, 0, sin(y / 2)};
        b = (orr_quat){cos(-p / 2), 0, sin(-p / 2), 0};
        ab = orr_quat_mul(a, b);
        q = orr_quat_mul(ab, c);
        snprintf(text, sizeof text, "0 %.12f %.12f %.12f %.12f\n", q.w, q.x, q.y, q.z);
        t = read(text, "t,qw[enu],qx,qy,qz", NULL);
        ASSERT_NEAR(remainder(t.heading_rad[0] - h, 2.0 * ORR_PI), 0, 1e-9);
        ASSERT_NEAR(t.pitch_rad[0], p, 1e-9);
        ASSERT_NEAR(t.roll_rad[0], r, 1e-9);
        orr_telemetry_free(&t);
    }
}

// GPS time beside a clock of the log's own that runs 80 ppm fast and whose rows come late by 50 to 250 ms, some by
// seconds: places keep GPS time exactly, angles the line through all rows.
static void two_clocks(void **state)
{
    (void)state;
    size_t size = 4000 * 80;
    char *text = malloc(size);
    assert_non_null(text);
    size_t n = (size_t)snprintf(text, size, "week,tow,t,lat,lon,height,heading\n");
    for (int k = 0; k < 3000; k++) {
        double gps = 1.0 * k, late = 0.05 + 0.2 * orr_rng_uniform(1, 0, (uint64_t)k);
        if (k % 100 == 7) late += 5.0 * orr_rng_uniform(1, 1, (uint64_t)k);
        n += (size_t)snprintf(text + n, size - n, "2300,%.3f,%.4f,50,%.9f,300,90\n", 1000.0 + gps,
                              17.0 + (gps + late) * (1.0 + 80e-6), 20 + 1e-6 * k);
    }
    orr_telemetry t = read(text, NULL, NULL);
    free(text);
    assert_int_equal(t.tie.n, 3000);
    ASSERT_NEAR(t.tie.drift, -80e-6,
                4e-6); // 58 ms of scatter: 1.2e-6
    assert_true(t.tie.scatter_s > 0.03 && t.tie.scatter_s < 0.1);
    orr_time first = orr_time_from_week(2300, INT64_C(1000000000000));
    for (size_t k = 0; k < t.n_position; k++)
        ASSERT_NEAR(orr_time_diff_s(orr_time_add_s(t.t0, t.position_t_s[k]), first), (double)k, 1e-8);
    // Angles stand where the row was written, less the mean delay: within the scatter of the places.
    double sum = 0.0;
    for (size_t k = 0; k < t.n_attitude; k++) {
        double d = t.attitude_t_s[k] - t.position_t_s[k];
        if (k % 100 != 7) assert_true(fabs(d) < 0.13);
        sum += k % 100 != 7 ? d : 0.0;
    }
    ASSERT_NEAR(sum / 2970.0, 0.0, 0.01);
    assert_true(orr_clock_tied_s(&t.tie, 100.0) > 100.0 - 1.0);
    orr_telemetry_free(&t);
}

// What the program's own tables say of their clock's zero.
static void own_tables(void **state)
{
    (void)state;
    static const char *const comment[] = {
        "# t in seconds after 2024-02-04T10:00:00.25 GPS\n",
        "# approach 2, Gauss-Legendre of 2 nodes a step (physical); t0 2024-02-04T10:00:00.25 GPS\n",
        "# seconds after 2024-02-04T09:59:42.25Z\n"};
    for (size_t k = 0; k < sizeof comment / sizeof comment[0]; k++) {
        char text[300];
        snprintf(text, sizeof text, "%st_s,lat_deg,lon_deg,height_m\n1.5,50,20,300\n", comment[k]);
        orr_telemetry t = read(text, NULL, NULL);
        assert_true(t.absolute);
        assert_int_equal(orr_time_add_s(t.t0, t.position_t_s[0]),
                         orr_time_from_week(2300, INT64_C(36001750000000)));
        orr_telemetry_free(&t);
    }
    // Their tables: seconds and instants are one clock.
    orr_telemetry t = read("t_s,lat_deg,lon_deg,height_m,t_gps\n1.5,50,20,300,2024-02-04T10:00:01.75\n"
                           "2.5,50,20,300,2024-02-04T10:00:02.75\n",
                           NULL, NULL);
    assert_true(t.absolute && t.tie.n == 0);
    assert_int_equal(orr_time_add_s(t.t0, t.position_t_s[0]),
                     orr_time_from_week(2300, INT64_C(36001750000000)));
    orr_telemetry_free(&t);
}

// Instants in UTC go by the table that is given: with a leap second at the end of 2026 the day after has one more.
static void leap_seconds_of_the_run(void **state)
{
    (void)state;
    const orr_leap_table *known = orr_leap_builtin();
    orr_leap_entry entry[64];
    memcpy(entry, known->entry, known->n * sizeof *entry);
    entry[known->n] = (orr_leap_entry){61406, 38}; // 2027-01-01
    const orr_leap_table table = {.n = known->n + 1, .entry = entry, .expires_mjd = 61583};
    static const char *const log[] = {
        "utc,lat,lon,height\n2026-12-31T23:59:59Z,50,20,300\n2026-12-31T23:59:60Z,50,20,300\n"
        "2027-01-01T00:00:00Z,50,20,300\n",
        "t[unix],lat,lon,height\n1798761599,50,20,300\n1798761600,50,20,300\n",
        "time,date,lat,lon,height\n23:59:59,2026-12-31,50,20,300\n00:00:00,2027-01-01,50,20,300\n",
        "$GPRMC,235959.00,A,5000.0000,N,02000.0000,E,0.0,0.0,311226,,,A*5D\r\n"
        "$GPGGA,235959.00,5000.0000,N,02000.0000,E,1,08,1.0,300.0,M,0.0,M,,*50\r\n"
        "$GPGGA,235960.00,5000.0000,N,02000.0000,E,1,08,1.0,300.0,M,0.0,M,,*5A\r\n"
        "$GPGGA,000000.00,5000.0000,N,02000.0000,E,1,08,1.0,300.0,M,0.0,M,,*51\r\n"};
    for (size_t k = 0; k < sizeof log / sizeof log[0]; k++) {
        orr_telemetry t;
        orr_diag d = {0};
        orr_warnings w = {0};
        ASSERT_OK(orr_telemetry_read_bytes("made", log[k], strlen(log[k]), NULL, &table, &t, &w, &d), d);
        assert_true(t.absolute && t.n_position >= 2);
        const orr_time last = orr_time_add_s(t.t0, t.position_t_s[t.n_position - 1]);
        assert_true(last - orr_time_add_s(t.t0, t.position_t_s[0]) == 2 * ORR_NS_PER_S);
        assert_true(last == orr_time_from_mjd(61406, 0, ORR_SCALE_UTC, &table));
        assert_false(told(&w, "60th second"));
        orr_telemetry_free(&t);
        orr_warnings_free(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instants_as_text),
        cmocka_unit_test(a_note_of_the_separator),
        cmocka_unit_test(seconds_that_start_again),
        cmocka_unit_test(decimal_commas),
        cmocka_unit_test(units_of_autopilots),
        cmocka_unit_test(columns_of_autopilots),
        cmocka_unit_test(clocks_without_a_unit),
        cmocka_unit_test(quaternions),
        cmocka_unit_test(two_clocks),
        cmocka_unit_test(own_tables),
        cmocka_unit_test(leap_seconds_of_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
