// SPDX-License-Identifier: GPL-3.0-or-later
// Zenith delays: Saastamoinen on a standard atmosphere, DO-229's means and seasons, STANAG 4294's three layers.
#include <math.h>

#include "src/scenario/troposphere/season_private.h"

orr_weather orr_weather_standard(double height_m, double humidity)
{
    const double top_m = 11000, h = fmin(height_m, top_m);
    const double t = 288.16 - 6.5e-3 * h; // RTKLIB's 15 deg C is 288.16 K
    const double above =
        exp(-9.80665 / (287.053 * t) * (height_m - h)); // where the temperature falls no more
    return (orr_weather){.pressure_hpa = 1013.25 * pow(1 - 2.2557e-5 * h, 5.2568) * above,
                         .temperature_k = t,
                         .vapour_hpa = 6.108 * humidity * exp((17.15 * t - 4684) / (t - 38.45)) * above};
}

orr_zenith_delay orr_zenith_saastamoinen(orr_weather w, double lat_rad, double height_m)
{
    const double gravity = 1 - 0.00266 * cos(2 * lat_rad) - 0.00028e-3 * height_m;
    return (orr_zenith_delay){.hydrostatic_m = 0.0022768 * w.pressure_hpa / gravity,
                              .wet_m = 0.002277 * (1255 / w.temperature_k + 0.05) * w.vapour_hpa};
}

// DO-229E, tables A-2: pressure [hPa], temperature [K], vapour pressure [hPa], lapse rate [K/m], vapour lapse rate, at 15, 30,
// 45, 60, 75 deg: means, and amplitudes of the season.
static const double DO229_MEAN[5][5] = {{1013.25, 1017.25, 1015.75, 1011.75, 1013.00},
                                        {299.65, 294.15, 283.15, 272.15, 263.65},
                                        {26.31, 21.79, 11.66, 6.78, 4.11},
                                        {6.30e-3, 6.05e-3, 5.58e-3, 5.39e-3, 4.53e-3},
                                        {2.77, 3.15, 2.57, 1.81, 1.55}};
static const double DO229_SEASON[5][5] = {{0, -3.75, -2.25, -1.75, -0.50},
                                          {0, 7.00, 11.00, 15.00, 14.50},
                                          {0, 8.85, 7.24, 5.36, 3.39},
                                          {0, 0.25e-3, 0.32e-3, 0.81e-3, 0.62e-3},
                                          {0, 0.33, 0.46, 0.74, 0.30}};

orr_zenith_delay orr_zenith_do229(double lat_rad, double height_m, orr_time t)
{
    const double season = orr_season_cosine(t, lat_rad < 0 ? 211 : 28);
    double x[5];
    for (int k = 0; k < 5; k++)
        x[k] = orr_by_latitude(DO229_MEAN[k], lat_rad) - orr_by_latitude(DO229_SEASON[k], lat_rad) * season;
    const double p = x[0], temperature = x[1], e = x[2], beta = x[3], lambda = x[4];
    const double k1 = 77.604, k2 = 382000, rd = 287.054, gm = 9.784, g = 9.80665;
    const double hydrostatic = 1e-6 * k1 * rd * p / gm;
    const double wet = 1e-6 * k2 * rd / (gm * (lambda + 1) - beta * rd) * e / temperature;
    const double left = fmax(1 - beta * height_m / temperature, 0); // of the temperature at this height
    return (orr_zenith_delay){.hydrostatic_m = hydrostatic * pow(left, g / (rd * beta)),
                              .wet_m = wet * pow(left, (lambda + 1) * g / (rd * beta) - 1)};
}

orr_zenith_delay orr_zenith_stanag4294(double height_m)
{
    const double sea = 324.8, high = 105;                    // refractivity at 0 and 9 km
    const double slope = -7.32 * exp(0.005577 * sea);        // 1/km, below 1 km
    const double at1 = sea + slope, c = log(at1 / high) / 8; // from 1 to 9 km it falls exponentially
    const double c9 = 0.1424;                                // 1/km, above
    const double h = height_m / 1e3;
    const double above9 = high / c9, from1to9 = (at1 - high) / c;
    double sum; // refractivity times kilometres above h
    if (h >= 9)
        sum = above9 * exp(-c9 * (h - 9));
    else if (h >= 1)
        sum = above9 + (at1 * exp(-c * (h - 1)) - high) / c;
    else
        sum = above9 + from1to9 + sea * (1 - h) + slope * (1 - h * h) / 2;
    return (orr_zenith_delay){.hydrostatic_m = 1e-6 * 1e3 * sum, .wet_m = 0};
}
