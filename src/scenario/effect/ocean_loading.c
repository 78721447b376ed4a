// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/ocean_loading.h"

#include <gsl/gsl_spline.h>
#include <math.h>
#include <string.h>

#include "core/constants.h"

enum { LUNAR_TIME, MOON, SUN, PERIGEE, NODE, SOLAR_PERIGEE, ARGUMENTS };

typedef struct tide {
    double amplitude_m;
    int times[ARGUMENTS];
} tide;
static const tide tides[] = {
#define ORR_TIDE(amplitude, ...) {amplitude, {__VA_ARGS__}},
#include "src/scenario/effect/tides.def"
#undef ORR_TIDE
};
_Static_assert(sizeof tides / sizeof *tides == ORR_TIDES, "the header tells how many there are");

// M2 S2 N2 K2 K1 O1 P1 Q1 Mf Mm Ssa, as BLQ files have them.
static const int told[ORR_BLQ_TIDES][ARGUMENTS] = {
    {2, 0, 0, 0, 0, 0}, {2, 2, -2, 0, 0, 0}, {2, -1, 0, 1, 0, 0}, {2, 2, 0, 0, 0, 0},
    {1, 1, 0, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, {1, 1, -2, 0, 0, 0}, {1, -2, 0, 1, 0, 0},
    {0, 2, 0, 0, 0, 0}, {0, 1, 0, -1, 0, 0}, {0, 0, 2, 0, 0, 0},
};
enum { SPECIES = 3, MOST_TOLD = 4 };
// Places of `told` by ascending frequency: of long periods, of a day, of half a day.
static const int ascending[SPECIES][MOST_TOLD] = {{10, 9, 8, -1}, {7, 5, 6, 4}, {2, 0, 1, 3}};

// Arguments in degrees, and how they change by the day, at centuries of TT after J2000.0 and a part of the day, UTC: the mean
// longitudes of IERS Conventions 2010, (5.43), in Doodson's combinations.
static void arguments(double T, double day, double deg[ARGUMENTS])
{
    const double l = 134.96340251 + T * (477198.8675605 + T * 0.0088553333),
                 lp = 357.5291091806 + T * (35999.0502911389 - T * 0.0001536667),
                 f = 93.27209062 + T * (483202.0174577222 - T * 0.003542),
                 d = 297.8501954694 + T * (445267.1114469445 - T * 0.0017696111),
                 node = 125.04455501 + T * (-1934.1362619722 + T * 0.0020756111);
    const double moon = f + node, sun = moon - d;
    deg[LUNAR_TIME] = 360 * day - d;
    deg[MOON] = moon;
    deg[SUN] = sun;
    deg[PERIGEE] = moon - l;
    deg[NODE] = -node;
    deg[SOLAR_PERIGEE] = sun - lp;
}

static double combine(const int times[ARGUMENTS], const double of[ARGUMENTS])
{
    double sum = 0;
    for (int k = 0; k < ARGUMENTS; k++) sum += times[k] * of[k];
    return sum;
}

static double amplitude_of(const int times[ARGUMENTS])
{
    for (size_t k = 0; k < ORR_TIDES; k++)
        if (memcmp(tides[k].times, times, sizeof tides[k].times) == 0) return fabs(tides[k].amplitude_m);
    return 1; // each of the eleven is among them
}

// One axis' in-phase or out-of-phase part over a species' frequencies.
static orr_status spread(const orr_blq *blq, int species, int axis, bool sine, const double rate[ARGUMENTS],
                         orr_ocean_loading *out)
{
    double x[MOST_TOLD], y[MOST_TOLD];
    size_t n = 0;
    for (; n < MOST_TOLD && ascending[species][n] >= 0; n++) {
        const int k = ascending[species][n];
        const double lag = blq->lag_deg[axis][k] * ORR_RAD_PER_DEG;
        x[n] = combine(told[k], rate);
        y[n] = blq->amplitude_m[axis][k] * (sine ? sin(lag) : cos(lag)) / amplitude_of(told[k]);
    }
    gsl_spline *s = gsl_spline_alloc(gsl_interp_cspline, n);
    if (s == NULL) return ORR_E_MEMORY;
    gsl_spline_init(s, x, y, n);
    for (size_t k = 0; k < ORR_TIDES; k++) {
        if (tides[k].times[LUNAR_TIME] != species) continue;
        const double at = fmin(fmax(combine(tides[k].times, rate), x[0]), x[n - 1]);
        (sine ? out->sine_m : out->cosine_m)[k][axis] = tides[k].amplitude_m * gsl_spline_eval(s, at, NULL);
    }
    gsl_spline_free(s);
    return ORR_OK;
}

orr_status orr_ocean_loading_of(const orr_blq *blq, orr_ocean_loading *out, orr_diag *diag)
{
    double now[ARGUMENTS], rate[ARGUMENTS];
    const double day_centuries = 1 / 36525.0;
    arguments(-day_centuries / 2, 0, now);
    arguments(day_centuries / 2, 1, rate);
    for (int k = 0; k < ARGUMENTS; k++) rate[k] -= now[k];
    orr_status s = ORR_OK;
    for (int axis = 0; axis < 3; axis++)
        for (int species = 0; species < SPECIES; species++)
            for (int sine = 0; s == ORR_OK && sine < 2; sine++)
                s = spread(blq, species, axis, sine == 1, rate, out);
    return s == ORR_OK ? ORR_OK : orr_diag_set(diag, s, "out of memory");
}

orr_vec3 orr_ocean_loading_m(const orr_ocean_loading *o, orr_time t)
{
    static const double origin_deg[SPECIES] = {180, 90,
                                               0}; // of the potential's signs (Cartwright and Tayler)
    int32_t utc, tt;
    double day, tt_day, deg[ARGUMENTS], moved_m[3] = {0, 0, 0};
    orr_time_mjd(t, ORR_SCALE_UTC, NULL, &utc, &day);
    orr_time_mjd(t, ORR_SCALE_TT, NULL, &tt, &tt_day);
    arguments((tt - 51544.5 + tt_day) / 36525, day, deg);
    for (size_t k = 0; k < ORR_TIDES; k++) {
        const double angle =
            fmod(combine(tides[k].times, deg) + origin_deg[tides[k].times[LUNAR_TIME]], 360) *
            ORR_RAD_PER_DEG;
        const double c = cos(angle), s = sin(angle);
        for (int axis = 0; axis < 3; axis++)
            moved_m[axis] += o->cosine_m[k][axis] * c + o->sine_m[k][axis] * s;
    }
    return (orr_vec3){-moved_m[1], -moved_m[2], moved_m[0]};
}
