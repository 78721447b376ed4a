// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery alignment`.
#ifndef ORR_CONFIG_STUDY_ALIGNMENT_H
#define ORR_CONFIG_STUDY_ALIGNMENT_H

#include "src/config/study.h"

#define ORR_SELF_METHODS(X)                                                                                  \
    X(ORR_SELF_WORD_INERTIAL, "inertial", "attitude by the gyros; gravity is seen to turn with the Earth")   \
    X(ORR_SELF_WORD_AVERAGE, "average", "means of rate and force in body axes")
typedef enum orr_self_word { ORR_SELF_METHODS(ORR_CHOICE_VALUE) } orr_self_word;

#define ORR_ALIGNMENT_KINDS(X)                                                                               \
    X(ORR_ALIGNMENT_SELF, "self", "at rest, by gravity and the Earth's rate")                                \
    X(ORR_ALIGNMENT_TRANSFER, "transfer", "of a second unit on a moving base, by the first one's velocity")
typedef enum orr_alignment_kind { ORR_ALIGNMENT_KINDS(ORR_CHOICE_VALUE) } orr_alignment_kind;

typedef struct orr_study_flexure {
    double sigma_arcmin, rate_radps;
} orr_study_flexure;

typedef struct orr_study_transfer {
    char *first_errors;
    int64_t unit, interval_ns;
    double velocity_noise_mps, start_velocity_mps;
    orr_real_list mounting_deg, first_attitude_arcsec;
    orr_study_flexure flexure;
} orr_study_transfer;

typedef struct orr_study_self {
    int method; // orr_self_word
    int64_t window_ns;
} orr_study_self;

typedef struct orr_study_alignment {
    orr_study_head head;
    int kind;
    char *scenario, *errors;
    int64_t duration_ns;
    int64_t seeds;
    orr_study_self self;
    orr_study_transfer transfer;
} orr_study_alignment;

extern const orr_schema orr_study_alignment_schema;

#endif
