// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/serve/service.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "src/service/serve/service_private.h"

enum { BACKLOG = 128, SLICE_NS = 500000 };
static const double sweep_s = 0.2; // how finely time-outs are kept

orr_service_options orr_service_defaults(void)
{
    return (orr_service_options){.max_clients = 256,
                                 .spare_s = 2,
                                 .first_s = 30,
                                 .idle_s = 600,
                                 .half_frame_s = 10,
                                 .stall_s = 30,
                                 .drain_s = 5,
                                 .signals = true};
}

// As many clients are connected as may be: the one that has been idle longest, and long enough, gives its
// place.
static bool make_room(orr_service *s)
{
    if (s->n_conns < s->options.max_clients) return true;
    orr_conn *idlest = NULL;
    for (orr_conn *c = s->conns; c != NULL; c = orr_conn_next(c))
        if (orr_conn_is_idle(c) && (idlest == NULL || orr_conn_last_ns(c) < orr_conn_last_ns(idlest)))
            idlest = c;
    if (idlest == NULL ||
        (double)(orr_service_clock_ns(s) - orr_conn_last_ns(idlest)) < s->options.spare_s * 1e9)
        return false;
    orr_service_tell(s, ORR_ID("N10") "%s: closing: it was idle, and its place is needed",
                     orr_conn_peer(idlest));
    orr_conn_refuse(idlest, ORR_MSG_ERROR_CODE_BUSY,
                    "it was idle, and another client needed the place: this server allows no more");
    return true;
}

// A client has come in, by the door's rules.
static void on_enter(void *user, orr_link *link, const orr_guest *guest)
{
    orr_service *s = user;
    const bool room = make_room(s);
    atomic_fetch_add(room && guest->may != ORR_MAY_NOTHING ? &s->came : &s->refused, 1);
    orr_conn *c = orr_conn_open(s, link, guest);
    if (c == NULL) return;
    if (room && guest->may != ORR_MAY_NOTHING) {
        orr_conn_serve(c);
        return;
    }
    if (guest->may == ORR_MAY_NOTHING) {
        orr_service_tell(s, ORR_ID("N08") "%s refused: the access file does not name it", guest->peer);
        orr_conn_refuse(c, ORR_MSG_ERROR_CODE_NOT_PERMITTED,
                        "this server does not know the name of your certificate");
        return;
    }
    orr_service_tell(s, ORR_ID("N09") "%s refused: %d clients are connected", guest->peer,
                     s->options.max_clients);
    orr_conn_refuse(c, ORR_MSG_ERROR_CODE_BUSY, "as many clients are connected as this server allows");
}

static void on_tell(void *user, const char *line) { orr_service_tell(user, "%s", line); }

// Streams that have made something are sent on.
static void send_streams(orr_service *s)
{
    for (orr_conn *c; s->streams != NULL && (c = orr_streams_ready(s->streams)) != NULL;) orr_conn_stream(c);
}

// Where motion has come that blocks were waiting for, they will be there in a moment.
static void answer_motion(orr_service *s)
{
    if (s->streams != NULL && orr_streams_moved(s->streams) && orr_wake_watch(&s->wake)) send_streams(s);
}

static void on_sweep(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    orr_service *s = user;
    int64_t now = orr_service_clock_ns(s);
    atomic_store(&s->beat_ns, now);
    if (s->options.beat != NULL) s->options.beat(s->options.user, now);
    for (orr_conn *c = s->conns, *next; c != NULL; c = next) {
        next = orr_conn_next(c);
        if (s->draining)
            orr_conn_drain(c, now);
        else
            orr_conn_sweep(c, now);
    }
    send_streams(s); // no wake that was lost holds a stream up for good
    orr_watch_note(s);
    if (s->draining && (s->conns == NULL || now > s->drain_until_ns)) {
        if (s->conns != NULL)
            ORR_LOG(s->log, ORR_LOG_WARN, ORR_ID("R04") "%d clients did not take their answers in time",
                    s->n_conns);
        s->done = true;
        return;
    }
    orr_door_sweep(s->door, now);
}

