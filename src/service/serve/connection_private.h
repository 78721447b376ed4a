// SPDX-License-Identifier: GPL-3.0-or-later
// One connection, between its buffers of output (connection_out.c), what it does (connection.c), and those who look at it from outside
// (connection_watch.c).
#ifndef ORR_SERVICE_SERVE_CONNECTION_PRIVATE_H
#define ORR_SERVICE_SERVE_CONNECTION_PRIVATE_H

#include "src/service/serve/lanes.h"
#include "src/service/serve/service_private.h"

typedef enum conn_state {
    CONN_OPEN,
    CONN_ENDING, // no more requests; closes its side when the output is sent
    CONN_LINGER, // its side is closed; waits for the peer's end, so that what was sent is not lost by a reset
} conn_state;

// Whole frames that wait to be sent, from `at` on.
typedef struct output {
    uint8_t *data;
    size_t at, size, capacity;
} output;

struct orr_conn {
    orr_turns_member turn; // first, so that the member is the connection
    orr_service *service;
    orr_link *link;
    orr_guest guest;
    conn_state state;
    bool peer_done; // the peer will send nothing more
    orr_server_conn conn;
    uint8_t *in;
    size_t in_size, in_capacity;
    size_t looked;   // bytes of the input in which messages of lanes have been looked for
    output out;      // answers; the begin of a frame that is not finished stands behind its end
    output lane;     // frames of streams
    bool stuck;      // behind `looked` stands a message of lanes for whose answer there was no room
    bool lane_more;  // its streams may have more than one write should hold
    size_t pass_at;  // where in `lane` the frame begins that a descriptor goes along with
    bool lane_first; // which of the two is sent next; what has been begun goes first
    orr_lanes lanes;
    bool busy;  // an answer is not finished
    bool fresh; // bytes have come that the server has not seen
    bool yield; // and takes long: others come first
    bool half;  // the input holds the beginning of a frame
    bool joined, counted;
    orr_allowance requests;                // of its own, beside its address's
    uint64_t charged;                      // requests that have been taken from both
    uint64_t told_requests, told_refusals; // that the service's totals have
    int64_t held_until_ns; // it has asked more than it may: until then it waits. 0: it has not
    bool wants_write;
    int64_t turn_ends_ns;
    int64_t since_ns; // what the deadline counts from
    int64_t last_ns;  // last complete request
    orr_conn *next, *prev;
};

// Whether frames wait in a buffer.
bool conn_waits(const output *o);
// Makes a buffer larger; false, and nothing, where there is no memory.
bool conn_grow(uint8_t **data, size_t *capacity, size_t need);
// Sends what the socket takes of one buffer: 1: all, 0: not all, -1: the connection is lost.
int conn_send_some(orr_conn *c, output *o);
// Takes frames of the streams while nothing of them waits. False: out of memory for a large one, whose turn it then never is.
bool conn_fill_lane(orr_conn *c);

// Whether anything waits to be sent, in TLS too.
bool conn_has_output(const orr_conn *c);
// Nothing is under way: all that was asked is answered and sent.
bool conn_at_rest(const orr_conn *c);
// Puts an ERROR behind the output, if there is room, and ends.
void conn_end_with(orr_conn *c, uint16_t code, const char *sentence);
// Ends it because the server does.
void conn_shut_down(orr_conn *c);
// What to wait for next; also closes when all is done. The connection may be gone afterwards.
void conn_settle(orr_conn *c);
// Sends, and settles. It may be gone afterwards.
void conn_go_on(orr_conn *c);

#endif
