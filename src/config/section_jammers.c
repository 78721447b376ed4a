// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_jammers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "src/config/rows_private.h"

static const orr_key rows[] = {
    {.name = "waveform",
     .kind = ORR_KEY_TEXT,
     .required = true,
     .offset = offsetof(orr_scenario_jammer, waveform),
     .help = "what it sends, a name that the generator knows: cw, sweep, noise, ..."},
    NEEDED_REAL_ROW(orr_scenario_jammer, "carrier", carrier_hz, 1e9, 3e9, "Hz", NULL,
                    "its carrier, as it sends it"),
    NEEDED_REAL_ROW(orr_scenario_jammer, "power", power_dbw, -120, 60, "dBW", NULL,
                    "radiated towards the antennas (EIRP)"),
    {.name = "position",
     .kind = ORR_KEY_REAL,
     .list = true,
     .required = true,
     .offset = offsetof(orr_scenario_jammer, position),
     .least = 3,
     .most = 3,
     .help = "where it is: latitude and longitude in degrees, height above the ellipsoid in metres"},
    {.name = "velocity",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_jammer, velocity_mps),
     .min = -1000,
     .max = 1000,
     .least = 3,
     .most = 3,
     .unit = "m/s",
     .help = "with which it moves from `from` on: East, North, Up"},
    {.name = "from",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_jammer, from),
     .given = offsetof(orr_scenario_jammer, has_from),
     .help = "when it begins to send; default: it always does"},
    {.name = "to",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_jammer, to),
     .given = offsetof(orr_scenario_jammer, has_to),
     .help = "when it ends"},
};
static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_jammer *j = map;
    const size_t n = strlen(j->waveform);
    if (n == 0 || n > ORR_JAMMER_WAVEFORM) {
        snprintf(why, ORR_SCHEMA_WHY, "a name of 1 to %d characters", ORR_JAMMER_WAVEFORM);
        return "waveform";
    }
    if (!(fabs(j->position.item[0]) <= 90)) {
        snprintf(why, ORR_SCHEMA_WHY, "latitude %g is no place", j->position.item[0]);
        return "position";
    }
    if (j->velocity_mps.n > 0 && !j->has_from) {
        snprintf(why, ORR_SCHEMA_WHY, "what moves needs `from`, when it is at its position");
        return "velocity";
    }
    if (j->has_from && j->has_to && j->to <= j->from) {
        snprintf(why, ORR_SCHEMA_WHY, "it ends before it begins");
        return "to";
    }
    return NULL;
}
const orr_schema orr_section_jammer = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_jammer), .check = check};
