// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scenario/effect/reflection.h"

#include <math.h>

#include "core/constants.h"

double complex orr_medium(double permittivity, double conductivity_spm, double carrier_hz)
{
    return permittivity - 60 * conductivity_spm * ORR_LIGHT_MPS / carrier_hz * (double complex)I;
}

void orr_fresnel(double complex medium, double grazing, double complex *level, double complex *upright)
{
    const double complex root = csqrt(medium - (1 - grazing * grazing));
    *level = (grazing - root) / (grazing + root);
    *upright = (medium * grazing - root) / (medium * grazing + root);
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
                             size_t n, double direct_deg, double reflected_deg)
{
    double complex level, upright;
    orr_fresnel(medium, grazing, &level, &upright);
    if (n == 0) return level; // half the sum and half the difference, received alike
    const double direct_db = orr_pattern_db(pattern, n, direct_deg, true);
    return (level + upright) / 2 * amplitude(orr_pattern_db(pattern, n, reflected_deg, true) - direct_db) +
           (level - upright) / 2 * amplitude(orr_pattern_db(pattern, n, reflected_deg, false) - direct_db);
}
