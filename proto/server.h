// SPDX-License-Identifier: MIT
// The server's side of a conversation as a state machine over bytes: no socket, no clock, no allocation. It
// takes what has come in and what room there is for going out, and calls a table of handlers; it never knows
// who answers. Whoever owns the connections (src/service) moves the bytes.
#ifndef ORR_PROTO_SERVER_H
#define ORR_PROTO_SERVER_H

#include "proto/frame.h"
#include "proto/gen/messages.h"

#define ORR_SERVER_SENTENCE 256
#define ORR_SERVER_KEPT 2048 // bytes that a handler may keep of a frame under way

// A handler that refuses returns an ORR_MSG_ERROR_CODE_* and writes its sentence here.
typedef struct orr_server_refusal {
    char sentence[ORR_SERVER_SENTENCE];
} orr_server_refusal;

// One frame of an answer while it is made. A frame that takes long is made in pieces, so that others have
// their turn between two of them: a handler that finds its turn over after a piece returns with `more` set
// (orr_server_next_piece does both), and is called again for the same frame with `done` and `kept` as it left
// them and a writer that stands behind what it has written.
typedef struct orr_server_part {
    uint32_t index; // which frame of the answer, from 0
    uint32_t done;  // the handler's own count of finished pieces; 0 at the begin of a frame
    bool more;      // set by the handler: the frame is not finished; false at each call
    bool (*over)(void *owner);
    void *owner;
    double kept[ORR_SERVER_KEPT / sizeof(double)]; // the handler's own; of no meaning at the begin of a frame
} orr_server_part;

// Whether the time of this turn has been used. Asked after each piece, never before the first: a call always
// gets on.
static inline bool orr_server_turn_over(const orr_server_part *part)
{
    return part->over != NULL && part->over(part->owner);
}

// Counts a finished piece of a frame that has `all`. True when this call is to make another; otherwise the
// frame is finished, or the turn is over and `more` is set.
static inline bool orr_server_next_piece(orr_server_part *part, uint32_t all)
{
    part->done++;
    part->more = part->done < all && orr_server_turn_over(part);
    return part->done < all && !part->more;
}

// How one kind of request is answered: it is decoded once a turn and its handlers get the struct, whose lists
// and strings are borrowed until they return. begin (which may be NULL) looks at it; it is answered by one
// frame, or by one an epoch. The other encodes the payload of frame number part->index into w, as a pure
// function of (request, index), for it is called again from the frame's begin when the output was too small.
// Both return 0 or a code with a sentence in *why. A writer that is full is no error of theirs. A kind whose
// handler is NULL is refused with NOT_SERVED.
#include "proto/gen/handlers.h"

// Shared by all connections, read only. HELLO and PING are answered here. caps fills all but versions, limits
// and requests. `served`, which may be NULL, says of a request that has a handler whether there is anything to answer it with, and over
// which span (*span comes as "no instant"); the others are not among the requests of CAPS.
typedef struct orr_server {
    const orr_msg_handlers *handlers;
    void (*caps)(void *user, orr_msg_caps *caps);
    bool (*served)(void *user, uint16_t request, orr_msg_span *span);
    void *user;
    bool lanes; // its owner answers the messages of orr_msg_is_lane itself: CAPS lists them
} orr_server;

// One connection; zero-initialise.
typedef struct orr_server_conn {
    uint16_t
        access; // ORR_MSG_ACCESS bits, of its owner: told in CAPS; NO_READING refuses all that handlers answer
    bool can_grow; // its owner can make the output larger: step.room then asks for that
    // The owner's: whether the time that it gives to one call of orr_server_run has been used. NULL: no
    // limit.
    bool (*over)(void *owner);
    void *owner;
    uint32_t frames;      // of the answer under way; 0 when there is none
    orr_server_part part; // the frame of it that is next
    size_t unfinished;    // its bytes so far, behind the end of the output
    char client[100];     // "name version" as HELLO gave them, printable; empty before
    uint64_t requests, refusals;
} orr_server_conn;

typedef struct orr_server_step {
    size_t consumed; // bytes of the input that are done with
    size_t need; // the input must grow to so many bytes (counted from `consumed`) before there is more to do
    bool busy;   // stopped for want of room or time: call again with the rest of the input
    // With busy, if not 0: the output must have such a capacity, a frame did not fit into it empty
    size_t room;
    // With busy: the time of this turn has been used; serve others first. Otherwise call again once output has
    // been sent
    bool yield;
    uint16_t closing; // not 0: close the connection once the output is sent; an ORR_MSG_ERROR_CODE_*
    char reason[ORR_SERVER_SENTENCE];
} orr_server_step;

#define ORR_SERVER_OUT (ORR_FRAME_OVERHEAD + ORR_MSG_LARGEST)
// (I10) Answers as many complete requests as fit into the output and as there is time for, one piece of an answer
// at least.
//   Given:    s           the handlers
//             c           the connection
//             in, n       n bytes that have come and are not consumed yet
//   Returned: c           its state after this call
//             out         with the answers appended, whole frames only; it may hold bytes before
//             step        how much was consumed, and what is needed next
//   Notes:    of a frame that is not finished c->unfinished bytes stand behind the end of the output; who sends
//             and moves the output keeps them behind its end until the next call. The output's capacity must be
//             ORR_SERVER_OUT at least, or, of a connection that can grow, able to become that; otherwise an
//             answer may never fit.
void orr_server_run(const orr_server *s, orr_server_conn *c, const uint8_t *in, size_t n,
                    orr_wire_writer *out, orr_server_step *step);

// The payload of CAPS, as HELLO is answered with it; `access` as of orr_server_conn.
void orr_server_caps(const orr_server *s, uint16_t access, orr_wire_writer *out);
// One ERROR frame outside any request (time-outs, too many clients, shutting down): sequence 0.
void orr_server_error(orr_wire_writer *out, uint16_t code, const char *sentence);

#endif
