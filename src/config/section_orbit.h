// SPDX-License-Identifier: GPL-3.0-or-later
// Section `orbit`: where the satellites are.
#ifndef ORR_CONFIG_SECTION_ORBIT_H
#define ORR_CONFIG_SECTION_ORBIT_H

#include "src/config/schema.h"

// A geostationary satellite that nothing but its longitude tells of.
typedef struct orr_scenario_geo {
    char *sat; // "S23"
    double longitude_deg;
} orr_scenario_geo;
typedef struct orr_scenario_geo_list {
    size_t n;
    orr_scenario_geo *item;
} orr_scenario_geo_list;

typedef struct orr_scenario_orbit {
    char *product;     // an orbit product (NetCDF)
    orr_text_list sp3; // or SP3 files, smoothed at start
    orr_text_list erp; // Earth rotation parameters for the smoothing; none: a secular pole, UT1 by the leap
                       // seconds
    orr_text_list clk; // RINEX CLK files, whose clocks come before those of sp3
    double nodes_s;    // keep only epochs that are multiples of it; 0: all
    orr_interval_list exclude;
    orr_text_list nav; // navigation files: orbits and clocks of satellites that product or sp3 lack
    orr_scenario_geo_list geo;
} orr_scenario_orbit;

extern const orr_schema orr_section_orbit;

#endif
