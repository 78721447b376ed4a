// SPDX-License-Identifier: GPL-3.0-or-later
// Section `jammers`: transmitters that disturb, as geometry and power.
#ifndef ORR_CONFIG_SECTION_JAMMERS_H
#define ORR_CONFIG_SECTION_JAMMERS_H

#include "src/config/schema.h"

#define ORR_MAX_JAMMERS 16
#define ORR_JAMMER_WAVEFORM 32 // characters of its name

typedef struct orr_scenario_jammer {
    char *waveform;
    double carrier_hz, power_dbw;
    orr_real_list position, velocity_mps; // latitude, longitude, height; East, North, Up
    bool has_from, has_to;
    orr_time from, to;
} orr_scenario_jammer;

typedef struct orr_scenario_jammers {
    size_t n;
    orr_scenario_jammer *item;
} orr_scenario_jammers;

extern const orr_schema orr_section_jammer;

#endif
