// SPDX-License-Identifier: GPL-3.0-or-later
// The fields in which SBAS' message 9 sends a state and a clock. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_GEO_FIELDS_H
#define ORR_ORBIT_NAVDATA_GEO_FIELDS_H

#include "orbit/navdata/field.h"

extern const orr_navfit_field orr_geo_fields[3][3]; // x, y, z: position, velocity, acceleration
extern const orr_navfit_field orr_geo_clock[2];     // aGf0, aGf1

#endif
