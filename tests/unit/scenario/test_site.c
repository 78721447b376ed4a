// SPDX-License-Identifier: GPL-3.0-or-later
// Tides of the ground against published values and closed forms, and as terms of channels.
#include <unistd.h>

#include "core/constants.h"
#include "src/scenario/effect/ocean_loading.h"
#include "src/scenario/effect/solid_tide.h"
#include "testing.h"
#include "unit/orbit/made_orbit.h"
#include "unit/scenario/made_channels.h"

#define SKY "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: BASE, position: [52, 17, 124]}]\n"

// The test cases that the IERS Conventions Centre publishes with DEHANTTIDEINEL.
static void the_solid_tide_is_the_published_one(void **state)
{
    (void)state;
    static const struct {
        orr_vec3 station, sun, moon, tide;
        double jd, tt_s; // 0 h UTC, and TT - UTC
    } published[] = {
        {{4075578.385, 931852.890, 4801570.154},
         {137859926952.015, 54228127881.4350, 23509422341.6960},
         {-179996231.920342, -312468450.131567, -169288918.592160},
         {0.07700420357108125891, 0.06304056321824967613, 0.05516568152597246810},
         2454934.5,
         66.184},
        {{1112189.660, -4842955.026, 3985352.284},
         {-54537460436.2357, 130244288385.279, 56463429031.5996},
         {300396716.912, 243238281.451, 120548075.939},
         {-0.02036831479592075833, 0.05658254776225972449, -0.07597679676871742227},
         2456121.5,
         67.184},
        {{1112200.5696, -4842957.8511, 3985345.9122},
         {100210282451.6279, 103055630398.3160, 56855096480.4475},
         {369817604.4348, 1897917.5258, 120804980.8284},
         {0.00509570869172363845, 0.0828663025983528700, -0.0636634925404189617},
         2457218.5,
         68.184},
    };
    for (size_t k = 0; k < sizeof published / sizeof *published; k++) {
        const double century = (published[k].jd - 2451545 + published[k].tt_s / 86400) / 36525;
        const orr_vec3 d =
            orr_solid_tide_m(published[k].station, published[k].sun, published[k].moon, 0, century);
        ASSERT_NEAR(orr_vec3_norm(orr_vec3_sub(d, published[k].tide)), 0, 2e-9);
    }
}

static void the_pole_tide_has_its_closed_form(void **state)
{
    (void)state;
    const double arcsec = ORR_RAD_PER_DEG / 3600;
    const orr_eop secular = {.xp_rad = 0.1 * arcsec, .yp_rad = 0.3 * arcsec};
    orr_eop eop = {.xp_rad = 0.6 * arcsec, .yp_rad = 0.3 * arcsec};
    const double r = 6371e3, h = sqrt(0.5);
    orr_vec3 d =
        orr_pole_tide_m((orr_vec3){r * h, 0, r * h}, &eop, &secular); // 45 N, 0 E: 33 mm per arcsecond of m1
    ASSERT_NEAR(d.x, -0.0165 * h, 1e-12);
    ASSERT_NEAR(d.z, -0.0165 * h, 1e-12);
    ASSERT_NEAR(d.y, 0, 1e-15);
    eop = (orr_eop){.xp_rad = secular.xp_rad, .yp_rad = 0.8 * arcsec}; // m2 is -0.5 arcseconds: to the East
    d = orr_pole_tide_m((orr_vec3){r * h, 0, r * h}, &eop, &secular);
    ASSERT_NEAR(d.y, 9e-3 * 0.5 * h, 1e-12);
    ASSERT_NEAR(d.x, 0, 1e-15);
    eop = (orr_eop){.xp_rad = 0.6 * arcsec, .yp_rad = secular.yp_rad};
    d = orr_pole_tide_m((orr_vec3){r, 0, 0}, &eop, &secular); // at the Equator to the South by 9 mm
    ASSERT_NEAR(d.z, -9e-3 * 0.5, 1e-12);
    eop = secular;
    ASSERT_NEAR(orr_vec3_norm(orr_pole_tide_m((orr_vec3){r * h, 0, r * h}, &eop, &secular)), 0, 0);
}

