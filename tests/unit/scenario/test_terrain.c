// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons of terrain: a ridge and a cone in closed form over a curved Earth, channels below them, what files lack.
#include "src/scenario/effect/terrain.h"

#include "core/constants.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, R, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"
#define RIDGE_FILE ORR_BINARY_DIR "/" ORR_TEST_NAME "_ridge.asc"
enum { SIDE = 241, MIDDLE = SIDE / 2 };

static float height[SIDE][SIDE];
static const orr_geodetic place = {52 * ORR_RAD_PER_DEG, 17 * ORR_RAD_PER_DEG, 102};

// Level ground at 100 m around the place.
static orr_esri_grid level(double lat_step_deg, double lon_step_deg)
{
    for (size_t i = 0; i < SIDE; i++)
        for (size_t j = 0; j < SIDE; j++) height[i][j] = 100;
    return (orr_esri_grid){.columns = SIDE,
                           .rows = SIDE,
                           .west_deg = 17 - MIDDLE * lon_step_deg,
                           .north_deg = 52 + MIDDLE * lat_step_deg,
                           .lon_step_deg = lon_step_deg,
                           .lat_step_deg = lat_step_deg,
                           .height_m = &height[0][0]};
}

static void horizon_of(const orr_esri_grid *g, double range_m, bool refraction, orr_horizon *out)
{
    double nearest_m, below_m;
    orr_diag diag = {0};
    ASSERT_OK(orr_horizon_of(g, 0, place, range_m, refraction, out, &nearest_m, &below_m, &diag), diag);
    ASSERT_NEAR(below_m, 0, 0);
    ASSERT_NEAR(nearest_m, range_m, 0);
}

// Elevation of a point at a height above the ellipsoid, that far along a circle of a radius.
static double seen_rad(double distance_m, double height_m, double radius_m)
{
    const double angle = distance_m / radius_m, own = radius_m + place.height_m, other = radius_m + height_m;
    return atan2(other * cos(angle) - own, other * sin(angle));
}

// The ellipsoid's radius of curvature at the place along a meridian and across it.
static double along_m(void)
{
    const double a = 6378137, e2 = 6.69438e-3, s = sin(place.lat_rad);
    return a * (1 - e2) / pow(1 - e2 * s * s, 1.5);
}
static double across_m(void)
{
    const double a = 6378137, e2 = 6.69438e-3, s = sin(place.lat_rad);
    return a / sqrt(1 - e2 * s * s);
}

// A ridge along a parallel, near and far: due North it has the elevation of its crest on the curved Earth (at 40 km 0.18 deg less than
// on a plane), aside that of a crest 1/cos farther.
static void a_ridge_has_its_elevation(void **state)
{
    (void)state;
    static orr_horizon h;
    static const double step_deg[] = {0.0005, 0.004};
    for (size_t k = 0; k < 2; k++) {
        const orr_esri_grid g = level(step_deg[k], 1.5 * step_deg[k]);
        for (size_t j = 0; j < SIDE; j++) height[MIDDLE - 90][j] = 600;
        const double distance_m = 90 * step_deg[k] * ORR_RAD_PER_DEG * along_m();
        horizon_of(&g, 1.1 * distance_m, false, &h);
        ASSERT_NEAR(orr_horizon_at(&h, 0), seen_rad(distance_m, 600, along_m()), 1e-6);
        for (double az = -30; az <= 30; az += 0.25) {
            const double turned = az < 0 ? az + 360 : az, far_m = distance_m / cos(az * ORR_RAD_PER_DEG);
            if (far_m > 1.09 * distance_m) continue;
            ASSERT_NEAR(orr_horizon_at(&h, turned * ORR_RAD_PER_DEG), seen_rad(far_m, 600, along_m()), 3e-4);
        }
        // To the South a level Earth, seen from 2 m: its horizon is 0.045 deg below, 5 km away.
        ASSERT_NEAR(orr_horizon_at(&h, ORR_PI), -sqrt(2 * 2 / along_m()), 1e-4);
    }
}

