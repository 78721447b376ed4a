// SPDX-License-Identifier: GPL-3.0-or-later
// Section `gravity`: the field that readings are made in, over normal gravity.
#ifndef ORR_CONFIG_SECTION_GRAVITY_H
#define ORR_CONFIG_SECTION_GRAVITY_H

#include "src/config/schema.h"

typedef struct orr_scenario_mass {
    double lat_deg, lon_deg, height_m, gm_m3ps2;
} orr_scenario_mass;

typedef struct orr_scenario_profile {
    double lat_deg, lon_deg, azimuth_deg;
    orr_real_list distance_m, mgal; // as many of either; none: those of gravity.file
} orr_scenario_profile;

typedef struct orr_scenario_gravity {
    char *model, *folder, *file;
    bool has_profile;
    orr_scenario_profile profile;
    struct {
        size_t n;
        orr_scenario_mass *item;
    } masses;
} orr_scenario_gravity;

extern const orr_schema orr_section_gravity;

#endif
