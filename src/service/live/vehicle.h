// SPDX-License-Identifier: GPL-3.0-or-later
// A body whose motion comes from outside: samples from the thread that reads connections, blocks by the thread that makes them, and
// what became of each sample.
#ifndef ORR_SERVICE_LIVE_VEHICLE_H
#define ORR_SERVICE_LIVE_VEHICLE_H

#include "core/status.h"
#include "proto/server.h"
#include "src/service/live/course.h"

typedef struct orr_vehicle orr_vehicle;

typedef struct orr_vehicle_options {
    double join_s;     // how long it takes to rejoin what is known; 0: jumps
    int64_t length_ns; // of blocks along live motion
    // Gets each sample as it was taken, for a recording; under the lock. May be NULL.
    void (*record)(void *user, const orr_msg_motion *m, orr_time from);
    void *record_user;
    // A recording to take the samples from, instead of connections: the next of it, with `from` as it was recorded. May be NULL.
    bool (*replay)(void *user, orr_msg_motion *m, orr_time *from);
    void *replay_user;
} orr_vehicle_options;

// Errors: ORR_E_ARG (a length that is not 1 to 100 ms, a join of more than 10 s), ORR_E_MEMORY. Free with orr_vehicle_close.
orr_status orr_vehicle_open(const orr_vehicle_options *options, orr_vehicle **out, orr_diag *diag);
void orr_vehicle_close(orr_vehicle *v); // NULL is allowed
// Length of its blocks.
int64_t orr_vehicle_length_ns(const orr_vehicle *v);

// Takes a sample at an instant of the scenario; ORR_TIME_NONE: its clock stands at its begin, and nothing is armed. Returns 0, or an
// ORR_MSG_ERROR_CODE and the sentence; counted in any case.
uint16_t orr_vehicle_take(orr_vehicle *v, const orr_msg_motion *m, orr_time now, orr_server_refusal *why);
// Tag of the last sample that was taken; ORR_TIME_NONE: none was.
orr_time orr_vehicle_reach(orr_vehicle *v);
// Motion at both ends of a block that is being made.
typedef struct orr_vehicle_block {
    orr_motion begin, end;
    bool antenna;  // of the antennas' point
    uint8_t state; // ORR_MSG_MOTION_STATE_*
    int64_t age_ns;
} orr_vehicle_block;
// False where there are no samples yet: the scenario's own motion holds.
bool orr_vehicle_block_at(orr_vehicle *v, orr_time t0, orr_time t1, orr_vehicle_block *out);
// State of the latest block in scenario's time that was made (ORR_MSG_MOTION_STATE_*), and its begin, which stays where none was.
uint8_t orr_vehicle_state(orr_vehicle *v, orr_time *begin);
// What became of the samples; lays down the worst state, and the counts where `reset` is set.
void orr_vehicle_stats(orr_vehicle *v, bool reset, orr_msg_motion_stats *out);

#endif
