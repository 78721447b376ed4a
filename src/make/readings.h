// SPDX-License-Identifier: GPL-3.0-or-later
// A prepared motion and options to ideal inertial readings with their truth: what `orrery imu` writes.
#ifndef ORR_MAKE_READINGS_H
#define ORR_MAKE_READINGS_H

#include "inertial/readings/imu_file.h"
#include "inertial/sense/measured.h"
#include "src/make/moving.h"

// A scenario, read once by a run's table of leap seconds and appended to `inputs` (may be NULL).
// Given:
//   inputs  the list that it is appended to; may be NULL
//   path    the scenario
//   leap    table of leap seconds, which has to outlive the scenario; NULL: built-in
// Returned:
//   out     the scenario; free with orr_scenario_free
//   diag    why it failed; may be NULL
// Errors: as of orr_scenario_read.
orr_status orr_inputs_scenario(orr_inputs *inputs, const char *path, const orr_leap_table *leap,
                               orr_scenario *out, orr_diag *diag);

// Appends the files that a scenario names, by reading them again to be hashed. What is no file any more (a pipe) or a folder is left out.
// Errors: those of orr_inputs_note.
orr_status orr_inputs_scenario_files(orr_inputs *inputs, const orr_scenario *scenario, orr_diag *diag);

typedef struct orr_readings_plan {
    const orr_moving *moving;
    size_t unit; // below moving->n_units
    double rate_hz;
    orr_imu_mode mode;
    bool instantaneous;
    orr_imu_axes axes;            // of the file
    const orr_imu_errors *errors; // of the sensors; NULL: ideal readings alone
    const char *errors_title;     // what they are, for the file
    double truth_rate_hz; // of the truth that a file has; 0: every reading of approach 1, 20 Hz of approach 2
} orr_readings_plan;
// What the motion's scenario asks for, of its own point.
orr_readings_plan orr_readings_plan_of(const orr_moving *moving);

typedef struct orr_readings {
    orr_imu imu;
    orr_gravimetry truth;
    size_t truth_every;    // readings from one instant of truth to the next
    orr_errors_report cut; // what errors of sensors cut off
} orr_readings;

// Errors: those of orr_imu_generate and orr_gravimetry_truth. Free with orr_readings_free whatever it returned.
orr_status orr_readings_make(const orr_readings_plan *plan, orr_readings *out, orr_diag *diag);
// Frees both; they are zero then.
void orr_readings_free(orr_readings *r);

// Writes readings and truth as a NetCDF file with provenance.
// Given:
//   r         the readings
//   plan      that they were made by
//   scenario  its title and its gravity's labels go into the file
//   inputs    what the scenario was read from, which comes before the files of the motion; may be NULL
//   path      where to
//   history   the command line
// Returned:
//   diag      why it failed; may be NULL
// Errors: those of orr_imu_write; ORR_E_MEMORY.
orr_status orr_readings_save(const orr_readings *r, const orr_readings_plan *plan,
                             const orr_scenario *scenario, const orr_inputs *inputs, const char *path,
                             const char *history, orr_diag *diag);

#endif
