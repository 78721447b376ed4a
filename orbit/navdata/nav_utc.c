// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/nav_utc.h"

// Bulletin C, January and July; eight bits of WN_LSF reach 127 weeks.
#define ANNOUNCED_DAYS 184
#define MJD_OF_WEEK_0 44244

orr_nav_utc orr_nav_utc_at(orr_time t, orr_time reference, const orr_leap_table *leap)
{
    if (leap == NULL) leap = orr_leap_builtin();
    orr_nav_utc utc = {.reference = reference, .leap_s = orr_leap_tai_minus_utc(t, leap) - 19};
    int32_t mjd;
    double fraction;
    orr_time_mjd(t, ORR_SCALE_UTC, leap, &mjd, &fraction);
    size_t k = 0;
    while (k + 1 < leap->n && leap->entry[k + 1].mjd <= mjd + ANNOUNCED_DAYS) k++;
    utc.leap_future_s = leap->entry[k].tai_minus_utc_s - 19;
    const int32_t eve = leap->entry[k].mjd - 1 - MJD_OF_WEEK_0; // the day at whose end it takes effect
    utc.week_lsf = (int32_t)orr_floor_div(eve, 7);
    utc.day = eve - 7 * utc.week_lsf + 1;
    return utc;
}
