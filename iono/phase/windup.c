// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/phase/windup.h"

#include <math.h>

double orr_windup_axes(const orr_iono_site *site, orr_vec3 sat_m, orr_vec3 sat_x, orr_vec3 sat_y,
                       double before)
{
    orr_vec3 k = orr_vec3_unit(orr_vec3_sub(site->pos_m, sat_m)); // from the satellite to the receiver
    orr_vec3 rx = site->north, ry = orr_vec3_scale(-1, site->east);
    // Effective dipoles (Wu et al. 1993, eqs. (23), (24)): D' = x' - k (k.x') - k x y', D = x - k (k.x) + k x
    // y.
    orr_vec3 ds = orr_vec3_sub(orr_vec3_axpy(-orr_vec3_dot(k, sat_x), k, sat_x), orr_vec3_cross(k, sat_y));
    orr_vec3 dr = orr_vec3_add(orr_vec3_axpy(-orr_vec3_dot(k, rx), k, rx), orr_vec3_cross(k, ry));
    // The angle between them about k; atan2 keeps its precision near 0 and half a turn, where acos loses it.
    double c = orr_vec3_dot(ds, dr), s = orr_vec3_dot(k, orr_vec3_cross(ds, dr));
    double turns = atan2(s, c) / (2 * ORR_PI);
    return turns + floor(before - turns + 0.5);
}

double orr_windup_turns(const orr_iono_site *site, orr_vec3 sat_m, orr_vec3 sun_m, double before)
{
    orr_vec3 z = orr_vec3_scale(-1, orr_vec3_unit(sat_m));
    orr_vec3 y = orr_vec3_unit(orr_vec3_cross(z, orr_vec3_unit(orr_vec3_sub(sun_m, sat_m))));
    return orr_windup_axes(site, sat_m, orr_vec3_cross(y, z), y, before);
}
