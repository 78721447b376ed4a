// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_orbit.h"

#include <stdio.h>
#include <string.h>

#include "src/config/rows_private.h"

static const orr_condition no_product[] = {
    {.key = "product", .absent = true, .why = "a product is smoothed already"}, {0}};
static const orr_condition not_a_product[] = {{.key = "sp3", .why = "a product is smoothed already"}, {0}};

static const orr_key geo_rows[] = {
    {.name = "sat",
     .kind = ORR_KEY_TEXT,
     .required = true,
     .offset = offsetof(orr_scenario_geo, sat),
     .help = "which, e.g. S23 (PRN 123)"},
    {.name = "longitude",
     .kind = ORR_KEY_REAL,
     .required = true,
     .offset = offsetof(orr_scenario_geo, longitude_deg),
     .min = -180,
     .max = 360,
     .unit = "deg",
     .help = "East"},
};

static const char *check_geo(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_geo *g = map;
    const orr_sat sat = orr_sat_parse(g->sat);
    if (sat != ORR_SAT_NONE && orr_sat_system(sat) == 'S') return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "'%.20s' is no SBAS satellite: S20 to S58, two digits of PRN 120 to 158",
             g->sat);
    return "sat";
}

static const orr_schema geo_table = {.key = geo_rows,
                                     .n = sizeof geo_rows / sizeof geo_rows[0],
                                     .size = sizeof(orr_scenario_geo),
                                     .check = check_geo};
static const orr_condition of_span[] = {
    {.key = "product|sp3|nav", .why = "a longitude tells no span of time"}, {0}};

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
    FILES_ROW(
        orr_scenario_orbit, "nav", nav, NULL,
        "RINEX navigation files: orbits and clocks of satellites that product or sp3 do not have (NavIC, "
        "SBAS), or of all where neither is given"),
    {.name = "geo",
     .kind = ORR_KEY_MAP,
     .list = true,
     .most = 39,
     .offset = offsetof(orr_scenario_orbit, geo),
     .only = of_span,
     .map = &geo_table,
     .help = "SBAS satellites that stand still over the Equator, with a clock of zero"},
};

const orr_schema orr_section_orbit = ORR_SCHEMA(rows, orr_scenario_orbit);
