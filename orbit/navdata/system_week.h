// SPDX-License-Identifier: GPL-3.0-or-later
// The weeks that navigation messages count. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_SYSTEM_WEEK_H
#define ORR_ORBIT_NAVDATA_SYSTEM_WEEK_H

#include "core/sat.h"
#include "core/time.h"

// Nanoseconds of the week of a satellite's own system, and that week (GPS', but BeiDou's own); week may be NULL.
int64_t orr_nav_seconds_of_week(orr_sat sat, orr_time t, int32_t *week);
// Whether a BeiDou satellite is geostationary and sends D2: C01-C05 and C59-C63.
bool orr_nav_beidou_geo(orr_sat sat);

#endif
