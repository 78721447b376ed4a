// SPDX-License-Identifier: GPL-3.0-or-later
// A UDP port of this machine that takes motion in a laboratory's dialect, served by a thread of its own.
#ifndef ORR_SERVICE_DIALECT_MOTION_PORT_H
#define ORR_SERVICE_DIALECT_MOTION_PORT_H

#include "core/status.h"
#include "src/service/dialect/dialect.h"
#include "src/service/live/streams.h"

typedef struct orr_motion_port orr_motion_port;

// Listens on loopback alone.
// Given:
//   port     of UDP; 0: any free one
//   dialect  how motion is told
//   streams  what takes the samples; they must outlive the port
// Returned:
//   out      the port; close with orr_motion_port_close
//   diag     why it failed
// Errors: ORR_E_IO, ORR_E_MEMORY.
orr_status orr_motion_port_open(uint16_t port, const orr_dialect *dialect, orr_streams *streams,
                                orr_motion_port **out, orr_diag *diag);
// The port as bound.
uint16_t orr_motion_port_number(const orr_motion_port *p);
void orr_motion_port_close(orr_motion_port *p); // NULL is allowed

#endif
