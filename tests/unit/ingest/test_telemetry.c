// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing.h"

#include "core/vec.h"
#include "ingest/telemetry/telemetry.h"

static orr_status read(const char *text, const char *columns, orr_telemetry *t, orr_warnings *w,
                       orr_diag *diag)
{
    return orr_telemetry_read_bytes("made.csv", text, strlen(text), columns, NULL, t, w, diag);
}

static void header_names_and_units(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    const char *text = "Time (ms); Latitude [deg]; lon_rad; alt_km; Heading; pitch[-deg]; roll_rad; what\n"
                       "1000; 56.5; 0.7; 1.5; 90; 2; -0.1; x\n"
                       "2000; 56.6; 0.7; 1.6; 350; 3; 3.1; y\n";
    orr_warnings w = {0};
    ASSERT_OK(read(text, NULL, &t, &w, &diag), diag);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.n_attitude, 2);
    ASSERT_NEAR(t.position_t_s[1], 2.0, 1e-12);
    ASSERT_NEAR(t.position[0].lat_rad, 56.5 * ORR_RAD_PER_DEG, 1e-12);
    ASSERT_NEAR(t.position[0].lon_rad, 0.7, 1e-12);
    ASSERT_NEAR(t.position[1].height_m, 1600, 1e-9);
    ASSERT_NEAR(t.heading_rad[0], 0.5 * ORR_PI, 1e-12);
    ASSERT_NEAR(t.pitch_rad[0], -2 * ORR_RAD_PER_DEG, 1e-12);
    ASSERT_NEAR(t.roll_rad[1], 3.1, 1e-12);
    assert_int_equal(t.attitude_line[1], 3);
    assert_false(t.absolute);
    assert_int_equal(w.count, 1); // the column "what"
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
}

// Every bad row is left out with a sentence of its own.
static void bad_rows_are_left_out(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    orr_warnings w = {0};
    const char *text =
        "t,lat,lon,height\n0,10,20,30\n1,95,20,30\n2,nan,20,30\n3,10,20\n4,ten,20,30\n5,10,20,31\n";
    ASSERT_OK(read(text, NULL, &t, &w, &diag), diag);
    assert_int_equal(t.rows, 6);
    assert_int_equal(t.unreadable, 4);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(w.count, 4);
    assert_int_equal(w.item[0].line, 3);
    assert_non_null(strstr(w.item[0].text, "95"));
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
    assert_int_equal(read("1 2 3 4 5\n", NULL, &t, NULL, &diag), ORR_E_FORMAT);
    assert_non_null(strstr(diag.text, "declare"));
    assert_int_equal(read("1 2\n", "t[ms],lat[furlong]", &t, NULL, &diag), ORR_E_ARG);
    assert_int_equal(read("t,lat\n1,2\n", NULL, &t, NULL, &diag), ORR_E_FORMAT);
    assert_int_equal(read("t,lat,lon,height\nx,y,z,u\n", NULL, &t, NULL, &diag), ORR_E_FORMAT);
}

// A declared log with a fix column, and GPS week and seconds that tie its clock to GPS time.
static void declared_columns_and_clock(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    const char *text =
        "7 1 0 0 10 20 30 500\n8 3 518400000 1770 10 20 30 1500\n9 3 518400200 1770 10 20 31 1700\n";
    ASSERT_OK(read(text, "-,fix[>=3],tow[ms],week,lat,lon,height,t[ms]", &t, NULL, &diag), diag);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.unreadable, 1);
    ASSERT_NEAR(t.position_t_s[0], 1.5, 1e-12);
    assert_true(t.absolute);
    assert_int_equal(t.t0, orr_time_from_week(1770, INT64_C(518398500000000)));
    orr_telemetry_free(&t);
    // ISO times of day
    ASSERT_OK(read("utc[utc],x,y,z\n2024-02-04T00:00:00,4e6,3e6,4e6\n2024-02-04T00:00:01.5,4e6,3e6,4e6\n",
                   NULL, &t, NULL, &diag),
              diag);
    ASSERT_NEAR(t.position_t_s[1], 1.5, 1e-9);
    assert_int_equal(t.t0, orr_time_from_week(2300, 18 * ORR_NS_PER_S)); // 18 leap seconds
    orr_telemetry_free(&t);
}

// Clocks that cannot be are left out before anything is made of them; seconds since 1970 can be.
static void clocks_out_of_bounds(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    orr_warnings w = {0};
    ASSERT_OK(read("week,tow,t,lat,lon,h\n2300,0,1e15,1,2,3\n2300,10,-1e300,1,2,3\n2300,20,1707004820,1,2,3\n"
                   "9999,30,1707004830,1,2,3\n",
                   NULL, &t, &w, &diag),
              diag);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.unreadable, 2);
    assert_non_null(strstr(w.item[0].text, "out of all bounds"));
    assert_int_equal(t.t0 + INT64_C(1707004820000000000), orr_time_from_week(2300, INT64_C(20000000000)));
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
    w = (orr_warnings){0};
    ASSERT_OK(read("time[gps],x,y,z\n2024-02-04T00:00:00,4e6,3e6,4e6\n1700-01-01T00:00:00,4e6,3e6,4e6\n"
                   "2250-01-01T00:00:00,4e6,3e6,4e6\n",
                   NULL, &t, &w, &diag),
              diag);
    assert_int_equal(t.n_position, 1);
    assert_int_equal(w.count, 2);
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
}

