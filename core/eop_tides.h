// SPDX-License-Identifier: GPL-3.0-or-later
// Tides of the Earth's rotation (IERS Conventions 2010, chapter 8): what daily Earth-orientation data do not
// hold (ocean tides, twice a day and daily) and what a smooth curve through days cannot follow (zonal tides
// of UT1).
#ifndef ORR_CORE_EOP_TIDES_H
#define ORR_CORE_EOP_TIDES_H

#include "core/time.h"

typedef struct orr_eop_tides {
    double xp_rad, yp_rad, ut1_s;
} orr_eop_tides;

// Ocean tides in pole and UT1 with periods about a day and half a day, to be added to daily values:
// tables 8.2 and 8.3, 71 terms. Up to 1 mas and 0.1 ms.
orr_eop_tides orr_eop_tides_subdaily(orr_time t);
// UT1 by zonal tides with periods up to 35 days, s: table 8.1, 41 terms. Up to 2.5 ms. Published series hold
// it.
double orr_eop_tides_zonal_ut1(orr_time t);

#endif
