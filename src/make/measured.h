// SPDX-License-Identifier: GPL-3.0-or-later
// A file of sensor errors, in the units of data sheets, to the model of them.
#ifndef ORR_MAKE_MEASURED_H
#define ORR_MAKE_MEASURED_H

#include "inertial/sense/measured.h"
#include "src/config/sensor_file.h"
#include "src/make/inputs.h"

// In SI units. The temperature profile is borrowed from the file, which has to outlive the model.
orr_imu_errors orr_errors_of(const orr_sensor_errors *file);
// Reads a file, appended to `inputs`.
//   Given:    inputs        what has been read so far
//             path          of the file
//   Returned: file          as it stands; free with orr_sensor_errors_free
//             out           the model
//   Notes:    Errors: those of reading, and of orr_sensor_errors_parse.
orr_status orr_errors_open(orr_inputs *inputs, const char *path, orr_sensor_errors *file, orr_imu_errors *out,
                           orr_diag *diag);

#endif
