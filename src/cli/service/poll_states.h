// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll without another word: satellite states.
#ifndef ORR_CLI_SERVICE_POLL_STATES_H
#define ORR_CLI_SERVICE_POLL_STATES_H

#include "src/service/dial.h"

typedef struct orr_state_poll {
    bool json;
    char frame[65];   // of CAPS, for the table's head
    uint64_t numbers; // satellites that had a state
    bool outside;     // an epoch was outside the span
} orr_state_poll;

// Asks and prints what comes.
orr_status orr_state_poll_run(orr_state_poll *p, orr_dial *d, const orr_msg_poll *poll, orr_diag *diag);

#endif
