// SPDX-License-Identifier: GPL-3.0-or-later
// Section `clocks`: noise of satellites' clocks and of the receiver's oscillator.
#ifndef ORR_CONFIG_SECTION_CLOCKS_H
#define ORR_CONFIG_SECTION_CLOCKS_H

#include "src/config/schema.h"

// Allan deviations at 1 s of five power laws.
typedef struct orr_scenario_clock {
    orr_sat_set sats; // of satellites' clocks
    double white_phase, flicker_phase, white_frequency, flicker_frequency, random_walk_frequency;
    int64_t seed;
} orr_scenario_clock;

typedef struct orr_scenario_clocks {
    struct {
        size_t n;
        orr_scenario_clock *item;
    } satellites;
    orr_scenario_clock receiver;
    bool has_receiver;
} orr_scenario_clocks;

extern const orr_schema orr_section_clocks;

#endif
