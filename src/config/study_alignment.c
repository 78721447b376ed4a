// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/config/study_alignment.h"

#include "src/config/rows_private.h"

static const orr_choice methods[] = {ORR_SELF_METHODS(ORR_CHOICE_WORD){0}};

static const orr_key self_rows[] = {
    CHOICE_ROW(orr_study_self, "method", method, methods, "inertial", NULL, "how angles are found"),
    {.name = "window",
     .kind = ORR_KEY_DURATION,
     .offset = offsetof(orr_study_self, window_ns),
     .unit = "s",
     .fallback = "10min",
     .help = "length of one alignment"},
};
static const orr_schema self_table = ORR_SCHEMA(self_rows, orr_study_self);

static const orr_key rows[] = {
    ORR_STUDY_HEAD(orr_study_alignment),
    {.name = "scenario",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_alignment, scenario),
     .help = "whose trajectory it is: at rest, or vibrating about a place"},
    {.name = "errors",
     .kind = ORR_KEY_FILE,
     .required = true,
     .offset = offsetof(orr_study_alignment, errors),
     .help = "errors of the sensors"},
    INT_ROW(orr_study_alignment, "seeds", seeds, 1, 10000, "20", NULL,
            "alignments, each with its own errors"),
    MAP_ROW(orr_study_alignment, "self", self, &self_table, NULL, "self-alignment at rest"),
};
const orr_schema orr_study_alignment_schema = {.key = rows,
                                               .n = sizeof rows / sizeof rows[0],
                                               .size = sizeof(orr_study_alignment),
                                               .hint = "'orrery alignment --help-study' lists all"};
