// SPDX-License-Identifier: GPL-3.0-or-later
// Section `receiver`: where the receiver is that a request means which names none.
#ifndef ORR_CONFIG_SECTION_RECEIVER_H
#define ORR_CONFIG_SECTION_RECEIVER_H

#include "src/config/schema.h"

typedef struct orr_scenario_receiver {
    orr_real_list position; // geodetic latitude and longitude in degrees, ellipsoidal height in metres; or
    int64_t unit;           // the inertial unit whose point it is, where there is a trajectory
} orr_scenario_receiver;

extern const orr_schema orr_section_receiver;

#endif
