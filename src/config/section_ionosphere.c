// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_ionosphere.h"

#include "src/config/rows_private.h"

static const orr_condition no_session[] = {
    {.key = "session", .absent = true, .why = "a session holds its field"}, {0}};
static const orr_condition of_session[] = {{.key = "session"}, {0}};
static const orr_condition of_noise[] = {{.key = "session"}, {.key = "noise", .words = "yes"}, {0}};

static const orr_condition of_field[] = {{.key = "field"}, {0}};
static const orr_condition of_rotated[] = {{.key = "field"}, {.key = "between", .words = "rotated"}, {0}};
static const orr_choice maps[] = {ORR_IONO_MAPS(ORR_CHOICE_WORD){0}};
static const orr_choice between[] = {ORR_IONO_BETWEEN(ORR_CHOICE_WORD){0}};

static const orr_key rows[] = {
    FILE_ROW(orr_scenario_iono, "field", field, no_session,
             "TEC field: IONEX maps, Bernese coefficients (.ION), or a RINEX navigation file (Klobuchar)"),
    CHOICE_ROW(orr_scenario_iono, "maps", maps, maps, "auto", of_field, "how maps are kept"),
    CHOICE_ROW(orr_scenario_iono, "between", between, between, "auto", of_field,
               "between the epochs of maps"),
    REAL_ROW(orr_scenario_iono, "rotation", rotation, 0, 1, NULL, "1", of_rotated,
             "part of the Sun's motion that maps follow"),
    FILE_ROW(orr_scenario_iono, "session", session, NULL,
             "session made by 'orrery iono' (NetCDF); it holds its field"),
    BOOL_ROW(orr_scenario_iono, "noise", noise, "yes", of_session,
             "fill what the station did not see with noise of the structure that it saw"),
    INT_ROW(orr_scenario_iono, "seed", seed, 0, 9007199254740992.0, "1", of_noise,
            "seed of the noise; the same seed gives the same delays"),
};

const orr_schema orr_section_ionosphere = ORR_SCHEMA(rows, orr_scenario_iono);
