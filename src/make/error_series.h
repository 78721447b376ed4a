// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of a unit's sensors over a whole motion, prepared once, so that readings over any interval have them: the same interval
// always gets the same errors, and intervals that meet share what lies between.
#ifndef ORR_MAKE_ERROR_SERIES_H
#define ORR_MAKE_ERROR_SERIES_H

#include "src/make/measured.h"
#include "src/make/moving.h"

// Sums of the errors of all increments up to each edge begin_s + k / rate_hz.
typedef struct orr_error_series {
    double begin_s, rate_hz;
    size_t n;
    orr_vec3 *dtheta_rad, *dv_mps; // [n + 1]
} orr_error_series;

// Errors of a unit at the scenario's rate of readings, as `orrery imu` has them of it.
//   Given:    moving        the motion
//             unit          which unit; it draws with errors->seed + unit
//             errors        of its sensors
//   Returned: out           free with orr_error_series_free
//   Notes:    Errors of orr_imu_generate and orr_imu_add_errors; ORR_E_MEMORY.
orr_status orr_error_series_make(const orr_moving *moving, size_t unit, const orr_imu_errors *errors,
                                 orr_error_series *out, orr_diag *diag);
// Adds the errors of an interval to its ideal increments; between edges they grow steadily.
//   Given:    s              the series
//             from_s, to_s   the interval, s after the trajectory's t0
//   Returned: dtheta_rad, dv_mps   with the errors
void orr_error_series_add(const orr_error_series *s, double from_s, double to_s, orr_vec3 *dtheta_rad,
                          orr_vec3 *dv_mps);
// Frees it; it is empty then.
void orr_error_series_free(orr_error_series *s);

#endif
