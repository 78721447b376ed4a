// SPDX-License-Identifier: GPL-3.0-or-later
// What DO-229 and Niell share: values tabulated at 15, 30, 45, 60 and 75 deg of latitude, and a cosine of the day of year.
#ifndef ORR_SCENARIO_TROPOSPHERE_SEASON_PRIVATE_H
#define ORR_SCENARIO_TROPOSPHERE_SEASON_PRIVATE_H

#include "src/scenario/troposphere/atmosphere.h"

// Linear in |latitude|, held beyond 15 and 75 deg.
double orr_by_latitude(const double table[5], double lat_rad);
// cos(2 pi (day of year - phase_day) / 365.25), the day with its fraction, UTC.
double orr_season_cosine(orr_time t, double phase_day);

#endif
