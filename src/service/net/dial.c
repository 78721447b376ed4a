// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/dial.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "src/service/net/url.h"

static ptrdiff_t read_socket(void *user, uint8_t *data, size_t n)
{
    const orr_dial *d = user;
    ssize_t got;
    do got = recv(d->fd, data, n, 0);
    while (got < 0 && errno == EINTR);
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

orr_status orr_dial_open(const char *url, double timeout_s, orr_dial **out, orr_diag *diag)
{
    orr_url u;
    orr_status s = orr_url_parse(url, &u, diag);
    if (s != ORR_OK) return s;
    orr_dial *d = calloc(1, sizeof *d);
    if (d == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    orr_url_text(&u, d->url);
    s = orr_url_connect(&u, timeout_s, &d->fd, diag);
    if (s != ORR_OK) {
        free(d);
        return s;
    }
    orr_client_init(&d->client, (orr_client_io){d, read_socket, write_socket}, d->buffer, sizeof d->buffer);
    *out = d;
    return ORR_OK;
}

void orr_dial_close(orr_dial *d)
{
    if (d == NULL) return;
    close(d->fd);
    free(d);
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
