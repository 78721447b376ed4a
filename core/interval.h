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

// Whether it begins or ends after `after` and not after `until`.
static inline bool orr_interval_turns(orr_interval i, orr_time after, orr_time until)
{
    return (after < i.from && i.from <= until) || (after < i.to && i.to <= until);
}
// Whether an instant is a multiple of step_ns, if it lies in `within`.
static inline bool orr_instant_fits(orr_time t, orr_interval within, int64_t step_ns)
{
    return !orr_interval_holds(within, t) || t % step_ns == 0;
}
// The same of an interval's begin and end.
static inline bool orr_interval_fits(orr_interval i, orr_interval within, int64_t step_ns)
{
    return orr_instant_fits(i.from, within, step_ns) && orr_instant_fits(i.to, within, step_ns);
}

#endif
