// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery crossovers`.
#ifndef ORR_CONFIG_STUDY_CROSSOVERS_H
#define ORR_CONFIG_STUDY_CROSSOVERS_H

#include "src/config/study.h"

#define ORR_GRAVITY_FILTERS(X)                                                                               \
    X(ORR_FILTER_GAUSSIAN, "gaussian", "of standard deviation length")                                       \
    X(ORR_FILTER_FIR, "fir", "finite impulse response, which passes half at a period of length")             \
    X(ORR_FILTER_KALMAN, "kalman", "smoother with a model of gravity, whose correlation time is length")
typedef enum orr_filter_word { ORR_GRAVITY_FILTERS(ORR_CHOICE_VALUE) } orr_filter_word;

typedef struct orr_study_receiver {
    double rate_hz, white_m, wander_m, wander_s;
} orr_study_receiver;
typedef struct orr_study_start {
    double tilt_arcsec, heading_arcsec;
} orr_study_start;
typedef struct orr_study_filter {
    int kind; // orr_filter_word
    int64_t length_ns;
    double model_mgal, height_m;
} orr_study_filter;
typedef struct orr_study_lines {
    double turn_degps;
    int64_t least_ns, margin_ns;
} orr_study_lines;

typedef struct orr_study_crossovers {
    orr_study_head head;
    char *scenario, *errors;
    orr_study_receiver receiver;
    orr_study_start alignment;
    orr_study_filter filter;
    orr_study_lines lines;
    int64_t seeds, duration_ns;
} orr_study_crossovers;

extern const orr_schema orr_study_crossovers_schema;

#endif
