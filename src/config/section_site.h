// SPDX-License-Identifier: GPL-3.0-or-later
// Section `site`: how the ground moves below fixed antennas.
#ifndef ORR_CONFIG_SECTION_SITE_H
#define ORR_CONFIG_SECTION_SITE_H

#include "src/config/schema.h"

typedef struct orr_scenario_site {
    bool solid_tide, pole_tide;
    char *ocean_loading; // BLQ file; NULL: none
} orr_scenario_site;

extern const orr_schema orr_section_site;

#endif
