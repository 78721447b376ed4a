// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/site.h"

#include "src/scenario/effect/solid_tide.h"

static orr_vec3 solid_m(const orr_eop *eop, orr_vec3 r_m, orr_vec3 sun_m, orr_time t)
{
    orr_mat3 R;
    int32_t utc, tt;
    double day, tt_day;
    orr_astro_gcrs_to_itrs(t, eop, NULL, &R, NULL);
    orr_time_mjd(t, ORR_SCALE_UTC, NULL, &utc, &day);
    orr_time_mjd(t, ORR_SCALE_TT, NULL, &tt, &tt_day);
    const double century = (tt - 51544.5 + tt_day) / 36525;
    return orr_solid_tide_m(r_m, sun_m, orr_mat3_apply(&R, orr_astro_moon(t)), 24 * day, century);
}

orr_site_moved orr_site_at(const orr_scenario_site *o, const orr_eop_series *eop,
                           const orr_ocean_loading *ocean, orr_vec3 r_m, const orr_mat3 *enu, orr_vec3 sun_m,
                           orr_time t)
{
    orr_site_moved out = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    if (ocean != NULL) out.ocean_m = orr_mat3_apply_t(enu, orr_ocean_loading_m(ocean, t));
    if (!o->solid_tide && !o->pole_tide) return out;
    const orr_eop now = orr_eop_at(eop, t, NULL, NULL);
    if (o->solid_tide) out.solid_m = solid_m(&now, r_m, sun_m, t);
    if (o->pole_tide) {
        const orr_eop secular = orr_eop_at(NULL, t, NULL, NULL);
        out.pole_m = orr_pole_tide_m(r_m, &now, &secular);
    }
    return out;
}
