// SPDX-License-Identifier: GPL-3.0-or-later
// A client's end of datagrams, beside its connection: a port for the datagrams of one stream, and motion to the server. Over TLS both are
// sealed by keys that either end takes from the session itself.
#ifndef ORR_SERVICE_NET_DIAL_PORT_H
#define ORR_SERVICE_NET_DIAL_PORT_H

#include "proto/datagram.h"
#include "src/service/net/dial.h"

typedef struct orr_dial_port orr_dial_port;

// Asks for the connection's channel, and opens a port at the address by which the connection goes.
// Given:
//   d     the connection, which must outlive the port; its client is used
// Returned:
//   out   the port; close with orr_dial_port_close
//   diag  why there is none
// Errors: ORR_E_IO, ORR_E_ARG (the server refuses), ORR_E_FORMAT (its keys are not those of the session), ORR_E_MEMORY.
orr_status orr_dial_port_open(orr_dial *d, orr_dial_port **out, orr_diag *diag);
void orr_dial_port_close(orr_dial_port *p); // NULL is allowed
// The number of the port, for SUBSCRIBE.
uint16_t orr_dial_port_number(const orr_dial_port *p);
// The channel that SUBSCRIBED named: its datagrams are taken from now on.
void orr_dial_port_take_up(orr_dial_port *p, uint32_t channel);
// What came next.
typedef enum orr_dial_port_what {
    ORR_DIAL_PORT_NOTHING,    // in time
    ORR_DIAL_PORT_DATAGRAM,   // a new frame of the channel
    ORR_DIAL_PORT_CONNECTION, // a frame of the connection
    ORR_DIAL_PORT_FAILED,     // of it, or its end
} orr_dial_port_what;
// Waits for a frame, by whichever way.
// Given:
//   p           the port
//   timeout_ms  how long
// Returned:
//   f           the frame, which borrows until the next call
//   status      of the connection, where that failed
orr_dial_port_what orr_dial_port_next(orr_dial_port *p, int timeout_ms, orr_frame *f,
                                      orr_wire_status *status);
// What has come, and what has not.
const orr_datagram_reader *orr_dial_port_reader(const orr_dial_port *p);
// Sends a sample in the connection's channel. ORR_E_IO; ORR_E_ARG where the server takes none.
orr_status orr_dial_port_motion(orr_dial_port *p, const orr_msg_motion *m, orr_diag *diag);

#endif
