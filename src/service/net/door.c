// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/door.h"

#include <errno.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/monotonic.h"
#include "core/outfile.h"

enum { MOST = 16 };

typedef struct listener {
    orr_door *door;
    int fd;
    orr_url url;
    char text[ORR_URL_TEXT];
    ino_t inode; // of a Unix socket's file: only our own is removed
    struct event *on_accept;
    bool paused, local;
} listener;

// A TLS handshake under way.
typedef struct arrival arrival;
struct arrival {
    orr_door *door;
    orr_link *link;
    orr_guest guest;
    int64_t since_ns;
    arrival *next, *prev;
};

struct orr_door {
    orr_door_options options;
    orr_peers *peers;
    listener at[MOST];
    size_t n;
    arrival *arrivals;
    int64_t n_arrivals;
};

static void tell(const orr_door *d, const char *fmt, ...) ORR_PRINTF(2, 3);
static void tell(const orr_door *d, const char *fmt, ...)
{
    char line[600];
    va_list args;
    va_start(args, fmt);
    vsnprintf(line, sizeof line, fmt, args);
    va_end(args);
    d->options.tell(d->options.user, line);
}

static void name_peer(const listener *l, const struct sockaddr *a, socklen_t n, int fd, orr_guest *g)
{
    char host[96], port[8];
    if (l->url.is_unix)
        snprintf(g->peer, sizeof g->peer, "client %d on %.100s", fd, l->text);
    else if (getnameinfo(a, n, host, sizeof host, port, sizeof port, NI_NUMERICHOST | NI_NUMERICSERV) == 0)
        snprintf(g->peer, sizeof g->peer, "client %s:%s", host, port);
    else
        snprintf(g->peer, sizeof g->peer, "client %d", fd);
}

// --- Handshakes ---

static orr_link *take_link(arrival *a)
{
    orr_link *link = a->link;
    orr_door *d = a->door;
    if (a->prev != NULL)
        a->prev->next = a->next;
    else
        d->arrivals = a->next;
    if (a->next != NULL) a->next->prev = a->prev;
    d->n_arrivals--;
    free(a);
    return link;
}

static void end_arrival(arrival *a)
{
    orr_peers_leave(a->guest.account);
    orr_link_close(take_link(a));
}

static void on_done(void *user)
{
    arrival *a = user;
    orr_door *d = a->door;
    orr_guest g = a->guest;
    if (!orr_tls_peer_name(orr_link_ssl(a->link), g.name)) {
        tell(d, ORR_ID("N04") "%s refused: its certificate has no common name of printable characters",
             g.peer);
        end_arrival(a);
        return;
    }
    g.may = orr_access_named(d->options.access, g.name);
    const size_t n = strlen(g.peer);
    snprintf(g.peer + n, sizeof g.peer - n, " (%s)", g.name);
    d->options.enter(d->options.user, take_link(a), &g);
}

static void on_failed(void *user)
{
    arrival *a = user;
    tell(a->door, ORR_ID("N03") "%s refused: TLS: %s", a->guest.peer, orr_link_why(a->link));
    end_arrival(a);
}

static void begin_handshake(orr_door *d, int fd, const orr_guest *g)
{
    SSL_CTX *context = orr_access_tls(d->options.access);
    arrival *a = calloc(1, sizeof *a);
    orr_link *link = context != NULL && a != NULL ? orr_link_tls(d->options.base, fd, context) : NULL;
    if (context == NULL || a == NULL) close(fd);
    SSL_CTX_free(context); // the link has its own hold on it
    if (link == NULL) {
        free(a);
        tell(d, ORR_ID("N07") "%s refused: out of memory", g->peer);
        orr_peers_leave(g->account);
        return;
    }
    *a = (arrival){.door = d, .link = link, .guest = *g, .since_ns = orr_monotonic_ns(), .next = d->arrivals};
    if (d->arrivals != NULL) d->arrivals->prev = a;
    d->arrivals = a;
    d->n_arrivals++;
    orr_link_await(link, a, on_done, on_failed);
}

bool orr_guest_readmit(orr_guest *g, orr_access *access)
{
    const unsigned edition = orr_access_edition(access);
    if (g->name[0] == '\0') return true;
    if (g->edition != edition) g->may = orr_access_named(access, g->name);
    g->edition = edition;
    return g->may != ORR_MAY_NOTHING;
}

// --- Arrivals ---

static void come_in(const listener *l, int fd, orr_guest *g)
{
    orr_door *d = l->door;
    if (l->url.tls) {
        if (d->n_arrivals >= orr_access_limits_of(d->options.access).handshakes) {
            tell(d, ORR_ID("N05") "%s refused: as many TLS handshakes are under way as may be", g->peer);
            orr_peers_leave(g->account);
            close(fd);
            return;
        }
        begin_handshake(d, fd, g);
        return;
    }
    g->may = orr_access_plain(d->options.access);
    orr_link *link = orr_link_plain(d->options.base, fd);
    if (link != NULL) {
        d->options.enter(d->options.user, link, g);
        return;
    }
    tell(d, ORR_ID("N07") "%s refused: out of memory", g->peer);
    orr_peers_leave(g->account);
}

// Nothing waits for more to send; and a peer whose machine has gone without a word is found out in a minute and a half.
static void prepare_socket(int fd)
{
    static const int one = 1, idle_s = 60, every_s = 10, times = 3;
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
    setsockopt(fd, SOL_SOCKET, SO_KEEPALIVE, &one, sizeof one);
    setsockopt(fd, IPPROTO_TCP, TCP_KEEPIDLE, &idle_s, sizeof idle_s);
    setsockopt(fd, IPPROTO_TCP, TCP_KEEPINTVL, &every_s, sizeof every_s);
    setsockopt(fd, IPPROTO_TCP, TCP_KEEPCNT, &times, sizeof times);
}

