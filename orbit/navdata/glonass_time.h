// SPDX-License-Identifier: GPL-3.0-or-later
// The calendar of the GLONASS message: days in Moscow (UTC + 3 h, leap seconds at 02:59:60), four-year
// intervals, frames of 30 s and superframes of five. A table of leap seconds may be NULL: the built-in one.
#ifndef ORR_ORBIT_NAVDATA_GLONASS_TIME_H
#define ORR_ORBIT_NAVDATA_GLONASS_TIME_H

#include "core/time.h"

// Day (MJD) and time of day in Moscow; only hour, minute, second and ns of c are of Moscow.
int32_t orr_glonass_clock(orr_time t, const orr_leap_table *leap, orr_civil *c);
// Begin (00:00) of the day in Moscow that holds t.
orr_time orr_glonass_day(orr_time t, const orr_leap_table *leap);
// N_4 and N_T of the day in Moscow: 1996-01-01 is day 1 of interval 1.
//   Given:    t       any instant of the day
//             leap    table of leap seconds; NULL: built-in
//   Returned: n4, nt  interval of four years, day in it
//             diag    ORR_E_RANGE before 1996 and after 2119, where N_4 ends
orr_status orr_glonass_calendar(orr_time t, const orr_leap_table *leap, int *n4, int *nt, orr_diag *diag);

// Frame of the superframe, 1..5, that begins at t_k: superframes are counted from the begin of the day in
// Moscow (the ICD leaves that open; receivers go by the satellites' numbers). 0 where no frame begins.
int orr_glonass_frame(orr_time t_k, const orr_leap_table *leap);
// Slot 1..24 whose almanac string 6..15 of frame 1..5 carries (table 4.6); 0 for strings that carry none.
int orr_glonass_almanac_slot(int frame, int string);

#endif
