// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/link.h"

#include <errno.h>
#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <event2/bufferevent_ssl.h>
#include <openssl/err.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "src/service/net/url.h"

struct orr_link {
    int fd;
    struct event *on_read, *on_write; // without TLS
    struct bufferevent *tls;
    SSL *ssl;            // of `tls`
    orr_log_rate update; // KeyUpdates
    bool want_read, want_write, finishing;
    int error; // of the connection, its end among them; 0: none
    void *user;
    orr_link_call *read, *write, *done, *failed;
    char why[200];
};

static orr_link *fail(orr_link *l, int fd)
{
    if (l == NULL)
        close(fd);
    else
        orr_link_close(l);
    return NULL;
}

static void readable(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    const orr_link *l = user;
    l->read(l->user);
}

static void writable(evutil_socket_t fd, short what, void *user)
{
    (void)fd;
    (void)what;
    const orr_link *l = user;
    l->write(l->user);
}

orr_link *orr_link_plain(struct event_base *base, int fd)
{
    orr_link *l = calloc(1, sizeof *l);
    if (l == NULL) return fail(l, fd);
    l->fd = fd;
    l->on_read = event_new(base, fd, EV_READ | EV_PERSIST, readable, l);
    l->on_write = event_new(base, fd, EV_WRITE | EV_PERSIST, writable, l);
    return l->on_read != NULL && l->on_write != NULL ? l : fail(l, fd);
}

static size_t received(const orr_link *l) { return evbuffer_get_length(bufferevent_get_input(l->tls)); }
static size_t waiting(const orr_link *l) { return evbuffer_get_length(bufferevent_get_output(l->tls)); }

// As an event of the kernel's: told again as long as there is something, whatever its user took.
static void tls_read(struct bufferevent *tls, void *user)
{
    const orr_link *l = user;
    if (!l->want_read || l->read == NULL || (received(l) == 0 && l->error == 0)) return;
    bufferevent_trigger(tls, EV_READ, BEV_TRIG_IGNORE_WATERMARKS | BEV_TRIG_DEFER_CALLBACKS);
    l->read(l->user); // the link may be gone now
}

static void say_farewell(const orr_link *l)
{
    ERR_clear_error();
    SSL_shutdown(l->ssl);
    ERR_clear_error();
    shutdown(l->fd, SHUT_WR);
}

static void tls_write(struct bufferevent *tls, void *user)
{
    orr_link *l = user;
    (void)tls;
    if (l->finishing && waiting(l) == 0) {
        l->finishing = false;
        say_farewell(l);
    }
    if (l->want_write && l->write != NULL) l->write(l->user);
}

static void tls_event(struct bufferevent *tls, short what, void *user)
{
    orr_link *l = user;
    if ((what & BEV_EVENT_CONNECTED) != 0) {
        if (l->done != NULL) l->done(l->user);
        return;
    }
    // Behind its end libevent sends nothing more either: what the peer has not had it never gets.
    if ((what & (BEV_EVENT_EOF | BEV_EVENT_ERROR | BEV_EVENT_TIMEOUT)) != 0) l->error = ECONNRESET;
    if (l->done != NULL && l->failed != NULL) { // the handshake
        orr_tls_reason_of(l->ssl, bufferevent_get_openssl_error(tls), l->why, sizeof l->why);
        l->failed(l->user);
        return;
    }
    // Whoever waits learns it from what it tries next.
    if (l->want_write && l->error != 0 && l->write != NULL)
        l->write(l->user);
    else
        tls_read(tls, l);
}

orr_link *orr_link_tls(struct event_base *base, int fd, SSL_CTX *context)
{
    orr_link *l = calloc(1, sizeof *l);
    if (l == NULL) return fail(l, fd);
    l->fd = fd;
    SSL *ssl = SSL_new(context);
    if (ssl == NULL) return fail(l, fd);
    // Deferred callbacks run outside of OpenSSL and of what we call ourselves; the connection is freed when libevent is done with it.
    l->tls = bufferevent_openssl_socket_new(base, fd, ssl, BUFFEREVENT_SSL_ACCEPTING,
                                            BEV_OPT_CLOSE_ON_FREE | BEV_OPT_DEFER_CALLBACKS);
    if (l->tls == NULL) return fail(l, fd); // and ssl is freed
    l->ssl = ssl;
    orr_tls_limit_updates(l->ssl, &l->update);
    bufferevent_openssl_set_allow_dirty_shutdown(l->tls, 1);
    bufferevent_setwatermark(l->tls, EV_READ, 0, ORR_LINK_BUFFER);
    bufferevent_setcb(l->tls, tls_read, tls_write, tls_event, l);
    return l;
}

void orr_link_serve(orr_link *l, void *user, orr_link_call *read, orr_link_call *write)
{
    l->user = user;
    l->read = read;
    l->write = write;
    l->done = l->failed = NULL;
}

