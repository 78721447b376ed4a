// SPDX-License-Identifier: GPL-3.0-or-later
// How a thread of blocks wakes the loop that sends them: by an eventfd, or at once where the loop is looking for it. Waking a thread that
// sleeps takes 20 us and more on a machine at rest, as much as making a block; looking for a moment spares that.
#ifndef ORR_SERVICE_SERVE_WAKE_H
#define ORR_SERVICE_SERVE_WAKE_H

#include <stdatomic.h>
#include <stdbool.h>

typedef struct orr_wake {
    int fd;               // readable when it was rung and nobody was looking; -1: not open
    atomic_bool rung;     // since it was last taken
    atomic_bool watched;  // the loop is looking
    bool alone;           // one processor: looking would hold up whoever is to ring
    unsigned vain, pause; // looks in a row that found nothing; how many are left out for that
} orr_wake;

// Opens it; false: no eventfd.
bool orr_wake_open(orr_wake *w);
// Closes it; one that was not opened may be closed if its fd is -1.
void orr_wake_close(orr_wake *w);
// Any thread: there is something to send.
void orr_wake_ring(orr_wake *w);
// The loop's thread: whether it was rung since the last time, and makes it silent.
bool orr_wake_take(orr_wake *w);
// The same, but looks for the ring for 100 us at most. After looks in vain it leaves out one, two, four and up to 32 of those that
// follow.
bool orr_wake_watch(orr_wake *w);

#endif
