// SPDX-License-Identifier: GPL-3.0-or-later
// Whose turn it is: of those who wait, the one that has used the least time so far. Who asks seldom and
// little is served after what is under way, however many others keep the processor busy; those share it
// evenly. No clock and no sockets: who uses it says what a turn has cost.
#ifndef ORR_SERVICE_TURNS_H
#define ORR_SERVICE_TURNS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// One that waits now and then; zero-initialise, then join.
typedef struct orr_turns_member {
    int64_t used;    // what its turns have cost, on the common scale
    uint64_t number; // order of arrival: of equals the first comes first
    size_t place;    // in the queue, from 1; 0: it does not wait
} orr_turns_member;

typedef struct orr_turns {
    orr_turns_member **heap; // the least used first
    size_t n, capacity, joined;
    int64_t floor; // what the last one served had used: nobody saves up more than `credit` below it
    int64_t credit;
    uint64_t arrivals;
} orr_turns;

// An empty queue; `credit` is what a member may have saved up against those who asked all the time.
void orr_turns_init(orr_turns *q, int64_t credit);
// Frees the queue; its members are their owners'.
void orr_turns_free(orr_turns *q);
// A member more, whose first turn comes soon. False: out of memory.
bool orr_turns_join(orr_turns *q, orr_turns_member *m);
// Takes a member out for good, waiting or not.
void orr_turns_leave(orr_turns *q, orr_turns_member *m);
// Waits for a turn; nothing where it waits already.
void orr_turns_wait(orr_turns *q, orr_turns_member *m);
// Takes the next one out of the queue; NULL where none waits.
orr_turns_member *orr_turns_next(orr_turns *q);
// Says what a turn has cost.
static inline void orr_turns_charge(orr_turns_member *m, int64_t cost) { m->used += cost; }

#endif