void orr_link_await(orr_link *l, void *user, orr_link_call *done, orr_link_call *failed)
{
    l->user = user;
    l->done = done;
    l->failed = failed;
    bufferevent_enable(l->tls, EV_READ | EV_WRITE);
}

const char *orr_link_why(const orr_link *l) { return l->why; }

ssize_t orr_link_recv(orr_link *l, void *data, size_t n)
{
    if (l->tls == NULL) return recv(l->fd, data, n, 0);
    const size_t got = bufferevent_read(l->tls, data, n);
    if (got > 0) return (ssize_t)got;
    if (l->error != 0) return errno = l->error, -1;
    return errno = EAGAIN, -1;
}

ssize_t orr_link_send(orr_link *l, const void *data, size_t n)
{
    if (l->tls == NULL) return send(l->fd, data, n, MSG_NOSIGNAL);
    if (l->error != 0) return errno = l->error, -1;
    const size_t held = waiting(l);
    if (held >= ORR_LINK_BUFFER) return errno = EAGAIN, -1;
    if (n > ORR_LINK_BUFFER - held) n = ORR_LINK_BUFFER - held;
    if (bufferevent_write(l->tls, data, n) != 0) return errno = ENOMEM, -1;
    return (ssize_t)n;
}

static bool want_event(struct event *e, bool wanted)
{
    return (wanted ? event_add(e, NULL) : event_del(e)) == 0;
}

bool orr_link_passes(const orr_link *l)
{
    int domain = 0;
    socklen_t n = sizeof domain;
    return l->tls == NULL && getsockopt(l->fd, SOL_SOCKET, SO_DOMAIN, &domain, &n) == 0 && domain == AF_UNIX;
}

ssize_t orr_link_pass(orr_link *l, const void *data, size_t n, const int *fd, size_t n_fd)
{
    union {
        struct cmsghdr head;
        char room[CMSG_SPACE(ORR_LINK_PASSES * sizeof(int))];
    } control = {.head = {.cmsg_len = CMSG_LEN(n_fd * sizeof(int)),
                          .cmsg_level = SOL_SOCKET,
                          .cmsg_type = SCM_RIGHTS}};
    memcpy(CMSG_DATA(&control.head), fd, n_fd * sizeof *fd);
    struct iovec bytes = {(void *)(uintptr_t)data, n};
    const struct msghdr m = {.msg_iov = &bytes,
                             .msg_iovlen = 1,
                             .msg_control = control.room,
                             .msg_controllen = CMSG_SPACE(n_fd * sizeof(int))};
    return sendmsg(l->fd, &m, MSG_NOSIGNAL);
}

bool orr_link_want(orr_link *l, bool read, bool write)
{
    if (l->tls == NULL) {
        const bool reads = want_event(l->on_read, read), writes = want_event(l->on_write, write);
        return reads && writes;
    }
    l->want_read = read;
    l->want_write = write;
    const int flags = BEV_TRIG_IGNORE_WATERMARKS | BEV_TRIG_DEFER_CALLBACKS;
    if (read && (received(l) > 0 || l->error != 0)) bufferevent_trigger(l->tls, EV_READ, flags);
    if (write && (waiting(l) == 0 || l->error != 0)) bufferevent_trigger(l->tls, EV_WRITE, flags);
    return true;
}

bool orr_link_unsent(const orr_link *l) { return l->tls != NULL && l->error == 0 && waiting(l) > 0; }

void orr_link_finish(orr_link *l)
{
    if (l->tls == NULL)
        shutdown(l->fd, SHUT_WR);
    else if (waiting(l) == 0)
        say_farewell(l);
    else
        l->finishing = true;
}

bool orr_link_keep_short(const orr_link *l, int bytes)
{
    return setsockopt(l->fd, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes) == 0;
}

SSL *orr_link_ssl(const orr_link *l) { return l->ssl; }

bool orr_link_peer(const orr_link *l, struct sockaddr_storage *a, socklen_t *n)
{
    return getpeername(l->fd, (struct sockaddr *)a, n) == 0 && a->ss_family != AF_UNIX;
}

bool orr_link_is_local(const orr_link *l)
{
    struct sockaddr_storage a;
    socklen_t n = sizeof a;
    if (getpeername(l->fd, (struct sockaddr *)&a, &n) != 0) return false;
    return a.ss_family == AF_UNIX || orr_address_is_local((struct sockaddr *)&a);
}

void orr_link_close(orr_link *l)
{
    if (l == NULL) return;
    if (l->on_read != NULL) event_free(l->on_read);
    if (l->on_write != NULL) event_free(l->on_write);
    if (l->ssl != NULL) SSL_set_app_data(l->ssl, NULL); // it may outlive the link by a moment
    if (l->tls != NULL)
        bufferevent_free(l->tls);
    else
        close(l->fd);
    free(l);
}
