// SPDX-License-Identifier: GPL-3.0-or-later
// Orbits and clocks of satellites that no precise orbit has (NavIC and SBAS as a rule): from the records of a navigation
// file, and of geostationary satellites from a longitude alone. What comes out is a product like any other.
#ifndef ORR_ORBIT_EPHEMERIS_BROADCAST_ORBITS_H
#define ORR_ORBIT_EPHEMERIS_BROADCAST_ORBITS_H

#include "ingest/rinex/rinex_nav.h"
#include "orbit/ephemeris/ephemeris.h"

// A satellite that stands still over the Equator, with a clock of zero.
typedef struct orr_geostationary {
    orr_sat sat;
    double lon_rad;
} orr_geostationary;

// Makes a product.
// Given:
//   nav        records; NULL: none
//   except     satellites that are left out: others have their orbits; NULL: none
//   geo        [n_geo] geostationary satellites, of whom records are not used
//   n_geo      how many
//   from, to   what is wanted; ORR_TIME_NONE of both: as far as the records reach
// Returned:
//   out        the product; NULL, and ORR_OK, where no satellite is left. Free with orr_ephemeris_free
//   warnings   satellites whose records do not reach into the span; may be NULL
//   diag       why it failed; may be NULL
// Errors: those of orr_ephemeris_build; ORR_E_ARG (a satellite twice in geo), ORR_E_NODATA (geo alone, and no span).
// Notes: from one record's time of ephemeris to the next the orbit passes from the one to the other by a weight with two
// continuous derivatives, so that position, velocity and acceleration have no steps; the same holds for the clock. An arc
// ends where no record is within reach (2 h; BeiDou 90, GLONASS 18, SBAS 15 min). The point that the message gives, the
// antenna's, stands for the centre of mass. Sigma is the record's accuracy, or 3 m.
orr_status orr_broadcast_orbits(const orr_nav *nav, const orr_sat_set *except, const orr_geostationary *geo,
                                size_t n_geo, orr_time from, orr_time to, orr_ephemeris **out,
                                orr_warnings *warnings, orr_diag *diag);

#endif
