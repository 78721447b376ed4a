// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of time, half open, so that neighbouring stretches add up.
#ifndef ORR_CORE_INTERVAL_H
#define ORR_CORE_INTERVAL_H

#include "core/time.h"

typedef struct orr_interval {
    orr_time from, to; // from <= t < to
} orr_interval;

// Whether from <= t < to.
static inline bool orr_interval_holds(orr_interval i, orr_time t) { return i.from <= t && t < i.to; }

#endif
