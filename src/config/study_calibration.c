// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_calibration.h"

#include "src/config/rows_private.h"

static const orr_choice axes[] = {ORR_STAND_AXES(ORR_CHOICE_WORD){0}};

static const orr_key stand_rows[] = {
    NEEDED_REAL_ROW(orr_study_stand, "lat", lat_deg, -90, 90, "deg", NULL, "latitude"),
    REAL_ROW(orr_study_stand, "lon", lon_deg, -360, 360, "deg", "0", NULL, "longitude"),
    REAL_ROW(orr_study_stand, "height", height_m, -1000, 10000, "m", "0", NULL, "above the ellipsoid"),
    REAL_ROW(orr_study_stand, "azimuth", azimuth_deg, -360, 360, "deg", "0", NULL,
             "of the axis, clockwise from North"),
    REAL_ROW(orr_study_stand, "elevation", elevation_deg, -90, 90, "deg", "0", NULL,
             "of the axis above the horizon: 0 is the source's horizontal axis, 90 a vertical one"),
    BOOL_ROW(orr_study_stand, "literal_mounting", literal_mounting, "false", NULL,
             "the mounting error as the first-order matrix (22) instead of the rotation"),
    BOOL_ROW(orr_study_stand, "literal_forces", literal_forces, "false", NULL,
             "forces of arms by the stand's rate alone (27), without the cross terms of the Earth's and the "
             "change of "
             "gravity"),
};
static const orr_schema stand_table = ORR_SCHEMA(stand_rows, orr_study_stand);

static const orr_key segment_rows[] = {
    {.name = "for",
     .kind = ORR_KEY_DURATION,
     .required = true,
     .offset = offsetof(orr_study_segment, for_ns),
     .unit = "s",
     .help = "how long; a whole number of readings"},
    REAL_ROW(orr_study_segment, "rate", rate_degps, -2000, 2000, "deg/s", "0", NULL,
             "the rate at its end, to which it goes linearly; the same as before is constant, 0 a stop"),
};
static const orr_schema segment_table = ORR_SCHEMA(segment_rows, orr_study_segment);

static const orr_key profile_rows[] = {
    MAPS_ROW(orr_study_profile, "segments", segments, &segment_table, 1000, NULL,
             "one after the other, from rest"),
    REAL_ROW(orr_study_profile, "ripple", ripple, 0, 0.99, NULL, "0", NULL,
             "of the drive: amplitude over the rate"),
    REAL_ROW(orr_study_profile, "ripple_per_turn", ripple_per_turn, 0, 1000, NULL, "1", NULL,
             "its periods in a turn"),
};
static const char *check_profile(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_profile *p = map;
    if (p->segments.n > 0) return NULL;
    snprintf(why, ORR_SCHEMA_WHY, "none; a profile has one at least");
    return "segments";
}
static const orr_schema profile_table = {.key = profile_rows,
                                         .n = sizeof profile_rows / sizeof profile_rows[0],
                                         .size = sizeof(orr_study_profile),
                                         .check = check_profile};

static const orr_key cycle_rows[] = {
    CHOICE_ROW(orr_study_cycle, "along", along, axes, "forward", NULL,
               "axis of the unit along the stand's axis"),
    REALS_ROW(orr_study_cycle, "turned", turned, "deg", NULL,
              "the unit turned from there as it is meant, by three angles about its axes 1, 2, 3 in this "
              "order: any mounting"),
    REALS_ROW(orr_study_cycle, "mounting", mounting, "deg", NULL,
              "three parts of the error of that, alpha of (22)"),
    REALS_ROW(orr_study_cycle, "offset", offset, "m", NULL, "the unit from the axis: right, forward, up"),
    REAL_ROW(orr_study_cycle, "start", start_deg, -360, 360, "deg", "0", NULL,
             "angle of the stand at the begin"),
    {.name = "profile",
     .kind = ORR_KEY_MAP,
     .offset = offsetof(orr_study_cycle, profile),
     .given = offsetof(orr_study_cycle, has_profile),
     .map = &profile_table,
     .help = "instead of the profile of all cycles"},
};
static const char *check_cycle(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_cycle *c = map;
    const struct {
        const char *name;
        size_t n;
    } list[] = {{"turned", c->turned.n}, {"mounting", c->mounting.n}, {"offset", c->offset.n}};
    for (size_t k = 0; k < 3; k++)
        if (list[k].n != 0 && list[k].n != 3) {
            snprintf(why, ORR_SCHEMA_WHY, "%zu values; three are wanted", list[k].n);
            return list[k].name;
        }
    return NULL;
}
static const orr_schema cycle_table = {.key = cycle_rows,
                                       .n = sizeof cycle_rows / sizeof cycle_rows[0],
                                       .size = sizeof(orr_study_cycle),
                                       .check = check_cycle};

