// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario's clock: which instant of the scenario it is at a reading of the host's monotonic clock. Plain numbers: who uses
// it says what the host's clock shows, so that all of it runs on simulated clocks.
#ifndef ORR_SERVICE_LIVE_CLOCK_H
#define ORR_SERVICE_LIVE_CLOCK_H

#include "core/time.h"

typedef enum orr_clock_state {
    ORR_CLOCK_STOPPED, // it shows the instant at which it will begin
    ORR_CLOCK_ARMED,   // likewise; a start is awaited
    ORR_CLOCK_RUNNING,
    ORR_CLOCK_PAUSED, // it shows the instant at which it was stopped
} orr_clock_state;

typedef struct orr_clock {
    orr_clock_state state;
    int64_t host_ns; // a reading of the host's clock, while it runs,
    orr_time t;      // and the instant that the scenario has then
    double drift;    // scenario seconds a second of the host, less 1
} orr_clock;

// The scenario's instant when the host's clock shows host_ns.
orr_time orr_clock_at(const orr_clock *c, int64_t host_ns);
// What the host's clock shows at an instant of the scenario; INT64_MAX where it does not run.
int64_t orr_clock_when(const orr_clock *c, orr_time t);
// Starts it: instant t is at host_ns, which may be to come (until then it counts down).
void orr_clock_start(orr_clock *c, int64_t host_ns, orr_time t);
// Stops it where it is; it goes on from there when it is started.
void orr_clock_pause(orr_clock *c, int64_t host_ns);

#endif