static void motion_files(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    ASSERT_OK(read("0.0,-3813477.954,3554276.552,3662785.237\n0.1,-3813477.599,3554276.226,3662785.918\n",
                   NULL, &t, NULL, &diag),
              diag);
    assert_int_equal(t.kind, ORR_TELEMETRY_MOTION_ECEF);
    ASSERT_NEAR(t.position[0].lat_rad * ORR_DEG_PER_RAD, 35.27, 0.01);
    orr_telemetry_free(&t);
    ASSERT_OK(read("0.0,35.274,137.014,100.0\n0.1,35.275,137.014,100.0\n", NULL, &t, NULL, &diag), diag);
    assert_int_equal(t.kind, ORR_TELEMETRY_MOTION_LLH);
    ASSERT_NEAR(t.position[1].lat_rad * ORR_DEG_PER_RAD, 35.275, 1e-12);
    orr_telemetry_free(&t);
}

static void nmea(void **state)
{
    (void)state;
    orr_diag diag = {0};
    orr_telemetry t;
    // The GGA and RMC examples of NMEA's own literature, with a heading, a wrong checksum, a lost fix and
    // midnight.
    const char *text = "$GPRMC,235959.00,A,4807.038,N,01131.000,E,022.4,084.4,230324,003.1,W*60\r\n"
                       "$GPGGA,235959.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*6B\r\n"
                       "$HEHDT,90.5,T*1E\r\n"
                       "$GPGGA,000000.00,4807.039,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*00\r\n"
                       "$GPGGA,000001.00,,,,,0,00,,,M,,M,,*67\r\n"
                       "$GPGGA,000002.00,4807.040,S,01131.000,W,1,08,0.9,545.4,M,46.9,M,,*FF\r\n";
    char fixed[800];
    // checksums by the rule, except the last
    size_t n = 0;
    const char *p = text;
    for (int line = 0; line < 6; line++) {
        const char *end = strchr(p, '*');
        unsigned sum = 0;
        for (const char *q = p + 1; q < end; q++) sum ^= (unsigned char)*q;
        if (line == 5) sum ^= 1;
        n += (size_t)snprintf(fixed + n, sizeof fixed - n, "%.*s*%02X\r\n", (int)(end - p), p, sum);
        p = strchr(p, '\n') + 1;
    }
    orr_warnings w = {0};
    ASSERT_OK(read(fixed, NULL, &t, &w, &diag), diag);
    assert_int_equal(t.kind, ORR_TELEMETRY_NMEA);
    assert_int_equal(t.n_position, 2);
    assert_int_equal(t.unreadable, 2);
    ASSERT_NEAR(t.position_t_s[1], 1.0, 1e-9); // over midnight
    ASSERT_NEAR(t.position[0].lat_rad * ORR_DEG_PER_RAD, 48 + 7.038 / 60, 1e-12);
    ASSERT_NEAR(t.position[0].height_m, 545.4 + 46.9, 1e-9); // over the ellipsoid
    assert_int_equal(t.n_attitude, 1);
    ASSERT_NEAR(t.heading_rad[0], 90.5 * ORR_RAD_PER_DEG, 1e-12);
    assert_true(isnan(t.roll_rad[0]));
    assert_true(t.absolute);
    orr_civil c;
    orr_time_to_civil(t.t0, ORR_SCALE_UTC, NULL, &c);
    assert_int_equal(c.year * 10000 + c.month * 100 + c.day, 20240323);
    assert_int_equal(c.hour * 10000 + c.minute * 100 + c.second, 235959);
    orr_warnings_free(&w);
    orr_telemetry_free(&t);
}

// Truncations of good text never crash and never invent rows.
static void truncated_text(void **state)
{
    (void)state;
    const char *text = "# columns: t[s],lat,lon,height\n1,2,3,4\n5,6,7,8\n$GPGGA,1,2\n\"t\",\"lat\"\n";
    for (size_t n = 1; n < strlen(text); n++) {
        orr_diag diag = {0};
        orr_telemetry t;
        if (orr_telemetry_read_bytes("cut", text, n, NULL, NULL, &t, NULL, &diag) == ORR_OK) {
            assert_true(t.n_position <= 2);
            orr_telemetry_free(&t);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(header_names_and_units),
        cmocka_unit_test(bad_rows_are_left_out),
        cmocka_unit_test(declared_columns_and_clock),
        cmocka_unit_test(clocks_out_of_bounds),
        cmocka_unit_test(motion_files),
        cmocka_unit_test(nmea),
        cmocka_unit_test(truncated_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
