// SPDX-License-Identifier: GPL-3.0-or-later
// VMF3's mapping functions.
#include "src/scenario/troposphere/harmonics_private.h"
#include "src/scenario/troposphere/season_private.h"

enum { B_HYDROSTATIC, C_HYDROSTATIC, B_WET, C_WET, QUANTITIES };
enum { DEGREE = 12, TERMS = ORR_HARMONICS_TERMS(DEGREE) };

// Harmonics of a degree and order: of the mean, and of cosine and sine of a year and of half a year.
typedef struct term {
    double cosine[5], sine[5];
} term;

static const term terms[QUANTITIES][TERMS] = {
#define COEFFICIENTS(...) __VA_ARGS__
#define ORR_VMF3(quantity, n, m, c, s) [quantity][ORR_HARMONICS_TERMS((n)-1) + (m)] = {c, s},
#include "src/scenario/troposphere/vmf3_harmonics.def"
#undef ORR_VMF3
#undef COEFFICIENTS
};

static double value_of(int quantity, const double season[5], const double *c, const double *s)
{
    double sum = 0;
    for (int k = 0; k < TERMS; k++) {
        const term *x = &terms[quantity][k];
        double cosine = 0, sine = 0;
        for (int j = 0; j < 5; j++) {
            cosine += x->cosine[j] * season[j];
            sine += x->sine[j] * season[j];
        }
        sum += cosine * c[k] + sine * s[k];
    }
    return sum;
}

void orr_mapping_vmf3_at(orr_geodetic place, orr_time t, double a_hydrostatic, double a_wet,
                         orr_mapping_fractions *hydrostatic, orr_mapping_fractions *wet)
{
    double season[5], c[TERMS], s[TERMS], v[QUANTITIES];
    orr_season_harmonics(t, season);
    orr_place_harmonics(DEGREE, place.lat_rad, place.lon_rad, c, s);
    for (int k = 0; k < QUANTITIES; k++) v[k] = value_of(k, season, c, s);
    *hydrostatic =
        (orr_mapping_fractions){a_hydrostatic, v[B_HYDROSTATIC], v[C_HYDROSTATIC], place.height_m / 1e3};
    *wet = (orr_mapping_fractions){a_wet, v[B_WET], v[C_WET], 0};
}
