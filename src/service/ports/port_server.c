// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/ports/port_server.h"

#include <errno.h>
#include <stdio.h>

#include "core/monotonic.h"
#include "src/service/net/door.h"
#include "src/service/net/loop.h"
#include "src/service/ports/ntrip.h"
#include "src/service/ports/port_source.h"

enum { CLIENTS = 64, TURN_US = 10000, EPOCHS_A_TURN = 20, TABLE = 1024, CLOSING_S = 2, KEPT = 16 << 10 };

typedef struct mouth mouth;
typedef struct port_client port_client;
struct port_client {
    mouth *mouth;
    orr_link *link;
    orr_guest guest;
    char in[ORR_NTRIP_REQUEST];
    size_t n_in;
    bool streaming, chunked;
    bool ending; // what waits is its last; then it is closed
    bool finished;
    orr_port_bytes out;
    size_t at;        // of out, sent
    int64_t since_ns; // of its coming, its last progress, or its end
    port_client *next;
};

// A source with its door.
struct mouth {
    orr_port_server *server;
    port_feed feed;
    orr_door *door;
    bool has_epoch; // feed.observed is there
    char mount[ORR_NTRIP_NAME];
    char url[ORR_URL_TEXT + ORR_NTRIP_NAME];
};

struct orr_port_server {
    orr_port_server_options options;
    char login[ORR_NTRIP_LOGIN];
    mouth mouth[ORR_PORT_SOURCES];
    size_t n_mouths, n;
    orr_loop loop;
    struct event *on_turn;
    port_client *client;
    orr_port_bytes bytes; // of one epoch
};

static void drop(port_client *c)
{
    orr_port_server *s = c->mouth->server;
    for (port_client **p = &s->client; *p != NULL; p = &(*p)->next)
        if (*p == c) {
            *p = c->next;
            break;
        }
    s->n--;
    orr_link_close(c->link);
    orr_peers_leave(c->guest.account);
    free(c->out.data);
    free(c);
}

static bool waits(const port_client *c) { return c->out.n > c->at || orr_link_unsent(c->link); }

// Sends what the socket takes; false where it is lost.
static bool flush(port_client *c)
{
    while (c->at < c->out.n) {
        const ssize_t sent = orr_link_send(c->link, c->out.data + c->at, c->out.n - c->at);
        if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
        c->at += (size_t)sent;
        c->since_ns = orr_monotonic_ns();
    }
    c->at = c->out.n = 0;
    return true;
}

// Sends and waits on; it may be gone afterwards.
static void settle(port_client *c)
{
    if (!flush(c)) {
        drop(c);
        return;
    }
    if (c->ending && !c->finished && !waits(c)) {
        orr_link_finish(c->link);
        c->finished = true;
        c->since_ns = orr_monotonic_ns();
    }
    if (!orr_link_want(c->link, true, waits(c))) drop(c);
}

// Bytes of a stream, as the client takes them.
static void append(port_client *c, const uint8_t *data, size_t n)
{
    char head[32];
    if (n == 0) return;
    if (!waits(c)) c->since_ns = orr_monotonic_ns();
    if (c->at > 0) {
        memmove(c->out.data, c->out.data + c->at, c->out.n - c->at);
        c->out.n -= c->at, c->at = 0;
    }
    if (c->chunked) orr_port_bytes_add(&c->out, head, (size_t)snprintf(head, sizeof head, "%zx\r\n", n));
    orr_port_bytes_add(&c->out, data, n);
    if (c->chunked) orr_port_bytes_add(&c->out, "\r\n", 2);
}

static void refuse(const port_client *c, const char *why)
{
    ORR_LOG(c->mouth->server->options.log, ORR_LOG_WARN, ORR_ID("P01") "%s refused at %s: %s", c->guest.peer,
            c->mouth->url, why);
}

