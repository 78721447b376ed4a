// SPDX-License-Identifier: GPL-3.0-or-later
// Section `land_mobile`: a road in two states, in view and in shadow.
#ifndef ORR_CONFIG_SECTION_LAND_MOBILE_H
#define ORR_CONFIG_SECTION_LAND_MOBILE_H

#include "src/config/schema.h"

typedef struct orr_scenario_land_mobile {
    orr_sat_set sats;
    bool has_sats;
    double speed_mps, good_m, bad_m, rice_db, shadow_db, shadow_sigma_db;
    int64_t seed;
} orr_scenario_land_mobile;
typedef struct orr_scenario_land_mobiles {
    size_t n;
    orr_scenario_land_mobile *item;
} orr_scenario_land_mobiles;

extern const orr_schema orr_section_land_mobile;

#endif
