// SPDX-License-Identifier: GPL-3.0-or-later
// Reflection of a circularly polarised wave by a smooth plane, and what an antenna makes of it.
#ifndef ORR_SCENARIO_EFFECT_REFLECTION_H
#define ORR_SCENARIO_EFFECT_REFLECTION_H

#include <complex.h>

#include "src/config/scenario.h"

// A medium at a frequency: relative permittivity - 60 i wavelength conductivity.
double complex orr_medium(double permittivity, double conductivity_spm, double carrier_hz);

// Fresnel's coefficients.
// Given:
//   medium     complex relative permittivity
//   grazing    sine of the angle between ray and plane
// Returned:
//   level      of a field along the plane (horizontal polarisation)
//   upright    of a field in the plane of incidence (vertical polarisation)
// Reference: Born and Wolf 1999, 1.5.2; signs as in Hannah 2001: both are -1 at grazing incidence.
void orr_fresnel(double complex medium, double grazing, double complex *level, double complex *upright);

// Gain of a pattern at an elevation above the antenna's horizon, dB; 0 without a pattern, the ends' beyond its ends.
double orr_pattern_db(const orr_scenario_gain *pattern, size_t n, double elevation_deg, bool rhcp);

// What an antenna receives of a ray that a plane reflects from below, against the direct ray: its complex ratio.
// Given:
//   medium        of the plane
//   grazing       sine of the angle of incidence
//   pattern, n    gains
//   direct_deg    elevation of the direct ray above the antenna's horizon
//   reflected_deg of the reflected one
// Returned:
//   slope         of the ratio by the grazing sine, the gains held
// Notes: of a right-handed wave (level + upright)/2 stays right-handed and (level - upright)/2 becomes left-handed.
double complex orr_reflected(double complex medium, double grazing, const orr_scenario_gain *pattern,
                             size_t n, double direct_deg, double reflected_deg, double complex *slope);

#endif
