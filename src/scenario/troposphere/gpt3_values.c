// SPDX-License-Identifier: GPL-3.0-or-later
// GPT3's grid at a place and an instant, the wet delay of its values, and slant delays of gradients.
#include <math.h>

#include "src/scenario/troposphere/season_private.h"

double orr_wet_askne_nordius_m(double vapour_hpa, double mean_k, double decrease)
{
    const double k1 = 77.604, k2 = 64.79, k3 = 377600;   // K/hPa, K/hPa, K^2/hPa
    const double k2p = k2 - k1 * 18.0152 / 28.9644;      // by the molar masses of water and dry air
    const double rd = 8.3143 / 28.9644e-3, gm = 9.80665; // J/K/kg, m/s^2
    return 1e-6 * (k2p + k3 / mean_k) * rd / (decrease + 1) / gm * vapour_hpa;
}

orr_zenith_delay orr_gradients_slant(const orr_gradients *g, double az_rad, double el_rad)
{
    const double bent = sin(el_rad) * tan(el_rad), n = cos(az_rad), e = sin(az_rad);
    return (orr_zenith_delay){(g->north_hydrostatic_m * n + g->east_hydrostatic_m * e) / (bent + 0.0031),
                              (g->north_wet_m * n + g->east_wet_m * e) / (bent + 0.0007)};
}

// A point's values at an ellipsoidal height.
static void lift(const orr_gpt3_point *p, const double season[5], double height_m, double v[ORR_GPT3_SEASONS],
                 orr_weather *w)
{
    for (int k = 0; k < ORR_GPT3_SEASONS; k++) {
        v[k] = 0;
        for (int j = 0; j < 5; j++) v[k] += (double)p->season[k][j] * season[j];
    }
    const double above_m = height_m - (double)p->undulation_m - (double)p->height_m;
    const double q = v[ORR_GPT3_HUMIDITY], p0 = v[ORR_GPT3_PRESSURE], t0 = v[ORR_GPT3_TEMPERATURE];
    const double virtual_k = t0 * (1 + 0.6077 * q);
    const double scale = 9.80665 * 28.965e-3 / (8.3143 * virtual_k); // 1/m
    const double thinner = exp(-scale * above_m);
    *w = (orr_weather){.pressure_hpa = p0 * thinner / 100,
                       .temperature_k = t0 + v[ORR_GPT3_LAPSE] * above_m,
                       .vapour_hpa =
                           q * p0 / (0.622 + 0.378 * q) / 100 * pow(thinner, v[ORR_GPT3_DECREASE] + 1)};
}

bool orr_gpt3_at(const orr_gpt3 *grid, orr_geodetic place, orr_time t, orr_gpt3_values *out)
{
    orr_lattice_cell cell;
    double season[5], sum[ORR_GPT3_SEASONS] = {0};
    *out = (orr_gpt3_values){.mean_k = 0};
    if (!orr_lattice_find(&grid->lattice, place.lat_rad * ORR_DEG_PER_RAD, place.lon_rad * ORR_DEG_PER_RAD,
                          &cell))
        return false;
    orr_season_harmonics(t, season);
    for (int j = 0; j < 4; j++) {
        double v[ORR_GPT3_SEASONS];
        orr_weather w;
        const double share = cell.weight[j];
        lift(&grid->point[cell.at[j]], season, place.height_m, v, &w);
        for (int k = 0; k < ORR_GPT3_SEASONS; k++) sum[k] += share * v[k];
        out->weather.pressure_hpa += share * w.pressure_hpa;
        out->weather.temperature_k += share * w.temperature_k;
        out->weather.vapour_hpa += share * w.vapour_hpa;
    }
    out->mean_k = sum[ORR_GPT3_MEAN];
    out->decrease = sum[ORR_GPT3_DECREASE];
    out->a_hydrostatic = sum[ORR_GPT3_A_HYDROSTATIC];
    out->a_wet = sum[ORR_GPT3_A_WET];
    out->gradients = (orr_gradients){sum[ORR_GPT3_NORTH_HYDROSTATIC], sum[ORR_GPT3_EAST_HYDROSTATIC],
                                     sum[ORR_GPT3_NORTH_WET], sum[ORR_GPT3_EAST_WET]};
    return true;
}
