// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of one connection on a libevent loop, with TLS (bufferevent_openssl) or without: who owns it reads, writes and waits in the
// same way. Without TLS every call is one of the kernel's.
#ifndef ORR_SERVICE_NET_LINK_H
#define ORR_SERVICE_NET_LINK_H

#include <event2/event.h>
#include <sys/socket.h>
#include <sys/types.h>

#include "src/service/net/tls.h"

enum { ORR_LINK_PASSES = 2, ORR_LINK_BUFFER = 64 << 10 }; // bytes that TLS holds in either direction, at most

typedef struct orr_link orr_link;
typedef void orr_link_call(void *user);

// Takes an accepted non-blocking socket over; NULL, and it is closed, where there is no memory.
orr_link *orr_link_plain(struct event_base *base, int fd);
// The same with TLS, whose handshake the peer begins; the connection is the link's in any case. Its user's `read` is called when the
// handshake is done, `failed` where it is not.
orr_link *orr_link_tls(struct event_base *base, int fd, SSL_CTX *context);
// Who is told that there is something to read (its end too), or room to write.
//   Given:    l        the link
//             user     handed to both
//             read     called while reading is wanted
//             write    called while writing is wanted
void orr_link_serve(orr_link *l, void *user, orr_link_call *read, orr_link_call *write);
// While the handshake is under way.
//   Given:    l        the link
//             user     handed to both
//             done     it is done
//             failed   it is not, and why (orr_link_why)
void orr_link_await(orr_link *l, void *user, orr_link_call *done, orr_link_call *failed);
// Why the handshake failed.
const char *orr_link_why(const orr_link *l);
// As recv does, errno and all; the end of a TLS connection is ECONNRESET.
ssize_t orr_link_recv(orr_link *l, void *data, size_t n);
// As send with MSG_NOSIGNAL does.
ssize_t orr_link_send(orr_link *l, const void *data, size_t n);
// Whether descriptors can go along with bytes: a Unix socket without TLS.
bool orr_link_passes(const orr_link *l);
// As orr_link_send, of a link that passes, with descriptors that go along with the first byte.
//   Given:    l      the link
//             data   n bytes
//             fd     n_fd descriptors, at most ORR_LINK_PASSES
ssize_t orr_link_pass(orr_link *l, const void *data, size_t n, const int *fd, size_t n_fd);
// What is waited for from now on. False: out of memory.
bool orr_link_want(orr_link *l, bool read, bool write);
// Whether bytes that orr_link_send took have not gone to the kernel.
bool orr_link_unsent(const orr_link *l);
// Nothing more will be sent: tells the peer, once all has gone.
void orr_link_finish(orr_link *l);
// Limits what the kernel keeps unsent. False with errno.
bool orr_link_keep_short(const orr_link *l, int bytes);
// The connection's TLS; NULL where there is none.
SSL *orr_link_ssl(const orr_link *l);
// The address that the peer has; false where it has none: a Unix socket.
//   Given:    l   the link
//             n   room of *a
//   Returned: a   the address
//             n   its bytes
bool orr_link_peer(const orr_link *l, struct sockaddr_storage *a, socklen_t *n);
// Whether the peer is on this machine: by loopback or a Unix socket.
bool orr_link_is_local(const orr_link *l);
// Closes and frees it, whatever is under way; NULL is allowed.
void orr_link_close(orr_link *l);

#endif
