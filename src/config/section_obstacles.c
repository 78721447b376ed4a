// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_obstacles.h"

#include <math.h>
#include <stdio.h>

#include "src/config/rows_private.h"

#define PLACE_ROW(T, n, m, need, h)                                                                          \
    {                                                                                                        \
        .name = n, .kind = ORR_KEY_REAL, .list = true, .required = need, .offset = offsetof(T, m),           \
        .min = -360, .max = 360, .least = 2, .most = 2, .unit = "deg", .help = h                             \
    }

static bool on_earth(const orr_real_list *place) { return place->n == 0 || fabs(place->item[0]) <= 90; }

static const char *off_earth(const orr_real_list *from, const orr_real_list *to, char why[ORR_SCHEMA_WHY])
{
    if (on_earth(from) && on_earth(to)) return NULL;
    const bool first = !on_earth(from);
    snprintf(why, ORR_SCHEMA_WHY, "latitude %g is no place", first ? from->item[0] : to->item[0]);
    return first ? "from" : "to";
}

static const orr_key wall_rows[] = {
    PLACE_ROW(orr_scenario_wall, "from", from, true, "latitude and longitude of one end"),
    PLACE_ROW(orr_scenario_wall, "to", to, true, "of the other"),
    REAL_ROW(orr_scenario_wall, "bottom", bottom_m, -500, 9000, "m", "-500", NULL,
             "its foot, above the ellipsoid"),
    NEEDED_REAL_ROW(orr_scenario_wall, "top", top_m, -500, 9000, "m", NULL, "its top, likewise"),
};
static const char *check_wall(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_wall *w = map;
    const char *off = off_earth(&w->from, &w->to, why);
    if (off != NULL) return off;
    if (w->top_m > w->bottom_m) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "the top is not above the bottom");
    return "top";
}
static const orr_condition by_place[] = {{.key = "from"}, {0}};
static const orr_condition without_time[] = {{.key = "during", .absent = true}, {0}};
static const orr_key tunnel_rows[] = {
    {.name = "during",
     .kind = ORR_KEY_INTERVAL,
     .offset = offsetof(orr_scenario_tunnel, during),
     .given = offsetof(orr_scenario_tunnel, has_during),
     .help = "when antennas are in it, FROM/TO on whole milliseconds"},
    {.name = "from",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_tunnel, from),
     .min = -360,
     .max = 360,
     .least = 2,
     .most = 2,
     .unit = "deg",
     .only = without_time,
     .help = "latitude and longitude of one mouth"},
    {.name = "to",
     .kind = ORR_KEY_REAL,
     .list = true,
     .offset = offsetof(orr_scenario_tunnel, to),
     .min = -360,
     .max = 360,
     .least = 2,
     .most = 2,
     .unit = "deg",
     .only = by_place,
     .help = "of the other"},
    REAL_ROW(orr_scenario_tunnel, "width", width_m, 1, 1000, "m", "20", by_place, "its width"),
};
static const char *check_tunnel(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_tunnel *t = map;
    if (!t->has_during && (t->from.n == 0 || t->to.n == 0)) {
        snprintf(why, ORR_SCHEMA_WHY, "needs a time (during), or the places of its two mouths (from, to)");
        return "";
    }
    if (t->has_during && (t->during.from % 1000000 != 0 || t->during.to % 1000000 != 0)) {
        snprintf(why, ORR_SCHEMA_WHY, "it begins and ends on a whole millisecond, where blocks can begin");
        return "during";
    }
    return off_earth(&t->from, &t->to, why);
}
static const orr_schema wall_table = {.key = wall_rows,
                                      .n = sizeof wall_rows / sizeof wall_rows[0],
                                      .size = sizeof(orr_scenario_wall),
                                      .check = check_wall};
static const orr_schema tunnel_table = {.key = tunnel_rows,
                                        .n = sizeof tunnel_rows / sizeof tunnel_rows[0],
                                        .size = sizeof(orr_scenario_tunnel),
                                        .check = check_tunnel};
static const orr_condition of_terrain[] = {{.key = "file"}, {0}};
static const orr_key terrain_rows[] = {
    {.name = "file",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_scenario_terrain, file),
     .help = "ESRI ASCII grid of heights by longitude and latitude, such as SRTM's"},
    REAL_ROW(orr_scenario_terrain, "undulation", undulation_m, -120, 120, "m", "0", of_terrain,
             "height of the geoid above the ellipsoid there: added to heights that are above the sea"),
    REAL_ROW(orr_scenario_terrain, "range", range_m, 100, 200000, "m", "50000", of_terrain,
             "how far terrain is looked at"),
    BOOL_ROW(orr_scenario_terrain, "refraction", refraction, "no", of_terrain,
             "rays bend down to the Earth: satellites are seen half a degree below a level horizon"),
};
static const orr_schema terrain_table = ORR_SCHEMA(terrain_rows, orr_scenario_terrain);
static const orr_key obstacle_rows[] = {
    MAPS_ROW(orr_scenario_obstacles, "walls", walls, &wall_table, 1000, NULL,
             "upright planes that hide what is behind"),
    MAPS_ROW(orr_scenario_obstacles, "tunnels", tunnels, &tunnel_table, 1000, NULL,
             "where or when nothing is received"),
    MAP_ROW(orr_scenario_obstacles, "terrain", terrain, &terrain_table, NULL,
            "terrain around antennas that stand: satellites below its horizon have no channel"),
};
const orr_schema orr_section_obstacles = ORR_SCHEMA(obstacle_rows, orr_scenario_obstacles);
