// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature of sensors: a profile outside, which they follow with a lag.
#ifndef ORR_INERTIAL_SENSE_TEMPERATURE_H
#define ORR_INERTIAL_SENSE_TEMPERATURE_H

#include "core/status.h"

typedef struct orr_temperature {
    size_t n; // points of the profile, linear between; 0: the sensors are at their reference temperature
    const double *t_s;     // [n] ascending, s after the begin of the run. Borrowed
    const double *celsius; // [n] borrowed
    double reference_c;    // where the coefficients of sensors are zero
    double lag_s;          // dT/dt = (outside - T) / lag; 0: the sensors are as warm as it is outside
} orr_temperature;

// The sensors, as time goes on. They begin as warm as it is outside.
typedef struct orr_thermal_state {
    const orr_temperature *profile;
    double t_s, celsius, rate_cps; // now; rate of the last step
    size_t piece;                  // of the profile
} orr_thermal_state;

// Whether a profile can be used for a run of this length: ORR_E_ARG (not ascending, no number, a negative lag), ORR_E_RANGE
// where it does not cover the run.
orr_status orr_temperature_check(const orr_temperature *profile, double duration_s, orr_diag *diag);
// The state at the begin of the run.
orr_thermal_state orr_thermal_begin(const orr_temperature *profile);
// One step on, exact for the linear profile.
void orr_thermal_advance(orr_thermal_state *s, double dt_s);

#endif
