// SPDX-License-Identifier: GPL-3.0-or-later
// The streams of a service. A thread of its own makes their blocks, by the handlers that answer polls but in a room of their own,
// so that a block is the poll's answer byte for byte; whoever owns the connections takes the blocks and sends them. Each stream
// has its cursor, its credit and a bounded queue: one that is not taken holds nobody up and ends with a reason.
#ifndef ORR_SERVICE_LIVE_STREAMS_H
#define ORR_SERVICE_LIVE_STREAMS_H

#include "core/status.h"
#include "proto/server.h"
#include "src/service/live/blocks.h"
#include "src/service/live/pace.h"
#include "src/service/live/vehicle.h"
#include "src/service/live/way.h"

enum {
    ORR_STREAM_QUEUE = 512,           // blocks that wait to be sent, at most
    ORR_STREAM_QUEUE_BYTES = 4 << 20, // and their bytes
    ORR_STREAM_QUEUE_FREE = 16,       // of one that is made as fast as it is taken
    ORR_STREAMS_MOST = 4096,
    ORR_STREAMS_RINGS = 32, // of them in shared memory
};
#define ORR_STREAM_GRACE_NS                                                                                  \
    INT64_C(500000000) // by which a block may be late before it is left out, or its stream ended

typedef struct orr_streams orr_streams;
typedef struct orr_stream orr_stream;

typedef struct orr_streams_options {
    // Makes the blocks; its user is the thread's alone. It must outlive the streams.
    const orr_server *maker;
    // Called by the thread when there is something to send (orr_streams_ready), without a lock held.
    void (*wake)(void *user);
    void *wake_user;
    // CONTROL LOAD of another scenario: its name, and where its clock is to stand (ORR_TIME_NONE: at its begin). Returns 0, or an
    // ORR_MSG_ERROR_CODE and the sentence. NULL: no others are loaded. Any thread calls it.
    uint16_t (*load)(void *user, const char *name, orr_time t, orr_server_refusal *why);
    void *load_user;
    // Told of a new stream whose first block may take long, with the maker's user; NULL: it is not.
    void (*expect)(void *user, uint16_t type, const orr_msg_any *request);
    void (*host)(void *user,
                 orr_host *out); // NULL: the machine's clocks. With it there is no thread: orr_streams_turn
    void *host_user;
    orr_time begin;             // where the scenario's clock stands at first
    orr_clock clock;            // unless it is stopped: the clock that goes on in its place
    const orr_leap_table *leap; // NULL: the one built in
    orr_vehicle *vehicle;       // that the maker's antennas ride on, borrowed; NULL: no motion is taken
    int priority;               // SCHED_FIFO of the thread; 0: an ordinary one
    int processor;              // that it runs on; negative: any
    bool lock_memory;           // all pages of the process stay in memory
} orr_streams_options;

// Prepares, and starts the thread. Errors: ORR_E_MEMORY; ORR_E_IO (the machine does not allow priority, processor or locked
// memory).
orr_status orr_streams_open(const orr_streams_options *options, orr_streams **out, orr_diag *diag);
// Ends the thread: no block is made and nobody woken after this.
void orr_streams_halt(orr_streams *s);
// Frees what orr_streams_open made. All streams must have been closed. NULL may be closed.
void orr_streams_close(orr_streams *s);

// Makes what is due, one block at most, when the host's clock shows now_ns. Returns when it should be called again at the latest:
// now_ns or earlier where there is more to do. For tests with clocks of their own; the thread calls it otherwise.
int64_t orr_streams_turn(orr_streams *s, int64_t now_ns);

// CONTROL, with its answer; 0 or an ORR_MSG_ERROR_CODE. Streams that follow the clock are looked at anew.
uint16_t orr_streams_control(orr_streams *s, const orr_msg_control *m, orr_msg_time *told,
                             orr_server_refusal *why);
// RADIO_TIME, likewise.
// Given:
//   s     the streams
//   m     what the generator tells
//   made  as of orr_pace_told
// Returned:
//   told  the answer
//   why   the sentence of a refusal
uint16_t orr_streams_radio(orr_streams *s, const orr_msg_radio_time *m, orr_time made, orr_msg_pace *told,
                           orr_server_refusal *why);
// MOTION: 0 or an ORR_MSG_ERROR_CODE. Blocks that are due are made with it.
uint16_t orr_streams_motion(orr_streams *s, const orr_msg_motion *m, orr_server_refusal *why);
// Whether motion has come since this was last asked that a stream's next block was waiting for, so that it is being made.
bool orr_streams_moved(orr_streams *s);
// GET_MOTION_STATS; false where no motion is taken.
bool orr_streams_motion_stats(orr_streams *s, bool reset, orr_msg_motion_stats *told);
// Where the scenario's clock begins (LOAD, `begin`).
orr_time orr_streams_begin(orr_streams *s);
// The clock itself, for streams that follow these (orr_streams_options.clock).
orr_clock orr_streams_clock(orr_streams *s);
// What TIME says.
void orr_streams_time(orr_streams *s, orr_msg_time *told);

// GET_MODES: appends the payload of MODES to w, which has room for ORR_MSG_MODES_LARGEST bytes.
void orr_streams_modes(orr_streams *s, uint64_t after, orr_wire_writer *w);

// Begins a stream.
// Given:
//   s       the streams
//   judge   refuses what cannot be asked, in the caller's thread
//   m       what is asked for
//   way     past the connection, that of m's DATAGRAMS, taken over in any case; NULL otherwise
//   owner   of orr_streams_ready
// Returned:
//   told    the answer
//   out     the stream; to be closed
//   why     the sentence of a refusal
// Returns 0 or an ORR_MSG_ERROR_CODE.
uint16_t orr_streams_subscribe(orr_streams *s, const orr_server *judge, const orr_msg_subscribe *m,
                               orr_way *way, void *owner, orr_msg_subscribed *told, orr_stream **out,
                               orr_server_refusal *why);
// The descriptor of the stream's ring, borrowed; -1: it has none.
int orr_stream_ring(const orr_stream *x);
// So many blocks more.
void orr_stream_credit(orr_stream *x, uint32_t blocks);
// Ends it as its client wishes: what waits is let go, STREAM_END comes next.
void orr_stream_end(orr_stream *x);
// Instant of its last block; ORR_TIME_NONE: none was made.
orr_time orr_stream_made(orr_stream *x);
// Forgets it, whatever waits.
void orr_stream_close(orr_stream *x);
// The owner of a stream that has something to send and was not told since it was last empty; NULL: none.
void *orr_streams_ready(orr_streams *s);
// What is next to be sent; NULL: nothing now. It is the caller's until orr_stream_sent. Behind a STREAM_END nothing comes.
orr_payload *orr_stream_next(orr_stream *x);
// Done with what orr_stream_next gave.
void orr_stream_sent(orr_stream *x, orr_payload *b);

// A stream as who watches the service sees it.
typedef struct orr_stream_look {
    uint16_t request; // message type that it repeats
    uint8_t pacing;   // ORR_MSG_PACING_*
    int64_t lead_ns;
    orr_time made;   // instant of the last block; ORR_TIME_NONE: none
    uint64_t blocks; // made
    uint64_t gaps;   // stretches of blocks that were left out
    uint64_t credit; // blocks that it may still send
    size_t waiting;  // blocks that are not taken
    int64_t
        margin_ns; // of the last block: from when it was made until it is on air; ORR_TIME_NONE: it follows no clock
    int64_t least_ns; // the least of all
} orr_stream_look;
// How a stream is at this moment; from any thread.
void orr_stream_looked(orr_stream *x, orr_stream_look *out);

#endif
