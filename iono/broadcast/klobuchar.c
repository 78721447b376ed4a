// SPDX-License-Identifier: GPL-3.0-or-later
#include "iono/broadcast/klobuchar.h"

#include <math.h>

#include "core/vec.h"

// Everything is in semicircles (half turns), as the interface document writes it.
static double vertical_s(const orr_klobuchar *k, orr_time t, double lat, double lon)
{
    double phi_m = lat + 0.064 * cos((lon - 1.617) * ORR_PI);
    int32_t week;
    int64_t ns;
    orr_time_week(t, &week, &ns);
    double local =
        fmod(4.32e4 * lon + (double)(ns % ((int64_t)ORR_S_PER_DAY * ORR_NS_PER_S)) * 1e-9, ORR_S_PER_DAY);
    if (local < 0) local += ORR_S_PER_DAY;
    double amplitude = 0, period = 0;
    for (int i = 3; i >= 0; i--) {
        amplitude = amplitude * phi_m + k->alpha[i];
        period = period * phi_m + k->beta[i];
    }
    if (amplitude < 0) amplitude = 0;
    if (period < 72000) period = 72000;
    double x = 2 * ORR_PI * (local - 50400) / period;
    double bump = fabs(x) < 1.57 ? amplitude * (1 - x * x / 2 + x * x * x * x / 24) : 0;
    return 5e-9 + bump;
}

double orr_klobuchar_vertical_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad)
{
    return ORR_LIGHT_MPS * vertical_s(k, t, lat_rad / ORR_PI, lon_rad / ORR_PI);
}

double orr_klobuchar_delay_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad,
                             double az_rad, double el_rad)
{
    double el = el_rad / ORR_PI;
    double psi = 0.0137 / (el + 0.11) - 0.022;
    double lat = lat_rad / ORR_PI + psi * cos(az_rad);
    if (lat > 0.416) lat = 0.416;
    if (lat < -0.416) lat = -0.416;
    double lon = lon_rad / ORR_PI + psi * sin(az_rad) / cos(lat * ORR_PI);
    double low = 0.53 - el, obliquity = 1 + 16 * low * low * low;
    return ORR_LIGHT_MPS * obliquity * vertical_s(k, t, lat, lon);
}

#define BEIDOU_EARTH_M 6378e3
#define BEIDOU_SHELL_M 375e3

static double beidou_vertical_s(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad)
{
    const int64_t day_ns = (int64_t)ORR_S_PER_DAY * ORR_NS_PER_S;
    const double of_day = (double)orr_floor_mod(orr_time_add(t, -14 * ORR_NS_PER_S), day_ns) * 1e-9; // BDT
    double local = fmod(of_day + lon_rad * 43200 / ORR_PI, ORR_S_PER_DAY);
    if (local < 0) local += ORR_S_PER_DAY;
    const double phi = fabs(lat_rad / ORR_PI);
    double amplitude = 0, period = 0;
    for (int i = 3; i >= 0; i--) {
        amplitude = amplitude * phi + k->alpha[i];
        period = period * phi + k->beta[i];
    }
    amplitude = fmax(amplitude, 0);
    period = fmin(fmax(period, 72000), 172800);
    const double late = local - 50400;
    return 5e-9 + (fabs(late) < period / 4 ? amplitude * cos(2 * ORR_PI * late / period) : 0);
}

double orr_klobuchar_beidou_vertical_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad)
{
    return ORR_LIGHT_MPS * beidou_vertical_s(k, t, lat_rad, lon_rad);
}

double orr_klobuchar_beidou_delay_m(const orr_klobuchar *k, orr_time t, double lat_rad, double lon_rad,
                                    double az_rad, double el_rad)
{
    const double sin_zenith = BEIDOU_EARTH_M / (BEIDOU_EARTH_M + BEIDOU_SHELL_M) * cos(el_rad);
    const double psi = ORR_PI / 2 - el_rad - asin(sin_zenith);
    const double lat = asin(sin(lat_rad) * cos(psi) + cos(lat_rad) * sin(psi) * cos(az_rad));
    const double lon = lon_rad + asin(fmin(1, fmax(-1, sin(psi) * sin(az_rad) / cos(lat))));
    return ORR_LIGHT_MPS * beidou_vertical_s(k, t, lat, lon) / sqrt(1 - sin_zenith * sin_zenith);
}
