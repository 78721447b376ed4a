// SPDX-License-Identifier: GPL-3.0-or-later
// orrery poll --imu and --truth: inertial increments and the true motion instead of satellite states.
#ifndef ORR_CLI_SERVICE_POLL_MOTION_H
#define ORR_CLI_SERVICE_POLL_MOTION_H

#include "src/cli/frame/cli.h"
#include "src/service/dial.h"

// Rows of poll's table.
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

typedef struct orr_motion_poll {
    bool imu, truth;
    uint16_t unit;
    int64_t step_ns; // of --imu; 0: the scenario's interval
    bool json;
    uint64_t numbers;
    bool outside;
} orr_motion_poll;

// Reads --imu, --truth, --unit; an exit status.
int orr_motion_poll_ask(const orr_cli *c, orr_motion_poll *out);
// Asks for count epochs or intervals from t on and prints them.
orr_status orr_motion_poll_run(orr_motion_poll *p, orr_dial *d, orr_time t, int64_t step_ns, uint32_t count,
                               orr_diag *diag);

#endif
