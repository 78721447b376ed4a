// SPDX-License-Identifier: GPL-3.0-or-later
// TLS 1.3 with certificates on both sides, by OpenSSL: contexts made of files, and what a peer's certificate calls it. There are no
// session tickets: every connection shows its certificate anew.
#ifndef ORR_SERVICE_NET_TLS_H
#define ORR_SERVICE_NET_TLS_H

#include <openssl/ssl.h>

#include "core/log.h"

enum { ORR_TLS_NAME = 65 };

// The files of one side.
typedef struct orr_tls_files {
    const char *certificate; // PEM, with those that lead to the authority
    const char *key;         // PEM; may be the same file
    const char *authority;   // PEM; whom the other side's certificate must come from
} orr_tls_files;

// A context for one side. Free with SSL_CTX_free.
//   Given:    files   what it is made of
//             server  which side
//   Returned: out     the context
//             diag    which file is to blame and why
//   Errors:   ORR_E_IO, ORR_E_FORMAT (not PEM, a key of another certificate, a certificate out of date), ORR_E_MEMORY
orr_status orr_tls_context(const orr_tls_files *files, bool server, SSL_CTX **out, orr_diag *diag);
// The common name of the peer's certificate, which has been verified. False: it has none, several, or one that is not 1 to 64
// printable characters of ASCII.
bool orr_tls_peer_name(const SSL *ssl, char name[ORR_TLS_NAME]);
// Why the last operation failed, from OpenSSL's queue, which is emptied: "certificate verify failed: certificate has expired".
char *orr_tls_reason(const SSL *ssl, char *buf, size_t n);
// The same of an error that somebody has taken out of the queue.
//   Given:    ssl   the connection; NULL: none yet
//             error of OpenSSL; 0: none
//             n     room of buf
//   Returned: buf   the reason; also the value
char *orr_tls_reason_of(const SSL *ssl, unsigned long error, char *buf, size_t n);
// A KeyUpdate costs its receiver a derivation of keys. A peer that sends more than 16 at once, or than one a second later on, is cut off.
// `rate` must outlive the connection.
void orr_tls_limit_updates(SSL *ssl, orr_log_rate *rate);

// A client's connection over a connected blocking socket.
//   Given:    context  of a client
//             fd       the socket; remains the caller's
//             host     name or address that the server's certificate must have
//   Returned: ssl      the connection; free with orr_tls_free
//             diag     why there is none
//   Errors:   ORR_E_IO, ORR_E_MEMORY
orr_status orr_tls_connect(SSL_CTX *context, int fd, const char *host, SSL **ssl, orr_diag *diag);
// As SSL_write_ex, and no SIGPIPE where the peer has gone.
bool orr_tls_write(SSL *ssl, const void *data, size_t n, size_t *put);
// Says farewell and frees it, likewise; NULL is allowed.
void orr_tls_free(SSL *ssl);

#endif
