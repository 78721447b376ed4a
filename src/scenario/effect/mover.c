// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/mover.h"

#include "core/constants.h"

orr_mover orr_mover_of(const orr_real_list *position, const orr_real_list *velocity_mps, orr_time from)
{
    const double *p = position->item;
    const orr_geodetic place = {p[0] * ORR_RAD_PER_DEG, p[1] * ORR_RAD_PER_DEG, p[2]};
    orr_mover m = {.r_m = orr_earth_to_ecef(place), .v_mps = {0, 0, 0}, .from = from};
    if (velocity_mps->n == 0) return m;
    const orr_mat3 enu = orr_earth_enu_from_ecef(place.lat_rad, place.lon_rad);
    const double *v = velocity_mps->item;
    m.v_mps = orr_mat3_apply_t(&enu, (orr_vec3){v[0], v[1], v[2]});
    return m;
}
