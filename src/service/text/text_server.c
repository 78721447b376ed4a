// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/text/text_server.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "core/monotonic.h"
#include "src/service/net/door.h"
#include "src/service/net/loop.h"
#include "src/service/text/session.h"

enum { CLIENTS = 32, MOST_WAITING = 1 << 20, SWEEP_US = 200000 };

typedef struct text_client text_client;
struct text_client {
    orr_text_server *server;
    orr_link *link;
    orr_guest guest;
    orr_asked asked; // what answers it, with its own permissions
    orr_text_session session;
    char *out; // what waits to be sent
    size_t n, at;
    int64_t last_ns, held_until_ns; // since when it is quiet; until when it has to wait, 0: it has not
    orr_allowance lines;
    text_client *next;
};

struct orr_text_server {
    orr_asked asked;
    orr_access *access;
    orr_loop loop;
    struct event *on_sweep;
    orr_door *door;
    size_t n;
    text_client *client;
};

static void drop(text_client *c)
{
    orr_text_server *s = c->server;
    for (text_client **p = &s->client; *p != NULL; p = &(*p)->next)
        if (*p == c) {
            *p = c->next;
            break;
        }
    s->n--;
    orr_link_close(c->link);
    orr_peers_leave(c->guest.account);
    orr_text_session_close(&c->session);
    free(c->out);
    free(c);
}

// Sends what the socket takes; false where it is lost.
static bool flush(text_client *c)
{
    while (c->at < c->n) {
        const ssize_t sent = orr_link_send(c->link, c->out + c->at, c->n - c->at);
        if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
        c->at += (size_t)sent;
    }
    c->at = c->n = 0;
    return true;
}

// While answers wait nothing more is asked. It may be gone afterwards.
static void settle(text_client *c)
{
    const bool waits = c->n > 0 || orr_link_unsent(c->link);
    if (!orr_link_want(c->link, !waits && c->held_until_ns == 0, waits)) drop(c);
}

// Appends an answer to what waits; false where too much does.
static bool append(text_client *c, const char *text, size_t n)
{
    if (n == 0) return true;
    if (c->n - c->at + n > MOST_WAITING && c->n > c->at) return false;
    char *grown = realloc(c->out, c->n + n);
    if (grown == NULL) return false;
    memcpy(grown + c->n, text, n);
    c->out = grown;
    c->n += n;
    return true;
}

// Takes the lines from what it and its address may ask.
static void charge(text_client *c, const char *data, size_t n)
{
    double lines = 0;
    if (!c->guest.limited) return;
    for (size_t k = 0; k < n; k++) lines += data[k] == '\n';
    const orr_access_limits limits = orr_access_limits_of(c->server->access);
    c->held_until_ns = orr_peers_charge(&c->lines, c->guest.account, lines, &limits, c->last_ns);
}

// By the rules as they are now; false where they leave it nothing.
static bool readmit(text_client *c)
{
    const orr_text_server *s = c->server;
    const bool stays = orr_guest_readmit(&c->guest, s->access);
    c->asked.may = c->guest.may;
    if (!stays)
        ORR_LOG(s->asked.log, ORR_LOG_WARN,
                ORR_ID("N14") "%s: closing: the access file does not name it any more", c->guest.peer);
    return stays;
}

// False: it has gone, or has to.
static bool serve(text_client *c)
{
    char data[4096];
    const ssize_t n = orr_link_recv(c->link, data, sizeof data);
    if (n < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    if (n == 0 || !readmit(c)) return false;
    c->last_ns = orr_monotonic_ns();
    charge(c, data, (size_t)n);
    char *answer = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&answer, &size);
    if (out == NULL) return false;
    orr_text_session_take(&c->session, data, (size_t)n, out);
    const bool whole = fclose(out) == 0;
    const bool good = whole && append(c, answer, size) && flush(c);
    free(answer);
    return good;
}

