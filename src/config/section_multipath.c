// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_multipath.h"

#include <math.h>
#include <stdio.h>

#include "src/config/rows_private.h"

static const orr_condition without_level[] = {{.key = "level", .absent = true}, {0}};
static const orr_key ground_rows[] = {
    {.name = "height",
     .kind = ORR_KEY_REAL,
     .offset = offsetof(orr_scenario_ground, height_m),
     .given = offsetof(orr_scenario_ground, has_height),
     .min = 0.01,
     .max = 20000,
     .unit = "m",
     .only = without_level,
     .help = "of every antenna above the plane that reflects"},
    {.name = "level",
     .kind = ORR_KEY_REAL,
     .offset = offsetof(orr_scenario_ground, level_m),
     .given = offsetof(orr_scenario_ground, has_level),
     .min = -500,
     .max = 9000,
     .unit = "m",
     .help = "height of that plane above the ellipsoid, for antennas that move"},
    REAL_ROW(orr_scenario_ground, "permittivity", permittivity, 1, 100, NULL, "15", NULL,
             "relative: 3 dry ground, 15 moist ground, 70 sea water"),
    REAL_ROW(orr_scenario_ground, "conductivity", conductivity_spm, 0, 1e8, "S/m", "0.005", NULL,
             "1e-4 dry ground, 0.005 moist ground, 5 sea water, 1e7 metal"),
};
static const char *check_ground(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_ground *g = map;
    if (g->has_height || g->has_level) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "needs a height of the antennas above it, or its level");
    return "";
}
static const orr_schema ground_table = {.key = ground_rows,
                                        .n = sizeof ground_rows / sizeof ground_rows[0],
                                        .size = sizeof(orr_scenario_ground),
                                        .check = check_ground};

static const orr_condition by_delay[] = {{.key = "delay"}, {0}};
static const orr_condition by_place[] = {{.key = "position"}, {0}};
static const orr_condition without_position[] = {{.key = "position", .absent = true}, {0}};
static const orr_key reflector_rows[] = {
    {.name = "sats",
     .kind = ORR_KEY_SATS,
     .offset = offsetof(orr_scenario_reflector, sats),
     .given = offsetof(orr_scenario_reflector, has_sats),
     .help = "satellites whose signals it returns; default: all"},
    {.name = "from",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_reflector, from),
     .given = offsetof(orr_scenario_reflector, has_from),
     .help = "when it appears, on a whole millisecond; default: it is there from the begin"},
    {.name = "to",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_reflector, to),
     .given = offsetof(orr_scenario_reflector, has_to),
     .help = "when it goes, likewise"},
    {.name = "delay",
     .kind = ORR_KEY_REAL,
     .offset = offsetof(orr_scenario_reflector, delay_m),
     .given = offsetof(orr_scenario_reflector, has_delay),
     .min = 0,
     .max = 1e6,
     .unit = "m",
     .only = without_position,
     .help = "of the echo behind the signal, at `from`"},
    REAL_ROW(orr_scenario_reflector, "doppler", doppler_hz, -1e4, 1e4, "Hz", "0", by_delay,
             "of the echo against the signal at 1575.42 MHz; the delay changes accordingly"),
    REAL_ROW(orr_scenario_reflector, "phase", phase_deg, -360, 360, "deg", "0", NULL,
             "by which the reflection retards the carrier"),
    NEEDED_REAL_ROW(orr_scenario_reflector, "power", power_db, -80, 20, "dB", NULL,
                    "of the echo against the signal"),
    {.name = "position",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_reflector, position),
     .least = 3,
     .most = 3,
     .help =
         "of a reflector in space: latitude and longitude in degrees, height above the ellipsoid in metres; "
         "delay and Doppler follow from it"},
    {.name = "velocity",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_reflector, velocity_mps),
     .min = -1000,
     .max = 1000,
     .least = 3,
     .most = 3,
     .unit = "m/s",
     .only = by_place,
     .help = "with which it moves from `from` on: East, North, Up"},
};
static const char *check_reflector(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_reflector *x = map;
    if (!x->has_delay && x->position.n == 0) {
        snprintf(why, ORR_SCHEMA_WHY, "needs a delay, or a position");
        return "";
    }
    if (x->position.n > 0 && !(fabs(x->position.item[0]) <= 90 && fabs(x->position.item[1]) <= 360)) {
        snprintf(why, ORR_SCHEMA_WHY, "latitude %g, longitude %g is no place", x->position.item[0],
                 x->position.item[1]);
        return "position";
    }
    const bool moves = x->velocity_mps.n > 0 || x->doppler_hz > 0 || x->doppler_hz < 0;
    if (moves && !x->has_from) {
        snprintf(why, ORR_SCHEMA_WHY, "what moves needs `from`, when it begins to");
        return "";
    }
    if (x->has_from && x->has_to && x->to <= x->from) {
        snprintf(why, ORR_SCHEMA_WHY, "it goes before it appears");
        return "to";
    }
    if ((x->has_from && x->from % 1000000 != 0) || (x->has_to && x->to % 1000000 != 0)) {
        snprintf(why, ORR_SCHEMA_WHY, "a reflector appears and goes on a whole millisecond");
        return "from";
    }
    return NULL;
}
static const orr_schema reflector_table = {.key = reflector_rows,
                                           .n = sizeof reflector_rows / sizeof reflector_rows[0],
                                           .size = sizeof(orr_scenario_reflector),
                                           .check = check_reflector};

