// SPDX-License-Identifier: GPL-3.0-or-later
// Section `obstacles`: what stands in the way of signals.
#ifndef ORR_CONFIG_SECTION_OBSTACLES_H
#define ORR_CONFIG_SECTION_OBSTACLES_H

#include "src/config/schema.h"

// An upright wall between two places.
typedef struct orr_scenario_wall {
    orr_real_list from, to; // latitude and longitude, deg
    double bottom_m, top_m; // above the ellipsoid
} orr_scenario_wall;

// A stretch in which nothing is received: of time, or of way.
typedef struct orr_scenario_tunnel {
    orr_interval during;
    bool has_during;
    orr_real_list from, to; // latitude and longitude of its mouths
    double width_m;
} orr_scenario_tunnel;

// What the terrain hides from antennas that stand.
typedef struct orr_scenario_terrain {
    char *file; // ESRI ASCII grid of geographic coordinates; NULL: none
    double undulation_m, range_m;
    bool refraction;
} orr_scenario_terrain;

typedef struct orr_scenario_obstacles {
    struct {
        size_t n;
        orr_scenario_wall *item;
    } walls;
    struct {
        size_t n;
        orr_scenario_tunnel *item;
    } tunnels;
    orr_scenario_terrain terrain;
} orr_scenario_obstacles;

extern const orr_schema orr_section_obstacles;

#endif
