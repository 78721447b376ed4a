// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/reflection.h"

#include <math.h>

#include "core/constants.h"

double complex orr_medium(double permittivity, double conductivity_spm, double carrier_hz)
{
    return permittivity - 60 * conductivity_spm * ORR_LIGHT_MPS / carrier_hz * (double complex)I;
}

// Root of a medium's epsilon less the cosine's square, with the real part positive.
static double complex root_of(double complex medium, double grazing)
{
    const double re = creal(medium) - (1 - grazing * grazing), im = cimag(medium);
    if (!(re > 0)) return csqrt(re + im * (double complex)I);
    const double x = sqrt((sqrt(re * re + im * im) + re) / 2);
    return x + im / (2 * x) * (double complex)I;
}

// a/b of numbers that are neither huge nor tiny.
static double complex quotient(double complex a, double complex b)
{
    const double by = 1 / (creal(b) * creal(b) + cimag(b) * cimag(b));
    return (creal(a) * creal(b) + cimag(a) * cimag(b)) * by +
           (cimag(a) * creal(b) - creal(a) * cimag(b)) * by * (double complex)I;
}

void orr_fresnel(double complex medium, double grazing, double complex *level, double complex *upright)
{
    const double complex root = root_of(medium, grazing);
    *level = quotient(grazing - root, grazing + root);
    *upright = quotient(medium * grazing - root, medium * grazing + root);
}

double orr_pattern_db(const orr_scenario_gain *p, size_t n, double elevation_deg, bool rhcp)
{
    if (n == 0) return 0;
    size_t k = 0;
    while (k < n && p[k].elevation_deg <= elevation_deg) k++;
    const orr_scenario_gain *a = &p[k > 0 ? k - 1 : 0], *b = &p[k < n ? k : n - 1];
    const double from = rhcp ? a->rhcp_db : a->lhcp_db, to = rhcp ? b->rhcp_db : b->lhcp_db;
    const double width = b->elevation_deg - a->elevation_deg;
    return width > 0 ? from + (to - from) * (elevation_deg - a->elevation_deg) / width : from;
}

static double amplitude(double db) { return pow(10, db / 20); }

double complex orr_reflected(double complex medium, double grazing, const orr_scenario_gain *pattern,
                             size_t n, double direct_deg, double reflected_deg, double complex *slope)
{
    const double complex root = root_of(medium, grazing), level = quotient(grazing - root, grazing + root);
    // The root's slope is grazing/root, and root^2 - grazing^2 = medium - 1.
    const double complex level_slope = quotient(-2 * level, root);
    if (n == 0) { // half the sum and half the difference, received alike
        *slope = level_slope;
        return level;
    }
    const double complex along = medium * grazing + root, upright = quotient(medium * grazing - root, along),
                         upright_slope = quotient(2 * medium * (medium - 1), root * along * along);
    const double direct_db = orr_pattern_db(pattern, n, direct_deg, true),
                 kept = amplitude(orr_pattern_db(pattern, n, reflected_deg, true) - direct_db) / 2,
                 turned = amplitude(orr_pattern_db(pattern, n, reflected_deg, false) - direct_db) / 2;
    *slope = (level_slope + upright_slope) * kept + (level_slope - upright_slope) * turned;
    return (level + upright) * kept + (level - upright) * turned;
}