static const orr_key gain_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_gain, "elevation", elevation_deg, -90, 90, "deg", NULL,
                    "above the antenna's own horizon"),
    REAL_ROW(orr_scenario_gain, "rhcp", rhcp_db, -100, 30, "dB", "0", NULL,
             "gain there for the satellites' polarisation"),
    REAL_ROW(orr_scenario_gain, "lhcp", lhcp_db, -100, 30, "dB", "-100", NULL, "gain for the other one"),
};
static const orr_schema gain_table = ORR_SCHEMA(gain_rows, orr_scenario_gain);

static const orr_condition of_ground[] = {{.key = "ground"}, {0}};
static const orr_key rows[] = {
    {.name = "ground",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario_multipath, ground),
     .given = offsetof(orr_scenario_multipath, has_ground),
     .map = &ground_table,
     .help = "specular reflection by level ground below the antennas"},
    MAPS_ROW(orr_scenario_multipath, "reflectors", reflectors, &reflector_table, ORR_MAX_ECHOES, NULL,
             "others, each an echo of its own"),
    MAPS_ROW(orr_scenario_multipath, "pattern", pattern, &gain_table, 181, of_ground,
             "what antennas make of the two polarisations, by ascending elevation, linear between; without "
             "it both "
             "are received alike from everywhere"),
    REAL_ROW(
        orr_scenario_multipath, "spacing", spacing_chips, 0, 1, "chip", "0", NULL,
        "between early and late of the correlator that observations are made with; 0: 0.5, or 0.1 of signals "
        "above 5 Mchip/s"),
};
static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_multipath *m = map;
    for (size_t k = 1; k < m->pattern.n; k++)
        if (!(m->pattern.item[k].elevation_deg > m->pattern.item[k - 1].elevation_deg)) {
            snprintf(why, ORR_SCHEMA_WHY, "elevation %g does not come after %g",
                     m->pattern.item[k].elevation_deg, m->pattern.item[k - 1].elevation_deg);
            return "pattern";
        }
    if (m->reflectors.n + (m->has_ground ? 1 : 0) <= ORR_MAX_ECHOES) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "a signal has at most %d echoes, that of the ground among them",
             ORR_MAX_ECHOES);
    return "reflectors";
}
const orr_schema orr_section_multipath = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_multipath), .check = check};
