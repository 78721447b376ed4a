// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/clock.h"

#include <math.h>

// Differences stay below 2^62 ns (146 years): clocks and scenarios do.
orr_time orr_clock_at(const orr_clock *c, int64_t host_ns)
{
    if (c->state != ORR_CLOCK_RUNNING) return c->t;
    const int64_t d = host_ns - c->host_ns;
    return orr_time_add(c->t, d + llround((double)d * c->drift));
}

int64_t orr_clock_when(const orr_clock *c, orr_time t)
{
    if (c->state != ORR_CLOCK_RUNNING) return INT64_MAX;
    int64_t d;
    if (__builtin_sub_overflow(t, c->t, &d)) return t > c->t ? INT64_MAX : INT64_MIN;
    const double less = (double)d * (c->drift / (1 + c->drift));
    return orr_time_add(c->host_ns, d - llround(less));
}

void orr_clock_start(orr_clock *c, int64_t host_ns, orr_time t)
{
    *c = (orr_clock){.state = ORR_CLOCK_RUNNING, .host_ns = host_ns, .t = t, .drift = c->drift};
}

void orr_clock_pause(orr_clock *c, int64_t host_ns)
{
    c->t = orr_clock_at(c, host_ns);
    c->state = ORR_CLOCK_PAUSED;
}
