// SPDX-License-Identifier: GPL-3.0-or-later
// The options of orrery poll that say what is asked for, as a request of the protocol.
#ifndef ORR_CLI_SERVICE_POLL_ASK_H
#define ORR_CLI_SERVICE_POLL_ASK_H

#include "proto/fields.h"
#include "src/cli/frame/options.h"
#include "src/cli/orbit/elements_rows.h"

// Rows of poll's table: what is asked for instead of states, each with what goes with it alone.
#define ORR_POLL_OPTIONS                                                                                     \
    {.name = "channels",                                                                                     \
     .kind = ORR_OPT_FLAG,                                                                                   \
     .applies = "!delays,!elements,!navdata,!imu,!truth,!events",                                            \
     .help = "Channels of an antenna instead of states: the blocks that hold the epochs (the scenario "      \
             "needs signals)."},                                                                             \
        {.name = "antenna",                                                                                  \
         .kind = ORR_OPT_INT,                                                                                \
         .applies = "channels",                                                                              \
         .value = "K",                                                                                       \
         .min = 0,                                                                                           \
         .max = 65535,                                                                                       \
         .help = "Which antenna; 0 by default."},                                                            \
        {.name = "terms",                                                                                    \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "channels",                                                                              \
         .help = "What each code is the sum of, too (in JSON)."},                                            \
        {.name = "delays",                                                                                   \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!elements,!navdata,!imu,!truth,!events",                                      \
         .help = "Ionospheric delays instead of states (the scenario needs an ionosphere)."},                \
        ORR_OPTION_RECEIVER(.applies = "delays",                                                             \
                            .help = "The receiver, in degrees (geodetic) and metres; the scenario's own by " \
                                    "default (receiver.position, the trajectory at each epoch, or the "      \
                                    "session's station)."),                                                  \
        ORR_OPTION_CARRIER(.applies = "delays", .repeated = true,                                            \
                           .help = "A carrier to give the delay for, up to four of them; 1575.42 by "        \
                                   "default."),                                                              \
        {.name = "elements",                                                                                 \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!delays,!navdata,!imu,!truth,!events",                                        \
         .help = "Kepler elements instead of states."},                                                      \
        {.name = "frame",                                                                                    \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .applies = "elements",                                                                              \
         .value = ORR_ELEMENTS_FRAMES,                                                                       \
         .help = "The axes, as of `orrery elements`; date by default."},                                     \
        {.name = "method",                                                                                   \
         .kind = ORR_OPT_CHOICE,                                                                             \
         .applies = "elements",                                                                              \
         .value = ORR_ELEMENTS_METHODS,                                                                      \
         .help = "How elements are made, as of `orrery elements`; state by default."},                       \
        {.name = "navdata",                                                                                  \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!delays,!elements,!imu,!truth,!events",                                       \
         .help = "Broadcast data instead of states: the fitted sets on the air."},                           \
        {.name = "pages",                                                                                    \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "navdata,!format=json",                                                                  \
         .help = "The subframes, strings and pages of the frame that holds each epoch, as `orrery navfit "   \
                 "--bits` writes them; "                                                                     \
                 "JSON has them with the sets."},                                                            \
        {.name = "message",                                                                                  \
         .kind = ORR_OPT_TEXT,                                                                               \
         .applies = "navdata",                                                                               \
         .value = "LIST",                                                                                    \
         .help = "Navigation messages, e.g. INAV,FNAV or LNAV; the first of each satellite by default."},    \
        {.name = "symbols",                                                                                  \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "navdata",                                                                               \
         .help = "Pages as the symbols that a modulator takes, instead of bits."},                           \
        {.name = "events",                                                                                   \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!delays,!elements,!navdata,!imu,!truth",                                      \
         .help = "What happens in the intervals of --step (an hour by default) instead of states."},         \
        {.name = "imu",                                                                                      \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!delays,!elements,!navdata,!truth,!events",                                   \
         .help = "Inertial increments over --step instead of states."},                                      \
        {.name = "truth",                                                                                    \
         .kind = ORR_OPT_FLAG,                                                                               \
         .applies = "!channels,!delays,!elements,!navdata,!imu,!events",                                     \
         .help = "True motion and gravity terms instead of states (the scenario needs a trajectory)."},      \
    {                                                                                                        \
        .name = "unit", .kind = ORR_OPT_INT, .applies = "imu|truth", .value = "K", .min = 0, .max = 65535,   \
        .help = "Which inertial unit; 0, the trajectory's own point, by default."                            \
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
