// SPDX-License-Identifier: GPL-3.0-or-later
// A file of sensor errors, a root of its own: what a grade of inertial sensors does to ideal readings. In the units of
// data sheets.
#ifndef ORR_CONFIG_SENSOR_FILE_H
#define ORR_CONFIG_SENSOR_FILE_H

#include "src/config/schema.h"

#define ORR_SENSOR_ERRORS_MAX_PROCESSES 4

typedef struct orr_error_process {
    double sigma, time_s;
} orr_error_process;

typedef struct orr_error_temperature {
    orr_real_list bias, bias2, rate, scale;
} orr_error_temperature;

// Of a triad. Lists have one value, for all axes, or three.
typedef struct orr_error_triad {
    orr_real_list bias, white, walk, ramp, scale, asymmetry, quadratic, cubic, misalignment, by_force,
        by_force_squared, rectification, arms;
    double bias_sigma, scale_sigma, misalignment_sigma, bandwidth_hz, damping, limit, quantum;
    orr_error_temperature temperature;
    struct {
        size_t n;
        orr_error_process *item;
    } instability;
} orr_error_triad;

typedef struct orr_error_profile {
    orr_real_list times_s, values_c;
    double reference_c, lag_s;
} orr_error_profile;

typedef struct orr_sensor_errors {
    char *title, *source;
    int64_t seed;
    orr_error_profile temperature;
    double vibration_g, delay_ms, jitter_us;
    orr_error_triad gyro, accelerometer;
} orr_sensor_errors;

// Reads and checks a file's text.
//   Given:    name          of the file, for sentences
//             text, n       its bytes
//   Returned: out           the errors; free with orr_sensor_errors_free
//   Notes:    ORR_E_FORMAT and ORR_E_KIND with line, column and path, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_sensor_errors_parse(const char *name, const char *text, size_t n, orr_sensor_errors *out,
                                   orr_diag *diag);
// Frees all; zeroed errors may be freed.
void orr_sensor_errors_free(orr_sensor_errors *e);

#endif
