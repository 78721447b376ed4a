// SPDX-License-Identifier: GPL-3.0-or-later
// A libevent loop that any thread can stop, and the thread that runs it where it has one of its own.
#ifndef ORR_SERVICE_NET_LOOP_H
#define ORR_SERVICE_NET_LOOP_H

#include <event2/event.h>
#include <pthread.h>
#include <stdbool.h>

#include "core/status.h"

// Zero-initialise.
typedef struct orr_loop {
    struct event_base *base;
    int stop_fd; // an eventfd
    struct event *on_stop;
    void (*stopped)(void *user); // NULL: the loop ends at once
    void *user;
    int nice; // of its own thread
    pthread_t thread;
    bool opened, has_thread;
} orr_loop;

// Makes the loop.
// Given:
//   l        zero-initialised, or with `nice` set
//   stopped  called in the loop, once or more, when it is to stop; NULL: the loop ends at once
//   user     of stopped
// Returned:
//   diag     why it failed
// Errors: ORR_E_MEMORY, ORR_E_IO. Free with orr_loop_close in any case.
orr_status orr_loop_open(orr_loop *l, void (*stopped)(void *user), void *user, orr_diag *diag);
// Runs it on a thread of its own; `what` it is for stands in the diagnostic. ORR_E_IO.
orr_status orr_loop_start(orr_loop *l, const char *what, orr_diag *diag);
// Says that it is to stop; from any thread.
void orr_loop_stop(const orr_loop *l);
// Ends its thread, if it has one: nothing of the loop is called after this.
void orr_loop_halt(orr_loop *l);
// Halts and frees it; events of others must have been freed. One that was not opened may be closed.
void orr_loop_close(orr_loop *l);

#endif
