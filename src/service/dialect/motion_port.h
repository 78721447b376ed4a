// SPDX-License-Identifier: GPL-3.0-or-later
// A UDP port that takes motion, served by a thread of its own: from this machine in a laboratory's dialect, from anywhere in datagrams of
// a client's channel (net/datagrams.h), which other machines seal.
#ifndef ORR_SERVICE_DIALECT_MOTION_PORT_H
#define ORR_SERVICE_DIALECT_MOTION_PORT_H

#include "core/status.h"
#include "src/service/dialect/dialect.h"
#include "src/service/live/streams.h"
#include "src/service/net/datagrams.h"

typedef struct orr_motion_port orr_motion_port;

// Listens; what comes before it is started waits.
// Given:
//   where      PORT of 127.0.0.1, or ADDRESS:PORT; port 0: any free one
//   dialect    how motion is told; of another machine's address that of frames alone
// Returned:
//   out        the port; close with orr_motion_port_close
//   diag       why it failed
// Errors: ORR_E_ARG (no address; a dialect that has no seal, beyond this machine), ORR_E_IO, ORR_E_MEMORY.
orr_status orr_motion_port_listen(const char *where, const orr_dialect *dialect, orr_motion_port **out,
                                  orr_diag *diag);
// Begins to take motion, into streams, and from the channels of clients, who are told the port by them; both must outlive it.
orr_status orr_motion_port_start(orr_motion_port *p, orr_streams *streams, orr_datagrams *datagrams,
                                 orr_diag *diag);
// ADDRESS:PORT as bound.
const char *orr_motion_port_where(const orr_motion_port *p);
void orr_motion_port_close(orr_motion_port *p); // NULL is allowed

#endif
