// SPDX-License-Identifier: MIT
// The server's side of a conversation as a state machine over bytes: no socket, no clock, no allocation. It
// takes what has come in and what room there is for going out, and calls a table of handlers; it never knows
// who answers. Whoever owns the connections (src/service) moves the bytes.
#ifndef ORR_PROTO_SERVER_H
#define ORR_PROTO_SERVER_H

#include "proto/frame.h"
#include "proto/gen/messages.h"

#define ORR_SERVER_SENTENCE 256

// A handler that refuses returns an ORR_MSG_ERROR_CODE_* and writes its sentence here.
typedef struct orr_server_refusal {
    char sentence[ORR_SERVER_SENTENCE];
} orr_server_refusal;

// How one kind of request is answered: begin looks at it and says how many frames will answer (at least 1);
// answer encodes the payload of frame number `index` into w, as a pure function of (request, index), for it
// is called again when the output was too small. Both return 0 or a code with a sentence in *why. A writer
// that is full is no error of theirs.
typedef struct orr_server_route {
    uint16_t request, reply; // ORR_MSG_TYPE_*
    uint16_t (*begin)(void *user, const orr_frame *request, uint32_t *frames, orr_server_refusal *why);
    uint16_t (*answer)(void *user, const orr_frame *request, uint32_t index, orr_wire_writer *w,
                       orr_server_refusal *why);
    bool slow; // a frame may take milliseconds: only one is made at a time, so that others have their turn
} orr_server_route;

// Shared by all connections, read only. HELLO and PING are answered here. caps fills all but versions, limits
// and requests. `served`, which may be NULL, says of a route whether it has anything to answer with, and over
// which span (*span comes as "no instant"); the others are not among the requests of CAPS.
typedef struct orr_server {
    const orr_server_route *route;
    size_t n_routes;
    void (*caps)(void *user, orr_msg_caps *caps);
    bool (*served)(void *user, uint16_t request, orr_msg_span *span);
    void *user;
} orr_server;

// One connection; zero-initialise.
typedef struct orr_server_conn {
    bool can_grow;          // its owner can make the output larger: step.room then asks for that
    uint32_t index, frames; // of the answer under way; frames is 0 when there is none
    char client[100];       // "name version" as HELLO gave them, printable; empty before
    uint64_t requests, refusals;
} orr_server_conn;

typedef struct orr_server_step {
    size_t consumed; // bytes of the input that are done with
    size_t need; // the input must grow to so many bytes (counted from `consumed`) before there is more to do
    bool busy;   // stopped for want of room: call again with the rest of the input once output has been sent
    // With busy, if not 0: the output must have such a capacity, a frame did not fit into it empty
    size_t room;
    bool yield;       // with busy: stopped after a frame of a slow kind; serve others first
    uint16_t closing; // not 0: close the connection once the output is sent; an ORR_MSG_ERROR_CODE_*
    char reason[ORR_SERVER_SENTENCE];
} orr_server_step;

// Answers as many complete requests of in[0..n) as fit into `out` (which may already hold bytes; whole frames
// only are appended). The output's capacity must be ORR_SERVER_OUT at least, or, of a connection that can
// grow, able to become that; otherwise an answer may never fit.
#define ORR_SERVER_OUT (ORR_FRAME_OVERHEAD + ORR_MSG_LARGEST)
void orr_server_run(const orr_server *s, orr_server_conn *c, const uint8_t *in, size_t n,
                    orr_wire_writer *out, orr_server_step *step);

// One ERROR frame outside any request (time-outs, too many clients, shutting down): sequence 0.
void orr_server_error(orr_wire_writer *out, uint16_t code, const char *sentence);

#endif
