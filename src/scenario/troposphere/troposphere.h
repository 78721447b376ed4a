// SPDX-License-Identifier: GPL-3.0-or-later
// Section `troposphere` as delays to a satellite.
#ifndef ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H
#define ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H

#include "src/config/section_channel.h"
#include "src/scenario/troposphere/atmosphere.h"

// Slant delays at an elevation.
// Given:
//   s             model, mapping, humidity
//   place         antenna; its ellipsoidal height is taken as that above the sea, as receivers do
//   el_rad        elevation of the satellite, geometric; below 0.5 deg that is taken
//   t             instant
// Returned:
//   hydrostatic_m, wet_m  delays, m; none above 100 km
orr_zenith_delay orr_troposphere_delay(const orr_scenario_troposphere *s, orr_geodetic place, double el_rad,
                                       orr_time t);

#endif
