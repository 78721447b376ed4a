// SPDX-License-Identifier: GPL-3.0-or-later
// Between service.c (listening, time, signals) and connection.c (one client).
#ifndef ORR_SERVICE_SERVICE_PRIVATE_H
#define ORR_SERVICE_SERVICE_PRIVATE_H

#include <event2/event.h>

#include "src/service/service.h"

enum {
    ORR_CONN_OUT = 128 << 10, // output at first: many frames a write; grows up to one largest frame
    ORR_CONN_IN = 4096,       // input at first; grows up to one largest request
    ORR_CONN_TURNS = 8,       // output buffers filled before others have their turn
    ORR_CONN_TURN_NS = 200000,
};

typedef struct orr_conn orr_conn;

struct orr_service {
    orr_service_options options;
    const orr_server *server;
    const orr_log *log;
    struct event_base *base;
    struct listener *listener;
    size_t n_listeners;
    struct event *on_stop, *on_sweep, *on_int, *on_term;
    int stop_pipe[2];
    orr_conn *conns; // all, newest first
    int n_conns;
    bool draining;
    int64_t drain_until_ns;
};

int64_t orr_service_now_ns(void); // monotonic

// Takes the accepted socket over; it is closed if this fails.
void orr_conn_open(orr_service *s, int fd, const char *peer);
// Looks at the connection's deadline, closes it if that has passed.
void orr_conn_sweep(orr_conn *c, int64_t now_ns);
// No more requests: ends as soon as what is under way has been sent.
void orr_conn_drain(orr_conn *c, int64_t now_ns);
void orr_conn_close(orr_conn *c);
orr_conn *orr_conn_next(const orr_conn *c);

#endif