static void sweep_every(orr_service *s, double seconds)
{
    struct timeval tv = {.tv_sec = 0, .tv_usec = (suseconds_t)(seconds * 1e6)};
    event_add(s->on_sweep, &tv);
}

static void stop(void *user)
{
    orr_service *s = user;
    if (s->draining) { // the second time: at once
        s->done = true;
        return;
    }
    s->draining = true;
    s->drain_until_ns = orr_service_clock_ns(s) + (int64_t)(s->options.drain_s * 1e9);
    orr_door_shut(s->door);
    if (s->options.stopping != NULL) s->options.stopping(s->options.user);
    ORR_LOG(s->log, ORR_LOG_INFO, ORR_ID("R02") "stopping, %d clients connected", s->n_conns);
    sweep_every(s, 0.02);
    on_sweep(-1, 0, s);
}

static void on_signal(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    orr_service *s = user;
    s->signalled = true;
    stop(s);
}

orr_service_counts orr_service_count(const orr_service *s)
{
    const int64_t now = orr_service_clock_ns(s);
    return (orr_service_counts){.uptime_s = (double)(now - s->opened_ns) * 1e-9,
                                .silent_s = (double)(now - atomic_load(&s->beat_ns)) * 1e-9,
                                .clients = atomic_load(&s->clients),
                                .came = atomic_load(&s->came),
                                .refused = atomic_load(&s->refused),
                                .requests = atomic_load(&s->requests),
                                .refusals = atomic_load(&s->refusals),
                                .held = atomic_load(&s->held)};
}

void orr_service_readmit(orr_service *s)
{
    for (orr_conn *c = s->conns, *next; c != NULL; c = next) {
        next = orr_conn_next(c);
        orr_conn_readmit(c);
    }
}

static void on_hangup(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    const orr_service *s = user;
    if (s->options.hangup != NULL) s->options.hangup(s->options.user);
}

static void on_wake(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    orr_service *s = user;
    (void)orr_wake_take(&s->wake);
    send_streams(s);
}

// One more address, or a socket that was handed over.
static orr_status add_listener(orr_service *s, size_t i, const char *url, orr_diag *diag)
{
    const orr_service_socket *handed = i < s->options.n_sockets ? &s->options.socket[i] : NULL;
    return handed != NULL ? orr_door_adopt(s->door, handed->fd, handed->tls, diag)
                          : orr_door_listen(s->door, url, diag);
}

static orr_status add_events(orr_service *s, orr_diag *diag)
{
    s->on_sweep = event_new(s->loop.base, -1, EV_PERSIST, on_sweep, s);
    s->on_wake = event_new(s->loop.base, s->wake.fd, EV_READ | EV_PERSIST, on_wake, s);
    if (s->on_sweep == NULL || s->on_wake == NULL || event_add(s->on_wake, NULL) != 0)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    sweep_every(s, sweep_s);
    return ORR_OK;
}

