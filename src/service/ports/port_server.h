// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers' ports live: what an antenna's receiver puts out at each epoch of the scenario's clock, for every client that connects; RTCM also as the one
// mountpoint of an NTRIP caster. A thread of its own serves them all, for clients by the same rules as the service's.
#ifndef ORR_SERVICE_PORTS_PORT_SERVER_H
#define ORR_SERVICE_PORTS_PORT_SERVER_H

#include "core/log.h"
#include "src/scenario/receiver/port.h"
#include "src/service/live/streams.h"
#include "src/service/net/access.h"

enum {
    ORR_PORT_SOURCES = 16,
    ORR_PORT_WAITING = 256 << 10, // bytes that wait for a client at most
    ORR_PORT_PATIENCE_S = 5,      // how long it may take none of them
};

// One of them.
typedef struct orr_port_source {
    orr_port_plan plan;
    const char *url;   // tcp://HOST:PORT, tls://HOST:PORT or unix:PATH
    const char *mount; // the caster's mountpoint; NULL: no NTRIP, bytes at once
    int64_t step_ns;   // epochs lie on multiples of it
    bool noise;
    uint64_t seed;
} orr_port_source;

typedef struct orr_port_server_options {
    const orr_port_source *source; // [n], copied with their texts
    size_t n;
    const char *login;    // "user:password" that NTRIP clients have to give, copied; NULL: none
    orr_streams *streams; // whose clock goes, borrowed
    orr_access *access;   // who may come in, borrowed
    const orr_log *log;   // borrowed
} orr_port_server_options;

typedef struct orr_port_server orr_port_server;

// Listens and serves until it is closed.
// Given:
//   options  sources and what they go by
// Returned:
//   out      the server; close with orr_port_server_close
//   diag     why it failed
// Errors: ORR_E_ARG (no address, one that the rules do not allow, a mountpoint's name), ORR_E_IO (an address in use), ORR_E_LIMIT, ORR_E_MEMORY.
// Notes: a client that takes nothing for 5 s, or for which 256 KiB wait, is closed, and the log says so; so is one of NTRIP that does not finish its request
// in the access rules' first_s. Epochs are made from the first multiple of the step on that the clock comes to; where it jumps, arcs begin anew.
orr_status orr_port_server_open(const orr_port_server_options *options, orr_port_server **out,
                                orr_diag *diag);
// The address of source k as bound; of a caster with the mountpoint behind it. NULL beyond the last.
const char *orr_port_server_url(const orr_port_server *s, size_t k);
void orr_port_server_close(orr_port_server *s); // NULL is allowed

#endif
