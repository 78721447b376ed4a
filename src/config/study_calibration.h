// SPDX-License-Identifier: GPL-3.0-or-later
// File of the study `orrery calibration`.
#ifndef ORR_CONFIG_STUDY_CALIBRATION_H
#define ORR_CONFIG_STUDY_CALIBRATION_H

#include "src/config/study.h"

// Axis 2 of the stand, and the place.
typedef struct orr_study_stand {
    double lat_deg, lon_deg, height_m, azimuth_deg, elevation_deg;
    bool literal_mounting, literal_forces;
} orr_study_stand;

typedef struct orr_study_segment {
    int64_t for_ns;
    double rate_degps;
} orr_study_segment;
typedef struct orr_study_profile {
    struct {
        size_t n;
        orr_study_segment *item;
    } segments;
    double ripple, ripple_per_turn;
} orr_study_profile;

#define ORR_STAND_AXES(X)                                                                                    \
    X(ORR_STAND_RIGHT, "right", "axis 1 along the stand's, 2 along its axis 3, 3 along 1")                   \
    X(ORR_STAND_FORWARD, "forward", "axis 2 along the stand's, 1 and 3 along its axes 1 and 3")              \
    X(ORR_STAND_UP, "up", "axis 3 along the stand's, 1 along its axis 3, 2 along 1")
typedef enum orr_stand_axis { ORR_STAND_AXES(ORR_CHOICE_VALUE) } orr_stand_axis;

typedef struct orr_study_cycle {
    int along; // orr_stand_axis
    orr_real_list turned, mounting, offset;
    double start_deg;
    bool has_profile;
    orr_study_profile profile;
} orr_study_cycle;

typedef struct orr_study_calibration {
    orr_study_head head;
    orr_study_stand stand;
    double rate_hz;
    orr_real_list arms;
    orr_study_profile profile;
    struct {
        size_t n;
        orr_study_cycle *item;
    } cycles;
    char *errors;
    bool estimate, solve_arms, offsets_known, null_test;
    double along_error_m;
    int64_t block_ns, seeds;
} orr_study_calibration;

extern const orr_schema orr_study_calibration_schema;

#endif
