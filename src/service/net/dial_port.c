// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/dial_port.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <openssl/crypto.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "src/service/net/seal.h"

enum { RECEIVED = 4 << 20 }; // bytes that the kernel may keep

struct orr_dial_port {
    orr_dial *dial;
    int fd;
    uint16_t number;
    orr_msg_datagrams told;  // without its keys
    orr_seal *mine, *theirs; // NULL: none
    orr_datagram_reader reader;
    uint64_t sent;
    uint8_t in[ORR_DATAGRAM_MOST];
};

static void set_port(struct sockaddr_storage *a, uint16_t port)
{
    if (a->ss_family == AF_INET6)
        ((struct sockaddr_in6 *)(void *)a)->sin6_port = htons(port);
    else
        ((struct sockaddr_in *)(void *)a)->sin_port = htons(port);
}

// The address of one end of the connection; loopback where that is a Unix socket.
static socklen_t address_of(const orr_dial *d, bool peer, uint16_t port, struct sockaddr_storage *a)
{
    socklen_t n = sizeof *a;
    const int got =
        peer ? getpeername(d->fd, (struct sockaddr *)a, &n) : getsockname(d->fd, (struct sockaddr *)a, &n);
    if (got != 0 || a->ss_family == AF_UNIX) {
        const struct sockaddr_in here = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
        memcpy(a, &here, sizeof here);
        n = sizeof here;
    }
    set_port(a, port);
    return n;
}

// What the server told has to be what this end of the session gives: then nobody stands between the two.
static orr_status take_keys(orr_dial_port *p, const orr_msg_datagrams *told, orr_diag *diag)
{
    orr_seal_keys keys;
    if (p->dial->ssl == NULL) return ORR_OK;
    if (told->seal != ORR_MSG_SEAL_HMAC_SHA256 || told->keys.size != sizeof keys ||
        !orr_seal_keys_of(p->dial->ssl, &keys) || CRYPTO_memcmp(&keys, told->keys.data, sizeof keys) != 0)
        return orr_diag_set(diag, ORR_E_FORMAT,
                            "%s: the keys of its datagrams are not those of the TLS session", p->dial->url);
    p->mine = orr_seal_open(keys.client);
    p->theirs = orr_seal_open(keys.server);
    return p->mine != NULL && p->theirs != NULL ? ORR_OK : orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
}

static orr_status bind_here(orr_dial_port *p, orr_diag *diag)
{
    struct sockaddr_storage a;
    socklen_t n = address_of(p->dial, false, 0, &a);
    const int most = RECEIVED;
    p->fd = socket(a.ss_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (p->fd < 0 || bind(p->fd, (struct sockaddr *)&a, n) != 0 ||
        getsockname(p->fd, (struct sockaddr *)&a, &n) != 0)
        return orr_diag_set(diag, ORR_E_IO, "no UDP port: %s", strerror(errno));
    // What the kernel does not grant only makes it lose more.
    (void)setsockopt(p->fd, SOL_SOCKET, SO_RCVBUF, &most, sizeof most);
    p->number = ntohs(a.ss_family == AF_INET6 ? ((struct sockaddr_in6 *)(void *)&a)->sin6_port
                                              : ((struct sockaddr_in *)(void *)&a)->sin_port);
    return ORR_OK;
}

orr_status orr_dial_port_open(orr_dial *d, orr_dial_port **out, orr_diag *diag)
{
    const orr_msg_open_datagrams ask = {0};
    orr_dial_port *p = calloc(1, sizeof *p);
    if (p == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    p->dial = d;
    p->fd = -1;
    orr_status s =
        orr_dial_status(d, orr_client_open_datagrams(&d->client, &ask, &p->told), "OPEN_DATAGRAMS", diag);
    if (s == ORR_OK) s = take_keys(p, &p->told, diag);
    p->told.keys = (orr_wire_bytes){0};
    if (s == ORR_OK) s = bind_here(p, diag);
    if (s != ORR_OK) {
        orr_dial_port_close(p);
        return s;
    }
    p->reader.holds = p->theirs != NULL ? orr_seal_holds : NULL;
    p->reader.user = p->theirs;
    *out = p;
    return ORR_OK;
}

void orr_dial_port_close(orr_dial_port *p)
{
    if (p == NULL) return;
    if (p->fd >= 0) close(p->fd);
    orr_seal_close(p->mine);
    orr_seal_close(p->theirs);
    free(p);
}

uint16_t orr_dial_port_number(const orr_dial_port *p) { return p->number; }
void orr_dial_port_take_up(orr_dial_port *p, uint32_t channel) { p->reader.channel = channel; }
const orr_datagram_reader *orr_dial_port_reader(const orr_dial_port *p) { return &p->reader; }

// Whether bytes of the connection have been read that no frame was made of yet.
static bool has_some(const orr_dial *d)
{
    return d->client.size > d->client.used || (d->ssl != NULL && SSL_pending(d->ssl) > 0);
}

static bool take_datagram(orr_dial_port *p, orr_frame *f)
{
    for (;;) {
        const ssize_t n = recv(p->fd, p->in, sizeof p->in, MSG_DONTWAIT);
        if (n < 0) return false;
        if (orr_datagram_read(&p->reader, p->in, (size_t)n, f)) return true;
    }
}

orr_dial_port_what orr_dial_port_next(orr_dial_port *p, int timeout_ms, orr_frame *f, orr_wire_status *status)
{
    *status = ORR_WIRE_OK;
    struct pollfd w[2] = {{.fd = p->fd, .events = POLLIN}, {.fd = p->dial->fd, .events = POLLIN}};
    for (;;) {
        if (take_datagram(p, f)) return ORR_DIAL_PORT_DATAGRAM;
        if (has_some(p->dial) || w[1].revents != 0) break;
        if (poll(w, 2, timeout_ms) <= 0) return ORR_DIAL_PORT_NOTHING;
    }
    *status = orr_client_next(&p->dial->client, f);
    return *status == ORR_WIRE_OK ? ORR_DIAL_PORT_CONNECTION : ORR_DIAL_PORT_FAILED;
}

orr_status orr_dial_port_motion(orr_dial_port *p, const orr_msg_motion *m, orr_diag *diag)
{
    uint8_t data[ORR_DATAGRAM_HEAD + ORR_FRAME_OVERHEAD + ORR_MSG_MOTION_LARGEST + ORR_DATAGRAM_SEAL];
    orr_wire_writer w = {data, ORR_DATAGRAM_HEAD, sizeof data - ORR_DATAGRAM_SEAL, ORR_WIRE_OK};
    struct sockaddr_storage to;
    size_t start;
    if (p->told.port == 0)
        return orr_diag_set(diag, ORR_E_ARG, "%s takes no motion by datagrams: serve --motion --motion-udp",
                            p->dial->url);
    orr_datagram_head(data, p->told.channel, ++p->sent);
    orr_frame_begin(&w, ORR_MSG_TYPE_MOTION, (uint32_t)p->sent, &start);
    orr_msg_motion_encode(m, &w);
    orr_frame_end(&w, start);
    size_t n = w.size;
    if (p->mine != NULL && !orr_seal_put(p->mine, data, n))
        return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    if (p->mine != NULL) n += ORR_DATAGRAM_SEAL;
    const socklen_t n_to = address_of(p->dial, true, p->told.port, &to);
    if (sendto(p->fd, data, n, MSG_NOSIGNAL, (struct sockaddr *)&to, n_to) >= 0) return ORR_OK;
    return orr_diag_set(diag, ORR_E_IO, "%s: UDP port %u: %s", p->dial->url, (unsigned)p->told.port,
                        strerror(errno));
}
