// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/glonass_time.h"

#define MOSCOW_H 3
#define FRAME_S 30
#define FRAMES 5

int32_t orr_glonass_clock(orr_time t, const orr_leap_table *leap, orr_civil *c)
{
    orr_time_to_civil(t, ORR_SCALE_UTC, leap, c);
    int32_t mjd = orr_mjd_from_date(c->year, c->month, c->day) + (c->hour + MOSCOW_H >= 24);
    c->hour = (c->hour + MOSCOW_H) % 24;
    return mjd;
}

orr_time orr_glonass_day(orr_time t, const orr_leap_table *leap)
{
    orr_civil c;
    return orr_time_from_mjd(orr_glonass_clock(t, leap, &c) - 1, (24.0 - MOSCOW_H) / 24, ORR_SCALE_UTC, leap);
}

orr_status orr_glonass_calendar(orr_time t, const orr_leap_table *leap, int *n4, int *nt, orr_diag *diag)
{
    orr_civil c;
    int32_t mjd = orr_glonass_clock(t, leap, &c);
    int year, month, day;
    orr_date_from_mjd(mjd, &year, &month, &day);
    if (year < 1996 || year > 2119)
        return orr_diag_set(diag, ORR_E_RANGE, "N_4 counts the years 1996 to 2119, not %d", year);
    *n4 = (year - 1996) / 4 + 1;
    *nt = mjd - orr_mjd_from_date(1996 + 4 * (*n4 - 1), 1, 1) + 1;
    return ORR_OK;
}

int orr_glonass_frame(orr_time t_k, const orr_leap_table *leap)
{
    orr_civil c;
    orr_glonass_clock(t_k, leap, &c);
    if (c.ns != 0 || (c.second != 0 && c.second != FRAME_S)) return 0;
    return (c.hour * 3600 + c.minute * 60 + c.second) / FRAME_S % FRAMES + 1;
}

int orr_glonass_almanac_slot(int frame, int string)
{
    if (frame < 1 || frame > FRAMES || string < 6 || string > 15 || (frame == FRAMES && string > 13))
        return 0;
    return 5 * (frame - 1) + (string - 6) / 2 + 1;
}
