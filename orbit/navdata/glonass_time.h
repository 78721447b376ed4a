// SPDX-License-Identifier: GPL-3.0-or-later
// The calendar of the GLONASS message: days in Moscow (UTC + 3 h, leap seconds at 02:59:60), four-year
// intervals, frames of 30 s and superframes of five.
#ifndef ORR_ORBIT_NAVDATA_GLONASS_TIME_H
#define ORR_ORBIT_NAVDATA_GLONASS_TIME_H

#include "core/time.h"

// Day (MJD) and time of day in Moscow; only hour, minute, second and ns of c are of Moscow.
int32_t orr_glonass_clock(orr_time t, orr_civil *c);
// Begin (00:00) of the day in Moscow that holds t.
orr_time orr_glonass_day(orr_time t);
// N_4 and N_T of that day: 1996-01-01 is day 1 of interval 1. ORR_E_RANGE before 1996 and after 2119, where
// N_4 ends.
orr_status orr_glonass_calendar(orr_time t, int *n4, int *nt, orr_diag *diag);

// Frame of the superframe, 1..5, that begins at t_k: superframes are counted from the begin of the day in
// Moscow (the ICD leaves that open; receivers go by the satellites' numbers). 0 where no frame begins.
int orr_glonass_frame(orr_time t_k);
// Slot 1..24 whose almanac string 6..15 of frame 1..5 carries (table 4.6); 0 for strings that carry none.
int orr_glonass_almanac_slot(int frame, int string);

#endif
