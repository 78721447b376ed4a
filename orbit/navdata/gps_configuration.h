// SPDX-License-Identifier: GPL-3.0-or-later
// The configuration of a GPS satellite as subframe 4 page 25 tells it: which signals its block sends. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_GPS_CONFIGURATION_H
#define ORR_ORBIT_NAVDATA_GPS_CONFIGURATION_H

#include "ingest/tables/antex.h"

// The three bits of the code of IS-GPS-200N 20.3.3.5.1.4: 1 II to IIR, 2 IIR-M, 3 IIF, 4 III, 5 IIIF; 0 beyond PRN 32.
// Given:
//   antex  tells the block; NULL, or where it does not have the satellite: the launches to 2025 do
//   sat    GPS satellite
//   t      instant
uint8_t orr_gps_configuration(const orr_antex *antex, orr_sat sat, orr_time t);

#endif
