// SPDX-License-Identifier: GPL-3.0-or-later
// File of `orrery aiding`.
#ifndef ORR_CONFIG_STUDY_AIDING_H
#define ORR_CONFIG_STUDY_AIDING_H

#include "src/config/study.h"

typedef struct orr_aiding_error {
    double bias, bias_sigma, sigma, time_s, white;
} orr_aiding_error;

typedef struct orr_aiding_barometer {
    orr_aiding_error error; // m
    double scale_ppm, lag_s;
} orr_aiding_barometer;

typedef struct orr_aiding_magnetometer {
    orr_aiding_error error; // nT
    char *model, *folder;
    orr_real_list hard_nt, soft_ppm;
} orr_aiding_magnetometer;

typedef struct orr_aiding_odometer {
    orr_aiding_error error; // m/s
    orr_real_list arm_m;
    double scale_ppm, quantum_m;
} orr_aiding_odometer;

typedef struct orr_aiding_antennas {
    orr_aiding_error error; // deg
    orr_real_list baseline_m;
    double across_m, up_m;
} orr_aiding_antennas;

typedef struct orr_aiding_receiver {
    char *orbit;
    orr_real_list arm_m;
    double mask_deg, range_m, rate_mps, sigma_m, time_s;
} orr_aiding_receiver;

typedef struct orr_study_aiding {
    orr_study_head head;
    char *scenario;
    int64_t unit, duration_ns;
    double rate_hz;
    bool has_barometer, has_magnetometer, has_odometer, has_antennas, has_receiver;
    orr_aiding_barometer barometer;
    orr_aiding_magnetometer magnetometer;
    orr_aiding_odometer odometer;
    orr_aiding_antennas antennas;
    orr_aiding_receiver receiver;
} orr_study_aiding;

extern const orr_schema orr_study_aiding_schema;

#endif
