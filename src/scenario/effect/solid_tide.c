// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/solid_tide.h"

#include <math.h>

#include "core/constants.h"

static const double RE_M = 6378136.6;                                   // of table 1.1
static const double SUN_RATIO = 332946.0482, MOON_RATIO = 0.0123000371; // masses against the Earth's

// A place on the sphere, and its directions.
typedef struct spot {
    double sin_lat, cos_lat, lon_rad;
    orr_vec3 up, east, north;
} spot;

static spot spot_of(orr_vec3 r)
{
    spot s = {.up = orr_vec3_unit(r)};
    s.sin_lat = s.up.z;
    s.cos_lat = sqrt(s.up.x * s.up.x + s.up.y * s.up.y);
    s.lon_rad = atan2(s.up.y, s.up.x);
    s.east = (orr_vec3){-sin(s.lon_rad), cos(s.lon_rad), 0};
    s.north = orr_vec3_cross(s.up, s.east);
    return s;
}

static void add(const spot *s, double up_m, double east_m, double north_m, orr_vec3 *out)
{
    *out = orr_vec3_axpy(up_m, s->up, orr_vec3_axpy(east_m, s->east, orr_vec3_axpy(north_m, s->north, *out)));
}

// Degrees 2 and 3 in phase, (7.5) and (7.6), with h2 and l2 by latitude, (7.2).
static void in_phase(const spot *s, const spot *body, double height2_m, double ratio, orr_vec3 *out)
{
    const double by_lat = (3 * s->sin_lat * s->sin_lat - 1) / 2;
    const double h2 = 0.6078 - 0.0006 * by_lat, l2 = 0.0847 + 0.0002 * by_lat, h3 = 0.292, l3 = 0.015;
    const double x = orr_vec3_dot(s->up, body->up), height3_m = height2_m * ratio;
    const orr_vec3 across = orr_vec3_axpy(-x, s->up, body->up);
    const double up_m = height2_m * h2 * (3 * x * x - 1) / 2 + height3_m * h3 * (5 * x * x * x - 3 * x) / 2;
    const double across_m = height2_m * 3 * l2 * x + height3_m * l3 * (15 * x * x - 3) / 2;
    *out = orr_vec3_axpy(up_m, s->up, orr_vec3_axpy(across_m, across, *out));
}

// Out of phase, (7.10) and (7.11), and the transverse part by latitude, (7.8) and (7.9).
static void corrections(const spot *s, const spot *body, double height2_m, orr_vec3 *out)
{
    const double l = s->lon_rad - body->lon_rad, sf = s->sin_lat, cf = s->cos_lat, sb = body->sin_lat,
                 cb = body->cos_lat;
    const double sin2f = 2 * sf * cf, cos2f = cf * cf - sf * sf, sin2b = 2 * sb * cb;
    const double h1 = -0.0025, l1 = -0.0007, h2 = -0.0022, l2 = -0.0007;
    add(s, -0.75 * h1 * height2_m * sin2b * sin2f * sin(l), -1.5 * l1 * height2_m * sin2b * sf * cos(l),
        -1.5 * l1 * height2_m * sin2b * cos2f * sin(l), out);
    add(s, -0.75 * h2 * height2_m * cb * cb * cf * cf * sin(2 * l),
        -1.5 * l2 * height2_m * cb * cb * cf * cos(2 * l),
        0.75 * l2 * height2_m * cb * cb * sin2f * sin(2 * l), out);
    const double diurnal = 0.0012, semidiurnal = 0.0024, p21 = 3 * sb * cb, p22 = 3 * cb * cb;
    add(s, 0, diurnal * sf * height2_m * p21 * cos2f * sin(l), -diurnal * sf * height2_m * p21 * sf * cos(l),
        out);
    add(s, 0, -0.5 * semidiurnal * sf * cf * height2_m * p22 * sf * sin(2 * l),
        -0.5 * semidiurnal * sf * cf * height2_m * p22 * cos(2 * l), out);
}

// A constituent: multiples of s, h, p, N', ps; amplitudes of both parts, radial and transverse, mm.
typedef struct constituent {
    signed char s, h, p, n, ps;
    double radial_in, radial_out, across_in, across_out;
} constituent;

// Table 7.3a, by Doodson number 135655 to 185565; those below 0.01 mm are left out.
static const constituent diurnal[] = {
    {-3, 0, 2, 0, 0, -0.01, 0, 0, 0},        {-3, 2, 0, 0, 0, -0.01, 0, 0, 0},
    {-2, 0, 1, -1, 0, -0.02, 0, 0, 0},       {-2, 0, 1, 0, 0, -0.08, 0, -0.01, 0.01},
    {-2, 2, -1, 0, 0, -0.02, 0, 0, 0},       {-1, 0, 0, -1, 0, -0.10, 0, 0, 0},
    {-1, 0, 0, 0, 0, -0.51, 0, -0.02, 0.03}, {-1, 2, 0, 0, 0, 0.01, 0, 0, 0},
    {0, -2, 1, 0, 0, 0.01, 0, 0, 0},         {0, 0, -1, 0, 0, 0.02, 0, 0, 0},
    {0, 0, 1, 0, 0, 0.06, 0, 0, 0},          {0, 0, 1, 1, 0, 0.01, 0, 0, 0},
    {0, 2, -1, 0, 0, 0.01, 0, 0, 0},         {1, -3, 0, 0, 1, -0.06, 0, 0, 0},
    {1, -2, 0, -1, 0, 0.01, 0, 0, 0},        {1, -2, 0, 0, 0, -1.23, -0.07, 0.06, 0.01},
    {1, -1, 0, 0, -1, 0.02, 0, 0, 0},        {1, -1, 0, 0, 1, 0.04, 0, 0, 0},
    {1, 0, 0, -1, 0, -0.22, 0.01, 0.01, 0},  {1, 0, 0, 0, 0, 12.00, -0.80, -0.67, -0.03},
    {1, 0, 0, 1, 0, 1.73, -0.12, -0.10, 0},  {1, 0, 0, 2, 0, -0.04, 0, 0, 0},
    {1, 1, 0, 0, -1, -0.50, -0.01, 0.03, 0}, {1, 1, 0, 0, 1, 0.01, 0, 0, 0},
    {0, 1, 0, 1, -1, -0.01, 0, 0, 0},        {1, 2, -2, 0, 0, -0.01, 0, 0, 0},
    {1, 2, 0, 0, 0, -0.11, 0.01, 0.01, 0},   {2, -2, 1, 0, 0, -0.01, 0, 0, 0},
    {2, 0, -1, 0, 0, -0.02, 0, 0, 0},
};
// Table 7.3b.
static const constituent long_period[] = {
    {0, 0, 0, 1, 0, 0.47, 0.16, 0.23, 0.07},      {0, 2, 0, 0, 0, -0.20, -0.11, -0.12, -0.05},
    {1, 0, -1, 0, 0, -0.11, -0.09, -0.08, -0.04}, {2, 0, 0, 0, 0, -0.13, -0.15, -0.11, -0.07},
    {2, 0, 0, 1, 0, -0.05, -0.06, -0.05, -0.03},
};

