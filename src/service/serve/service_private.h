// SPDX-License-Identifier: GPL-3.0-or-later
// Between service.c (listening, time, signals) and connection.c (one client).
#ifndef ORR_SERVICE_SERVICE_PRIVATE_H
#define ORR_SERVICE_SERVICE_PRIVATE_H

#include <event2/event.h>
#include <stdatomic.h>

#include "src/service/live/streams.h"
#include "src/service/net/datagrams.h"
#include "src/service/net/door.h"
#include "src/service/net/loop.h"
#include "src/service/serve/service.h"
#include "src/service/serve/turns.h"
#include "src/service/serve/wake.h"

enum {
    ORR_CONN_OUT = 128 << 10, // output at first: many frames a write; grows up to one largest frame
    ORR_CONN_IN = 4096,       // input at first; grows up to one largest request, with streams up to
    ORR_CONN_IN_MOST = 2 * (ORR_MSG_MAX_REQUEST + ORR_FRAME_OVERHEAD),
    ORR_CONN_KERNEL =
        256
        << 10, // bytes of a connection with streams that the kernel keeps, at most (twice that with its own)
    ORR_CONN_LANE = 64 << 10, // frames of streams a write; grows up to one largest frame
    ORR_CONN_TURN_NS =
        200000, // a turn; a piece of an answer may end it late, none takes longer than twice that
};

typedef struct orr_conn orr_conn;

// The clients as they were at the last sweep, for other threads; kept while somebody asks.
typedef struct orr_watch {
    pthread_mutex_t lock;
    int64_t asked_ns; // when somebody did last; 0: nobody has
    orr_client_look *row;
    size_t n, all;
} orr_watch;

struct orr_service {
    orr_service_options options;
    const orr_server *server;
    orr_streams *streams; // NULL: none are served
    const orr_log *log;
    orr_loop loop;
    orr_access *access, *own_access; // the rules; those made here where nobody gave any
    orr_door *door;
    orr_datagrams *datagrams;
    int64_t opened_ns;
    atomic_llong beat_ns; // when the loop last came round
    atomic_ullong clients, came, refused, requests, refusals, held;
    struct event *on_sweep, *on_int, *on_term, *on_hangup;
    orr_wake wake; // streams have something to send
    struct event *on_wake;
    orr_conn *conns; // all, newest first
    int n_conns;     // of those that are served
    orr_turns turns;
    orr_watch watch;
    orr_log_rate rate; // of lines that clients cause
    bool done;
    bool draining;
    bool signalled; // to stop
    int64_t drain_until_ns;
};

int64_t orr_service_clock_ns(const orr_service *s); // monotonic
// A warning that a client has caused, at a limited rate.
void orr_service_tell(orr_service *s, const char *fmt, ...) ORR_PRINTF(2, 3);

// Takes a guest's link over; NULL, and it is closed, if this fails. Then it is served or refused.
orr_conn *orr_conn_open(orr_service *s, orr_link *link, const orr_guest *guest);
// The rules have changed: what it may do is looked up again; it is ended where that is nothing.
void orr_conn_readmit(orr_conn *c);
// Begins to read its requests.
void orr_conn_serve(orr_conn *c);
// Tells it why and ends it; it may be gone afterwards.
void orr_conn_refuse(orr_conn *c, uint16_t code, const char *sentence);
// Its streams have something to send. It may be gone afterwards.
void orr_conn_stream(orr_conn *c);
// Its turn has come: answers for ORR_CONN_TURN_NS. It may be gone afterwards.
void orr_conn_turn(orr_turns_member *m);
// Whether it is served and nothing of it is under way.
bool orr_conn_is_idle(const orr_conn *c);
// When it last asked, or came.
int64_t orr_conn_last_ns(const orr_conn *c);
// Who it is, as orr_conn_open was told.
const char *orr_conn_peer(const orr_conn *c);
// What a watcher sees of it.
void orr_conn_look(const orr_conn *c, int64_t now_ns, orr_client_look *out);
// Notes all clients, if somebody watches (watch.c).
void orr_watch_note(orr_service *s);
// Looks at the connection's deadline, closes it if that has passed.
void orr_conn_sweep(orr_conn *c, int64_t now_ns);
// No more requests: ends as soon as what is under way has been sent.
void orr_conn_drain(orr_conn *c, int64_t now_ns);
// Closes and frees it, whatever is under way.
void orr_conn_close(orr_conn *c);
// The next older connection; NULL behind the last.
orr_conn *orr_conn_next(const orr_conn *c);

#endif
