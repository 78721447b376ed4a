// SPDX-License-Identifier: GPL-3.0-or-later
// Frequency channels of GLONASS' FDMA signals.
#ifndef ORR_ORBIT_NAVDATA_GLONASS_CHANNEL_H
#define ORR_ORBIT_NAVDATA_GLONASS_CHANNEL_H

#include "ingest/rinex/rinex_nav.h"

// Frequency channel of a GLONASS satellite.
// Given:
//   nav      navigation records; NULL: none
//   sat      satellite
//   t        the record nearest to this instant decides
// Returned:
//   channel  -7 to 6
//   nominal  whether it is that of the nominal plan of the 24 slots, because no record tells
// False, and nothing written, where neither knows.
bool orr_glonass_channel(const orr_nav *nav, orr_sat sat, orr_time t, int *channel, bool *nominal);

#endif
