// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_gravity.h"

#include "src/config/rows_private.h"

static const orr_condition of_model[] = {{.key = "model"}, {0}};
static const orr_condition of_mgal[] = {{.key = "mgal"}, {0}};
static const orr_condition of_distance[] = {{.key = "distance"}, {0}};

static const orr_key mass_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_mass, "lat", lat_deg, -90, 90, "deg", NULL, "latitude of the mass"),
    NEEDED_REAL_ROW(orr_scenario_mass, "lon", lon_deg, -360, 360, "deg", NULL, "its longitude"),
    REAL_ROW(orr_scenario_mass, "height", height_m, -1e6, 1e5, "m", "0", NULL,
             "its height above the ellipsoid (below: negative)"),
    NEEDED_REAL_ROW(orr_scenario_mass, "gm", gm_m3ps2, -1e16, 1e16, "m3/s2", NULL,
                    "GM of the extra mass; negative for a lack"),
};

static const orr_schema mass_table = ORR_SCHEMA(mass_rows, orr_scenario_mass);

static const orr_key profile_rows[] = {
    NEEDED_REAL_ROW(orr_scenario_profile, "lat", lat_deg, -90, 90, "deg", NULL,
                    "latitude of the profile's distance 0"),
    NEEDED_REAL_ROW(orr_scenario_profile, "lon", lon_deg, -360, 360, "deg", NULL, "its longitude"),
    REAL_ROW(orr_scenario_profile, "azimuth", azimuth_deg, -360, 360, "deg", "0", NULL,
             "direction of the profile there, clockwise from North"),
    REALS_ROW(orr_scenario_profile, "distance", distance_m, "m", of_mgal,
              "ascending distances; without them gravity.file is a profile"),
    REALS_ROW(orr_scenario_profile, "mgal", mgal, "mGal", of_distance,
              "disturbances at the distances, joined by a natural cubic spline"),
};

static const char *check_profile(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_profile *p = map;
    if (p->distance_m.n == p->mgal.n) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "%zu values for %zu distances", p->mgal.n, p->distance_m.n);
    return "mgal";
}

static const orr_schema profile_table = {.key = profile_rows,
                                         .n = sizeof profile_rows / sizeof profile_rows[0],
                                         .size = sizeof(orr_scenario_profile),
                                         .check = check_profile};

static const orr_key rows[] = {
    TEXT_ROW(orr_scenario_gravity, "model", model, NULL,
             "spherical harmonics in GeographicLib's format, e.g. egm96; without it, normal gravity"),
    FILE_ROW(orr_scenario_gravity, "folder", folder, of_model, "where the model's files are"),
    FILE_ROW(orr_scenario_gravity, "file", file, NULL,
             "map of the disturbance (CSV of lat, lon, mgal on a grid, or NetCDF), or a profile (CSV of "
             "distance in m, mgal) whose place gravity.profile tells"),
    {.name = "profile",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_scenario_gravity, profile),
     .given = offsetof(orr_scenario_gravity, has_profile),
     .map = &profile_table,
     .help = "disturbance along a geodesic of the ellipsoid, the same at any distance across"},
    MAPS_ROW(orr_scenario_gravity, "masses", masses, &mass_table, 0, NULL, "extra point masses"),
};

static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_scenario_gravity *g = map;
    if (!g->has_profile || g->profile.distance_m.n > 0 || g->file != NULL) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "has no effect without distance and mgal, or a gravity.file that has them");
    return "profile";
}

const orr_schema orr_section_gravity = {
    .key = rows, .n = sizeof rows / sizeof rows[0], .size = sizeof(orr_scenario_gravity), .check = check};
