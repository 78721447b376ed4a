// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/system_week.h"

int64_t orr_nav_seconds_of_week(orr_sat sat, orr_time t, int32_t *week)
{
    const bool beidou = orr_sat_system(sat) == 'C';
    int32_t w;
    int64_t ns;
    orr_time_week(beidou ? t - ORR_BDT_BEHIND_GPS_NS : t, &w, &ns);
    if (week != NULL) *week = beidou ? w - ORR_BDT_WEEK_0 : w;
    return ns;
}

bool orr_nav_beidou_geo(orr_sat sat)
{
    const int n = orr_sat_number(sat);
    return orr_sat_system(sat) == 'C' && (n <= 5 || n >= 59);
}
