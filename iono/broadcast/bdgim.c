// SPDX-License-Identifier: GPL-3.0-or-later
// BDS-SIS-ICD-B1C 1.0, 7.8.2: equations (7-8) to (7-19) and tables 7-10, 7-11.
#include "iono/broadcast/bdgim.h"

#include <math.h>
#include <stdlib.h>

#define EARTH_M 6378e3
#define SHELL_M 400e3
#define POLE_LAT_RAD (80.27 * ORR_RAD_PER_DEG)
#define POLE_LON_RAD (-72.58 * ORR_RAD_PER_DEG)
#define PERIODS 12 // besides the mean

// Periods in days.
static const double period_days[PERIODS] = {1,      0.5,    0.33,    14.6,    27,      121.6,
                                            182.51, 365.25, 4028.71, 2014.35, 1342.90, 1007.18};

// The forecast terms: degree, order (negative: sine), and in hundredths of a TECU the mean, then cosine and sine of each
// period.
static const struct {
    signed char degree, order;
    short hundredths[1 + 2 * PERIODS];
} forecast[] = {
    {3, 0, {-61, -51, 23, -6, 2, 1, 0, -1, 0, 0, 1, -19, -9, -18, 15, 109, 50, -34, 0, -13, 5, -6, 3, -3, 4}},
    {3, 1, {-131, -43, -20, -5, -8, -3,  -2, 0, -2, 0,  0, -2, 7,
            6,    -31, -14, -8, -9, -11, 7,  3, 13, -2, 8, -2}},
    {3, -1, {-200, 34, -31, 6,   -6,   1,   -3,  1, 1,  3, 0,  12, 3,
             -55,  13, -21, -38, -122, -22, -37, 7, -7, 4, -1, -4}},
    {3, 2, {-3, -1, 16, 17, -11, -1, -5, 0, 0, 1, 1, -10, 6, -2, 5, 52, 36, 5, 1, 5, 2, 3, -1, 4, 0}},
    {3, -2, {15, 17, -3, 15, 15, 5, -1, 1, -1, 2, 0, 6, 9, 9, -9, 27, 14, 15, 2, 6, -1, 2, -3, 1, -1}},
    {3, 3, {-48, 2, 2, 0, -14, -3, -7, 0, 1, 1, 0, 0, 1, -8, -3, 0, 4, -29, -3, -11, 3, -5, 2, -2, 0}},
    {3, -3, {-40, -6, 4, 11, 1, 5, -3, -1, 0, 0, 0, -2, 2, 0, 6, 11, 0, -17, -1, -7, 2, -5, 1, -2, 1}},
    {4, 0, {228, 30, 18, -5, 1, -3, -1, -1, -2, -2, 0, -8, 0, 86, -36, 17, 25, 158, 49, 46, -4, 1, 4, -4, 7}},
    {4, 1, {-16, 44, 34, -16, 4, -1, 2, 0, 0, 0, 0, -2, -4, -18, 8, 23, 17, -6, -3, 0, -1, 0, 0, 0, 0}},
    {4, -1, {-21, -28, 45, 2, -14, 0, -1, 0, 0, 0, 0, -7, -2, -5, 5, 35, 27, -15, -2, -4, -1, 0, 0, 0, 0}},
    {4, 2, {-10, -31, 19, 11, -5, -8, 3, 0, 0, 0, 0, 1, -1, -7, 6, -5, -3, 0, 1, 1, 2, 0, 0, 0, 0}},
    {4, -2, {-13, -17, -25, 4, 8, -4, -10, 0, 0, 0, 0, 3, 1, 4, -2, 2, -3, 13, 2, 7, 3, 0, 0, 0, 0}},
    {5, 0, {21, 4, -12, 12, 8, 0, 1, 0, 0, 0, 0, 15, -10, 14, -5, -60, -32, 28, 4, 9, 2, 0, 0, 0, 0}},
    {5, 1, {68, 39, 18, 7, -1, -2, 5, 0, 0, 0, 0, 6, 0, -3, 6, 2, -10, -8, -4, -5, -4, 0, 0, 0, 0}},
    {5, -1, {106, -12, 40, 2, 1, -3, -1, 0, 0, 0, 0, -5, -1, 37, -20, 1, 20, 62, 16, 15, -4, 0, 0, 0, 0}},
    {5, 2, {0, 12, -9, -14, 11, 0, 4, 0, 0, 0, 0, -3, 2, -11, 4, 27, 10, -1, -2, -1, -1, 0, 0, 0, 0}},
    {5, -2, {-12, 0, 21, -14, -12, -3, 0, 0, 0, 0, 0, -10, 5, -12, 7, 32, 30, -4, -1, 1, 0, 0, 0, 0, 0}}};

