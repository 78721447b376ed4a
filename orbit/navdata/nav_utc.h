// SPDX-License-Identifier: GPL-3.0-or-later
// What messages tell of UTC. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_NAV_UTC_H
#define ORR_ORBIT_NAVDATA_NAV_UTC_H

#include "core/time.h"

// A system's time less UTC: leap seconds now and to come. Its time itself is the product's, so that A0 and A1 are zero, as are
// the offsets between systems.
typedef struct orr_nav_utc {
    double a0_s, a1_sps;
    orr_time reference;                 // of A0: tot
    int32_t week_lsf;                   // full GPS week of the day at whose end the leap second comes
    int32_t leap_s, leap_future_s, day; // GPS - UTC now and after; day 1 (Sunday) to 7
} orr_nav_utc;

// Leap seconds around t: the one that is announced, or the last one (IS-GPS-200N 20.3.3.5.2.4). IERS announces a leap second
// half a year ahead, and only then can messages tell of it.
// leap may be NULL: built-in.
orr_nav_utc orr_nav_utc_at(orr_time t, orr_time reference, const orr_leap_table *leap);

#endif
