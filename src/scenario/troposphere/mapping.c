// SPDX-License-Identifier: GPL-3.0-or-later
// Mapping functions: from the zenith to an elevation.
#include <math.h>

#include "src/scenario/troposphere/season_private.h"

double orr_by_latitude(const double table[5], double lat_rad)
{
    const double x = fabs(lat_rad) * ORR_DEG_PER_RAD / 15 - 1;
    if (x <= 0) return table[0];
    if (x >= 4) return table[4];
    const int k = (int)x;
    return table[k] + (x - k) * (table[k + 1] - table[k]);
}

static double day_of_year(orr_time t)
{
    orr_civil c;
    orr_time_to_civil(t, ORR_SCALE_UTC, NULL, &c);
    return orr_day_of_year(c.year, c.month, c.day) +
           (c.hour * 3600 + c.minute * 60 + c.second + c.ns * 1e-9) / 86400.0;
}

double orr_season_cosine(orr_time t, double phase_day)
{
    return cos(2 * ORR_PI * (day_of_year(t) - phase_day) / 365.25);
}

void orr_season_harmonics(orr_time t, double out[5])
{
    const double year = 2 * ORR_PI * day_of_year(t) / 365.25;
    out[0] = 1;
    for (int k = 1; k <= 2; k++) {
        out[2 * k - 1] = cos(k * year);
        out[2 * k] = sin(k * year);
    }
}

double orr_mapping_cosecant(double el_rad) { return 1 / sin(el_rad); }

double orr_mapping_black_eisner(double el_rad)
{
    const double s = sin(el_rad), below = fmax(4 - el_rad * ORR_DEG_PER_RAD, 0);
    return 1.001 / sqrt(0.002001 + s * s) * (1 + 0.015 * below * below);
}

double orr_mapping_chao(double el_rad) { return 1 / (sin(el_rad) + 0.00143 / (tan(el_rad) + 0.0455)); }

// Niell 1996, tables 3 and 4: a, b, c of the continued fraction at 15, 30, 45, 60, 75 deg.
static const double DRY_MEAN[3][5] = {{1.2769934e-3, 1.2683230e-3, 1.2465397e-3, 1.2196049e-3, 1.2045996e-3},
                                      {2.9153695e-3, 2.9152299e-3, 2.9288445e-3, 2.9022565e-3, 2.9024912e-3},
                                      {62.610505e-3, 62.837393e-3, 63.721774e-3, 63.824265e-3, 64.258455e-3}};
static const double DRY_SEASON[3][5] = {{0, 1.2709626e-5, 2.6523662e-5, 3.4000452e-5, 4.1202191e-5},
                                        {0, 2.1414979e-5, 3.0160779e-5, 7.2562722e-5, 11.723375e-5},
                                        {0, 9.0128400e-5, 4.3497037e-5, 84.795348e-5, 170.37206e-5}};
static const double WET[3][5] = {{5.8021897e-4, 5.6794847e-4, 5.8118019e-4, 5.9727542e-4, 6.1641693e-4},
                                 {1.4275268e-3, 1.5138625e-3, 1.4572752e-3, 1.5007428e-3, 1.7599082e-3},
                                 {4.3472961e-2, 4.6729510e-2, 4.3908931e-2, 4.4626982e-2, 5.4736038e-2}};
static const double HEIGHT[3] = {2.53e-5, 5.49e-3, 1.14e-3};

// Marini's continued fraction, 1 at the zenith.
static double marini(double s, double a, double b, double c)
{
    return (1 + a / (1 + b / (1 + c))) / (s + a / (s + b / (s + c)));
}

double orr_mapping_fraction(const orr_mapping_fractions *m, double el_rad)
{
    const double s = sin(el_rad), at_sea = marini(s, m->a, m->b, m->c);
    if (m->height_km == 0) return at_sea;
    return at_sea + (1 / s - marini(s, HEIGHT[0], HEIGHT[1], HEIGHT[2])) * m->height_km;
}

void orr_mapping_niell_at(double lat_rad, double height_m, orr_time t, orr_mapping_fractions *hydrostatic,
                          orr_mapping_fractions *wet)
{
    const double season = orr_season_cosine(t, lat_rad < 0 ? 28 + 365.25 / 2 : 28);
    double dry[3], w[3];
    for (int k = 0; k < 3; k++) {
        dry[k] = orr_by_latitude(DRY_MEAN[k], lat_rad) - orr_by_latitude(DRY_SEASON[k], lat_rad) * season;
        w[k] = orr_by_latitude(WET[k], lat_rad);
    }
    *hydrostatic = (orr_mapping_fractions){dry[0], dry[1], dry[2], height_m / 1e3};
    *wet = (orr_mapping_fractions){w[0], w[1], w[2], 0};
}
