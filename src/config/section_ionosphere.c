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
static const orr_choice models[] = {ORR_IONO_MODELS(ORR_CHOICE_WORD){0}};
static const orr_choice mappings[] = {ORR_IONO_MAPPINGS(ORR_CHOICE_WORD){0}};
static const orr_condition of_nequick[] = {
    {.key = "field"},
    {.key = "model", .words = "nequick|auto", .why = "its tables serve NeQuick-G alone"},
    {0}};

static const orr_key rows[] = {
    FILE_ROW(orr_scenario_iono, "field", field, no_session,
             "TEC field: IONEX maps, Bernese coefficients (.ION), or a RINEX navigation file (a broadcast "
             "model)"),
    CHOICE_ROW(orr_scenario_iono, "maps", maps, maps, "auto", of_field, "how maps are kept"),
    CHOICE_ROW(orr_scenario_iono, "between", between, between, "auto", of_field,
               "between the epochs of maps"),
    REAL_ROW(orr_scenario_iono, "rotation", rotation, 0, 1, NULL, "1", of_rotated,
             "part of the Sun's motion that maps follow"),
    CHOICE_ROW(orr_scenario_iono, "model", model, models, "auto", of_field,
               "which broadcast model of a navigation file"),
    FILE_ROW(orr_scenario_iono, "nequick", nequick, of_nequick,
             "folder of NeQuick-G's tables: ccir11.asc to ccir22.asc and modip.asc, plain or with .gz"),
    CHOICE_ROW(orr_scenario_iono, "mapping", mapping, mappings, "mslm", of_field,
               "slant content from vertical; NeQuick-G integrates along the ray"),
    FILE_ROW(orr_scenario_iono, "session", session, NULL,
             "session made by 'orrery iono' (NetCDF); it holds its field"),
    BOOL_ROW(orr_scenario_iono, "noise", noise, "yes", of_session,
             "fill what the station did not see with noise of the structure that it saw"),
    INT_ROW(orr_scenario_iono, "seed", seed, 0, 9007199254740992.0, "1", of_noise,
            "seed of the noise; the same seed gives the same delays"),
};

const orr_schema orr_section_ionosphere = ORR_SCHEMA(rows, orr_scenario_iono);