static const orr_condition of_errors[] = {{.key = "errors"}, {0}};

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_calibration),
    {.name = "stand",
     .kind = ORR_KEY_MAP,
     .required = true,
     .offset = offsetof(orr_study_calibration, stand),
     .map = &stand_table,
     .help = "where it stands, and its axis"},
    REAL_ROW(orr_study_calibration, "rate", rate_hz, 0.01, 10000, "Hz", "100", NULL, "of the readings"),
    REALS_ROW(
        orr_study_calibration, "arms", arms, "m", NULL,
        "places of the three accelerometers from the unit's point, nine numbers; without, all are there"),
    MAP_ROW(orr_study_calibration, "profile", profile, &profile_table, NULL,
            "what the stand does in each cycle"),
    MAPS_ROW(orr_study_calibration, "cycles", cycles, &cycle_table, 24, NULL,
             "mountings, one after the other"),
    {.name = "errors",
     .kind = ORR_KEY_FILE,
     .offset = offsetof(orr_study_calibration, errors),
     .help = "errors of the sensors"},
    BOOL_ROW(orr_study_calibration, "estimate", estimate, "true", NULL,
             "recover the constant errors by least squares, as a check"),
    BOOL_ROW(orr_study_calibration, "solve_arms", solve_arms, "true", NULL,
             "with the arms of the accelerometers among the unknowns"),
    BOOL_ROW(orr_study_calibration, "offsets_known", offsets_known, "false", NULL,
             "the offsets of the cycles are known; all nine arms are then seen"),
    REAL_ROW(orr_study_calibration, "along_error", along_error_m, -10, 10, "m", "0", NULL,
             "by which the known offset along the axis is wrong"),
    {.name = "block",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_calibration, block_ns),
     .unit = "s",
     .fallback = "1",
     .help = "over which readings are summed for least squares"},
    INT_ROW(orr_study_calibration, "seeds", seeds, 0, 10000, "0", of_errors,
            "draws of the noise, whose normalised squared errors are averaged"),
    BOOL_ROW(orr_study_calibration, "null_test", null_test, "true", NULL,
             "navigate on the ideal readings of the unit's point in the first cycle"),
};
static const char *check(const void *map, char why[ORR_SCHEMA_WHY])
{
    const orr_study_calibration *c = map;
    if (c->arms.n != 0 && c->arms.n != 9) {
        snprintf(why, ORR_SCHEMA_WHY, "%zu values; nine are wanted", c->arms.n);
        return "arms";
    }
    if (c->cycles.n == 0) {
        snprintf(why, ORR_SCHEMA_WHY, "none; a plan has one at least");
        return "cycles";
    }
    for (size_t k = 0; k < c->cycles.n; k++)
        if (!c->cycles.item[k].has_profile && c->profile.segments.n == 0) {
            snprintf(why, ORR_SCHEMA_WHY, "cycle %zu has no profile, and there is none for all", k + 1);
            return "cycles";
        }
    return NULL;
}
const orr_schema orr_study_calibration_schema = {.key = rows,
                                                 .n = sizeof rows / sizeof rows[0],
                                                 .size = sizeof(orr_study_calibration),
                                                 .check = check,
                                                 .hint = "'orrery calibration --help-study' lists all"};