static void on_accept(evutil_socket_t fd, short what, void *user)
{
    (void)what;
    listener *l = user;
    orr_door *d = l->door;
    struct sockaddr_storage a;
    socklen_t n = sizeof a;
    int client = accept4(fd, (struct sockaddr *)&a, &n, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (client < 0) {
        if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
            // The connection stays in the queue and the event would fire again at once: look again at the
            // next sweep.
            tell(d, ORR_ID("N01") "cannot accept a client: %s", strerror(errno));
            event_del(l->on_accept);
            l->paused = true;
        }
        return;
    }
    if (!l->url.is_unix) prepare_socket(client);
    orr_guest g = {.insecure = !l->local && !l->url.tls};
    name_peer(l, (struct sockaddr *)&a, n, client, &g);
    const orr_access_limits limits = orr_access_limits_of(d->options.access);
    g.limited = limits.local || !l->local;
    if (g.limited) {
        const char *why;
        g.account = orr_peers_enter(d->peers, (struct sockaddr *)&a, limits.clients_per_address,
                                    limits.connections_per_s, orr_monotonic_ns(), &why);
        if (g.account == NULL) {
            tell(d, ORR_ID("N02") "%s refused: %s", g.peer, why);
            close(client);
            return;
        }
    }
    come_in(l, client, &g);
}

// --- The door itself ---

orr_door *orr_door_open(const orr_door_options *options)
{
    orr_door *d = calloc(1, sizeof *d);
    if (d == NULL) return NULL;
    d->options = *options;
    d->peers = orr_peers_open();
    if (d->peers != NULL) return d;
    free(d);
    return NULL;
}

// An address that is listened on becomes one of the door's, if the rules allow it; from here on orr_door_shut closes it.
static orr_status take_in(orr_door *d, listener *l, orr_diag *diag)
{
    d->n++;
    orr_url_text(&l->url, l->text);
    l->local = orr_url_is_local(&l->url);
    orr_status s = orr_access_listen(d->options.access, &l->url,
                                     diag); // a name has become an address; nobody is accepted yet
    if (s != ORR_OK) return s;
    l->on_accept = event_new(d->options.base, l->fd, EV_READ | EV_PERSIST, on_accept, l);
    if (l->on_accept == NULL || event_add(l->on_accept, NULL) != 0)
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (!l->local && !l->url.tls)
        tell(d,
             ORR_ID("R09") "%s can be reached from other machines without authentication (insecure_listen): "
                           "whoever reaches it may do everything",
             l->text);
    return ORR_OK;
}

static listener *next_listener(orr_door *d, orr_diag *diag)
{
    if (d->n == MOST) {
        orr_diag_set(diag, ORR_E_LIMIT, "at most %d addresses to listen on", MOST);
        return NULL;
    }
    d->at[d->n] = (listener){.door = d, .fd = -1};
    return &d->at[d->n];
}

orr_status orr_door_listen(orr_door *d, const char *url, orr_diag *diag)
{
    listener *l = next_listener(d, diag);
    if (l == NULL) return ORR_E_LIMIT;
    orr_url wanted;
    orr_status s = orr_url_parse(url, &wanted, diag);
    if (s == ORR_OK) s = orr_url_listen(&wanted, d->options.backlog, &l->fd, &l->url, diag);
    if (s != ORR_OK) return s;
    struct stat st;
    if (l->url.is_unix) orr_outfile_remember(l->url.path);
    if (l->url.is_unix && lstat(l->url.path, &st) == 0) l->inode = st.st_ino;
    s = take_in(d, l, diag);
    return s == ORR_OK ? orr_access_give(d->options.access, &l->url, diag) : s;
}

orr_status orr_door_adopt(orr_door *d, int fd, bool tls, orr_diag *diag)
{
    listener *l = next_listener(d, diag);
    if (l == NULL) return ORR_E_LIMIT;
    const orr_status s = orr_url_of_socket(fd, &l->url, diag);
    if (s != ORR_OK) return s;
    l->fd = fd;
    l->url.tls = tls && !l->url.is_unix;
    return take_in(d, l, diag);
}

const char *orr_door_url(const orr_door *d, size_t i) { return i < d->n ? d->at[i].text : NULL; }

void orr_door_sweep(orr_door *d, int64_t now_ns)
{
    const double most_s = orr_access_limits_of(d->options.access).handshake_s;
    for (arrival *a = d->arrivals, *next; a != NULL; a = next) {
        next = a->next;
        if ((double)(now_ns - a->since_ns) * 1e-9 < most_s) continue;
        tell(d, ORR_ID("N06") "%s closed: its TLS handshake takes too long", a->guest.peer);
        end_arrival(a);
    }
    for (size_t i = 0; i < d->n; i++) {
        listener *l = &d->at[i];
        if (l->paused && l->on_accept != NULL) event_add(l->on_accept, NULL);
        l->paused = false;
    }
}

void orr_door_shut(orr_door *d)
{
    while (d->arrivals != NULL) end_arrival(d->arrivals);
    for (size_t i = 0; i < d->n; i++) {
        listener *l = &d->at[i];
        if (l->on_accept != NULL) event_free(l->on_accept);
        l->on_accept = NULL;
        if (l->fd < 0) continue;
        close(l->fd);
        l->fd = -1;
        struct stat st;
        if (l->url.is_unix && lstat(l->url.path, &st) == 0 && S_ISSOCK(st.st_mode) && st.st_ino == l->inode)
            unlink(l->url.path);
        if (l->url.is_unix) orr_outfile_forget(l->url.path);
    }
}

void orr_door_close(orr_door *d)
{
    if (d == NULL) return;
    orr_door_shut(d);
    orr_peers_close(d->peers);
    free(d);
}
