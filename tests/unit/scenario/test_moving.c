// SPDX-License-Identifier: GPL-3.0-or-later
// The moving part of a scenario: a made gravity disturbance goes where a transfer carries the flight.
#include "src/make/moving.h"

#include <unistd.h>

#include "testing.h"

static orr_status open_text(const char *text, orr_moving *v, orr_diag *diag)
{
    orr_scenario s;
    ASSERT_OK(orr_scenario_parse("s.yaml", text, strlen(text), ORR_BINARY_DIR, NULL, &s, diag), *diag);
    orr_status status = orr_moving_open(&s.motion, orr_moving_fallback_start(), NULL, NULL, v, diag);
    orr_scenario_free(&s);
    return status;
}

static double disturbance(const orr_moving *v, double t_s)
{
    orr_motion m;
    v->trajectory.evaluate(v->trajectory.self, t_s, &m);
    return orr_gravity_disturbance_mgal(v->gravity, m.r_m);
}

#define FLIGHT(more)                                                                                         \
    "trajectory: {kind: analytic, duration: 100, lat: 50, lon: 20, height: 1000, motions: [{kind: "          \
    "straight, north: 80}]" more "}\n"

// The flight passes 4 km over a mass after 50 s, 49 mGal. Over the pole, across the date line and turned it
// meets the same: lengths along the ground change by 0.7 % at most (polar.h) and the mass lies off the new
// vertical by two times 0.19 deg of 4 km, 27 m. Where the disturbance falls along the track by half in 3 km
// both are less than 1 %.
static void masses_go_with_the_flight(void **state)
{
    (void)state;
    static const char *const to[] = {FLIGHT(", transfer: {lat: 90, lon: 0}"),
                                     FLIGHT(", transfer: {lat: -20, lon: 180, azimuth: 70}"),
                                     FLIGHT(", transfer: {lat: 50, lon: 20}")};
    // 4000 m further North than the origin: 4000/(M + h) rad; M = 6382.3 km there.
#define MASS "gravity: {masses: [{lat: 50.0359, lon: 20, height: -3000, gm: 7840}]}\n"
    orr_moving home, there;
    orr_diag diag = {0};
    ASSERT_OK(open_text(FLIGHT("") MASS, &home, &diag), diag);
    ASSERT_NEAR(disturbance(&home, 50), 49, 0.1);
    for (size_t k = 0; k < sizeof to / sizeof to[0]; k++) {
        char text[600];
        snprintf(text, sizeof text, "%s" MASS, to[k]);
        ASSERT_OK(open_text(text, &there, &diag), diag);
        for (double t_s = 0; t_s <= 100; t_s += 10)
            ASSERT_NEAR(disturbance(&there, t_s), disturbance(&home, t_s), 0.01 * 49);
        orr_moving_free(&there);
    }
    orr_moving_free(&home);
}

static void profiles_go_with_the_flight(void **state)
{
    (void)state;
#define PROFILE                                                                                              \
    "gravity: {profile: {lat: 50, lon: 20, azimuth: 0, distance: [-9000, 0, 2000, 4000, 6000, 8000, "        \
    "19000], "                                                                                               \
    "mgal: [0, 0, 30, 49, 30, 0, 0]}}\n"
    orr_moving home, there;
    orr_diag diag = {0};
    ASSERT_OK(open_text(FLIGHT("") PROFILE, &home, &diag), diag);
    ASSERT_OK(open_text(FLIGHT(", transfer: {lat: 90, lon: 0}") PROFILE, &there, &diag), diag);
    // A profile's steepest slope, 15 mGal/km, over 0.7 % of 8 km.
    for (double t_s = 0; t_s <= 100; t_s += 10)
        ASSERT_NEAR(disturbance(&there, t_s), disturbance(&home, t_s), 15 * 0.007 * 8);
    assert_true(disturbance(&there, 50) > 48);
    orr_moving_free(&home);
    orr_moving_free(&there);
}

static void write_file(const char *name, const char *text)
{
    char path[400];
    snprintf(path, sizeof path, "%s/%s", ORR_BINARY_DIR, name);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    assert_true(fputs(text, f) >= 0 && fclose(f) == 0);
}

// A map stays on its part of the Earth: what would be lost is refused, and so are places without a profile.
static void files_of_gravity(void **state)
{
    (void)state;
    orr_moving v;
    orr_diag diag = {0};
    char map[1000] = "lat,lon,mgal\n";
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            snprintf(map + strlen(map), sizeof map - strlen(map), "%.1f,%.1f,%d\n", 49.5 + 0.4 * i,
                     19.5 + 0.4 * k, 10 * i);
    write_file("map.csv", map);
    write_file("profile.csv", "distance,mgal\n-9000,0\n0,1\n9000,2\n19000,3\n");
    ASSERT_OK(open_text(FLIGHT("") "gravity: {file: map.csv}\n", &v, &diag), diag);
    assert_true(disturbance(&v, 50) > 10);
    orr_moving_free(&v);
    ASSERT_OK(open_text(FLIGHT(", transfer: {lat: 90, lon: 0}") "gravity: {file: map.csv}\n", &v, &diag),
              diag);
    assert_true(disturbance(&v, 50) > 10); // it goes with the flight
    orr_moving_free(&v);
    ASSERT_OK(open_text(FLIGHT("") "gravity: {file: profile.csv, profile: {lat: 50, lon: 20}}\n", &v, &diag),
              diag);
    assert_true(disturbance(&v, 50) > 1);
    orr_moving_free(&v);
    static const char *const wrong[][2] = {
        {FLIGHT("") "gravity: {file: map.csv, profile: {lat: 50, lon: 20}}\n",
         "has no effect without distance and mgal"},
        {FLIGHT("") "gravity: {file: profile.csv}\n", "has to tell its lat, lon"},
        {FLIGHT("") "gravity: {file: profile.csv, profile: {lat: 50, lon: 20, distance: [-9000, 0, 19000], "
                    "mgal: [1, 2, 3]}}\n",
         "one of them is possible"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        assert_int_not_equal(open_text(wrong[k][0], &v, &diag), ORR_OK);
        if (strstr(diag.text, wrong[k][1]) == NULL || strstr(diag.file, ".csv") == NULL)
            fail_msg("%s: %s", diag.file, diag.text);
    }
    unlink(ORR_BINARY_DIR "/map.csv");
    unlink(ORR_BINARY_DIR "/profile.csv");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(masses_go_with_the_flight),
        cmocka_unit_test(profiles_go_with_the_flight),
        cmocka_unit_test(files_of_gravity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
