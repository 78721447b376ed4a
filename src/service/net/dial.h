// SPDX-License-Identifier: GPL-3.0-or-later
// proto's client over a socket of this machine's: what orrery poll and the tests speak through.
#ifndef ORR_SERVICE_DIAL_H
#define ORR_SERVICE_DIAL_H

#include "core/status.h"
#include "proto/client.h"

#define ORR_DIAL_BUFFER (ORR_FRAME_OVERHEAD + ORR_MSG_LARGEST)

typedef struct orr_dial {
    orr_client client;
    int fd;
    char url[300];
    uint8_t buffer[ORR_DIAL_BUFFER];
} orr_dial;

// Connects; every read and write gives up after timeout_s. Errors: ORR_E_ARG (not a URL), ORR_E_IO,
// ORR_E_MEMORY.
orr_status orr_dial_open(const char *url, double timeout_s, orr_dial **out, orr_diag *diag);
// Closes the connection and frees it; NULL may be closed.
void orr_dial_close(orr_dial *d);
// What went wrong in a call of the client as a status with a sentence; `doing` is what was being done
// ("POLL").
orr_status orr_dial_status(const orr_dial *d, orr_wire_status s, const char *doing, orr_diag *diag);

#endif
