// SPDX-License-Identifier: GPL-3.0-or-later
// Section `orbit`: where the satellites are.
#ifndef ORR_CONFIG_SECTION_ORBIT_H
#define ORR_CONFIG_SECTION_ORBIT_H

#include "src/config/schema.h"

typedef struct orr_scenario_orbit {
    char *product;     // an orbit product (NetCDF)
    orr_text_list sp3; // or SP3 files, smoothed at start
    orr_text_list erp; // Earth rotation parameters for the smoothing; none: a secular pole, UT1 by the leap
                       // seconds
    orr_text_list clk; // RINEX CLK files, whose clocks come before those of sp3
    double nodes_s;    // keep only epochs that are multiples of it; 0: all
    orr_interval_list exclude;
} orr_scenario_orbit;

extern const orr_schema orr_section_orbit;

#endif