// The stream begins: what a base station tells now and then comes at once.
static void begin_stream(port_client *c)
{
    mouth *m = c->mouth;
    orr_port_bytes *b = &m->server->bytes;
    orr_diag diag;
    c->streaming = true;
    b->n = 0;
    // What cannot be told now was told of when its epoch was made.
    if (m->has_epoch && !m->feed.ended &&
        orr_port_greeting(m->feed.port, &m->feed.observed, b, &diag) == ORR_OK)
        append(c, b->data, b->n);
    if (m->feed.ended) c->ending = true;
}

static void answer_with(port_client *c, const orr_ntrip_request *r, orr_ntrip_answer answer, const char *body)
{
    char head[ORR_NTRIP_HEAD];
    const size_t n = orr_ntrip_head(r, answer, strlen(body), head);
    orr_port_bytes_add(&c->out, head, n);
    orr_port_bytes_add(&c->out, body, strlen(body));
    c->ending = answer != ORR_NTRIP_STREAM;
    c->since_ns = orr_monotonic_ns();
}

static void answer_request(port_client *c, const orr_ntrip_request *r)
{
    const orr_port_server *s = c->mouth->server;
    const char *login = s->options.login;
    char table[TABLE];
    const bool named = !r->too_long && strcmp(r->mount, c->mouth->feed.source.mount) == 0;
    if (!named) {
        const bool asked = r->mount[0] == '\0' && !r->too_long;
        (void)port_feed_table(&c->mouth->feed, login != NULL, table, sizeof table);
        if (!asked) refuse(c, "it names another mountpoint");
        if (!asked && r->revision == 2)
            answer_with(c, r, ORR_NTRIP_NOT_FOUND, "There is no such mountpoint.\r\n");
        else
            answer_with(c, r, ORR_NTRIP_TABLE, table);
    } else if (login != NULL && !orr_ntrip_login(r->login, login)) {
        refuse(c, r->login[0] == '\0' ? "it gives no login" : "its login is wrong");
        answer_with(c, r, ORR_NTRIP_UNAUTHORISED, "User and password are wanted.\r\n");
    } else {
        answer_with(c, r, ORR_NTRIP_STREAM, "");
        c->chunked = r->revision == 2 && r->http_1_1;
        begin_stream(c);
    }
}

static void read_request(port_client *c)
{
    orr_ntrip_request r;
    switch (orr_ntrip_read(c->in, c->n_in, &r)) {
    case ORR_NTRIP_MORE:
        break;
    case ORR_NTRIP_WHOLE:
        answer_request(c, &r);
        break;
    case ORR_NTRIP_NOT_GET:
        refuse(c, "it does not ask for data, but offers some");
        answer_with(c, NULL, ORR_NTRIP_NO_SOURCES, "This caster takes no streams.\r\n");
        break;
    default:
        refuse(c, "its request is none of NTRIP");
        answer_with(c, NULL, ORR_NTRIP_BAD, "This is an NTRIP caster: GET /MOUNT HTTP/1.0 is wanted.\r\n");
        break;
    }
}

// What comes: a request, or, behind it, what is not looked at (positions of NTRIP clients). It may be gone afterwards.
static void on_read(void *user)
{
    port_client *c = user;
    char data[ORR_NTRIP_REQUEST];
    const ssize_t n = orr_link_recv(c->link, data, sizeof data);
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
    if (n <= 0) {
        drop(c);
        return;
    }
    if (!c->streaming && !c->ending) {
        const size_t room = sizeof c->in - c->n_in, take = (size_t)n < room ? (size_t)n : room;
        memcpy(c->in + c->n_in, data, take);
        c->n_in += take;
        read_request(c);
    }
    settle(c);
}

static void on_write(void *user) { settle(user); }

