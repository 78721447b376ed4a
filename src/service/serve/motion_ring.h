// SPDX-License-Identifier: GPL-3.0-or-later
// Motion through shared memory: a ring that one client on this host writes, and an eventfd by which it says so. The memory is the server's
// and keeps its size; what stands in it is a peer's, as the bytes of any frame.
#ifndef ORR_SERVICE_SERVE_MOTION_RING_H
#define ORR_SERVICE_SERVE_MOTION_RING_H

#include <event2/event.h>

#include "src/service/live/ring_made.h"
#include "src/service/live/streams.h"

enum { ORR_MOTION_RING_SLOTS = 256, ORR_MOTION_RING_STRIDE = 256 };

typedef struct orr_motion_ring {
    orr_ring_made made;
    int bell; // an eventfd
    struct event *on_bell;
    orr_streams *streams;
    bool may; // its client may send motion
    uint64_t taken;
} orr_motion_ring;

// Makes one, which is read on the loop of `base`.
// Given:
//   base     of libevent
//   streams  what takes the samples; both must outlive the ring
// Returned:
//   out      the ring; close with orr_motion_ring_close
//   diag     why there is none
// Errors: ORR_E_IO, ORR_E_MEMORY.
orr_status orr_motion_ring_open(struct event_base *base, orr_streams *streams, orr_motion_ring **out,
                                orr_diag *diag);
void orr_motion_ring_close(orr_motion_ring *r); // NULL is allowed

#endif