orr_status orr_service_open(const orr_service_options *options, const orr_server *server, const orr_log *log,
                            orr_service **out, orr_diag *diag)
{
    static const char *const fallback[] = {"tcp://"};
    const char *const *url = options->n_urls > 0 ? options->url : fallback;
    size_t n = options->n_sockets > 0 ? options->n_sockets : options->n_urls > 0 ? options->n_urls : 1;
    orr_service *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s->options = *options;
    s->opened_ns = orr_service_clock_ns(s);
    atomic_store(&s->beat_ns, s->opened_ns);
    s->server = server;
    s->log = log;
    pthread_mutex_init(&s->watch.lock, NULL);
    s->rate = (orr_log_rate){.burst = 20, .every_ns = 200000000};
    orr_turns_init(&s->turns, ORR_CONN_TURN_NS);
    const bool wakes = orr_wake_open(&s->wake);
    s->datagrams = orr_datagrams_open();
    orr_status status = orr_loop_open(&s->loop, stop, s, diag);
    if (status == ORR_OK && options->access == NULL)
        status = orr_access_open(NULL, false, ORR_MAY_ALL, &s->own_access, diag);
    s->access = options->access != NULL ? options->access : s->own_access;
    if (status == ORR_OK)
        s->door = orr_door_open(&(orr_door_options){.base = s->loop.base,
                                                    .access = s->access,
                                                    .backlog = BACKLOG,
                                                    .user = s,
                                                    .enter = on_enter,
                                                    .tell = on_tell});
    if (status != ORR_OK)
        ; // told
    else if (s->door == NULL || s->datagrams == NULL)
        status = orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    else if (!wakes)
        status = orr_diag_set(diag, ORR_E_IO, "no eventfd");
    if (status == ORR_OK) status = add_events(s, diag);
    for (size_t i = 0; status == ORR_OK && i < n; i++)
        status = add_listener(s, i, options->n_sockets > 0 ? NULL : url[i], diag);
    if (status != ORR_OK) {
        orr_service_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

void orr_service_provide(orr_service *s, const orr_server *server) { s->server = server; }
void orr_service_stream(orr_service *s, orr_streams *streams) { s->streams = streams; }

orr_datagrams *orr_service_datagrams(const orr_service *s) { return s->datagrams; }

void orr_service_wake(void *user)
{
    orr_service *s = user;
    orr_wake_ring(&s->wake);
}

const char *orr_service_url(const orr_service *s, size_t i) { return orr_door_url(s->door, i); }

// From here on signals are the loop's.
static bool take_signals(orr_service *s)
{
    s->on_int = event_new(s->loop.base, SIGINT, EV_SIGNAL | EV_PERSIST, on_signal, s);
    s->on_term = event_new(s->loop.base, SIGTERM, EV_SIGNAL | EV_PERSIST, on_signal, s);
    s->on_hangup = event_new(s->loop.base, SIGHUP, EV_SIGNAL | EV_PERSIST, on_hangup, s);
    return s->on_int != NULL && s->on_term != NULL && s->on_hangup != NULL &&
           event_add(s->on_int, NULL) == 0 && event_add(s->on_term, NULL) == 0 &&
           event_add(s->on_hangup, NULL) == 0;
}

// Turns for about a slice of time; then whoever has sent something meanwhile joins the queue.
static void take_turns(orr_service *s)
{
    orr_turns_member *m = orr_turns_next(&s->turns);
    if (m == NULL) return;
    const int64_t until_ns = orr_service_clock_ns(s) + SLICE_NS;
    for (; m != NULL; m = orr_service_clock_ns(s) < until_ns ? orr_turns_next(&s->turns) : NULL)
        orr_conn_turn(m);
}

orr_status orr_service_run(orr_service *s, void (*ready)(void *user), void *user, orr_diag *diag)
{
    if (s->options.signals && !take_signals(s)) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (ready != NULL) ready(user);
    while (!s->done) {
        int how = EVLOOP_ONCE | (s->turns.n > 0 ? EVLOOP_NONBLOCK : 0);
        if (event_base_loop(s->loop.base, how) < 0)
            return orr_diag_set(diag, ORR_E_IO, "the event loop failed");
        take_turns(s);
        answer_motion(s);
    }
    return ORR_OK;
}

bool orr_service_signalled(const orr_service *s) { return s->signalled; }

void orr_service_stop(orr_service *s) { orr_loop_stop(&s->loop); }

void orr_service_close(orr_service *s)
{
    if (s == NULL) return;
    while (s->conns != NULL) orr_conn_close(s->conns);
    orr_door_close(s->door);
    struct event *events[] = {s->on_wake, s->on_sweep, s->on_int, s->on_term, s->on_hangup};
    for (size_t i = 0; i < sizeof events / sizeof events[0]; i++)
        if (events[i] != NULL) event_free(events[i]);
    orr_loop_close(&s->loop);
    orr_datagrams_close(s->datagrams);
    orr_wake_close(&s->wake);
    orr_turns_free(&s->turns);
    pthread_mutex_destroy(&s->watch.lock);
    free(s->watch.row);
    orr_access_close(s->own_access);
    free(s);
}
