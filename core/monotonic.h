// SPDX-License-Identifier: GPL-3.0-or-later
// How long something takes.
#ifndef ORR_CORE_MONOTONIC_H
#define ORR_CORE_MONOTONIC_H

#include <stdint.h>
#include <time.h>

// Seconds of the host's monotonic clock: only differences mean something.
static inline double orr_monotonic_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
// The same as nanoseconds.
static inline int64_t orr_monotonic_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

#endif