// A cone due East: its summit, its silhouette, which is the line from the summit to where a tangent plane touches its foot, and
// nothing beside it.
static void a_cone_has_its_silhouette(void **state)
{
    (void)state;
    static orr_horizon h;
    const double step_m = 25, high_m = 800, foot_m = 1000;
    const orr_esri_grid g = level(step_m / along_m() * ORR_DEG_PER_RAD,
                                  step_m / (across_m() * cos(place.lat_rad)) * ORR_DEG_PER_RAD);
    const double distance_m = 80 * step_m;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            const double r = step_m * hypot(j - MIDDLE - 80, i - MIDDLE);
            height[i][j] = (float)(102 + fmax(high_m * (1 - r / foot_m), -2));
        }
    horizon_of(&g, 2900, false, &h);
    // A parallel bends away from due East: the summit is 2e-4 rad beside it, where the silhouette falls by 0.7 of that.
    ASSERT_NEAR(orr_horizon_at(&h, ORR_PI / 2), seen_rad(distance_m, 102 + high_m, across_m()), 2e-4);
    const double half = asin(foot_m / distance_m); // of the foot, as it is seen
    for (double part = 0.1; part < 0.95; part += 0.05) {
        // From the summit (distance, 0, high) to the tangent point of the foot's circle.
        const double az = part * half, tx = distance_m - foot_m * sin(half), ty = foot_m * cos(half);
        const double s = distance_m * tan(az) / (ty - (tx - distance_m) * tan(az));
        const double x = distance_m + s * (tx - distance_m), y = s * ty, z = high_m * (1 - s);
        const double el = atan2(z, hypot(x, y));
        // Chords of the mesh lie inside the cone: a few metres of 800.
        ASSERT_NEAR(orr_horizon_at(&h, ORR_PI / 2 + az), el, 0.004);
        ASSERT_NEAR(orr_horizon_at(&h, ORR_PI / 2 - az), el, 0.004);
    }
    assert_true(fabs(orr_horizon_at(&h, ORR_PI / 2 + 1.05 * half)) < 2e-3);
    assert_true(fabs(orr_horizon_at(&h, 3 * ORR_PI / 2)) < 2e-3);
}

// Over level ground bent rays of radio waves come from 0.65 deg below the horizon; high up nothing changes.
static void refraction_lowers_the_horizon(void **state)
{
    (void)state;
    static orr_horizon straight, bent;
    const orr_esri_grid g = level(0.0005, 0.0008);
    for (size_t j = 0; j < SIDE; j++) height[MIDDLE - 20][j] = 3000;
    horizon_of(&g, 5000, false, &straight);
    horizon_of(&g, 5000, true, &bent);
    const double level_deg =
        ORR_DEG_PER_RAD * (orr_horizon_at(&bent, ORR_PI) - orr_horizon_at(&straight, ORR_PI));
    ASSERT_NEAR(level_deg, -0.65, 0.03);
    const double steep = orr_horizon_at(&straight, 0); // 68 deg
    assert_true(steep > 1.1);
    ASSERT_NEAR(orr_horizon_at(&bent, 0), steep, 3e-4);
}

// The file of a ridge 2 km to the North: 8 arc seconds a cell.
static void write_ridge(double ridge_m)
{
    FILE *f = fopen(RIDGE_FILE, "w");
    assert_non_null(f);
    fprintf(f, "ncols 61\nnrows 61\nxllcorner %.9f\nyllcorner %.9f\ncellsize 0.002\nNODATA_value -9999\n",
            17 - 30.5 * 0.002, 52 - 30.5 * 0.002);
    for (int i = 0; i < 61; i++)
        for (int j = 0; j < 61; j++) fprintf(f, "%g%c", i == 21 ? ridge_m : 84.0, j < 60 ? ' ' : '\n');
    assert_int_equal(fclose(f), 0);
}

