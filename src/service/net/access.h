// SPDX-License-Identifier: GPL-3.0-or-later
// Who may come in, and what he may do then: the rules of an access file, its certificates loaded. They are exchanged as a whole while the
// service runs; all functions may be called from any thread.
#ifndef ORR_SERVICE_NET_ACCESS_H
#define ORR_SERVICE_NET_ACCESS_H

#include "src/config/access.h"
#include "src/service/net/tls.h"
#include "src/service/net/url.h"

typedef struct orr_access orr_access;

// Rules of a file.
//   Given:    path      the access file; NULL: the defaults, which let nobody in from other machines
//             insecure  as if the file had insecure_listen
//             at_most   what clients may do at most, orr_may: ORR_MAY_READ with --read-only
//   Returned: out       the rules; free with orr_access_close
//             diag      why there are none
//   Errors:   as of orr_access_read and orr_tls_context
orr_status orr_access_open(const char *path, bool insecure, unsigned at_most, orr_access **out,
                           orr_diag *diag);
void orr_access_close(orr_access *a); // NULL is allowed
// Reads the file again: the new rules hold from now on, or, after an error, the old ones stay.
// Rules that no longer allow an address that is listened on are an error too (ORR_E_FORMAT): it could not be closed without a drop.
orr_status orr_access_reload(orr_access *a, orr_diag *diag);
// The number of the present rules, from 1 on: who keeps what a client may do asks again when it has changed.
unsigned orr_access_edition(const orr_access *a);

// Whether one may listen there: on this machine, with TLS where there is a certificate, or without where that is allowed explicitly.
// ORR_E_ARG with what to do otherwise.
orr_status orr_access_listen(orr_access *a, const orr_url *bound, orr_diag *diag);
// Gives a Unix socket to the group that the rules name. ORR_E_ARG: there is no such group; ORR_E_IO.
orr_status orr_access_give(orr_access *a, const orr_url *bound, orr_diag *diag);
// What clients who come by this address without TLS may do.
unsigned orr_access_plain(const orr_access *a);
// What the client of this name may do (ORR_MAY_NOTHING: the rules do not know it).
unsigned orr_access_named(orr_access *a, const char *name);
// The present certificates, to be freed with SSL_CTX_free; NULL where there are none.
SSL_CTX *orr_access_tls(orr_access *a);
// The limits that hold at present.
orr_access_limits orr_access_limits_of(orr_access *a);

#endif
