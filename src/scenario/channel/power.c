// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/channel/power.h"

#include <math.h>

#include "core/limb.h"

static const double EARTH_M = ORR_EARTH_MEAN_RADIUS_M;

double orr_power_space_loss_db(double range_m, double carrier_hz)
{
    return 20 * log10(4 * ORR_PI * range_m * carrier_hz / ORR_LIGHT_MPS);
}

double orr_power_atmosphere_db(double el_rad)
{
    const double s = sin(fmax(el_rad, 0)),
                 q = EARTH_M / 6e3; // way through a layer of 6 km over its thickness
    return 0.035 * (sqrt(q * q * s * s + 2 * q + 1) - q * s);
}

// Above the power at 5 deg, dB: a parabola through 0 at 5, 2 at 40 and 0.5 at 90 deg.
static double above_least_db(double el_rad)
{
    const double x = fmax(el_rad * ORR_DEG_PER_RAD, 0) - 5;
    const double b = (0.5 / 85 - 2.0 / 35) / (85 - 35), a = 2.0 / 35 - 35 * b;
    return x * (a + b * x);
}

// Gain beyond the limb above that at it, dB.
static double lobe_db(const orr_scenario_lobes *lobes, double limb_deg, double nadir_deg)
{
    if (lobes->n == 0) return -fmin(3 * (nadir_deg - limb_deg), 20);
    double at_deg = limb_deg, db = 0;
    for (size_t k = 0; k < lobes->n; k++) {
        const orr_scenario_lobe *l = &lobes->item[k];
        if (l->nadir_deg >
            limb_deg) { // what a table says of angles within the limb is of the main lobe, which stands
            if (nadir_deg < l->nadir_deg)
                return db + (l->gain_db - db) * (nadir_deg - at_deg) / (l->nadir_deg - at_deg);
            at_deg = l->nadir_deg, db = l->gain_db;
        }
    }
    return db;
}

// Gain towards an angle from nadir, of a satellite so far from the Earth's centre, dB above what makes up for the loss in space
// over a metre.
static double radiated_db(double radius_m, double nadir_rad, const orr_scenario_lobes *lobes)
{
    const double limb = asin(EARTH_M / radius_m), inside = fmin(nadir_rad, limb);
    const double el = acos(fmin(radius_m * sin(inside) / EARTH_M, 1));
    const double range = radius_m * cos(inside) - EARTH_M * sin(el);
    const double beyond =
        nadir_rad > limb ? lobe_db(lobes, limb * ORR_DEG_PER_RAD, nadir_rad * ORR_DEG_PER_RAD) : 0;
    return above_least_db(el) + 20 * log10(range) + orr_power_atmosphere_db(el) + beyond;
}

double orr_power_gain_db(orr_vec3 sat_m, orr_vec3 r_m, double el_rad, const orr_scenario_lobes *lobes)
{
    const orr_vec3 d = orr_vec3_sub(r_m, sat_m);
    const double range = orr_vec3_norm(d), radius = orr_vec3_norm(sat_m);
    const double cosine = -orr_vec3_dot(d, sat_m) / (range * radius);
    const double above_ground = orr_vec3_norm(r_m) - EARTH_M;
    const double lost = above_ground < ORR_SPACE_HEIGHT_M ? orr_power_atmosphere_db(el_rad) : 0;
    return radiated_db(radius, acos(fmin(fmax(cosine, -1), 1)), lobes) - 20 * log10(range) - lost;
}

double orr_power_received_dbw(const orr_signal *s, orr_vec3 sat_m, orr_vec3 r_m, double el_rad,
                              const orr_scenario_lobes *lobes)
{
    return s->power_dbw + orr_power_gain_db(sat_m, r_m, el_rad, lobes);
}
