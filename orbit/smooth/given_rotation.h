// SPDX-License-Identifier: GPL-3.0-or-later
// What a given series of Earth rotation says of the positions: all, something (its ends are carried on), or nothing. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_GIVEN_ROTATION_H
#define ORR_ORBIT_SMOOTH_GIVEN_ROTATION_H

#include "core/astro.h"
#include "core/status.h"

typedef enum orr_given_rotation {
    ORR_GIVEN_COVERS,       // two values are there for every instant, three days apart at most
    ORR_GIVEN_CARRIED_ON,   // some instants lie beyond its ends, or in a gap
    ORR_GIVEN_SAYS_NOTHING, // by more than thirty days
} orr_given_rotation;

// What a series says of a span. The pole goes 3 mas a day and its slope is carried on for ten days: after thirty it is as
// wrong as the secular pole, which is 50 to 200 mas off.
// Given:
//   eop       the series, with two entries at least
//   from, to  the span
// Returned:
//   text      [n] in words where the series has its values, or its gap, and where the positions are
//   value     what it says of the span
orr_given_rotation orr_given_rotation_of(const orr_eop_series *eop, orr_time from, orr_time to, char *text,
                                         size_t n);

#endif
