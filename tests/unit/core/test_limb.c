// SPDX-License-Identifier: GPL-3.0-or-later
// What the Earth hides, against tangents to circle and ellipse in closed form.
#include "core/limb.h"

#include <math.h>

#include "core/constants.h"
#include "core/earth.h"
#include "testing.h"

// In the equator's plane the Earth is a circle: from a height H the limb of height h lies acos((a + h)/(a + H)) below the level.
static void the_limb_of_the_equator_is_a_circles(void **state)
{
    (void)state;
    for (double H = 400e3; H < 4e7; H *= 3)
        for (double h = 0; h <= ORR_SPACE_HEIGHT_M; h += 50e3) {
            const double dip = acos((ORR_WGS84_A_M + h) / (ORR_WGS84_A_M + H));
            const orr_vec3 r = {0, -(ORR_WGS84_A_M + H), 0};
            for (int side = -1; side <= 1; side += 2) {
                const double d = dip + side * 1e-9; // of which a metre at the limb of the highest is 2e-8
                const orr_vec3 far = {r.x + 9e7 * cos(d), r.y + 9e7 * sin(d), 0};
                assert_int_equal(orr_limb_hides(r, far, h), side > 0);
                assert_int_equal(orr_limb_hides(far, r, h), side > 0); // the way back is the same
            }
            const double before = 0.99 * sqrt(pow(ORR_WGS84_A_M + H, 2) - pow(ORR_WGS84_A_M + h, 2));
            const orr_vec3 near = {r.x + before * cos(dip + 1e-6), r.y + before * sin(dip + 1e-6), 0};
            assert_false(orr_limb_hides(r, near, h)); // what stands before the limb
            const orr_vec3 up = {0, 5 * r.y, 0};
            assert_false(orr_limb_hides(r, up, h));
            assert_true(orr_limb_hides(r, orr_vec3_scale(-5, r), h));
        }
}

// The tangent from above the pole touches the ellipse x^2/A^2 + z^2/B^2 = 1 at z = B^2/z0.
static void the_limb_of_the_pole_is_an_ellipses(void **state)
{
    (void)state;
    const double A = ORR_WGS84_A_M, B = A * (1 - ORR_WGS84_F);
    for (double H = 400e3; H < 4e7; H *= 3) {
        const double z0 = B + H, z = B * B / z0, x = A * sqrt(1 - z * z / (B * B));
        for (int side = -1; side <= 1; side += 2) {
            const orr_vec3 r = {0, 0, z0}, far = {3 * x, 0, z0 + 3 * (z - z0) - side * 1e-2};
            assert_int_equal(orr_limb_hides(r, far, 0),
                             side > 0); // a centimetre under the tangent or above it
        }
    }
}

static void space_begins_at_its_height_everywhere(void **state)
{
    (void)state;
    for (double lat = -ORR_PI / 2; lat <= ORR_PI / 2; lat += ORR_PI / 36)
        for (int side = -1; side <= 1; side += 2) {
            const orr_geodetic g = {lat, 1, ORR_SPACE_HEIGHT_M + side * 10};
            assert_int_equal(orr_limb_in_space(orr_earth_to_ecef(g)), side > 0);
        }
    assert_false(orr_limb_in_space((orr_vec3){0, 0, 0}));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_limb_of_the_equator_is_a_circles),
                                       cmocka_unit_test(the_limb_of_the_pole_is_an_ellipses),
                                       cmocka_unit_test(space_begins_at_its_height_everywhere)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
