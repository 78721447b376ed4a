// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/troposphere.h"

#include <math.h>

static const double TOP_M = 100e3;

static orr_zenith_delay zenith(const orr_scenario_troposphere *s, orr_geodetic place, orr_time t)
{
    const double h = place.height_m, lat = place.lat_rad;
    switch (s->model) {
    case ORR_TROPOSPHERE_SAASTAMOINEN:
        return orr_zenith_saastamoinen(orr_weather_standard(h, s->humidity), lat, h);
    case ORR_TROPOSPHERE_DO229:
        return orr_zenith_do229(lat, h, t);
    case ORR_TROPOSPHERE_STANAG4294:
        return orr_zenith_stanag4294(h);
    default:
        return (orr_zenith_delay){0, 0};
    }
}

orr_troposphere_site orr_troposphere_at(const orr_scenario_troposphere *s, orr_geodetic place, orr_time t)
{
    orr_troposphere_site out = {.model = s->model, .mapping = s->mapping};
    if (place.height_m > TOP_M) {
        out.model = ORR_TROPOSPHERE_NONE;
        return out;
    }
    out.zenith = zenith(s, place, t);
    if (s->mapping == ORR_TROPO_MAPPING_NIELL)
        orr_mapping_niell_at(place.lat_rad, place.height_m, t, &out.hydrostatic, &out.wet);
    if (s->mapping == ORR_TROPO_MAPPING_GMF) orr_mapping_gmf_at(place, t, &out.hydrostatic, &out.wet);
    return out;
}

// Mapping functions are not made for less than 0.5 deg. From 1 deg down to the horizon the elevation bends towards that, without
// a corner.
static double held_rad(double el_rad)
{
    const double least = 0.5 * ORR_RAD_PER_DEG;
    if (el_rad >= 2 * least) return el_rad;
    return least + fmax(el_rad, 0) * fmax(el_rad, 0) / (4 * least);
}

// The model's own mapping.
static double own(int model, double el_rad)
{
    switch (model) {
    case ORR_TROPOSPHERE_SAASTAMOINEN:
        return orr_mapping_cosecant(el_rad);
    case ORR_TROPOSPHERE_DO229:
        return orr_mapping_black_eisner(el_rad);
    default:
        return orr_mapping_chao(el_rad);
    }
}

orr_zenith_delay orr_troposphere_slant(const orr_troposphere_site *site, double el_rad)
{
    const double el = held_rad(el_rad);
    if (site->model == ORR_TROPOSPHERE_NONE) return (orr_zenith_delay){0, 0};
    if (site->mapping == ORR_TROPO_MAPPING_OWN) {
        const double m = own(site->model, el);
        return (orr_zenith_delay){m * site->zenith.hydrostatic_m, m * site->zenith.wet_m};
    }
    return (orr_zenith_delay){orr_mapping_fraction(&site->hydrostatic, el) * site->zenith.hydrostatic_m,
                              orr_mapping_fraction(&site->wet, el) * site->zenith.wet_m};
}