static void satellites_below_it_have_no_channel(void **state)
{
    (void)state;
    static orr_channel open[ROOM], hidden[ROOM];
    const double reach_m = 9 * 0.002 * ORR_RAD_PER_DEG * along_m();
    size_t behind = 0, above = 0;
    write_ridge(1000);
    for (int k = 0; k < 12; k++) {
        const orr_time t = at(300 + 1500 * k);
        open_with(SKY);
        const size_t n = all_at(t, 0, open);
        tear_down(NULL);
        open_with(SKY "obstacles: {terrain: {file: " RIDGE_FILE ", undulation: 38, range: 4000}}\n");
        const size_t m = all_at(t, 0, hidden);
        tear_down(NULL);
        for (size_t i = 0, j = 0; i < n; i++) {
            const bool there = j < m && hidden[j].sat == open[i].sat && hidden[j].signal == open[i].signal;
            if (there) j++;
            const double north = cos(open[i].az_rad), el = open[i].el_rad;
            const double crest = north > 0.7 ? seen_rad(reach_m / north, 1038, along_m()) : 0;
            if (north > 0.7 && el < crest - 0.01 && el > 0.01) {
                assert_false(there);
                behind++;
            } else if (el > 0.5) {
                assert_true(there);
                above++;
            }
            if (el < -0.01) assert_false(there); // level ground hides as well
        }
    }
    assert_true(behind > 3 && above > 30);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    write_ridge(1000);
    refused_with("signals: [G]\nantennas: [{name: FAR, position: [53, 17, 124]}]\nobstacles: {terrain: "
                 "{file: " RIDGE_FILE "}}\n",
                 "no height of the terrain at 53.0000 17.0000");
    refused_with(SKY "obstacles: {terrain: {file: " RIDGE_FILE ", undulation: 110}}\n",
                 "70 m below the terrain");
    refused_with(SKY "obstacles: {terrain: {range: 4000}}\n", "file");
    orr_esri_grid g;
    static const struct {
        const char *text, *words;
    } wrong[] = {
        {"ncols 2\nnrows 2\nxllcorner 500000\nyllcorner 5760000\ncellsize 30\n1 2 3 4\n", "no degrees"},
        {"ncols 2\nnrows 2\nxllcorner 17\nyllcorner 52\ncellsize 1\n1 2 3\n", "ends after 3"},
        {"ncols 2\nnrows 2\nxllcorner 17\nyllcorner 52\ncellsize 1\n1 2 3 4 5\n", "more than 2 x 2"},
        {"ncols 2\nnrows 2\nxllcorner 17\ncellsize 1\n1 2 3 4\n", "no yllcorner"},
        {"ncols 2\nnrows 2\nxllcorner 17\nyllcorner 52\ncellsize 1\n1 2 x 4\n", "'x' is no height"},
        {"ncols 90000\nnrows 1000\nxllcorner 17\nyllcorner 52\ncellsize 1e-4\n1\n", "too short"},
        {"ncols 2\nnrows 2\ncolour 17\n", "'colour' is no key"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        orr_diag diag = {0};
        assert_int_not_equal(orr_esri_grid_parse("f", wrong[k].text, strlen(wrong[k].text), NULL, &g, &diag),
                             ORR_OK);
        if (strstr(diag.text, wrong[k].words) == NULL)
            fail_msg("'%s' has not '%s'", diag.text, wrong[k].words);
    }
    // Centres and corners tell the same place, rows run from the North.
    static const char good[] =
        "NCOLS 2\nNROWS 3\nXLLCENTER 17\nYLLCENTER 52\nDX 0.5\nDY 0.25\nnodata_value -1\n1 2\n3 -1\n5 6\n";
    orr_diag diag = {0};
    ASSERT_OK(orr_esri_grid_parse("f", good, sizeof good - 1, NULL, &g, &diag), diag);
    ASSERT_NEAR(g.west_deg, 17, 1e-12);
    ASSERT_NEAR(g.north_deg, 52.5, 1e-12);
    ASSERT_NEAR((double)g.height_m[1], 2, 0);
    assert_true(isnan(g.height_m[3]));
    orr_esri_grid_free(&g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ridge_has_its_elevation),
        cmocka_unit_test(a_cone_has_its_silhouette),
        cmocka_unit_test(refraction_lowers_the_horizon),
        cmocka_unit_test_teardown(satellites_below_it_have_no_channel, tear_down),
        cmocka_unit_test_teardown(what_cannot_be_is_refused, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
