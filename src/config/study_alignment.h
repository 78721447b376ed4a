// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery alignment`.
#ifndef ORR_CONFIG_STUDY_ALIGNMENT_H
#define ORR_CONFIG_STUDY_ALIGNMENT_H

#include "src/config/study.h"

#define ORR_SELF_METHODS(X)                                                                                  \
    X(ORR_SELF_WORD_INERTIAL, "inertial", "attitude by the gyros; gravity is seen to turn with the Earth")   \
    X(ORR_SELF_WORD_AVERAGE, "average", "means of rate and force in body axes")
typedef enum orr_self_word { ORR_SELF_METHODS(ORR_CHOICE_VALUE) } orr_self_word;

typedef struct orr_study_self {
    int method; // orr_self_word
    int64_t window_ns;
} orr_study_self;

typedef struct orr_study_alignment {
    orr_study_head head;
    char *scenario, *errors;
    int64_t seeds;
    orr_study_self self;
} orr_study_alignment;

extern const orr_schema orr_study_alignment_schema;

#endif
