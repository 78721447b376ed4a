// SPDX-License-Identifier: GPL-3.0-or-later
// The one face of the engine's sources (orbits, broadcast data, ionosphere, motion): each is opened from the
// scenario (*out stays NULL where the scenario does not have it), tells the stretch of time that it covers,
// is evaluated at instants, and is closed. Every function of a source takes NULL for one that is not there.
#ifndef ORR_SCENARIO_SOURCE_H
#define ORR_SCENARIO_SOURCE_H

#include "core/time.h"

// Whether there are numbers, and if not, why not. The wire's `answer` has the same values.
typedef enum orr_answer {
    ORR_ANSWER_OK = 0,
    ORR_ANSWER_OUTSIDE_SPAN = 1,  // the instant is outside the span
    ORR_ANSWER_NO_ARC = 2,        // the satellite has no valid arc at the instant
    ORR_ANSWER_NOT_SERVED = 3,    // the satellite is not in the product, or the scenario has no such source
    ORR_ANSWER_BELOW_HORIZON = 4, // the receiver does not see the satellite
    ORR_ANSWER_NO_VALUE = 5, // a hole in the ionosphere's maps; an arc too short for the method; a value that
                             // does not fit its field
} orr_answer;

// What a source covers; both ends belong to it.
typedef struct orr_span {
    orr_time from, to;
} orr_span;

// Whether an instant is within; both ends are.
static inline bool orr_span_holds(orr_span s, orr_time t) { return s.from <= t && t <= s.to; }

#endif
