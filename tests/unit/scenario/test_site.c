// SPDX-License-Identifier: GPL-3.0-or-later
// Tides of the ground against published values and closed forms, and as terms of channels.
#include "core/constants.h"
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_solid_tide_is_the_published_one),
        cmocka_unit_test(the_pole_tide_has_its_closed_form),
        cmocka_unit_test_teardown(channels_see_the_ground_move, tear_down),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
