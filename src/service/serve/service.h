// SPDX-License-Identifier: GPL-3.0-or-later
// The service: sockets in, an orr_server's answers out, on one libevent loop. It moves bytes and keeps time;
// what the bytes mean is proto's business, and what is answered the handler table's.
#ifndef ORR_SERVICE_SERVICE_H
#define ORR_SERVICE_SERVICE_H

#include "core/log.h"
#include "proto/server.h"
#include "src/service/live/streams.h"
#include "src/service/net/access.h"
#include "src/service/net/datagrams.h"

enum { ORR_CLIENT_STREAMS = 8, ORR_CLIENTS_LOOKED = 64 };

// A listening socket that was handed over.
typedef struct orr_service_socket {
    int fd;
    bool tls;
} orr_service_socket;

typedef struct orr_service_options {
    const char *const *url; // where to listen; none: loopback and the default port
    size_t n_urls;
    const orr_service_socket *socket; // listened on in place of URLs
    size_t n_sockets;
    int max_clients;     // at once; one more takes the place of the longest idle, or is told BUSY
    double spare_s;      // so long a client must have been idle to lose its place to a new one
    double first_s;      // a connection that has sent no complete request for so long is closed
    double idle_s;       // the same later on; PING keeps a connection
    double half_frame_s; // from the first byte of a frame to its last
    double stall_s;      // a client that takes nothing of what waits for it
    double drain_s;      // after SIGTERM, for answers under way
    orr_access *access;  // who may do what; it must outlive the service. NULL: this machine alone, everything
    bool signals;        // SIGINT and SIGTERM stop it, SIGHUP calls hangup
    void *user;          // handed to these, which may be NULL:
    void (*hangup)(void *user);               // SIGHUP has come
    void (*beat)(void *user, int64_t now_ns); // the loop has come round, several times a second
    void (*stopping)(void *user);             // it listens no more
    int64_t (*clock_ns)(void *user);          // monotonic; NULL: the machine's. Tests count work by it
    void *clock_user;
} orr_service_options;
orr_service_options orr_service_defaults(void); // 256 clients; 2, 30, 600, 10, 30 and 5 s; signals

typedef struct orr_service orr_service;

// Listens; who connects before it runs waits.
// Given:
//   options  where to listen, limits and times
//   server   what answers; it must outlive the service. NULL: it comes later (orr_service_provide)
//   log      must outlive the service; may be NULL
// Returned:
//   out      the service; free with orr_service_close
//   diag     why it failed; may be NULL
// Errors: ORR_E_ARG (a URL), ORR_E_IO (a port in use, ...), ORR_E_MEMORY.
orr_status orr_service_open(const orr_service_options *options, const orr_server *server, const orr_log *log,
                            orr_service **out, orr_diag *diag);
// What answers, before the service runs, if it was opened without.
void orr_service_provide(orr_service *s, const orr_server *server);
// Streams beside the answers, likewise. They are halted before the service is closed, and closed after it.
void orr_service_stream(orr_service *s, orr_streams *streams);
// Streams have something to send; from any thread. `user` is the service.
void orr_service_wake(void *user);
// The channels by which its clients send datagrams; for who takes those.
orr_datagrams *orr_service_datagrams(const orr_service *s);
// The URLs as bound (port 0 has become a real one); NULL beyond the last.
const char *orr_service_url(const orr_service *s, size_t i);
// Takes the signals, calls `ready` (which may be NULL), and serves until a signal or orr_service_stop, then finishes what
// is under way. A second signal does not wait for that.
orr_status orr_service_run(orr_service *s, void (*ready)(void *user), void *user, orr_diag *diag);
void orr_service_stop(orr_service *s); // from any thread
// Whether a signal told it to stop.
bool orr_service_signalled(const orr_service *s);
// A client as who watches the service sees it.
typedef struct orr_client_look {
    char peer[160];
    char name[100]; // name and version as HELLO told them; empty without
    uint64_t requests;
    int64_t quiet_ns; // since the last of them
    size_t n_streams; // it has; the first of them follow
    orr_stream_look stream[ORR_CLIENT_STREAMS];
} orr_client_look;
// The clients of at most 0.2 s ago, at most `most` of them; returns how many there are. From any one thread. The first call in a
// while gets none: only who is watched is looked at.
size_t orr_service_clients(orr_service *s, orr_client_look *out, size_t most);
// What the service has done so far; from any thread.
typedef struct orr_service_counts {
    double uptime_s, silent_s; // since it was opened; since its loop last came round
    uint64_t clients, came, refused, requests, refusals, held;
} orr_service_counts;
// The counts of this moment.
orr_service_counts orr_service_count(const orr_service *s);
// The rules of access have been read again: clients that are connected go by them from now on; one that has no permission left is closed,
// no other. In the service's own thread.
void orr_service_readmit(orr_service *s);
// Closes all connections and listening sockets, removes files of Unix sockets, and frees the service; NULL may be closed.
void orr_service_close(orr_service *s);

#endif
