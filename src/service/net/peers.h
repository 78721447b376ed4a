// SPDX-License-Identifier: GPL-3.0-or-later
// What each address has taken of a service: connections that are open, how fast new ones come, how many requests. Networks of 64 bits
// count as one address of IPv6, as one customer has that many.
#ifndef ORR_SERVICE_NET_PEERS_H
#define ORR_SERVICE_NET_PEERS_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/socket.h>

#include "src/config/access.h"

enum { ORR_PEERS_MOST = 4096 };

// An amount that runs dry and is filled again at a constant rate up to `burst`. Zero-initialise: it is full at first.
typedef struct orr_allowance {
    double spent;
    int64_t at_ns;
} orr_allowance;
// Takes `n` of it, whether it is there or not.
//   Given:    a       the allowance
//             n       how much
//             per_s   how fast it is filled; 0: without limit
//             burst   how much there can be
//             now_ns  of a monotonic clock
//   Returned: (value) 0, or after how many ns it will be out of debt
int64_t orr_allowance_take(orr_allowance *a, double n, double per_s, double burst, int64_t now_ns);

typedef struct orr_peers orr_peers;
typedef struct orr_peer orr_peer;

// An empty table; NULL: out of memory.
orr_peers *orr_peers_open(void);
// Frees it; NULL is allowed.
void orr_peers_close(orr_peers *p);
// A new connection from an address.
//   Given:    p        the table
//             from     the address; other families than IPv4 and IPv6 have one entry
//             most     connections that may be open
//             per_s    new ones a second, twice as many at once; 0: any number
//             now_ns   of a monotonic clock
//   Returned: why      why it is refused
//             (value)  the address's entry, until orr_peers_leave; NULL: refused
orr_peer *orr_peers_enter(orr_peers *p, const struct sockaddr *from, int64_t most, double per_s,
                          int64_t now_ns, const char **why);
// A connection of it has closed; NULL is allowed.
void orr_peers_leave(orr_peer *e);
// Takes requests from what a connection and its address may ask.
//   Given:    own      of the connection
//             e        its address; NULL: it is not counted
//             n        how many requests
//             limits   the rates; bursts are of a second
//             now_ns   of a monotonic clock
//   Returned: (value)  until when the connection has to wait; 0: it has not
int64_t orr_peers_charge(orr_allowance *own, orr_peer *e, double n, const orr_access_limits *limits,
                         int64_t now_ns);

#endif
