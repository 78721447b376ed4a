// SPDX-License-Identifier: GPL-3.0-or-later
// A study of calibration from its file: stand, cycles, sensors, and the plan of the least squares.
#ifndef ORR_MAKE_CALIBRATION_H
#define ORR_MAKE_CALIBRATION_H

#include "inertial/study/calibration.h"
#include "src/config/study_calibration.h"
#include "src/make/measured.h"

typedef struct orr_calibration_job {
    orr_stand stand;
    size_t n_cycles;
    orr_stand_cycle *cycle;     // as they are
    orr_stand_segment *segment; // of all cycles
    orr_vec3 inner_m[3];
    bool has_errors;
    orr_sensor_errors file;
    orr_imu_errors errors; // without arms, which are in inner_m
    // The same in the accelerometers' own axes, which calibration finds.
    orr_calibration_truth truth;
    orr_stand_cycle *own_cycle;
    orr_calibration_plan plan; // on own_cycle
    bool more;                 // errors have parts beyond the constants and white noise
} orr_calibration_job;

// Prepares a study.
//   Given:    study         its file; outlives the job
//             inputs        what has been read so far
//   Returned: inputs        with the file of errors
//             out           free with orr_calibration_job_free, whatever was returned
//   Notes:    ORR_E_ARG, ORR_E_MEMORY, those of orr_errors_open.
orr_status orr_calibration_open(const orr_study_calibration *study, orr_inputs *inputs,
                                orr_calibration_job *out, orr_diag *diag);
// Frees all; zero may be freed.
void orr_calibration_job_free(orr_calibration_job *job);

#endif
