// SPDX-License-Identifier: GPL-3.0-or-later
// What studies are made from: their own file, and the scenarios and sensors that it names, each read once with its hash.
#ifndef ORR_MAKE_STUDY_H
#define ORR_MAKE_STUDY_H

#include "src/config/study.h"
#include "src/make/measured.h"
#include "src/make/readings.h"

// Reads a study's file, appended to `inputs`.
//   Given:    inputs        what has been read so far
//             path          of the file
//             schema        root table of the study
//   Returned: base          schema->size bytes; free with orr_schema_free
//   Notes:    Errors: those of reading, and of orr_study_parse.
orr_status orr_study_open(orr_inputs *inputs, const char *path, const orr_schema *schema, void *base,
                          orr_diag *diag);

// A motion that a study names by its scenario's file.
typedef struct orr_study_motion {
    orr_scenario scenario;
    orr_moving moving;
} orr_study_motion;
// Reads a scenario and prepares its motion, appended to `inputs`.
//   Given:    inputs        what has been read so far
//             path          of the scenario
//             duration_ns   length instead of the scenario's; 0: the scenario's own
//   Returned: out           free with orr_study_motion_free, whatever was returned
//   Notes:    Errors: those of orr_inputs_scenario and orr_moving_open.
orr_status orr_study_motion_open(orr_inputs *inputs, const char *path, int64_t duration_ns,
                                 orr_study_motion *out, orr_diag *diag);
// Frees both; they are zero then.
void orr_study_motion_free(orr_study_motion *m);

#endif
