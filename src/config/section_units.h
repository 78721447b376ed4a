// SPDX-License-Identifier: GPL-3.0-or-later
// Section `units`: further inertial units on the body.
#ifndef ORR_CONFIG_SECTION_UNITS_H
#define ORR_CONFIG_SECTION_UNITS_H

#include "src/config/schema.h"

#define ORR_MOTION_MAX_UNITS 16 // with unit 0, the trajectory's own point

typedef struct orr_scenario_unit {
    char *name;
    double right_m, forward_m, up_m, heading_deg, pitch_deg, roll_deg;
} orr_scenario_unit;

typedef struct orr_scenario_units {
    size_t n;
    orr_scenario_unit *item;
} orr_scenario_units;

extern const orr_schema orr_section_unit; // of one of the list

#endif