static double angle(const constituent *c, const double a[6])
{
    return c->s * a[1] + c->h * a[2] + c->p * a[3] + c->n * a[4] + c->ps * a[5];
}

// Step 2: (7.12) and (7.13). Arguments tau, s, h, p, N' and ps in radians; the Moon's and the Sun's mean longitudes and those of their
// perigees, of date (Simon et al. 1994).
static void by_frequency(const spot *place, double ut_h, double t, orr_vec3 *out)
{
    const double moon = 218.31664563 + t * (481267.88194 + t * (-0.0014663889 + t * 0.00000185139));
    const double precession = t * (1.396971278 + t * (0.000308889 + t * 0.000000021));
    double a[6] = {
        15 * ut_h + 280.4606184 + t * (36000.7700536 + t * (0.00038793 - t * 0.0000000258)) - moon,
        moon + precession,
        280.46645 + t * (36000.7697489 + t * 0.00030322222),
        83.35324312 + t * (4069.01363525 + t * (-0.01032172222 - t * 0.0000124991)),
        234.95544499 + t * (1934.13626197 + t * (-0.00207561111 - t * 0.00000213944)),
        282.93734098 + t * (1.71945766667 + t * 0.00045688889),
    };
    for (int k = 0; k < 6; k++) a[k] = fmod(a[k], 360) * ORR_RAD_PER_DEG;
    const double sf = place->sin_lat, cf = place->cos_lat, sin2f = 2 * sf * cf, cos2f = cf * cf - sf * sf;
    for (size_t k = 0; k < sizeof diurnal / sizeof *diurnal; k++) {
        const constituent *c = &diurnal[k];
        const double x = a[0] + angle(c, a) + place->lon_rad, s = sin(x), z = cos(x);
        add(place, 1e-3 * (c->radial_in * s + c->radial_out * z) * sin2f,
            1e-3 * (c->across_in * z - c->across_out * s) * sf,
            1e-3 * (c->across_in * s + c->across_out * z) * cos2f, out);
    }
    for (size_t k = 0; k < sizeof long_period / sizeof *long_period; k++) {
        const constituent *c = &long_period[k];
        const double x = angle(c, a), s = sin(x), z = cos(x);
        add(place, 1e-3 * (c->radial_in * z + c->radial_out * s) * (3 * sf * sf - 1) / 2, 0,
            1e-3 * (c->across_in * z + c->across_out * s) * sin2f, out);
    }
}

orr_vec3 orr_solid_tide_m(orr_vec3 r_m, orr_vec3 sun_m, orr_vec3 moon_m, double ut_h, double century)
{
    const orr_vec3 body[2] = {sun_m, moon_m};
    const double mass[2] = {SUN_RATIO, MOON_RATIO};
    const spot place = spot_of(r_m);
    orr_vec3 out = {0, 0, 0};
    for (int k = 0; k < 2; k++) {
        const spot of = spot_of(body[k]);
        const double ratio = RE_M / orr_vec3_norm(body[k]),
                     height2_m = mass[k] * RE_M * ratio * ratio * ratio;
        in_phase(&place, &of, height2_m, ratio, &out);
        corrections(&place, &of, height2_m, &out);
    }
    by_frequency(&place, ut_h, century, &out);
    return out;
}

orr_vec3 orr_pole_tide_m(orr_vec3 r_m, const orr_eop *eop, const orr_eop *secular)
{
    static const double ARCSEC_PER_RAD = 3600 * ORR_DEG_PER_RAD;
    const spot s = spot_of(r_m);
    const double m1 = (eop->xp_rad - secular->xp_rad) * ARCSEC_PER_RAD,
                 m2 = -(eop->yp_rad - secular->yp_rad) * ARCSEC_PER_RAD;
    const double along = m1 * cos(s.lon_rad) + m2 * sin(s.lon_rad),
                 across = m1 * sin(s.lon_rad) - m2 * cos(s.lon_rad);
    orr_vec3 out = {0, 0, 0};
    // Colatitude's axis points South: its -9 mm cos 2 theta is +9 mm to the North.
    add(&s, -33e-3 * 2 * s.sin_lat * s.cos_lat * along, 9e-3 * s.sin_lat * across,
        9e-3 * (s.sin_lat * s.sin_lat - s.cos_lat * s.cos_lat) * along, &out);
    return out;
}
