// SPDX-License-Identifier: GPL-3.0-or-later
// Section `troposphere` as delays to a satellite.
#ifndef ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H
#define ORR_SCENARIO_TROPOSPHERE_TROPOSPHERE_H

#include "src/config/section_channel.h"
#include "src/scenario/source/source.h"
#include "src/scenario/troposphere/atmosphere.h"

typedef struct orr_troposphere orr_troposphere;

// Opens the section, and reads its files.
// Given:
//   s      section; not kept
//   leap   leap seconds; NULL: built-in
// Returned:
//   out    the troposphere, NULL where the section says none; close with orr_troposphere_close
//   diag   as of the readers; ORR_E_NODATA (gradients of files that have none)
orr_status orr_troposphere_open(const orr_scenario_troposphere *s, const orr_leap_table *leap,
                                orr_troposphere **out, orr_diag *diag);
// NULL is allowed.
void orr_troposphere_close(orr_troposphere *o);
// The time that its files cover; false: it has no limits.
bool orr_troposphere_span(const orr_troposphere *o, orr_span *out);
// Makes sure that its files cover an antenna.
// Given:
//   o        the troposphere; NULL: none
//   antenna  which, from 0
//   name     of the antenna, by which files of stations know it
//   place    of a fixed antenna; NULL: it moves
// Returned:
//   o        knows the antenna's station
//   diag     ORR_E_NODATA: files do not cover the place, or do not know the station; or the antenna moves and they are of stations,
//            or of a part of the Earth alone
orr_status orr_troposphere_stand(orr_troposphere *o, size_t antenna, const char *name,
                                 const orr_geodetic *place, orr_diag *diag);
// The same of a place that has no station of its own: it takes that of antenna 0.
// Given:
//   o, name, place  as orr_troposphere_stand
// Returned:
//   diag            likewise, but for stations
orr_status orr_troposphere_covers(const orr_troposphere *o, const char *name, const orr_geodetic *place,
                                  orr_diag *diag);

// What all satellites over a place share at an instant.
typedef struct orr_troposphere_site {
    int model, mapping;
    orr_zenith_delay zenith;
    orr_mapping_fractions hydrostatic, wet; // of mappings that are continued fractions
    bool has_gradients;
    orr_gradients gradients;
} orr_troposphere_site;

// Prepares a place.
// Given:
//   o        the troposphere
//   antenna  which, from 0
//   place    antenna; its ellipsoidal height is taken as that above the sea, as receivers do, but for GPT3, which knows the geoid
//   t        instant
// Notes: no delay above 100 km, nor where files cover neither place nor time.
orr_troposphere_site orr_troposphere_at(const orr_troposphere *o, size_t antenna, orr_geodetic place,
                                        orr_time t);
// Slant delays, m, at an azimuth and an elevation; it is geometric, and below 1 deg it is held, smoothly, so that the horizon has
// the delay of 0.5 deg.
orr_zenith_delay orr_troposphere_slant(const orr_troposphere_site *site, double az_rad, double el_rad);

#endif
