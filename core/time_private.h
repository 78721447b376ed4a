// SPDX-License-Identifier: GPL-3.0-or-later
// What time.c, leap.c and time_text.c share. Not for other rooms.
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

// TAI seconds since MJD 0 at which entry i begins.
int64_t orr_leap_entry_start(const orr_leap_table *leap, size_t i);
// The entry in force at so many TAI seconds since MJD 0; 0 also before the first.
size_t orr_leap_index_tai(const orr_leap_table *leap, int64_t tai_s);
// TAI - UTC at the start of a UTC day; the first entry's also before it.
int orr_leap_of_day(const orr_leap_table *leap, int32_t mjd);

#endif