static void on_enter(void *user, orr_link *link, const orr_guest *guest)
{
    mouth *m = user;
    orr_port_server *s = m->server;
    const bool may = (guest->may & ORR_MAY_READ) != 0;
    port_client *c = may && s->n < CLIENTS ? calloc(1, sizeof *c) : NULL;
    if (c == NULL) {
        ORR_LOG(s->options.log, ORR_LOG_WARN, ORR_ID("P01") "%s refused at %s: %s", guest->peer, m->url,
                !may              ? "it may not read"
                : s->n >= CLIENTS ? "as many clients are connected as may be"
                                  : "out of memory");
        orr_link_close(link);
        orr_peers_leave(guest->account);
        return;
    }
    c->mouth = m, c->link = link, c->guest = *guest;
    c->since_ns = orr_monotonic_ns();
    c->next = s->client;
    s->client = c;
    s->n++;
    (void)orr_link_keep_short(link, KEPT); // else the machine keeps minutes for one who takes nothing
    orr_link_serve(link, c, on_read, on_write);
    if (m->feed.source.mount == NULL) begin_stream(c);
    settle(c);
}

static void on_tell(void *user, const char *line)
{
    const mouth *m = user;
    ORR_LOG(m->server->options.log, ORR_LOG_WARN, "%s", line);
}

// To all who listen to a source; `last`: nothing follows.
static void send_all(const mouth *m, const orr_port_bytes *b, bool last)
{
    for (port_client *c = m->server->client, *next; c != NULL; c = next) {
        next = c->next;
        if (c->mouth != m || !c->streaming || c->ending) continue;
        append(c, b->data, b->n);
        if (last && c->chunked) orr_port_bytes_add(&c->out, "0\r\n\r\n", 5);
        c->ending = last;
        settle(c);
    }
}

static void turn(mouth *m, const orr_msg_time *now)
{
    orr_port_server *s = m->server;
    orr_diag diag;
    for (int k = 0; k < EPOCHS_A_TURN; k++) {
        const bool had_ended = m->feed.ended;
        diag.text[0] = '\0';
        s->bytes.n = 0;
        const bool made =
            port_feed_turn(&m->feed, now->t, now->state == ORR_MSG_CLOCK_STATE_RUNNING, &s->bytes, &diag);
        m->has_epoch = m->feed.observed.item != NULL;
        if (made) send_all(m, &s->bytes, false);
        if (made) continue;
        if (m->feed.ended && !had_ended) {
            ORR_LOG(s->options.log, ORR_LOG_WARN, ORR_ID("P03") "%s ends: %s", m->url,
                    diag.text[0] != '\0' ? diag.text : "the scenario ends");
            s->bytes.n = 0;
            send_all(m, &s->bytes, true);
        }
        return;
    }
}

// Who takes nothing, or does not ask, is closed.
static void sweep(port_client *c, int64_t now_ns, double first_s)
{
    const orr_log *log = c->mouth->server->options.log;
    const double s = (double)(now_ns - c->since_ns) * 1e-9;
    if (c->finished) {
        if (s > CLOSING_S) drop(c);
    } else if (c->out.n - c->at > ORR_PORT_WAITING || c->out.lost) {
        ORR_LOG(log, ORR_LOG_WARN, ORR_ID("P02") "%s closed at %s: it is too slow, %zu bytes wait for it",
                c->guest.peer, c->mouth->url, c->out.n - c->at);
        drop(c);
    } else if (waits(c) && s > ORR_PORT_PATIENCE_S) {
        ORR_LOG(log, ORR_LOG_WARN, ORR_ID("P02") "%s closed at %s: it has taken nothing for %d s",
                c->guest.peer, c->mouth->url, ORR_PORT_PATIENCE_S);
        drop(c);
    } else if (!c->streaming && !c->ending && s > first_s) {
        refuse(c, "its request did not come in time");
        drop(c);
    }
}

// By the rules as they are now: who may not read any more goes.
static void readmit(const orr_port_server *s)
{
    for (port_client *c = s->client, *next; c != NULL; c = next) {
        next = c->next;
        (void)orr_guest_readmit(&c->guest, s->options.access);
        if ((c->guest.may & ORR_MAY_READ) != 0) continue;
        ORR_LOG(s->options.log, ORR_LOG_WARN, ORR_ID("N14") "%s: closing at %s: it may not read any more",
                c->guest.peer, c->mouth->url);
        drop(c);
    }
}

