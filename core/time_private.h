// SPDX-License-Identifier: GPL-3.0-or-later
// Where the GPS scale stands among the others; of time.c and the routines of this room that count in TAI.
#ifndef ORR_CORE_TIME_PRIVATE_H
#define ORR_CORE_TIME_PRIVATE_H

#include "core/time.h"

#define ORR_MJD_GPS_EPOCH 44244 // 1980-01-06
#define ORR_TAI_MINUS_GPS_S 19  // fixed, the TAI - UTC of 1980-01-06

// Whole TAI seconds since MJD 0 (floor), the count in which leap tables are ordered.
static inline int64_t orr_tai_seconds(orr_time t)
{
    return orr_floor_div(t, ORR_NS_PER_S) + (int64_t)ORR_MJD_GPS_EPOCH * ORR_S_PER_DAY + ORR_TAI_MINUS_GPS_S;
}

#endif
