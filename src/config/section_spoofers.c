// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_spoofers.h"

#include <math.h>
#include <stdio.h>

#include "src/config/rows_private.h"

#define PLACE_ROW(n, m, h)                                                                                   \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .list = true, .required = true,                                     \
        .offset = offsetof(orr_scenario_spoofer, m), .least = 3, .most = 3, .help = h                        \
    }
static const orr_key rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .offset = offsetof(orr_scenario_spoofer, sats),
     .given = offsetof(orr_scenario_spoofer, has_sats),
     .help = "satellites that it counterfeits; default: all"},
    {.name = "from",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_spoofer, from),
     .given = offsetof(orr_scenario_spoofer, has_from),
     .help = "when it begins to send, on a whole millisecond; default: it always does"},
    {.name = "to",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_spoofer, to),
     .given = offsetof(orr_scenario_spoofer, has_to),
     .help = "when it ends, likewise"},
    PLACE_ROW("pretends", pretends,
              "the place that its signals tell: latitude and longitude in degrees, height above the "
              "ellipsoid in metres"),
    PLACE_ROW("position", position, "where its transmitter is, likewise"),
    {.name = "velocity",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_spoofer, velocity_mps),
     .min = -1000,
     .max = 1000,
     .least = 3,
     .most = 3,
     .unit = "m/s",
     .help = "with which that moves from `from` on: East, North, Up"},
    REAL_ROW(orr_scenario_spoofer, "delay", delay_s, -1, 1, "s", "0", NULL,
             "by which it sends late, beside the way from its transmitter"),
    REAL_ROW(orr_scenario_spoofer, "power", power_db, -60, 60, "dB", "3", NULL,
             "received, against what the satellite's signal has at the place that is told"),
};
static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_spoofer *s = map;
    const orr_real_list *place[] = {&s->pretends, &s->position};
    static const char *const name[] = {"pretends", "position"};
    for (int k = 0; k < 2; k++)
        if (!(fabs(place[k]->item[0]) <= 90)) {
            snprintf(why, ORR_SCHEMA_WHY, "latitude %g is no place", place[k]->item[0]);
            return name[k];
        }
    if (s->velocity_mps.n > 0 && !s->has_from) {
        snprintf(why, ORR_SCHEMA_WHY, "what moves needs `from`, when it is at its position");
        return "velocity";
    }
    if (s->has_from && s->has_to && s->to <= s->from) {
        snprintf(why, ORR_SCHEMA_WHY, "it ends before it begins");
        return "to";
    }
    if ((s->has_from && s->from % 1000000 != 0) || (s->has_to && s->to % 1000000 != 0)) {
        snprintf(why, ORR_SCHEMA_WHY, "it begins and ends on a whole millisecond, where blocks can begin");
        return "from";
    }
    return NULL;
}
const orr_schema orr_section_spoofer = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_spoofer), .check = check};
