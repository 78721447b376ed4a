// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario's clock against what paces it: the wall's clock, or a generator that tells its elapsed time (RADIO_TIME). Plain
// numbers in, no clock read: what the host's clocks show comes from the caller, so that drifts, holes, steps and suspends are tested
// on simulated ones.
#ifndef ORR_SERVICE_LIVE_PACE_H
#define ORR_SERVICE_LIVE_PACE_H

#include "core/leap.h"
#include "proto/server.h"
#include "src/service/live/clock.h"

// What the host's clocks show at one moment, ns.
typedef struct orr_host {
    int64_t mono_ns; // CLOCK_MONOTONIC: stands during a suspend, is never set
    int64_t boot_ns; // CLOCK_BOOTTIME: goes on during a suspend
    int64_t real_ns; // CLOCK_REALTIME: Unix time, which somebody may set
    int64_t tai_ns;  // CLOCK_TAI
} orr_host;

// The generator's clock against the host's: its elapsed time at host_ns, and its rate.
typedef struct orr_radio {
    uint64_t samples;   // since the lock was last taken up
    int64_t host_ns;    // of the last sample
    int64_t elapsed_ns; // what the loop thinks that the generator showed then, and
    double fraction_ns; // the rest
    double rate;        // generator seconds a second of the host, less 1
    double error_ns;    // of the last sample against what was expected
    double square_ns2;  // of errors, averaged
    unsigned far;       // samples in a row that were far off
} orr_radio;

typedef struct orr_pace {
    orr_clock clock;   // what streams follow
    uint8_t reference; // ORR_MSG_CLOCK_REFERENCE_*
    orr_time begin;    // where STOP leads back to
    bool waits_pps;    // PPS0 is fixed, START is awaited
    orr_time pps0;     // instant of the scenario at PPS0; ORR_TIME_NONE: none
    int64_t pps0_ns;   // the reference's reading there: the generator's elapsed time, or the wall's instant
    int64_t start_ns;  // reading of the reference at which it starts, when it was told to
    orr_time start_t;  // and the instant that the scenario has then
    orr_radio radio;
    uint32_t steps, suspends, sets;
    bool has_host;
    orr_host host;              // last seen
    const orr_leap_table *leap; // NULL: the one built in
} orr_pace;

// Stopped at an instant.
void orr_pace_init(orr_pace *p, orr_time begin, const orr_leap_table *leap);
// Looks whether the host was suspended or its wall clock set since the last call; to be called a few times a second.
void orr_pace_host(orr_pace *p, const orr_host *h);
// CONTROL. Returns 0, or an ORR_MSG_ERROR_CODE and the sentence.
uint16_t orr_pace_control(orr_pace *p, const orr_host *h, const orr_msg_control *m, orr_server_refusal *why);
// RADIO_TIME: the loop gets a sample. Returns 0, or an ORR_MSG_ERROR_CODE and the sentence.
uint16_t orr_pace_radio(orr_pace *p, const orr_host *h, const orr_msg_radio_time *m, orr_server_refusal *why);
// The answer to RADIO_TIME; `made` is the instant of the last block that was made, ORR_TIME_NONE without any.
void orr_pace_told(const orr_pace *p, const orr_host *h, orr_time made, orr_msg_pace *m);
// What TIME says.
void orr_pace_time(const orr_pace *p, const orr_host *h, orr_msg_time *m);
// The clock's state (ORR_MSG_CLOCK_STATE_*) when it shows t.
uint8_t orr_pace_state(const orr_pace *p, orr_time t);
// How it stands with the generator when the host's clock shows now_ns: ORR_MSG_MODE_SILENT, LOCKED or STEPPING.
uint8_t orr_pace_lock(const orr_pace *p, int64_t now_ns);
// The wall's instant in the GPS scale.
orr_time orr_pace_wall(const orr_pace *p, const orr_host *h);
// Leap seconds around an instant. A change beyond the end of the table is not known.
orr_msg_leap_seconds orr_pace_leap(orr_time t, const orr_leap_table *table);

#endif
