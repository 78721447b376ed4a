// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery vibration`.
#ifndef ORR_CONFIG_STUDY_VIBRATION_H
#define ORR_CONFIG_STUDY_VIBRATION_H

#include "src/config/study.h"

// A method by its coefficients.
typedef struct orr_study_method {
    char *name;
    int64_t samples;
    orr_real_list coefficients;
} orr_study_method;

typedef struct orr_study_ratios {
    double low, high;
    int64_t points;
    orr_real_list also;
} orr_study_ratios;

// Vibration by its density.
typedef struct orr_study_spectrum {
    char *file;
    double coherence;
    int64_t runs, run_ns;
} orr_study_spectrum;

// Where the body stands, and how.
typedef struct orr_study_place {
    double lat_deg, lon_deg, height_m, heading_deg, pitch_deg, roll_deg;
} orr_study_place;

typedef struct orr_study_vibration {
    orr_study_head head;
    double readings_hz;
    orr_real_list products;
    int64_t duration_ns;
    orr_study_ratios ratios;
    orr_text_list methods;
    struct {
        size_t n;
        orr_study_method *item;
    } own;
    bool has_rest, has_spectrum;
    orr_study_place rest;
    orr_study_spectrum spectrum;
} orr_study_vibration;

extern const orr_schema orr_study_vibration_schema;

#endif