static void channels_see_the_ground_move(void **state)
{
    (void)state;
    open_with(SKY "site: {solid_tide: yes, pole_tide: yes}\n");
    orr_channel x[ROOM];
    double most = 0, before = 0, after = 0;
    for (int k = 0; k < 20; k++) {
        const size_t n = all_at(at(600 + 900 * k), 0, x);
        assert_true(n > 0);
        for (size_t j = 0; j < n; j++) {
            const double d = x[j].term_m[ORR_TERM_SOLID_TIDE];
            most = fmax(most, fabs(d));
            assert_true(x[j].term_m[ORR_TERM_POLE_TIDE] ==
                        0); // these orbits know no pole but the secular one
        }
    }
    assert_in_range((int)(1000 * most), 50, 450); // mm
    before = one_at(at(4999), "G01", "L1CA").term_m[ORR_TERM_SOLID_TIDE];
    after = one_at(at(5001), "G01", "L1CA").term_m[ORR_TERM_SOLID_TIDE];
    ASSERT_NEAR(one_at(at(5000), "G01", "L1CA").rate_mps[ORR_TERM_SOLID_TIDE], (after - before) / 2, 1e-8);
    tear_down(NULL);
    open_with(SKY);
    assert_true(one_at(at(5000), "G01", "L1CA").term_m[ORR_TERM_SOLID_TIDE] == 0);
}

// Two stations as the IERS publish them with HARDISP (CSR4.0), and what that makes of 24 hours from 2009-06-25 01:10:45 UTC: up, South,
// West, mm.
static const char HARDISP_BLQ[] =
    "$$ Ocean loading displacement\n$$\n"
    "  ONSALA\n"
    "  .00352 .00123 .00080 .00032 .00187 .00112 .00063 .00003 .00082 .00044 .00037\n"
    "  .00144 .00035 .00035 .00008 .00053 .00049 .00018 .00009 .00012 .00005 .00006\n"
    "  .00086 .00023 .00023 .00006 .00029 .00028 .00010 .00007 .00004 .00002 .00001\n"
    "  -64.7 -52.0 -96.2 -55.2 -58.8 -151.4 -65.6 -138.1 8.4 5.2 2.1\n"
    "  85.5 114.5 56.5 113.6 99.4 19.1 94.1 -10.4 -167.4 -170.0 -177.7\n"
    "  109.5 147.0 92.7 148.8 50.5 -55.1 36.4 -170.4 -15.0 2.3 5.2\n"
    "  REYKJAVIK\n"
    "  .02359 .01481 .00448 .00419 .00273 .00033 .00088 .00005 .00081 .00034 .00034\n"
    "  .00514 .00280 .00089 .00078 .00106 .00074 .00035 .00018 .00004 .00001 .00003\n"
    "  .00209 .00077 .00051 .00021 .00151 .00066 .00047 .00019 .00014 .00008 .00006\n"
    "  78.5 102.3 76.3 104.1 -52.0 -160.4 -52.6 -128.0 -174.8 -175.7 -178.1\n"
    "  54.2 93.8 38.9 96.9 2.3 -12.5 3.1 -31.6 -144.4 -122.6 -173.5\n"
    "  156.2 -167.1 141.9 -164.9 155.9 178.7 155.6 -168.5 177.7 178.7 179.7\n";
