// SPDX-License-Identifier: GPL-3.0-or-later
// Streams between what clients do to them (streams.c), what is made when (schedule.c) and what waits (queue.c).
#ifndef ORR_SERVICE_LIVE_STREAMS_PRIVATE_H
#define ORR_SERVICE_LIVE_STREAMS_PRIVATE_H

#include <pthread.h>
#include <stdatomic.h>

#include "src/service/live/modes.h"
#include "src/service/live/streams.h"

struct orr_stream {
    orr_streams *all;
    void *owner;
    // What it asks for: does not change.
    uint16_t type;
    uint8_t pacing;
    int64_t lead_ns, step_ns;
    orr_msg_any request;    // its lists borrow `poll`; its epochs are the thread's
    orr_msg_epochs *epochs; // NULL: of GET_MODES
    uint8_t *poll;
    size_t poll_size;
    orr_time last; // of the span
    orr_way *way;  // NULL: blocks wait in the queue
    // Where it is: under the lock.
    orr_time next;
    uint64_t left; // blocks; UINT64_MAX: no end
    uint64_t credit;
    orr_time made;  // instant of the last block; ORR_TIME_NONE: none
    uint64_t known; // of GET_MODES: number of the last change that it was told
    bool dry;       // it had no credit when a block was due
    uint64_t blocks, gaps;
    int64_t margin_ns, least_ns; // as of orr_stream_look
    bool ended, closed, making;
    orr_payload *queue[ORR_STREAM_QUEUE + 2]; // two more for a GAP and the STREAM_END
    size_t head, n, bytes;
    bool listed;        // among those that are ready
    orr_stream *follow; // there
};

struct orr_streams {
    orr_streams_options options;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    pthread_t thread;
    bool has_thread, stop;
    bool told;          // something has been listed since the last wake
    bool changed_since; // something that the thread waits for, since it last looked
    atomic_bool moved;  // as of orr_streams_moved
    orr_pace pace;
    int64_t looked_ns; // when the host's clocks were compared last
    orr_modes modes;
    orr_payloads payloads;
    orr_stream **stream; // all that are not closed, and closed ones that are being made
    size_t n_rings;
    size_t n, turn; // turn: of the streams that are made as fast as they are taken
    orr_stream *ready, *ready_last;
    // The thread's own: room for a block, and the last one with what was asked, for streams that ask for the same.
    uint8_t *room;
    orr_payload *made;
    uint16_t made_type;
    orr_msg_epochs made_epochs;
    uint8_t *made_poll;
    size_t made_size;
};

// What the machine's clocks show, or the caller's host instead (host.c).
orr_host streams_host(const orr_streams *s);
// The monotonic one of them alone.
int64_t streams_now_ns(const orr_streams *s);

// All of these under the lock (queue.c). Puts a payload behind a stream's queue and lists the stream; takes the owner's part.
void streams_push(orr_stream *x, orr_payload *b);
// The first of the queue, which is not empty.
orr_payload *streams_pop(orr_stream *x);
// Takes a stream out of the list of those that are ready.
void streams_unlist(orr_stream *x);
// Ends a stream: its last frame.
void streams_finish(orr_stream *x, uint8_t reason, const char *sentence);
// Looks which modes clock and motion are in when the host's clock shows now_ns (streams_modes.c).
void streams_note_modes(orr_streams *s, int64_t now_ns);
// Begins a stream of GET_MODES, which nobody else knows yet; takes the lock itself.
void streams_begin_modes(orr_streams *s, orr_stream *x);
// Whether a stream of GET_MODES has something to tell.
bool streams_has_modes(const orr_stream *x);
// Tells it; by the thread.
void streams_make_modes(orr_stream *x);
// Whether a stream's next block waits for nothing any more since motion has come (schedule.c).
bool streams_follow_motion(const orr_streams *s);
// Takes a stream out and frees it.
void streams_forget(orr_stream *x);
// Frees one that was never in.
void streams_free(orr_stream *x);

#endif
