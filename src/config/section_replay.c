// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/section_replay.h"

#include "src/config/rows_private.h"

static const orr_condition of_sinex[] = {{.key = "sinex"}, {0}};

static const orr_key rows[] = {
    {.name = "observations",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_scenario_replay, observations),
     .help = "RINEX observations of a station that stands, of any version, Hatanaka-compressed or not; the "
             "orbits and "
             "the ionosphere have to be those of its day"},
    FILE_ROW(orr_scenario_replay, "sinex", sinex, NULL,
             "SINEX file with the station's coordinates; default: the position of the observations' header"),
    TEXT_ROW(orr_scenario_replay, "station", station, of_sinex,
             "the station's name there; default: the first four characters of the observations' name"),
    {.name = "from",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_replay, from),
     .given = offsetof(orr_scenario_replay, has_from),
     .help = "first epoch; the record's by default"},
    {.name = "to",
     .kind = ORR_KEY_TIME,
     .offset = offsetof(orr_scenario_replay, to),
     .given = offsetof(orr_scenario_replay, has_to),
     .help = "last epoch, likewise"},
    BOOL_ROW(orr_scenario_replay, "estimate_position", estimate_position, "yes", NULL,
             "the position is estimated from the observations; SINEX coordinates count as known to 1 cm, "
             "those of a "
             "header to 100 m"),
    BOOL_ROW(
        orr_scenario_replay, "residuals", residuals, "yes", NULL,
        "what the models leave of code and carrier is added, so that the recorded epochs have the recorded "
        "observations"),
};
const orr_schema orr_section_replay = ORR_SCHEMA(rows, orr_scenario_replay);
