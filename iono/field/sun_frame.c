// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/field/sun_frame.h"

#include <math.h>

double orr_mean_sun_lon(orr_time t, const orr_leap_table *leap)
{
    // UTC as a plain count of 86400 s days: across a leap second UT holds its pace to a second, 15" of
    // longitude.
    int64_t utc = t - (int64_t)(orr_leap_tai_minus_utc(t, leap) - 19) * ORR_NS_PER_S;
    int64_t day = (int64_t)ORR_S_PER_DAY * ORR_NS_PER_S, rest = utc % day;
    if (rest < 0) rest += day;
    double lon = ORR_PI - 2 * ORR_PI * ((double)rest / (double)day);
    return lon >= ORR_PI ? -ORR_PI : lon; // 0h: the antimeridian
}

orr_mat3 orr_geomagnetic_axes(double pole_lat_rad, double pole_lon_rad)
{
    double sp = sin(pole_lat_rad), cp = cos(pole_lat_rad), sl = sin(pole_lon_rad), cl = cos(pole_lon_rad);
    return (orr_mat3){{{sp * cl, sp * sl, -cp}, {-sl, cl, 0}, {cp * cl, cp * sl, sp}}};
}

double orr_geomagnetic_lon_of_equator(const orr_mat3 *geomagnetic, double lon_rad)
{
    orr_vec3 v = orr_mat3_apply(geomagnetic, (orr_vec3){cos(lon_rad), sin(lon_rad), 0});
    return atan2(v.y, v.x);
}

orr_mat3 orr_axes_turned(const orr_mat3 *axes, double from_rad)
{
    double c = cos(from_rad), s = sin(from_rad);
    orr_mat3 out = *axes;
    for (int j = 0; j < 3; j++) {
        out.m[0][j] = c * axes->m[0][j] + s * axes->m[1][j];
        out.m[1][j] = c * axes->m[1][j] - s * axes->m[0][j];
    }
    return out;
}
