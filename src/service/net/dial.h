// SPDX-License-Identifier: GPL-3.0-or-later
// proto's client over a socket of this machine's: what orrery poll and the tests speak through.
#ifndef ORR_SERVICE_DIAL_H
#define ORR_SERVICE_DIAL_H

#include "proto/client.h"
#include "src/service/net/tls.h"

#define ORR_DIAL_BUFFER (ORR_FRAME_OVERHEAD + ORR_MSG_LARGEST)

typedef struct orr_dial {
    orr_client client;
    int fd;
    int passed[2]; // descriptors that came along, the first first; -1: none
    SSL *ssl;      // of tls://
    char url[300];
    uint8_t buffer[ORR_DIAL_BUFFER];
} orr_dial;

// Connects; every read and write gives up after timeout_s.
//   Given:    url        tcp://HOST:PORT, tls://HOST:PORT or unix:PATH
//             identity   for tls://: a file with the client's certificate and key (PEM); NULL otherwise, or for that of the environment
//                        variable ORRERY_IDENTITY
//             timeout_s  seconds
//   Returned: out        the connection; close with orr_dial_close
//             diag       why there is none
//   Notes:    the server's certificate must come from the authority in ca.pem beside the identity.
//   Errors:   ORR_E_ARG (not a URL; no identity), ORR_E_IO, ORR_E_FORMAT (the identity), ORR_E_MEMORY
orr_status orr_dial_open(const char *url, const char *identity, double timeout_s, orr_dial **out,
                         orr_diag *diag);
// Closes the connection and frees it; NULL may be closed.
void orr_dial_close(orr_dial *d);
// The next of the descriptors that came last along with bytes of a Unix socket (of a ring, with SUBSCRIBED; of motion's ring and its bell, with
// MOTION_RING): the caller's from then on. -1: none.
int orr_dial_passed(orr_dial *d);
// What went wrong in a call of the client as a status with a sentence; `doing` is what was being done
// ("POLL").
orr_status orr_dial_status(const orr_dial *d, orr_wire_status s, const char *doing, orr_diag *diag);

#endif
