// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limb.h"

#include "core/constants.h"

// Scaled so that the ellipsoid of that height is the unit sphere: straight lines stay straight.
static orr_vec3 scaled(orr_vec3 r_m, double height_m)
{
    const double a = ORR_WGS84_A_M + height_m, b = ORR_WGS84_A_M * (1 - ORR_WGS84_F) + height_m;
    return (orr_vec3){r_m.x / a, r_m.y / a, r_m.z / b};
}

bool orr_limb_in_space(orr_vec3 r_m)
{
    const orr_vec3 p = scaled(r_m, ORR_SPACE_HEIGHT_M);
    return orr_vec3_dot(p, p) > 1;
}

bool orr_limb_hides(orr_vec3 r_m, orr_vec3 target_m, double height_m)
{
    const orr_vec3 p = scaled(r_m, height_m), d = orr_vec3_sub(scaled(target_m, height_m), p);
    const double along = -orr_vec3_dot(p, d) / orr_vec3_dot(d, d); // of the point nearest to the centre
    if (!(along > 0)) return false;
    const orr_vec3 nearest = orr_vec3_axpy(along < 1 ? along : 1, d, p);
    return orr_vec3_dot(nearest, nearest) < 1;
}
