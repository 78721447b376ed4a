// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_clocks.h"

#include <stdio.h>

#include "src/config/rows_private.h"

#define DEVIATION_ROW(n, m, h) REAL_ROW(orr_scenario_clock, n, m, 0, 1e-6, NULL, "0", NULL, h)
#define LAW_ROWS                                                                                             \
    DEVIATION_ROW("white_phase", white_phase, "Allan deviation at 1 s of its white phase noise: as 1/tau"),  \
        DEVIATION_ROW("flicker_phase", flicker_phase,                                                        \
                      "of flicker phase noise, at 0.5 Hz bandwidth: nearly as 1/tau"),                       \
        DEVIATION_ROW("white_frequency", white_frequency, "of white frequency noise: as tau^-1/2"),          \
        DEVIATION_ROW("flicker_frequency", flicker_frequency,                                                \
                      "of flicker frequency noise: the same for all tau"),                                   \
        DEVIATION_ROW("random_walk_frequency", random_walk_frequency,                                        \
                      "of the frequency's random walk: as tau^1/2"),                                         \
        INT_ROW(orr_scenario_clock, "seed", seed, 0, 9e15, "1", NULL, "seed")

static const char *check_clock(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_clock *c = map;
    if (c->white_phase + c->flicker_phase + c->white_frequency + c->flicker_frequency +
            c->random_walk_frequency >
        0)
        return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "has no effect without one of the five deviations");
    return "";
}
static const orr_key satellite_rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .required = true,
     .offset = offsetof(orr_scenario_clock, sats),
     .help = "satellites, each with a noise of its own; the first of the list that names one is its"},
    LAW_ROWS,
};
static const orr_key receiver_rows[] = {LAW_ROWS};
static const orr_schema satellite_table = {.key = satellite_rows,
                                           .n = sizeof satellite_rows / sizeof satellite_rows[0],
                                           .size = sizeof(orr_scenario_clock),
                                           .check = check_clock};
static const orr_schema receiver_table = {.key = receiver_rows,
                                          .n = sizeof receiver_rows / sizeof receiver_rows[0],
                                          .size = sizeof(orr_scenario_clock),
                                          .check = check_clock};
static const orr_key rows[] = {
    MAPS_ROW(orr_scenario_clocks, "satellites", satellites, &satellite_table, 100, NULL,
             "noise of satellites' clocks between the nodes of the orbits' clocks, which stay"),
    {.name = "receiver",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario_clocks, receiver),
     .given = offsetof(orr_scenario_clocks, has_receiver),
     .map = &receiver_table,
     .help = "noise of the receivers' oscillators, in observations alone: what a generator plays has none"},
};
const orr_schema orr_section_clocks = ORR_SCHEMA(rows, orr_scenario_clocks);
