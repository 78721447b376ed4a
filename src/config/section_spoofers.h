// SPDX-License-Identifier: GPL-3.0-or-later
// Section `spoofers`: false sets of signals.
#ifndef ORR_CONFIG_SECTION_SPOOFERS_H
#define ORR_CONFIG_SECTION_SPOOFERS_H

#include "src/config/schema.h"

#define ORR_MAX_SPOOFERS 4

typedef struct orr_scenario_spoofer {
    orr_sat_set sats;
    bool has_sats, has_from, has_to;
    orr_time from, to;
    orr_real_list pretends;               // the place that its signals tell: latitude, longitude, height
    orr_real_list position, velocity_mps; // of its transmitter
    double delay_s, power_db;
} orr_scenario_spoofer;

typedef struct orr_scenario_spoofers {
    size_t n;
    orr_scenario_spoofer *item;
} orr_scenario_spoofers;

extern const orr_schema orr_section_spoofer;

#endif
