// SPDX-License-Identifier: GPL-3.0-or-later
// The options of orrery poll that say what is asked for, as a request of the protocol.
#ifndef ORR_CLI_SERVICE_POLL_ASK_H
#define ORR_CLI_SERVICE_POLL_ASK_H

#include "proto/fields.h"
#include "src/cli/frame/cli.h"
#include "src/cli/orbit/elements_rows.h"

// Rows of poll's table, kind by kind.
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
#define ORR_POLL_NAVDATA_OPTIONS                                                                             \
    {.name = "navdata",                                                                                      \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .help = "broadcast data instead of states: the fitted sets on the air"},                                \
    {                                                                                                        \
        .name = "pages", .kind = ORR_OPT_FLAG,                                                               \
        .help = "with --navdata: the subframes and strings that hold each epoch, as `orrery navfit --bits` " \
                "writes them"                                                                                \
    }
#define ORR_POLL_MOTION_OPTIONS                                                                              \
    {.name = "imu",                                                                                          \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .help = "inertial increments over --step (default: the scenario's interval) instead of states"},        \
        {.name = "truth",                                                                                    \
         .kind = ORR_OPT_FLAG,                                                                               \
         .help = "true motion and gravity terms instead of states (the scenario needs a trajectory)"},       \
    {                                                                                                        \
        .name = "unit", .kind = ORR_OPT_INT, .value = "K", .min = 0, .max = 65535,                           \
        .help = "with --imu and --truth: which inertial unit. Default 0, the trajectory's own point"         \
    }

typedef struct orr_poll_request {
    const orr_message_info *info; // of the request
    orr_msg_any m;                // its epochs and satellites are set by whoever asks
    double hz[ORR_MSG_MAX_CARRIERS];
    const char *what; // is asked for, in the words of a failure
    bool pages;       // of NAVDATA: subframes and strings, not the sets
} orr_poll_request;

// Reads the options; an exit status.
int orr_poll_ask(const orr_cli *c, orr_poll_request *out);

#endif
