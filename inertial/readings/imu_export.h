// SPDX-License-Identifier: GPL-3.0-or-later
// Readings in the formats of other tools. Each has its own axes, units and meaning of a time tag; docs/inertial.md says what
// each tool makes of them.
#ifndef ORR_INERTIAL_READINGS_IMU_EXPORT_H
#define ORR_INERTIAL_READINGS_IMU_EXPORT_H

#include <stdio.h>

#include "inertial/readings/imu.h"

typedef enum orr_imu_export {
    // CSV of pyins: increments (sensor_type "increment"), forward, right, down, with a row before the first.
    ORR_EXPORT_PYINS,
    // CSV of INSTINCT's file reader: mean rate and force, at the middle of each reading, forward, right, down.
    ORR_EXPORT_INSTINCT,
    // Text of PSINS: increments of angle and velocity and the time at their end, right, forward, up.
    ORR_EXPORT_PSINS,
    // CSV for NaveGo without a header: time at the end, mean force, mean rate, forward, right, down.
    ORR_EXPORT_NAVEGO,
    // NovAtel RAWIMUSX (message 1462) of an ISA-100C: counts of 1e-9 rad and 2e-8 m/s, right, forward, up.
    ORR_EXPORT_NOVATEL,
    // VectorNav binary output: TimeGps, DeltaTheta (deg), DeltaVel, single precision, forward, right, down.
    ORR_EXPORT_VECTORNAV,
} orr_imu_export;

// Writes a run.
//   Given:    f             open stream
//             imu           the run
//             to            format
//             measured      the readings with errors, else the ideal ones
//   Returned: diag          why it failed
//   Notes:    Counts carry what rounding leaves over on to the next. ORR_E_ARG (no readings with errors), ORR_E_RANGE (an
//             increment that the format cannot hold, an instant before GPS time), ORR_E_IO.
orr_status orr_imu_export_write(FILE *f, const orr_imu *imu, orr_imu_export to, bool measured,
                                orr_diag *diag);
// The truth where there is any, as CSV: time,lat,lon,alt,VN,VE,VD,roll,pitch,heading in s, deg, m, m/s; its first row is
// what a navigator starts from. Errors: ORR_E_IO.
orr_status orr_imu_export_truth(FILE *f, const orr_imu *imu, orr_diag *diag);

#endif
