// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll --delays: ionospheric delays instead of satellite states.
#ifndef ORR_CLI_SERVICE_POLL_DELAYS_H
#define ORR_CLI_SERVICE_POLL_DELAYS_H

#include "src/cli/frame/cli.h"
#include "src/service/dial.h"

// Rows of poll's table.
#define ORR_POLL_DELAY_OPTIONS                                                                               \
    {.name = "delays",                                                                                       \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .help = "ionospheric delays instead of states (the scenario needs an ionosphere)"},                     \
        {.name = "receiver",                                                                                 \
         .kind = ORR_OPT_TEXT,                                                                               \
         .value = "LAT,LON,H",                                                                               \
         .help = "with --delays: the receiver, degrees (geodetic) and metres. Default: the scenario's own "  \
                 "(receiver.position, the trajectory at each epoch, or the session's station)"},             \
    {                                                                                                        \
        .name = "carrier", .kind = ORR_OPT_TEXT, .value = "MHZ", .repeated = true,                           \
        .help = "with --delays: a carrier to give the delay for, up to four of them. Default 1575.42"        \
    }

typedef struct orr_delay_poll {
    bool asked;
    orr_msg_poll_delays poll; // t and count are set by orr_delay_poll_run
    double hz[ORR_MSG_MAX_CARRIERS];
    bool json;
    uint64_t numbers; // satellites that had a delay
    bool outside;
} orr_delay_poll;

// Reads --delays, --receiver and --carrier; an exit status.
int orr_delay_poll_ask(const orr_cli *c, orr_delay_poll *out);
// Asks for count epochs from t on and prints them.
orr_status orr_delay_poll_run(orr_delay_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag);

#endif
