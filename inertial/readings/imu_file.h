// SPDX-License-Identifier: GPL-3.0-or-later
// A run of readings on disk: NetCDF-4 with the truth, the mode, the start state and the gravity it was made
// in, so that a null test needs nothing else; and CSV for everybody else's tools.
#ifndef ORR_INERTIAL_READINGS_IMU_FILE_H
#define ORR_INERTIAL_READINGS_IMU_FILE_H

#include "core/ncfile.h"
#include "inertial/readings/gravimetry_truth.h"

#define ORR_IMU_FORMAT "orrery inertial readings" // attribute "format" of such a file

typedef struct orr_imu_labels {
    const char *title;                                  // may be NULL
    const char *history;                                // the command line
    const char *gravity_model_name, *gravity_model_dir; // of spherical harmonics, or NULL
    const orr_nc_input *input;
    size_t n_inputs;
    size_t truth_every; // truth is written at every so many edges; 0 or 1: all
    orr_imu_axes axes;  // of readings and attitudes in the file
    const char *errors; // whose errors the measured increments have; NULL: there are none
} orr_imu_labels;

// Writes a run of readings as NetCDF-4. Layout: dimensions step (n), edge (n + 1), truth (n / truth_every + 1), xyz (3), quat (4), gravimetry;
// variables time_s(truth), dtheta_rad(step, xyz), dv_mps(step, xyz), [gyro_radps, accel_mps2 (edge, xyz)],
// position_m, velocity_mps (truth, xyz; ecef), attitude(truth, quat; w x y z, body from ecef),
// [carried_position_m (edge, xyz; inertial)], start_*, gravity and gravimetry. docs/inertial.md.
//   Given:    path          of the file; it appears there when it is whole
//             imu           the readings with their truth
//             gravimetry    true gravity along the track; NULL: none
//             gravity       field that the readings were made in; NULL: normal gravity
//             labels        title, history and inputs, and how often truth is written
//   Returned: diag          a sentence on what went wrong
//   Notes:    ORR_E_ARG (truth at instants that are not there), else as of core/ncfile.h.
orr_status orr_imu_write(const char *path, const orr_imu *imu, const orr_gravimetry *gravimetry,
                         const orr_gravity *gravity, const orr_imu_labels *labels, orr_diag *diag);

// What a file holds. `gravity` is rebuilt from the file (NULL: normal gravity); spherical harmonics are
// opened from where they were, or from model_dir if it is not NULL. Free with orr_imu_file_free.
typedef struct orr_imu_file {
    orr_imu imu;
    orr_gravimetry gravimetry; // n = 0: none
    orr_gravity *gravity;
    orr_gravity_model *model;
    char title[256];
} orr_imu_file;

// Reads a file that orr_imu_write wrote. Errors: ORR_E_KIND (another kind of file), ORR_E_FORMAT (not whole, or
// no numbers), those of orr_gravity_model_open and of core/ncfile.h.
orr_status orr_imu_read(const char *path, const char *model_dir, orr_imu_file *out, orr_diag *diag);
// Frees readings, gravity and model; an empty file is allowed.
void orr_imu_file_free(orr_imu_file *f);

// What a file of readings is, from its head alone: neither the readings nor a gravity model are opened.
typedef struct orr_imu_summary {
    orr_time t0;
    double begin_s, rate_hz; // reading j spans [begin_s + j / rate_hz, begin_s + (j + 1) / rate_hz] after t0
    size_t n;
    orr_imu_mode mode;
    size_t truth_every;
    bool instantaneous;
    size_t n_gravimetry; // instants of true gravity
    char gravity[256];   // "normal gravity, profile of 14 points"
    char title[256];
} orr_imu_summary;
// Reads the head of a file. Errors: ORR_E_KIND, ORR_E_FORMAT, those of core/ncfile.h.
orr_status orr_imu_summarise(const char *path, orr_imu_summary *out, orr_diag *diag);

// One line per edge: time, increments since the edge before, position, velocity (East, North, Up; with axes forward,
// right, down North, East, Down), angles, and the instantaneous readings where there are any. Errors: ORR_E_IO.
orr_status orr_imu_write_csv(FILE *f, const orr_imu *imu, orr_imu_axes axes, orr_diag *diag);

#endif
