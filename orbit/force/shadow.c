// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/shadow.h"

double orr_force_limb_distance(orr_vec3 r, orr_vec3 sun)
{
    if (orr_vec3_dot(r, sun) >= 0) return HUGE_VAL; // the day side
    orr_vec3 d = orr_vec3_sub(sun, r);
    double dn = orr_vec3_norm(d), rn = orr_vec3_norm(r);
    double cosine = -orr_vec3_dot(r, d) / (dn * rn);
    double separation = acos(cosine < 1.0 ? cosine : 1.0);
    return (separation - asin(ORR_SHADOW_RADIUS_M / rn)) / asin(ORR_SUN_RADIUS_M / dn);
}

double orr_force_sunlight(orr_vec3 r, orr_vec3 sun)
{
    double x = orr_force_limb_distance(r, sun);
    if (x >= 1) return 1.0;
    if (x <= -1) return 0.0;
    return 0.5 + (x * sqrt(1 - x * x) + asin(x)) / ORR_PI;
}

double orr_force_sunlight_fast(orr_vec3 r, orr_vec3 sun)
{
    // The penumbra reaches 0.5 deg of the satellite's distance beyond the shadow's cylinder at most.
    const double along = orr_vec3_dot(r, sun), s2 = orr_vec3_dot(sun, sun), r2 = orr_vec3_dot(r, r);
    const double edge = ORR_SHADOW_RADIUS_M + 0.01 * sqrt(r2);
    if (along >= 0 || r2 - along * along / s2 > edge * edge) return 1.0;
    return orr_force_sunlight(r, sun);
}
