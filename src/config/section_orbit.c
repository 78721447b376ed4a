// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_orbit.h"

#include "src/config/rows_private.h"

static const orr_condition no_product[] = {
    {.key = "product", .absent = true, .why = "a product is smoothed already"}, {0}};
static const orr_condition not_a_product[] = {{.key = "sp3", .why = "a product is smoothed already"}, {0}};

static const orr_key rows[] = {
    FILE_ROW(orr_scenario_orbit, "product", product, NULL, "orbit product made by 'orrery orbit' (NetCDF)"),
    {.name = "sp3",
     .kind = ORR_KEY_FILE,
     .list = true,
     .offset = offsetof(orr_scenario_orbit, sp3),
     .only = no_product,
     .help = "precise orbit files, smoothed jointly when the service starts (seconds)"},
    FILES_ROW(orr_scenario_orbit, "erp", erp, not_a_product,
              "Earth rotation parameters; without them the orbits themselves tell pole and length of day"),
    FILES_ROW(orr_scenario_orbit, "clk", clk, not_a_product,
              "RINEX clock files (30 s, 5 s), whose clocks come before those of sp3; aligned where another "
              "centre's"),
    REAL_ROW(orr_scenario_orbit, "nodes", nodes_s, 0, 86400, "s", "0", not_a_product,
             "use only epochs that are multiples of this; 0 for all"),
    {.name = "exclude",
     .kind = ORR_KEY_INTERVAL,
     .list = true,
     .offset = offsetof(orr_scenario_orbit, exclude),
     .only = not_a_product,
     .help = "stretches of time whose epochs are not used"},
};

const orr_schema orr_section_orbit = ORR_SCHEMA(rows, orr_scenario_orbit);
