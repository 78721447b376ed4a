// SPDX-License-Identifier: GPL-3.0-or-later
#include "inertial/motion/local_map.h"

#include <math.h>

orr_local_map orr_local_map_make(orr_geodetic origin)
{
    orr_local_map m = {.A0 = orr_earth_enu_from_ecef(origin.lat_rad, origin.lon_rad),
                       .height_m = origin.height_m};
    double M, N;
    orr_earth_radii(origin.lat_rad, &M, &N);
    m.east_m = N + origin.height_m;
    m.north_m = M + origin.height_m;
    return m;
}

void orr_local_map_series(double s, double *C, double *S, double *S1, double *S2)
{
    // sum (-s)^k / (2k)! and / (2k+1)!; by k = 20 the terms are below 1e-17 for s <= 10.
    double even = 1.0, odd = 1.0, power = 1.0, power1 = 0.0, power2 = 0.0;
    *C = *S = 1.0;
    *S1 = *S2 = 0.0;
    for (int k = 1; k <= 20; k++) {
        power2 = -(power2 * s) - 2.0 * power1; // derivatives of (-s)^k by the product rule
        power1 = -(power1 * s) - power;
        power = -power * s;
        even *= (2.0 * k - 1.0) * 2.0 * k;
        odd *= 2.0 * k * (2.0 * k + 1.0);
        *C += power / even;
        *S += power / odd;
        *S1 += power1 / odd;
        *S2 += power2 / odd;
    }
}

orr_vec3 orr_local_map_to_ecef(const orr_local_map *m, orr_vec3 enu_m)
{
    double x = enu_m.x / m->east_m, y = enu_m.y / m->north_m, C, S, S1, S2;
    orr_local_map_series(x * x + y * y, &C, &S, &S1, &S2);
    orr_vec3 n = orr_mat3_apply_t(&m->A0, orr_vec3_make(S * x, S * y, C));
    double N = ORR_WGS84_A_M / sqrt(1.0 - ORR_WGS84_E2 * n.z * n.z), h = m->height_m + enu_m.z;
    return orr_vec3_make((N + h) * n.x, (N + h) * n.y, (N * (1.0 - ORR_WGS84_E2) + h) * n.z);
}

orr_vec3 orr_local_map_from_ecef(const orr_local_map *m, orr_vec3 r_m)
{
    orr_geodetic g = orr_earth_from_ecef(r_m);
    double c = cos(g.lat_rad);
    orr_vec3 n =
        orr_mat3_apply(&m->A0, orr_vec3_make(c * cos(g.lon_rad), c * sin(g.lon_rad), sin(g.lat_rad)));
    double across = hypot(n.x, n.y), k = across > 1e-9 ? atan2(across, n.z) / across : 1.0;
    return orr_vec3_make(k * n.x * m->east_m, k * n.y * m->north_m, g.height_m - m->height_m);
}
