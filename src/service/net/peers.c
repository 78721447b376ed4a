// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/net/peers.h"

#include <math.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <string.h>

enum { SLOTS = 8 }; // places that an address may have

struct orr_peer {
    bool used;
    int family;
    uint8_t address[8]; // IPv4, or the network of IPv6
    int64_t open, last_ns;
    orr_allowance arrivals, requests;
};

struct orr_peers {
    uint64_t salt; // so that nobody knows which addresses share their places
    orr_peer entry[ORR_PEERS_MOST];
};

int64_t orr_allowance_take(orr_allowance *a, double n, double per_s, double burst, int64_t now_ns)
{
    if (!(per_s > 0)) return 0;
    const double elapsed_s = a->at_ns != 0 ? (double)(now_ns - a->at_ns) * 1e-9 : 0;
    a->spent = fmax(0, a->spent - elapsed_s * per_s) + n;
    a->at_ns = now_ns;
    return a->spent > burst ? (int64_t)((a->spent - burst) / per_s * 1e9) : 0;
}

orr_peers *orr_peers_open(void)
{
    orr_peers *p = calloc(1, sizeof *p);
    if (p != NULL) p->salt = (uint64_t)(uintptr_t)p * 0x9e3779b97f4a7c15u;
    return p;
}

void orr_peers_close(orr_peers *p) { free(p); }

static void key_of(const struct sockaddr *from, orr_peer *key)
{
    static const uint8_t mapped[12] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
    *key = (orr_peer){.family = from->sa_family};
    if (from->sa_family == AF_INET) {
        memcpy(key->address, &((const struct sockaddr_in *)(const void *)from)->sin_addr, 4);
    } else if (from->sa_family == AF_INET6) {
        const uint8_t *a = ((const struct sockaddr_in6 *)(const void *)from)->sin6_addr.s6_addr;
        const bool v4 = memcmp(a, mapped, sizeof mapped) == 0; // by a socket of both
        if (v4) key->family = AF_INET;
        memcpy(key->address, v4 ? a + 12 : a, v4 ? 4 : 8);
    }
}

static size_t place_of(const orr_peers *p, const orr_peer *key)
{
    uint64_t x = p->salt ^ (uint64_t)key->family;
    for (size_t k = 0; k < sizeof key->address; k++) x = (x ^ key->address[k]) * 0x100000001b3u;
    return (size_t)((x ^ x >> 32) % (ORR_PEERS_MOST / SLOTS)) * SLOTS;
}

// The entry of an address, or one that has been of no use for the longest time; NULL where all its places have connections.
static orr_peer *find(orr_peers *p, const orr_peer *key)
{
    orr_peer *set = &p->entry[place_of(p, key)], *spare = NULL;
    for (size_t k = 0; k < SLOTS; k++) {
        orr_peer *e = &set[k];
        if (e->used && e->family == key->family && memcmp(e->address, key->address, sizeof e->address) == 0)
            return e;
        if (e->open == 0 && (spare == NULL || e->last_ns < spare->last_ns)) spare = e;
    }
    if (spare == NULL) return NULL;
    *spare = *key;
    spare->used = true;
    return spare;
}

orr_peer *orr_peers_enter(orr_peers *p, const struct sockaddr *from, int64_t most, double per_s,
                          int64_t now_ns, const char **why)
{
    orr_peer key;
    key_of(from, &key);
    orr_peer *e = find(p, &key);
    *why = "too many addresses are connected";
    if (e == NULL) return NULL;
    e->last_ns = now_ns;
    *why = "as many connections are open from this address as may be";
    if (e->open >= most) return NULL;
    *why = "connections come from this address too fast";
    orr_allowance arrivals = e->arrivals;
    if (orr_allowance_take(&arrivals, 1, per_s, fmax(1, 2 * per_s), now_ns) > 0) return NULL; // costs nothing
    e->arrivals = arrivals;
    e->open++;
    *why = NULL;
    return e;
}

void orr_peers_leave(orr_peer *e)
{
    if (e != NULL) e->open--;
}

int64_t orr_peers_charge(orr_allowance *own, orr_peer *e, double n, const orr_access_limits *limits,
                         int64_t now_ns)
{
    const double one = limits->requests_per_s, all = limits->requests_per_s_per_address;
    const int64_t wait = orr_allowance_take(own, n, one, one, now_ns);
    const int64_t other = e != NULL ? orr_allowance_take(&e->requests, n, all, all, now_ns) : 0;
    const int64_t longer = wait > other ? wait : other;
    return longer > 0 ? now_ns + longer : 0;
}
