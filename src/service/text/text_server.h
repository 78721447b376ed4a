// SPDX-License-Identifier: GPL-3.0-or-later
// The text twin's own port, served by a thread of its own: lines in, lines out, for clients by the same rules as the service's.
#ifndef ORR_SERVICE_TEXT_TEXT_SERVER_H
#define ORR_SERVICE_TEXT_TEXT_SERVER_H

#include "src/service/net/access.h"
#include "src/service/text/ask.h"

typedef struct orr_text_server orr_text_server;

// Listens and serves until it is closed; at most 32 clients, of which one that takes nothing is closed when 1 MiB waits for it.
// Given:
//   url     tcp://HOST:PORT, tls://HOST:PORT or unix:PATH
//   asked   what answers; its room and its permissions are not used, its server is the thread's from now on
//   access  who may come in and do what; it must outlive the server
// Returned:
//   out     the server; close with orr_text_server_close
//   diag    why it failed
// Errors: ORR_E_ARG (no address, or one that the rules do not allow), ORR_E_IO, ORR_E_MEMORY.
orr_status orr_text_server_open(const char *url, const orr_asked *asked, orr_access *access,
                                orr_text_server **out, orr_diag *diag);
// The address as bound.
const char *orr_text_server_url(const orr_text_server *s);
void orr_text_server_close(orr_text_server *s); // NULL is allowed

#endif
