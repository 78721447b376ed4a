// SPDX-License-Identifier: GPL-3.0-or-later
// Where a service is: tcp://HOST:PORT, tls://HOST:PORT or unix:PATH, read, written, listened on and connected to.
#ifndef ORR_SERVICE_URL_H
#define ORR_SERVICE_URL_H

#include <sys/socket.h>

#include "core/status.h"

#define ORR_URL_TEXT 300

typedef struct orr_url {
    bool is_unix;
    bool tls;       // of TCP
    char host[128]; // of TCP; without the brackets of IPv6
    uint16_t port;
    char path[108]; // of Unix: sun_path with its NUL
} orr_url;

// "tcp://127.0.0.1:4000", "tcp://[::1]:4000", "tcp://localhost" (the default port), "tcp://:0" (loopback, any
// port), "tcp://*:4000" (to listen on every address of this machine), "unix:/run/orrery.sock". tls:// as tcp://. ORR_E_ARG with a sentence otherwise.
orr_status orr_url_parse(const char *text, orr_url *out, orr_diag *diag);
// The URL as text, in buf.
char *orr_url_text(const orr_url *u, char buf[ORR_URL_TEXT]);

// Opens a non-blocking listening socket. A Unix socket has mode 0660. A Unix socket file that nobody listens on is replaced; one in use, and a file
// that is no socket, are refused.
// Given:
//   u        where
//   backlog  how many may wait to be accepted
// Returned:
//   fd       the socket
//   bound    the URL with the port that was given
//   diag     why it failed; may be NULL
// Errors: ORR_E_IO.
orr_status orr_url_listen(const orr_url *u, int backlog, int *fd, orr_url *bound, orr_diag *diag);
// A socket that takes datagrams there.
// Given:
//   u        of TCP, with an address and no name: loopback, one of this machine's, or *
// Returned:
//   fd       the socket, which waits
//   bound    the same with the port that was given
//   diag     why it failed
// Errors: ORR_E_ARG, ORR_E_IO.
orr_status orr_url_bind_datagrams(const orr_url *u, int *fd, orr_url *bound, orr_diag *diag);
// The address of a listening socket that somebody has handed over; ORR_E_ARG where it is none.
orr_status orr_url_of_socket(int fd, orr_url *out, orr_diag *diag);
// Whether every peer of the bound socket is on this machine.
bool orr_url_is_local(const orr_url *u);
// Whether an address of IPv4 or IPv6 is one of loopback.
bool orr_address_is_local(const struct sockaddr *a);
// A connected blocking socket whose reads and writes fail after timeout_s without progress. ORR_E_IO.
orr_status orr_url_connect(const orr_url *u, double timeout_s, int *fd, orr_diag *diag);

#endif
