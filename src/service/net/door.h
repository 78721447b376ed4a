// SPDX-License-Identifier: GPL-3.0-or-later
// Addresses that are listened on, and who comes in there: limits of addresses, TLS handshakes with their number and time, the name of the
// certificate and what it may do. What comes out is a link that can be served. All of it runs on one libevent loop.
#ifndef ORR_SERVICE_NET_DOOR_H
#define ORR_SERVICE_NET_DOOR_H

#include "src/service/net/access.h"
#include "src/service/net/link.h"
#include "src/service/net/peers.h"

// A client that has come in.
typedef struct orr_guest {
    char peer[160];          // who it is, for the log: "client 10.0.0.7:40000 (flight-1)"
    char name[ORR_TLS_NAME]; // of its certificate; "" without TLS
    unsigned may;            // orr_may
    unsigned edition;        // of the rules by which it may; 0: they are asked at once
    bool insecure;           // from another machine, perhaps, and without TLS
    bool limited;            // rates hold for it
    orr_peer *account;       // of its address; orr_peers_leave when it has gone. NULL: not counted
} orr_guest;

// Brings what a guest may do up to date with the rules, which may have been read again since it came. False: it has come by its
// certificate's name and has no permission left.
bool orr_guest_readmit(orr_guest *g, orr_access *access);

typedef struct orr_door_options {
    struct event_base *base;
    orr_access *access;
    int backlog;
    void *user;
    // Takes the link and the account over.
    void (*enter)(void *user, orr_link *link, const orr_guest *guest);
    // A line about a client, or of an address that other machines reach without TLS, without its newline.
    void (*tell)(void *user, const char *line);
} orr_door_options;

typedef struct orr_door orr_door;

// Without addresses at first; NULL: out of memory. Close with orr_door_close.
orr_door *orr_door_open(const orr_door_options *options);
// Listens at one more address, if the rules allow it. ORR_E_ARG (no address, or the rules do not), ORR_E_IO, ORR_E_LIMIT (16 are the most),
// ORR_E_MEMORY.
orr_status orr_door_listen(orr_door *d, const char *url, orr_diag *diag);
// Listens at a socket that somebody else listens on already and has handed over; its file, where it is a Unix socket, stays his.
// Errors: ORR_E_ARG (no listening socket, or the rules do not allow it), ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_door_adopt(orr_door *d, int fd, bool tls, orr_diag *diag);
// The i-th address as bound, as text; NULL beyond the last.
const char *orr_door_url(const orr_door *d, size_t i);
// Several times a second: handshakes that take too long are ended, addresses that ran out of descriptors are tried again.
void orr_door_sweep(orr_door *d, int64_t now_ns);
// Listens no more, and removes the files of Unix sockets; handshakes under way are ended.
void orr_door_shut(orr_door *d);
void orr_door_close(orr_door *d); // NULL is allowed

#endif
