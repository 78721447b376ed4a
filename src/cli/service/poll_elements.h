// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll --elements: Kepler elements instead of satellite states.
#ifndef ORR_CLI_SERVICE_POLL_ELEMENTS_H
#define ORR_CLI_SERVICE_POLL_ELEMENTS_H

#include "src/cli/frame/cli.h"
#include "src/cli/orbit/elements_rows.h"
#include "src/service/dial.h"

// Rows of poll's table.
#define ORR_POLL_ELEMENT_OPTIONS                                                                             \
    {.name = "elements", .kind = ORR_OPT_FLAG, .help = "Kepler elements instead of states"},                 \
        {.name = "frame",                                                                                    \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .value = ORR_ELEMENTS_FRAMES,                                                                       \
         .help = "with --elements: the axes, as of `orrery elements`. Default date"},                        \
    {                                                                                                        \
        .name = "method", .kind = ORR_OPT_CHOICE, .value = ORR_ELEMENTS_METHODS,                             \
        .help = "with --elements: how they are made, likewise. Default state"                                \
    }

typedef struct orr_element_poll {
    bool asked;
    orr_msg_poll_elements poll; // t and count are set by orr_element_poll_run
    bool json, headed;          // the columns' names have been printed
    uint64_t numbers;           // satellites that had elements
    bool outside;
} orr_element_poll;

// Reads --elements, --frame and --method; an exit status.
int orr_element_poll_ask(const orr_cli *c, orr_element_poll *out);
// Asks for count epochs from t on and prints them.
orr_status orr_element_poll_run(orr_element_poll *p, orr_dial *d, orr_time t, uint32_t count, orr_diag *diag);

#endif
