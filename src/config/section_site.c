// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_site.h"

#include "src/config/rows_private.h"

static const orr_key rows[] = {
    BOOL_ROW(
        orr_scenario_site, "solid_tide", solid_tide, "no", NULL,
        "the solid Earth's tide, its permanent part included: positions are the conventional tide-free ones"),
    BOOL_ROW(orr_scenario_site, "pole_tide", pole_tide, "no", NULL,
             "the tide of the pole's wandering, where the orbits know the Earth's rotation"),
    FILE_ROW(orr_scenario_site, "ocean_loading", ocean_loading, NULL,
             "BLQ file of the ocean tides' loading; it has to know every fixed antenna by its name"),
};
const orr_schema orr_section_site = ORR_SCHEMA(rows, orr_scenario_site);
