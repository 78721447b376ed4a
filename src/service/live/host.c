// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // CLOCK_BOOTTIME, CLOCK_TAI
#include <time.h>

#include "src/service/live/streams_private.h"

static int64_t ns_of(clockid_t clock)
{
    struct timespec ts;
    clock_gettime(clock, &ts);
    return (int64_t)ts.tv_sec * ORR_NS_PER_S + ts.tv_nsec;
}

orr_host streams_host(const orr_streams *s)
{
    orr_host h;
    if (s->options.host != NULL)
        s->options.host(s->options.host_user, &h);
    else
        h = (orr_host){ns_of(CLOCK_MONOTONIC), ns_of(CLOCK_BOOTTIME), ns_of(CLOCK_REALTIME),
                       ns_of(CLOCK_TAI)};
    return h;
}

int64_t streams_now_ns(const orr_streams *s)
{
    return s->options.host != NULL ? streams_host(s).mono_ns : ns_of(CLOCK_MONOTONIC);
}
