// SPDX-License-Identifier: GPL-3.0-or-later
// Multiple signal messages of RTCM 3, MSM4 and MSM7: observations of one system at one epoch as bits (RTCM 10403.3, 3.5.16).
#ifndef ORR_SCENARIO_RECEIVER_MSM_H
#define ORR_SCENARIO_RECEIVER_MSM_H

#include "core/signal.h"
#include "core/time.h"
#include "orbit/navdata/rtcm_frame.h"

// One signal of one satellite.
typedef struct orr_msm_cell {
    orr_sat sat;
    uint8_t satellite, signal; // DF394's and DF395's number, from 1
    int8_t channel;            // of GLONASS; told by MSM7 alone
    double code_m;
    double phase_m;  // phase range, within 1000 m of the code; NAN: not told
    double rate_mps; // of the phase range
    double cn0_dbhz;
    int64_t lock_ms; // how long it has been tracked without a slip
} orr_msm_cell;

typedef struct orr_msm_head {
    int msm;          // 4 or 7
    unsigned station; // DF003
    uint32_t epoch;   // the 30 bits of the system's own time (orr_msm_epoch)
    bool more;        // messages of the same epoch follow, of this station (DF393)
} orr_msm_head;

// Number of the satellite in DF394, from 1; 0 where it has none.
int orr_msm_satellite(orr_sat sat);
// Number of a signal in DF395, from 1; 0 where it has none.
int orr_msm_signal(const orr_signal *s);
// Number of a system's message (1077 for 'G' and 7).
int orr_msm_number(char system, int msm);
// An epoch in a system's own time: milliseconds of its week, of GLONASS day of the week and milliseconds of the day in Moscow.
uint32_t orr_msm_epoch(char system, orr_time t, const orr_leap_table *leap);

// Encodes as many satellites as one message holds: 64 cells of satellites times signals.
// Given:
//   h        head; `more` is set besides where cells are left
//   cell, n  of one system, by satellite and signal; at least one
// Returned:
//   frame    the message
// Returns how many cells it holds: whole satellites, at least one of them.
// Notes: what a field cannot hold is sent as its "not valid": codes of a satellite that differ by more than 146 m from their
// middle, ranges beyond 254 ms.
size_t orr_msm_encode(const orr_msm_head *h, const orr_msm_cell *cell, size_t n, orr_rtcm_frame *frame);

// Lock time indicators: of MSM4 (DF402, 4 bits) and of MSM7 (DF407, 10 bits).
unsigned orr_msm_lock4(int64_t lock_ms);
// DF407.
unsigned orr_msm_lock7(int64_t lock_ms);

#endif
