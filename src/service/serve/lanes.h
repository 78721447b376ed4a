// SPDX-License-Identifier: GPL-3.0-or-later
// The streams of one connection beside its requests: what its client says of them, and which of their frames goes out next.
#ifndef ORR_SERVICE_SERVE_LANES_H
#define ORR_SERVICE_SERVE_LANES_H

#include "src/config/access.h"
#include "src/service/live/streams.h"
#include "src/service/serve/datagram_lane.h"
#include "src/service/serve/motion_ring.h"

enum { ORR_LANES_MOST = 32, ORR_LANES_ENDED = 64 };

// Zero-initialise but for the first five and the first two of `datagrams`.
typedef struct orr_lanes {
    orr_streams *streams;
    const orr_server *judge;
    void *owner;  // of the streams: the connection
    unsigned may; // orr_may: what else is asked is refused
    orr_datagram_lane datagrams;
    bool passes; // descriptors can go along with bytes: a Unix socket
    int pass
        [ORR_LINK_PASSES]; // descriptors that are to go along with the frame that was put last; whoever sends it calls orr_lanes_passed
    size_t n_pass;
    struct event_base *base; // of the loop that reads its ring of motion
    orr_motion_ring *motion; // NULL: it has none
    orr_stream *stream[ORR_LANES_MOST];
    uint32_t id[ORR_LANES_MOST];
    orr_payload *held[ORR_LANES_MOST]; // taken, and there was no room for it
    size_t n, next;
    uint32_t ended[ORR_LANES_ENDED]; // the last of them
    size_t n_ended;
} orr_lanes;

// Takes a message of those that orr_msg_is_lane tells; what is to be said at once goes into out, whole frames only. False: there
// was no room for that; try again with more.
bool orr_lanes_take(orr_lanes *l, const orr_frame *f, orr_wire_writer *out);
// Appends frames of the streams, each in its turn, as long as there is room. Returns 0, or how many bytes the next one needs.
size_t orr_lanes_fill(orr_lanes *l, orr_wire_writer *out);
// The descriptors that were to go along have gone, or need not any more.
void orr_lanes_passed(orr_lanes *l);
// Whether any of its streams has something to send, or credit for it.
bool orr_lanes_can_go_on(const orr_lanes *l);
// What its client may do from now on.
void orr_lanes_permit(orr_lanes *l, unsigned may);
// Closes all streams and its channel of datagrams.
void orr_lanes_close(orr_lanes *l);

#endif
