// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/dial.h"

#include <errno.h>
#include <openssl/err.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/path.h"
#include "src/service/net/url.h"

enum { PASSED = sizeof((orr_dial *)NULL)->passed / sizeof(int) };

static void drop_passed(orr_dial *d)
{
    for (int k = 0; k < PASSED; k++) {
        if (d->passed[k] >= 0) close(d->passed[k]);
        d->passed[k] = -1;
    }
}

static ptrdiff_t read_socket(void *user, uint8_t *data, size_t n)
{
    orr_dial *d = user;
    union {
        struct cmsghdr head;
        char room[CMSG_SPACE(PASSED * sizeof(int))];
    } control;
    struct iovec bytes = {data, n};
    struct msghdr m;
    ssize_t got;
    do {
        m = (struct msghdr){.msg_iov = &bytes,
                            .msg_iovlen = 1,
                            .msg_control = control.room,
                            .msg_controllen = sizeof control.room};
        got = recvmsg(d->fd, &m, MSG_CMSG_CLOEXEC);
    } while (got < 0 && errno == EINTR);
    const struct cmsghdr *c = got > 0 ? CMSG_FIRSTHDR(&m) : NULL;
    if (c == NULL || c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_RIGHTS) return got;
    drop_passed(d);
    memcpy(d->passed, CMSG_DATA(c), c->cmsg_len - CMSG_LEN(0)); // at most as many: there was room for no more
    return got;
}

static ptrdiff_t write_socket(void *user, const uint8_t *data, size_t n)
{
    const orr_dial *d = user;
    ssize_t put;
    do put = send(d->fd, data, n, MSG_NOSIGNAL);
    while (put < 0 && errno == EINTR);
    return put;
}

static ptrdiff_t read_tls(void *user, uint8_t *data, size_t n)
{
    const orr_dial *d = user;
    size_t got;
    ERR_clear_error();
    errno = 0;
    if (SSL_read_ex(d->ssl, data, n, &got) == 1) return (ptrdiff_t)got;
    return SSL_get_error(d->ssl, 0) == SSL_ERROR_ZERO_RETURN ? 0 : -1;
}

static ptrdiff_t write_tls(void *user, const uint8_t *data, size_t n)
{
    const orr_dial *d = user;
    size_t put;
    ERR_clear_error();
    errno = 0;
    return orr_tls_write(d->ssl, data, n, &put) ? (ptrdiff_t)put : -1;
}

// What TLS stands on: the client's certificate and the authority beside it.
static orr_status identify(const char *url, const char *identity, SSL_CTX **context, orr_diag *diag)
{
    if (identity == NULL) identity = getenv("ORRERY_IDENTITY");
    if (identity == NULL || *identity == '\0')
        return orr_diag_set(diag, ORR_E_ARG,
                            "%s wants a certificate: --identity NAME.pem, as 'orrery tls init' makes it",
                            url);
    char authority[4096];
    const int folder = (int)(orr_base_name(identity) - identity);
    if (snprintf(authority, sizeof authority, "%.*sca.pem", folder, identity) >= (int)sizeof authority)
        return orr_diag_set(diag, ORR_E_ARG, "%.100s...: the name is too long", identity);
    const orr_tls_files files = {identity, identity, authority};
    return orr_tls_context(&files, false, context, diag);
}

orr_status orr_dial_open(const char *url, const char *identity, double timeout_s, orr_dial **out,
                         orr_diag *diag)
{
    orr_url u;
    orr_status s = orr_url_parse(url, &u, diag);
    if (s != ORR_OK) return s;
    orr_dial *d = calloc(1, sizeof *d);
    if (d == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    d->fd = d->passed[0] = d->passed[1] = -1;
    orr_url_text(&u, d->url);
    SSL_CTX *context = NULL;
    if (u.tls) s = identify(d->url, identity, &context, diag);
    if (s == ORR_OK) s = orr_url_connect(&u, timeout_s, &d->fd, diag);
    if (s == ORR_OK && u.tls) s = orr_tls_connect(context, d->fd, u.host, &d->ssl, diag);
    SSL_CTX_free(context);
    if (s != ORR_OK) {
        orr_dial_close(d);
        return s;
    }
    orr_client_init(&d->client,
                    u.tls ? (orr_client_io){d, read_tls, write_tls}
                          : (orr_client_io){d, read_socket, write_socket},
                    d->buffer, sizeof d->buffer);
    *out = d;
    return ORR_OK;
}

void orr_dial_close(orr_dial *d)
{
    if (d == NULL) return;
    orr_tls_free(d->ssl);
    drop_passed(d);
    if (d->fd >= 0) close(d->fd);
    free(d);
}

int orr_dial_passed(orr_dial *d)
{
    int *at = d->passed[0] >= 0 ? &d->passed[0] : &d->passed[1];
    const int fd = *at;
    *at = -1;
    return fd;
}

orr_status orr_dial_status(const orr_dial *d, orr_wire_status s, const char *doing, orr_diag *diag)
{
    switch (s) {
    case ORR_WIRE_OK:
        return ORR_OK;
    case ORR_WIRE_REFUSED: {
        const char *name = orr_msg_error_code_name(d->client.error_code);
        return orr_diag_set(diag, ORR_E_ARG, "%s: the server refused %s: %s (%s)", d->url, doing,
                            d->client.sentence, name != NULL ? name : "?");
    }
    case ORR_WIRE_IO:
        if (d->ssl != NULL && errno == ECONNRESET)
            return orr_diag_set(diag, ORR_E_IO,
                                "%s: %s: the server broke off; where that is at once, it does not accept the "
                                "certificate (its log says why)",
                                d->url, doing);
        if (d->ssl != NULL && errno == 0) {
            char reason[200];
            return orr_diag_set(diag, ORR_E_IO, "%s: %s: TLS: %s", d->url, doing,
                                orr_tls_reason(d->ssl, reason, sizeof reason));
        }
        if (errno == EAGAIN || errno == EWOULDBLOCK)
            return orr_diag_set(diag, ORR_E_IO, "%s: no answer to %s in time", d->url, doing);
        return orr_diag_set(diag, ORR_E_IO, "%s: %s: %s", d->url, doing, strerror(errno));
    case ORR_WIRE_CLOSED:
        return orr_diag_set(diag, ORR_E_IO, "%s: the server closed the connection", d->url);
    case ORR_WIRE_SPACE:
        return orr_diag_set(diag, ORR_E_LIMIT, "%s: %s: %s", d->url, doing, orr_wire_status_text(s));
    case ORR_WIRE_MAGIC:
        return orr_diag_set(diag, ORR_E_KIND, "%s: what answers there is no Orrery service", d->url);
    default:
        return orr_diag_set(diag, ORR_E_FORMAT, "%s: %s: %s", d->url, doing, orr_wire_status_text(s));
    }
}
