// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll --navdata: broadcast data instead of satellite states.
#ifndef ORR_CLI_SERVICE_POLL_NAVDATA_H
#define ORR_CLI_SERVICE_POLL_NAVDATA_H

#include "src/cli/frame/cli.h"
#include "src/service/dial.h"

// Rows of poll's table.
#define ORR_POLL_NAVDATA_OPTIONS                                                                             \
    {.name = "navdata",                                                                                      \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .help = "broadcast data instead of states: the fitted sets on the air"},                                \
    {                                                                                                        \
        .name = "pages", .kind = ORR_OPT_FLAG,                                                               \
        .help = "with --navdata: the subframes and strings that hold each epoch, as `orrery navfit --bits` " \
                "writes them"                                                                                \
    }

typedef struct orr_navdata_poll {
    bool asked, pages;
    orr_msg_poll_navdata poll; // t and count are set by orr_navdata_poll_run
    bool json, headed;         // the columns' names have been printed
    uint64_t numbers;          // satellites that had a set
    bool outside;
} orr_navdata_poll;

// Reads --navdata and --pages; an exit status.
int orr_navdata_poll_ask(const orr_cli *c, orr_navdata_poll *out);
// Asks for count epochs from t on and prints them.
orr_status orr_navdata_poll_run(orr_navdata_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag);

#endif