static void on_read(void *user)
{
    text_client *c = user;
    if (serve(c))
        settle(c);
    else
        drop(c);
}

static void on_write(void *user)
{
    text_client *c = user;
    if (flush(c))
        settle(c);
    else
        drop(c);
}

static void on_enter(void *user, orr_link *link, const orr_guest *guest)
{
    orr_text_server *s = user;
    const bool room = s->n < CLIENTS && guest->may != ORR_MAY_NOTHING;
    text_client *c = room ? calloc(1, sizeof *c) : NULL;
    if (c != NULL) {
        *c = (text_client){.server = s,
                           .link = link,
                           .guest = *guest,
                           .asked = s->asked,
                           .last_ns = orr_monotonic_ns(),
                           .next = s->client};
        c->asked.may = guest->may;
    }
    if (c == NULL || !orr_text_session_open(&c->session, &c->asked)) {
        free(c);
        orr_link_close(link);
        orr_peers_leave(guest->account);
        return;
    }
    s->client = c;
    s->n++;
    orr_link_serve(link, c, on_read, on_write);
    settle(c);
}

static void on_tell(void *user, const char *line)
{
    const orr_text_server *s = user;
    ORR_LOG(s->asked.log, ORR_LOG_WARN, "%s", line);
}

static void on_sweep(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    const orr_text_server *s = user;
    const int64_t now = orr_monotonic_ns();
    const double idle_s = orr_access_limits_of(s->access).idle_s;
    orr_door_sweep(s->door, now);
    for (text_client *c = s->client, *next; c != NULL; c = next) {
        next = c->next;
        if (!readmit(c)) {
            drop(c);
            continue;
        }
        if (c->held_until_ns != 0 && now >= c->held_until_ns) {
            c->held_until_ns = 0;
            settle(c);
            continue;
        }
        // One at a terminal may think for as long as he likes.
        if (c->guest.limited && (double)(now - c->last_ns) * 1e-9 > idle_s) drop(c);
    }
}

static orr_status prepare(orr_text_server *s, orr_diag *diag)
{
    static const struct timeval every = {0, SWEEP_US};
    const orr_status status = orr_loop_open(&s->loop, NULL, NULL, diag);
    if (status != ORR_OK) return status;
    s->asked.room = malloc(ORR_MSG_LARGEST);
    s->door = orr_door_open(&(orr_door_options){.base = s->loop.base,
                                                .access = s->access,
                                                .backlog = CLIENTS,
                                                .user = s,
                                                .enter = on_enter,
                                                .tell = on_tell});
    s->on_sweep = event_new(s->loop.base, -1, EV_PERSIST, on_sweep, s);
    if (s->asked.room == NULL || s->door == NULL || s->on_sweep == NULL ||
        event_add(s->on_sweep, &every) != 0)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    return ORR_OK;
}

orr_status orr_text_server_open(const char *url, const orr_asked *asked, orr_access *access,
                                orr_text_server **out, orr_diag *diag)
{
    orr_text_server *s = calloc(1, sizeof *s);
    if (s == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    s->asked = *asked;
    s->access = access;
    orr_status status = prepare(s, diag);
    if (status == ORR_OK) status = orr_door_listen(s->door, url, diag);
    if (status == ORR_OK) status = orr_loop_start(&s->loop, "text", diag);
    if (status != ORR_OK) {
        orr_text_server_close(s);
        return status;
    }
    *out = s;
    return ORR_OK;
}

const char *orr_text_server_url(const orr_text_server *s) { return orr_door_url(s->door, 0); }

void orr_text_server_close(orr_text_server *s)
{
    if (s == NULL) return;
    orr_loop_halt(&s->loop);
    while (s->client != NULL) drop(s->client);
    orr_door_close(s->door);
    if (s->on_sweep != NULL) event_free(s->on_sweep);
    orr_loop_close(&s->loop);
    free(s->asked.room);
    free(s);
}
