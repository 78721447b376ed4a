// SPDX-License-Identifier: GPL-3.0-or-later
// What a replay was made with, and its residuals by satellite and signal: as text, CSV and JSON.
#ifndef ORR_CLI_SCENARIO_REPLAY_REPORT_H
#define ORR_CLI_SCENARIO_REPLAY_REPORT_H

#include <jansson.h>
#include <stdio.h>

#include "src/scenario/replay/replay_make.h"

// A table of both.
void orr_replay_report_text(FILE *f, const orr_replay *r, const orr_replay_report *report);
// A row a track: sat, signal, code, and the statistics.
void orr_replay_report_csv(FILE *f, const orr_replay *r);
// The same, with what was estimated; NULL without memory.
json_t *orr_replay_report_json(const orr_replay *r, const orr_replay_report *report);

#endif
