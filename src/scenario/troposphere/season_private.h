// SPDX-License-Identifier: GPL-3.0-or-later
// What DO-229 and Niell share: values tabulated at 15, 30, 45, 60 and 75 deg of latitude, and a cosine of the day of year.
#ifndef ORR_SCENARIO_TROPOSPHERE_SEASON_PRIVATE_H
#define ORR_SCENARIO_TROPOSPHERE_SEASON_PRIVATE_H

#include "src/scenario/troposphere/atmosphere.h"

// Linear in |latitude|, held beyond 15 and 75 deg.
double orr_by_latitude(const double table[5], double lat_rad);
// cos(2 pi (day of year - phase_day) / 365.25), the day with its fraction, UTC.
double orr_season_cosine(orr_time t, double phase_day);
// Cosine and sine of a year and of half a year, from the day of year with its fraction, UTC, over 365.25, behind 1: what GPT3's
// and VMF3's seasons are multiplied by. At the turn of the year they step by a quarter of a day or more, as published.
void orr_season_harmonics(orr_time t, double out[5]);

#endif