// The broadcast terms in the order of the coefficients.
static const signed char broadcast[9][2] = {{0, 0}, {1, 0},  {1, 1}, {1, -1}, {2, 0},
                                            {2, 1}, {2, -1}, {2, 2}, {2, -2}};

// Fully normalised P_nm(sin lat) cos m lon, or sin |m| lon for m < 0, without the Condon-Shortley phase.
static double harmonic(int n, int order, double lat, double lon)
{
    const int m = abs(order);
    const double x = sin(lat), c = cos(lat);
    double last = 0, p = 1; // P_(k-1)m, P_km
    for (int k = 1; k <= m; k++) p *= (2 * k - 1) * c;
    for (int k = m + 1; k <= n; k++) {
        const double next = ((2 * k - 1) * x * p - (k + m - 1) * last) / (k - m);
        last = p;
        p = next;
    }
    double norm = (2 * n + 1) * (m > 0 ? 2 : 1);
    for (int k = n - m + 1; k <= n + m; k++) norm /= k;
    return sqrt(norm) * p * (order >= 0 ? cos(m * lon) : sin(m * lon));
}

// A forecast coefficient at the odd hour of the two that t lies in, TECU.
static double coefficient(size_t i, double mjd)
{
    const double odd_hour = floor(mjd) + (floor((mjd - floor(mjd)) * 12) + 0.5) / 12;
    double sum = forecast[i].hundredths[0];
    for (int k = 0; k < PERIODS; k++) {
        const double phase = 2 * ORR_PI / period_days[k] * odd_hour;
        sum +=
            forecast[i].hundredths[1 + 2 * k] * cos(phase) + forecast[i].hundredths[2 + 2 * k] * sin(phase);
    }
    return sum / 100;
}

double orr_bdgim_vertical_tecu(const double alpha_tecu[9], orr_time t, double lat_rad, double lon_rad)
{
    int32_t day;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_BDT, NULL, &day, &fraction);
    const double sin_pole = sin(POLE_LAT_RAD), cos_pole = cos(POLE_LAT_RAD), dl = lon_rad - POLE_LON_RAD;
    const double lat = asin(sin_pole * sin(lat_rad) + cos_pole * cos(lat_rad) * cos(dl));
    const double lon = atan2(cos(lat_rad) * sin(dl) * cos_pole, sin_pole * sin(lat) - sin(lat_rad));
    const double sun = ORR_PI * (1 - 2 * fraction) - POLE_LON_RAD;
    const double from_sun = lon - atan2(sin(sun), sin_pole * cos(sun));
    double sum = 0;
    for (int i = 0; i < 9; i++)
        sum += alpha_tecu[i] * harmonic(broadcast[i][0], broadcast[i][1], lat, from_sun);
    for (size_t i = 0; i < sizeof forecast / sizeof *forecast; i++)
        sum +=
            coefficient(i, day + fraction) * harmonic(forecast[i].degree, forecast[i].order, lat, from_sun);
    return sum;
}

double orr_bdgim_slant_tecu(const double alpha_tecu[9], orr_time t, orr_geodetic site, double az_rad,
                            double el_rad)
{
    const double sin_zenith = EARTH_M / (EARTH_M + SHELL_M) * cos(el_rad); // at the shell
    const double psi = ORR_PI / 2 - el_rad - asin(sin_zenith);
    const double lat = asin(sin(site.lat_rad) * cos(psi) + cos(site.lat_rad) * sin(psi) * cos(az_rad));
    const double lon = site.lon_rad + atan2(sin(psi) * sin(az_rad) * cos(site.lat_rad),
                                            cos(psi) - sin(site.lat_rad) * sin(lat));
    const double vertical = orr_bdgim_vertical_tecu(alpha_tecu, t, lat, lon);
    return vertical > 0 ? vertical / sqrt(1 - sin_zenith * sin_zenith) : 0;
}