static const double HARDISP_MM[2][24][3] = {
    {{3.094, -1.538, -0.895}, {1.812, -0.950, -0.193},  {0.218, -0.248, 0.421},  {-1.104, 0.404, 0.741},
     {-1.668, 0.863, 0.646},  {-1.209, 1.042, 0.137},   {0.235, 0.926, -0.667},  {2.337, 0.580, -1.555},
     {4.554, 0.125, -2.278},  {6.271, -0.291, -2.615},  {6.955, -0.537, -2.430}, {6.299, -0.526, -1.706},
     {4.305, -0.244, -0.559}, {1.294, 0.245, 0.793},    {-2.163, 0.819, 2.075},  {-5.375, 1.326, 3.024},
     {-7.695, 1.622, 3.448},  {-8.669, 1.610, 3.272},   {-8.143, 1.262, 2.557},  {-6.290, 0.633, 1.477},
     {-3.566, -0.155, 0.282}, {-0.593, -0.941, -0.766}, {1.992, -1.561, -1.457}, {3.689, -1.889, -1.680}},
    {{-5.940, -1.245, -0.278},  {13.516, -1.086, 3.212},   {29.599, -0.353, 5.483},
     {38.468, 0.699, 5.997},    {38.098, 1.721, 4.690},    {28.780, 2.363, 1.974},
     {13.016, 2.371, -1.369},   {-5.124, 1.653, -4.390},   {-21.047, 0.310, -6.225},
     {-30.799, -1.383, -6.313}, {-32.056, -3.048, -4.549}, {-24.698, -4.288, -1.314},
     {-10.814, -4.794, 2.623},  {5.849, -4.416, 6.291},    {20.857, -3.208, 8.766},
     {30.226, -1.413, 9.402},   {31.437, 0.594, 7.996},    {24.079, 2.389, 4.844},
     {9.945, 3.606, 0.663},     {-7.426, 4.022, -3.581},   {-23.652, 3.601, -6.911},
     {-34.618, 2.505, -8.585},  {-37.515, 1.044, -8.270},  {-31.544, -0.402, -6.125}}};
#define BLQ ORR_BINARY_DIR "/" ORR_TEST_NAME ".blq"

static void write_blq(const char *text)
{
    FILE *f = fopen(BLQ, "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
}

static void ocean_loading_is_the_published_one(void **state)
{
    (void)state;
    static const char *const station[2] = {"Onsala", "REYKJAVIK"};
    static orr_ocean_loading o;
    orr_blq blq;
    orr_diag diag = {0};
    orr_time t;
    write_blq(HARDISP_BLQ);
    ASSERT_OK(orr_time_parse("2009-06-25T01:11:00", NULL, &t, &diag), diag); // 01:10:45 UTC
    for (size_t i = 0; i < 2; i++) {
        ASSERT_OK(orr_blq_read(BLQ, station[i], &blq, &diag), diag);
        ASSERT_OK(orr_ocean_loading_of(&blq, &o, &diag), diag);
        for (size_t k = 0; k < 24; k++) {
            const orr_vec3 d = orr_ocean_loading_m(&o, t + (int64_t)k * 3600 * ORR_NS_PER_S);
            const double *want = HARDISP_MM[i][k];
            ASSERT_NEAR(1e3 * d.z, want[0], 0.01);
            ASSERT_NEAR(-1e3 * d.y, want[1], 0.01);
            ASSERT_NEAR(-1e3 * d.x, want[2], 0.01);
        }
    }
    assert_int_equal(orr_blq_read(BLQ, "BOR1", &blq, &diag), ORR_E_NODATA);
    assert_non_null(strstr(diag.text, "no ocean loading of 'BOR1': the file has ONSALA"));
    write_blq("  ONSALA\n  .00352 .00123 .00080\n");
    assert_int_equal(orr_blq_read(BLQ, "ONSALA", &blq, &diag), ORR_E_FORMAT);
    assert_int_equal(diag.line, 2);
}

static void channels_have_the_ocean(void **state)
{
    (void)state;
    write_blq(HARDISP_BLQ);
    open_with(
        "signals: [G, E]\nmask: {elevation: -10}\nantennas: [{name: ONSALA, position: [57.4, 11.9, 46]}]\n"
        "site: {ocean_loading: " BLQ "}\n");
    const orr_channel x = one_at(at(5000), "G01", "L1CA");
    assert_true(x.term_m[ORR_TERM_OCEAN_LOADING] != 0 && fabs(x.term_m[ORR_TERM_OCEAN_LOADING]) < 0.015);
    tear_down(NULL);
    refused_with(SKY "site: {ocean_loading: " BLQ "}\n", "no ocean loading of 'BASE'");
    unlink(BLQ);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_solid_tide_is_the_published_one),
        cmocka_unit_test(the_pole_tide_has_its_closed_form),
        cmocka_unit_test_teardown(channels_see_the_ground_move, tear_down),
        cmocka_unit_test(ocean_loading_is_the_published_one),
        cmocka_unit_test_teardown(channels_have_the_ocean, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
