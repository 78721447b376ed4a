// SPDX-License-Identifier: GPL-3.0-or-later
// A ring (proto/ring.h) in memory of its own, handed out as a descriptor: that of a stream can be read and not written, one of motion is
// written by its client.
#ifndef ORR_SERVICE_LIVE_RING_MADE_H
#define ORR_SERVICE_LIVE_RING_MADE_H

#include "core/status.h"
#include "proto/ring.h"
#include "src/service/live/way.h"

enum { ORR_RING_SLOTS = 128, ORR_RING_STRIDE = 64 << 10 }; // pages are taken as they are written

typedef struct orr_ring_made {
    orr_ring ring;
    int fd;
} orr_ring_made;

// Errors: ORR_E_IO, ORR_E_MEMORY. Free with orr_ring_made_close.
orr_status orr_ring_made_open(orr_ring_made *out, orr_diag *diag);
// Writes one message and wakes who waits for it (a futex on the low half of the ring's count). False where it is too large.
bool orr_ring_made_write(orr_ring_made *r, uint16_t type, const uint8_t *data, size_t size);
// A ring that the other side writes.
// Given:
//   slots   messages that it holds
//   stride  bytes of a slot, a multiple of 64
// Returned:
//   out     the ring, to be read by orr_ring_read; the memory tells nothing that is believed
//   diag    why there is none
// Errors: as orr_ring_made_open.
orr_status orr_ring_made_theirs(orr_ring_made *out, uint32_t slots, uint32_t stride, orr_diag *diag);
// A ring of its own as the way of a stream. Errors: as orr_ring_made_open.
orr_status orr_ring_way_open(orr_way **out, orr_diag *diag);
// Readers keep their own; *r is empty then.
void orr_ring_made_close(orr_ring_made *r);

#endif
