// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/tides.h"

#include "orbit/force/force.h"

#define ARCSEC (ORR_RAD_PER_DEG / 3600.0)
#define MJD_J2000 51544.5

// Normalisation of degree 2: sqrt((2 - d0m) 5 (2 - m)!/(2 + m)!).
static const double norm2[3] = {2.23606797749978969, 1.29099444873580562, 0.64549722436790281};

// Love numbers k2m, real and imaginary (IERS Conventions 2010, table 6.3, anelastic).
static const double love[3][2] = {{0.30190, 0}, {0.29830, -0.00144}, {0.30102, -0.00130}};

// One body's share: (6.6), dC - i dS = k2m / 5 GM/GM_earth (R/r)^3 P2m(sin lat) exp(-i m lon), normalised.
static void add_body(orr_vec3 r, double gm, double normal[3][2])
{
    const double d = orr_vec3_norm(r), s = r.z / d, c = sqrt(1 - s * s), lon = atan2(r.y, r.x);
    const double ratio = ORR_EGM96_RADIUS_M / d, size = gm / ORR_EGM96_GM * ratio * ratio * ratio / 5;
    const double p[3] = {(1.5 * s * s - 0.5) * norm2[0], 3 * s * c * norm2[1], 3 * c * c * norm2[2]};
    for (int m = 0; m < 3; m++) {
        const double re = size * p[m] * cos(m * lon), im = -size * p[m] * sin(m * lon);
        normal[m][0] += love[m][0] * re - love[m][1] * im;
        normal[m][1] += love[m][0] * im + love[m][1] * re;
    }
}

void orr_tides_gravitation(orr_time t, orr_vec3 sun, orr_vec3 moon, double xp_rad, double yp_rad,
                           double change[5])
{
    double z[3][2] = {{0}};
    add_body(sun, ORR_SUN_GM, z);
    add_body(moon, ORR_MOON_GM, z);
    double c20 = z[0][0], c21 = z[1][0], s21 = -z[1][1];
    // The secular pole (IERS Conventions 2010, updated 2018, 7.1.4), about which the pole swings, arcseconds.
    int32_t day;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_TT, NULL, &day, &fraction);
    const double years = (day - MJD_J2000 + fraction) / 365.25;
    const double xm = 0.055 + 0.001677 * years, ym = 0.3205 + 0.00346 * years;
    const double m1 = xp_rad / ARCSEC - xm, m2 = -(yp_rad / ARCSEC - ym);
    c21 += -1.333e-9 * (m1 + 0.0115 * m2); // pole tide
    s21 += -1.333e-9 * (m2 - 0.0115 * m1);
    // The mean figure axis follows the secular pole, C21 = sqrt(3) xm C20; EGM96 has that of 1986.
    const double a = 1.73205080756887729 * -0.484165371736e-3;
    c21 += a * xm * ARCSEC + 0.186987635955e-9;
    s21 += -a * ym * ARCSEC - 0.119528012031e-8;
    c20 += 1.3e-10; // from 1986 to about 2000 and later
    change[0] = norm2[0] * c20;
    change[1] = norm2[1] * c21;
    change[2] = norm2[1] * s21;
    change[3] = norm2[2] * z[2][0];
    change[4] = norm2[2] * -z[2][1];
}
