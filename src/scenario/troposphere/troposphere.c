// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/troposphere/troposphere.h"

#include <math.h>

static const double LOWEST_RAD = 0.5 * ORR_RAD_PER_DEG; // mapping functions are not made for less
static const double TOP_M = 100e3;

orr_zenith_delay orr_troposphere_delay(const orr_scenario_troposphere *s, orr_geodetic place, double el_rad,
                                       orr_time t)
{
    const double h = place.height_m, lat = place.lat_rad, el = fmax(el_rad, LOWEST_RAD);
    orr_zenith_delay z = {0, 0};
    double own = 1; // the model's own mapping
    if (h > TOP_M) return z;
    switch (s->model) {
    case ORR_TROPOSPHERE_SAASTAMOINEN:
        z = orr_zenith_saastamoinen(orr_weather_standard(h, s->humidity), lat, h);
        own = orr_mapping_cosecant(el);
        break;
    case ORR_TROPOSPHERE_DO229:
        z = orr_zenith_do229(lat, h, t);
        own = orr_mapping_black_eisner(el);
        break;
    case ORR_TROPOSPHERE_STANAG4294:
        z = orr_zenith_stanag4294(h);
        own = orr_mapping_chao(el);
        break;
    default:
        return z;
    }
    double dry = own, wet = own;
    if (s->mapping == ORR_TROPO_MAPPING_NIELL) orr_mapping_niell(el, lat, h, t, &dry, &wet);
    return (orr_zenith_delay){dry * z.hydrostatic_m, wet * z.wet_m};
}
