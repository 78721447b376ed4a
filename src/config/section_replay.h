// SPDX-License-Identifier: GPL-3.0-or-later
// Section `replay`: a station's recorded observations, which the scenario's channels reproduce.
#ifndef ORR_CONFIG_SECTION_REPLAY_H
#define ORR_CONFIG_SECTION_REPLAY_H

#include "core/time.h"
#include "src/config/schema.h"

typedef struct orr_scenario_replay {
    char *observations; // RINEX file; NULL: no replay
    char *sinex;        // coordinates; NULL: those of the observations' header
    char *station;      // its name there; NULL: by the observations' name
    bool has_from, has_to;
    orr_time from, to; // epochs outside are left out
    bool estimate_position, residuals;
} orr_scenario_replay;

extern const orr_schema orr_section_replay;

#endif
