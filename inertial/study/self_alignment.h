// SPDX-License-Identifier: GPL-3.0-or-later
// Self-alignment of a unit at rest: heading, pitch and roll from gravity and the Earth's rate alone, and what sensor
// errors make of them in closed form.
#ifndef ORR_INERTIAL_STUDY_SELF_ALIGNMENT_H
#define ORR_INERTIAL_STUDY_SELF_ALIGNMENT_H

#include "inertial/readings/imu.h"

typedef enum orr_self_method {
    // Means of rate and force over the window, in body axes. Coning about a horizontal axis looks like a drift.
    ORR_SELF_AVERAGE,
    // Attitude by the gyros from the window's begin on; gravity is seen to turn with the Earth in the axes of that
    // instant. Vibration does no more to it than to the gyros.
    ORR_SELF_INERTIAL,
} orr_self_method;

typedef struct orr_self_alignment {
    orr_angles found, truth; // of the average: the means of the window; else at its end
    orr_angles error;        // found less truth, the heading's within half a turn
    // What the mean errors of the window's readings make of the angles to first order.
    orr_angles closed_form;
    orr_vec3 gyro_error_radps, accel_error_mps2; // those means, East, North, Up
} orr_self_alignment;

// Aligns on the measured readings, on the ideal ones where there are none.
//   Given:    imu           a run at rest (vibrating about a place is allowed) with its truth at every reading
//             method        how
//             from, to      readings of the window
//             gravity       field; NULL: normal gravity
//   Returned: out           angles and their errors
//   Notes:    ORR_E_ARG (no window of two readings, truth not at every reading); ORR_E_NUMERIC where gravity and
//             the Earth's rate are parallel, or gravity has not turned.
//   Reference: Britting 1971, 8.2; Titterton and Weston 2004, 10.4: heading by dw_E / (u cos lat), tilts by df / g.
orr_status orr_self_align(const orr_imu *imu, orr_self_method method, size_t from, size_t to,
                          const orr_gravity *gravity, orr_self_alignment *out, orr_diag *diag);

// Errors of the angles by constant errors of a level unit's sensors, to first order:
// heading -dw_E / (u cos lat) + tan(lat) df_E / g, pitch and roll by df / g along the body's axes.
//   Given:    gyro_radps, accel_mps2   errors, East, North, Up
//             heading_rad              of the unit
//             lat_rad                  latitude, not of a pole
//             gravity_mps2             plumb gravity, above 0
//   Returned: the errors of the angles
orr_angles orr_self_alignment_closed_form(orr_vec3 gyro_radps, orr_vec3 accel_mps2, double heading_rad,
                                          double lat_rad, double gravity_mps2);

#endif
