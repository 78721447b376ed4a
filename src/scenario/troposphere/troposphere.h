// SPDX-License-Identifier: GPL-3.0-or-later
// Section `troposphere` as delays to a satellite.
#ifndef ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H
#define ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H

#include "src/config/section_channel.h"
#include "src/scenario/troposphere/atmosphere.h"

// What all satellites over a place share at an instant.
typedef struct orr_troposphere_site {
    int model, mapping;
    orr_zenith_delay zenith;
    orr_mapping_fractions hydrostatic, wet; // of mappings that are continued fractions
} orr_troposphere_site;

// Prepares a place.
// Given:
//   s      model, mapping, humidity
//   place  antenna; its ellipsoidal height is taken as that above the sea, as receivers do
//   t      instant
// Notes: no delay above 100 km.
orr_troposphere_site orr_troposphere_at(const orr_scenario_troposphere *s, orr_geodetic place, orr_time t);
// Slant delays, m, at an elevation; it is geometric, and below 1 deg it is held, smoothly, so that the horizon has
// the delay of 0.5 deg.
orr_zenith_delay orr_troposphere_slant(const orr_troposphere_site *site, double el_rad);

#endif