static void on_turn(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    orr_port_server *s = user;
    orr_msg_time now;
    orr_streams_time(s->options.streams, &now);
    readmit(s);
    for (size_t k = 0; k < s->n_mouths; k++) turn(&s->mouth[k], &now);
    const int64_t now_ns = orr_monotonic_ns();
    for (size_t k = 0; k < s->n_mouths; k++) orr_door_sweep(s->mouth[k].door, now_ns);
    const double first_s = orr_access_limits_of(s->options.access).first_s;
    for (port_client *c = s->client, *next; c != NULL; c = next) {
        next = c->next;
        sweep(c, now_ns, first_s);
    }
}

static orr_status prepare(orr_port_server *s, orr_diag *diag)
{
    static const struct timeval every = {0, TURN_US};
    const orr_status status = orr_loop_open(&s->loop, NULL, NULL, diag);
    if (status != ORR_OK) return status;
    s->on_turn = event_new(s->loop.base, -1, EV_PERSIST, on_turn, s);
    return s->on_turn != NULL && event_add(s->on_turn, &every) == 0
               ? ORR_OK
               : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static orr_status open_mouth(orr_port_server *s, const orr_port_source *source, orr_diag *diag)
{
    static const char good[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
    const char *mount = source->mount;
    if (mount != NULL &&
        (mount[0] == '\0' || strspn(mount, good) != strlen(mount) || strlen(mount) >= ORR_NTRIP_NAME))
        return orr_diag_set(diag, ORR_E_ARG,
                            "a mountpoint has 1 to %d letters, digits, '_', '-' and '.', not '%.100s'",
                            ORR_NTRIP_NAME - 1, mount);
    mouth *m = &s->mouth[s->n_mouths];
    m->server = s;
    s->n_mouths++; // from here on it is closed
    orr_status status = port_feed_open(&m->feed, source, diag);
    if (status != ORR_OK) return status;
    if (mount != NULL) m->feed.source.mount = strcpy(m->mount, mount); // it fits
    m->door = orr_door_open(&(orr_door_options){.base = s->loop.base,
                                                .access = s->options.access,
                                                .backlog = CLIENTS,
                                                .user = m,
                                                .enter = on_enter,
                                                .tell = on_tell});
    if (m->door == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    status = orr_door_listen(m->door, source->url, diag);
    if (status == ORR_OK)
        snprintf(m->url, sizeof m->url, "%s%s%s", orr_door_url(m->door, 0), mount != NULL ? "/" : "",
                 mount != NULL ? mount : "");
    return status;
}

orr_status orr_port_server_open(const orr_port_server_options *options, orr_port_server **out, orr_diag *diag)
{
    if (options->n > ORR_PORT_SOURCES)
        return orr_diag_set(diag, ORR_E_LIMIT, "at most %d receivers' ports are served", ORR_PORT_SOURCES);
    orr_port_server *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s->options = *options;
    if (options->login != NULL) {
        snprintf(s->login, sizeof s->login, "%s", options->login);
        s->options.login = s->login;
    }
    orr_status status = prepare(s, diag);
    for (size_t k = 0; status == ORR_OK && k < options->n; k++)
        status = open_mouth(s, &options->source[k], diag);
    if (status == ORR_OK) status = orr_loop_start(&s->loop, "receivers' ports", diag);
    if (status != ORR_OK) {
        orr_port_server_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

const char *orr_port_server_url(const orr_port_server *s, size_t k)
{
    return s != NULL && k < s->n_mouths ? s->mouth[k].url : NULL;
}

void orr_port_server_close(orr_port_server *s)
{
    if (s == NULL) return;
    orr_loop_halt(&s->loop);
    while (s->client != NULL) drop(s->client);
    for (size_t k = 0; k < s->n_mouths; k++) {
        orr_door_close(s->mouth[k].door);
        port_feed_close(&s->mouth[k].feed);
    }
    if (s->on_turn != NULL) event_free(s->on_turn);
    orr_loop_close(&s->loop);
    free(s->bytes.data);
    free(s);
}
