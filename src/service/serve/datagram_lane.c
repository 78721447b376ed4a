// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/serve/datagram_lane.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

typedef struct datagram_way {
    orr_way way;
    int fd;
    struct sockaddr_storage to;
    socklen_t n_to;
    uint32_t channel, stream;
    uint64_t number;
    orr_seal *seal; // NULL: none
    uint8_t *room;
    size_t capacity;
} datagram_way;

static uint16_t wrong(orr_server_refusal *why, uint16_t code, const char *sentence)
{
    snprintf(why->sentence, sizeof why->sentence, "%.250s", sentence);
    return code;
}

// Whether datagrams between the two are sealed, and by which keys. Other machines have to be.
static uint16_t find_seal(const orr_datagram_lane *l, bool *sealed, orr_seal_keys *keys,
                          orr_server_refusal *why)
{
    if (l->all == NULL) return wrong(why, ORR_MSG_ERROR_CODE_NOT_SERVED, "this server has no datagrams");
    SSL *ssl = orr_link_ssl(l->link);
    *sealed = ssl != NULL;
    if (ssl == NULL && !orr_link_is_local(l->link))
        return wrong(why, ORR_MSG_ERROR_CODE_NOT_PERMITTED,
                     "datagrams between machines are sealed by keys of a TLS session: connect by tls://");
    if (ssl != NULL && !orr_seal_keys_of(ssl, keys))
        return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, "the TLS session gave no keys");
    return 0;
}

uint16_t orr_datagram_lane_open(orr_datagram_lane *l, bool may, orr_seal_keys *room, orr_msg_datagrams *told,
                                orr_server_refusal *why)
{
    bool sealed;
    const uint16_t code = find_seal(l, &sealed, room, why);
    if (code != 0) return code;
    if (l->channel == 0) l->channel = orr_datagrams_admit(l->all, sealed ? room->client : NULL, may);
    if (l->channel == 0) return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, "out of memory");
    const orr_datagram_counts n = orr_datagrams_count(l->all, l->channel);
    *told = (orr_msg_datagrams){.channel = l->channel,
                                .port = orr_datagrams_port(l->all),
                                .seal = sealed ? ORR_MSG_SEAL_HMAC_SHA256 : ORR_MSG_SEAL_NONE,
                                .taken = n.taken,
                                .replayed = n.replayed,
                                .refused = n.refused};
    if (sealed) told->keys = (orr_wire_bytes){room->client, sizeof *room};
    return 0;
}

void orr_datagram_lane_permit(const orr_datagram_lane *l, bool may)
{
    if (l->channel != 0) orr_datagrams_permit(l->all, l->channel, may);
}

void orr_datagram_lane_close(orr_datagram_lane *l)
{
    if (l->channel != 0) orr_datagrams_leave(l->all, l->channel);
    l->channel = 0;
}

// --- Streams ---

static bool get_room(datagram_way *d, size_t n)
{
    if (n <= d->capacity) return true;
    uint8_t *grown = realloc(d->room, n);
    if (grown == NULL) return false;
    d->room = grown;
    d->capacity = n;
    return true;
}

// What the kernel does not take is lost as on the way: its number says so.
static bool put(orr_way *w, uint16_t type, const uint8_t *data, size_t size)
{
    datagram_way *d = (datagram_way *)w;
    const size_t whole = ORR_DATAGRAM_HEAD + ORR_FRAME_OVERHEAD + size;
    if (size > ORR_DATAGRAM_FRAME || !get_room(d, whole + ORR_DATAGRAM_SEAL)) return false;
    orr_wire_writer out = {d->room, ORR_DATAGRAM_HEAD, d->capacity, ORR_WIRE_OK};
    size_t start;
    orr_datagram_head(d->room, d->channel, ++d->number);
    orr_frame_begin(&out, type, d->stream, &start);
    orr_wire_put_raw(&out, data, size);
    orr_frame_end(&out, start);
    if (d->seal != NULL && !orr_seal_put(d->seal, d->room, whole)) return false;
    const ssize_t sent = sendto(d->fd, d->room, whole + (d->seal != NULL ? ORR_DATAGRAM_SEAL : 0),
                                MSG_NOSIGNAL | MSG_DONTWAIT, (const struct sockaddr *)&d->to, d->n_to);
    return sent >= 0 || errno != EMSGSIZE;
}

static void close_way(orr_way *w)
{
    datagram_way *d = (datagram_way *)w;
    if (d->fd >= 0) close(d->fd);
    orr_seal_close(d->seal);
    free(d->room);
    free(d);
}

// The client's address, or this machine where it came by a Unix socket.
static void find_address(const orr_link *link, uint16_t port, datagram_way *d)
{
    d->n_to = sizeof d->to;
    if (!orr_link_peer(link, &d->to, &d->n_to)) {
        struct sockaddr_in here = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
        memcpy(&d->to, &here, sizeof here);
        d->n_to = sizeof here;
    }
    if (d->to.ss_family == AF_INET6)
        ((struct sockaddr_in6 *)(void *)&d->to)->sin6_port = htons(port);
    else
        ((struct sockaddr_in *)(void *)&d->to)->sin_port = htons(port);
}

uint16_t orr_datagram_lane_way(const orr_datagram_lane *l, uint16_t port, uint32_t stream, orr_way **out,
                               uint32_t *channel, orr_server_refusal *why)
{
    bool sealed;
    orr_seal_keys keys;
    if (port == 0)
        return wrong(why, ORR_MSG_ERROR_CODE_BAD_REQUEST, "SUBSCRIBE: datagrams want a port of the client's");
    const uint16_t code = find_seal(l, &sealed, &keys, why);
    if (code != 0) return code;
    datagram_way *d = calloc(1, sizeof *d);
    if (d == NULL) return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, "out of memory");
    d->way = (orr_way){.fd = -1, .lossy = true, .put = put, .close = close_way};
    d->stream = stream;
    find_address(l->link, port, d);
    d->fd = socket(d->to.ss_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (sealed) d->seal = orr_seal_open(keys.server);
    if (d->fd < 0 || (sealed && d->seal == NULL)) {
        close_way(&d->way);
        return wrong(why, ORR_MSG_ERROR_CODE_INTERNAL, "SUBSCRIBE: no socket for datagrams");
    }
    *channel = d->channel = orr_datagrams_number(l->all);
    *out = &d->way;
    return 0;
}
