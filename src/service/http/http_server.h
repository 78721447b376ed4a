// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP for people and monitors beside the protocol: a table of paths, each with what answers it, on a thread of its own that gives way to
// those that serve and stream. Reading alone (GET and HEAD), on this machine alone; a request whose Host or Origin is another's is
// refused, so that no page of the web reads through a visitor's browser.
#ifndef ORR_SERVICE_HTTP_HTTP_SERVER_H
#define ORR_SERVICE_HTTP_HTTP_SERVER_H

#include <stdint.h>
#include <stdio.h>

#include "core/status.h"

enum { ORR_HTTP_LISTENERS = 16 }; // of server-sent events at once; one more is told 503

// What is asked of a route.
typedef struct orr_http_ask {
    const char *query; // behind '?', decoded; "" without
    uint64_t seen;     // of server-sent events the route's own memory of this listener, 0 at first
} orr_http_ask;

// One path and what answers it.
typedef struct orr_http_route {
    const char *path; // "/metrics"
    const char *type; // Content-Type; of server-sent events it is text/event-stream
    double every_s;   // 0: answered once. Otherwise server-sent events: asked so often for each listener
    // Prints the answer, or the events since the last time, and returns the status, 200 for a good one. Called on the server's
    // thread alone.
    int (*answer)(void *user, orr_http_ask *ask, FILE *out);
    void *user;
} orr_http_route;

typedef struct orr_http_server orr_http_server;

// Listens; who connects before it serves waits.
// Given:
//   address   "127.0.0.1:8080", "[::1]:0", "localhost:8080" or ":8080"
// Returned:
//   out       the server; close with orr_http_server_close
//   diag      why it failed
// Errors: ORR_E_ARG (no address, or one that other machines reach), ORR_E_IO (a port in use), ORR_E_MEMORY.
orr_status orr_http_server_listen(const char *address, orr_http_server **out, orr_diag *diag);
// Serves n paths until it is closed; the table is copied, its texts and users are borrowed. Errors: ORR_E_IO, ORR_E_MEMORY.
orr_status orr_http_server_start(orr_http_server *s, const orr_http_route *route, size_t n, orr_diag *diag);
// Where the first path is, "http://127.0.0.1:8080/"; port 0 has become a real one.
const char *orr_http_server_url(const orr_http_server *s);
// Ends the thread and all connections; NULL is allowed.
void orr_http_server_close(orr_http_server *s);

// Whether a Host header, or what stands behind "http://" in an Origin header, names this machine's loopback at the port: 127.0.0.1, [::1]
// or localhost.
bool orr_http_is_own(const char *host, uint16_t port);

#endif
