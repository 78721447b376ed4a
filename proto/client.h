// SPDX-License-Identifier: MIT
// The client's side of a conversation, for a generator's firmware: C99 and libc alone, no allocation, no
// clock, no socket. The caller supplies read and write callbacks (a socket, a UART, a test's pipe) and one
// buffer.
//
//     orr_client c;
//     static uint8_t buffer[32768];
//     orr_client_init(&c, io, buffer, sizeof buffer);
//     orr_msg_poll poll = {.epochs = {t_ns, 0, 1}};           // no satellites named: all
//     if (orr_client_poll(&c, &poll) == ORR_WIRE_OK && orr_client_states(&c, &states) == ORR_WIRE_OK) {
//         orr_wire_iter it = {0};
//         while (orr_msg_sat_state_next(&states.satellites, &it, &sat)) use(&sat);
//     }
#ifndef ORR_PROTO_CLIENT_H
#define ORR_PROTO_CLIENT_H

#include "proto/frame.h"
#include "proto/gen/messages.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct orr_client_io {
    void *user;
    // Waits for at least one byte, reads at most n. Returns how many; 0 at the peer's end; negative on
    // failure or timeout.
    ptrdiff_t (*read)(void *user, uint8_t *data, size_t n);
    // Writes at least one byte of n. Returns how many; 0 or negative on failure.
    ptrdiff_t (*write)(void *user, const uint8_t *data, size_t n);
} orr_client_io;

#define ORR_CLIENT_SENTENCE 160

typedef struct orr_client {
    orr_client_io io;
    uint8_t *data;
    size_t capacity, size, used; // bytes of data that are filled; of the frame handed out last
    uint32_t sequence;           // of the last message sent
    uint32_t awaited;            // of the request whose answer is waited for
    uint32_t index, count;       // of its epochs: that of the next frame, and how many there are
    uint16_t error_code;         // after ORR_WIRE_REFUSED: ORR_MSG_ERROR_CODE_*
    char sentence[ORR_CLIENT_SENTENCE];
    // Gets each frame that comes while another one is waited for: those of streams (SUBSCRIBE), whose number is the
    // frame's sequence. It must not use the client. NULL: such frames are ORR_WIRE_UNEXPECTED.
    void (*stream)(void *user, const orr_frame *f);
    void *stream_user;
} orr_client;

// The buffer holds one frame at a time: ORR_FRAME_OVERHEAD plus the largest message that will be sent or
// received (ORR_MSG_..._LARGEST; a STATES of n satellites takes ORR_MSG_STATES_LARGEST -
// (ORR_MSG_MAX_SATELLITES - n) * ORR_MSG_SAT_STATE_SIZE). It must stay alive as long as the client.
void orr_client_init(orr_client *c, orr_client_io io, uint8_t *buffer, size_t capacity);

// What is asked and heard stands in proto/gen/verbs.h, one function a message. What is decoded borrows the
// buffer until the next call. Errors: ORR_WIRE_REFUSED (error_code, sentence), ORR_WIRE_SPACE, and those of
// frame and io; after any but REFUSED, SPACE on sending, and LIMIT the connection is of no more use.
//
// A buffer for NAVDATA: 32 GPS and 24 GLONASS satellites take ORR_FRAME_OVERHEAD + 33 KiB, each satellite at
// most 2 + ORR_MSG_SAT_NAVDATA_LARGEST. A POLL_DELAYS whose receiver_m is NAN, NAN, NAN asks for the
// scenario's own receiver.

// HELLO of this version, in short; the answer's CAPS borrow the buffer.
orr_wire_status orr_client_open(orr_client *c, const char *name, const char *version, orr_msg_caps *caps);
// PING in short: ORR_WIRE_UNEXPECTED where the answer's token is another.
orr_wire_status orr_client_check(orr_client *c, uint64_t token);

// What the verbs are made of. Begins a request of a type in the buffer: its payload is then encoded into *w, and
// *start is for orr_client_send.
void orr_client_begin(orr_client *c, uint16_t type, orr_wire_writer *w, size_t *start);
// Ends the request that begin started at *start and writes all of it. ORR_WIRE_SPACE (or what encoding met) where
// it did not fit, ORR_WIRE_IO.
orr_wire_status orr_client_send(orr_client *c, orr_wire_writer *w, size_t start);
// Waits for the next frame. ORR_WIRE_OK where it is of the type and answers the last request, REFUSED where it is
// an ERROR, UNEXPECTED otherwise, and the errors of frame and io. *f borrows the buffer until the next call.
orr_wire_status orr_client_answer(orr_client *c, uint16_t type, orr_frame *f);
// Waits for the next frame, whatever it is, and hands it out: who has streams looks at f->sequence and f->type, and decodes.
// ORR_WIRE_REFUSED for an ERROR that answers no request: the server is about to close.
orr_wire_status orr_client_next(orr_client *c, orr_frame *f);
// A request of epochs says how many frames it expects.
void orr_client_expect(orr_client *c, uint32_t count);
// (I11, I12) Compares a frame's index and count with what is due; ORR_WIRE_UNEXPECTED where they differ.
orr_wire_status orr_client_epoch(orr_client *c, uint32_t index, uint32_t count);

#ifdef __cplusplus
}
#endif

#include "proto/gen/verbs.h"

#endif
