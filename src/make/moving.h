// SPDX-License-Identifier: GPL-3.0-or-later
// The moving part of a scenario, prepared: one trajectory serves readings, truth and the satellites'
// receiver.
#ifndef ORR_MAKE_MOVING_H
#define ORR_MAKE_MOVING_H

#include "core/log.h"
#include "inertial/motion/dual_unit.h"
#include "inertial/motion/telemetry_fit.h"
#include "inertial/readings/imu.h"
#include "ingest/telemetry/telemetry.h"
#include "src/config/scenario.h"
#include "src/make/inputs.h"

// A scenario's motion, prepared. Unit 0 is the body's own reference; unit k is units.item[k - 1].
typedef struct orr_moving {
    orr_trajectory trajectory;                 // of unit 0
    size_t n_units;                            // 1 and those named
    orr_trajectory unit[ORR_MOTION_MAX_UNITS]; // unit[0] is not used
    orr_gravity *gravity;                      // NULL: normal gravity
    orr_gravity_model *model;
    orr_imu_mode mode;
    double rate_hz;
    bool from_telemetry;
    orr_fit_report report; // of telemetry
    orr_clock_tie tie;     // of a log with two clocks; n = 0: there is one clock
    orr_time tie_zero;     // t0 of that log
    orr_inputs inputs;     // the files that were read: logs, gravity
} orr_moving;

// Begin of a motion that nothing dates (2024-02-04T00:00:00 GPS): readings of a file and of a service agree.
orr_time orr_moving_fallback_start(void);

// Prepares the motion of a scenario.
// Given:
//   m               trajectory, units, gravity and readings of the scenario
//   fallback_start  where the scenario has no start
//   leap            table of leap seconds that logs are read by; NULL: built-in
// Returned:
//   warnings        of the logs' readers; may be NULL
//   out             the motion; free with orr_moving_free
//   diag            why it failed, with file and line; may be NULL
// Errors: those of readers and makers; ORR_E_NODATA (the scenario has no trajectory).
orr_status orr_moving_open(const orr_scenario_motion *m, orr_time fallback_start, const orr_leap_table *leap,
                           orr_warnings *warnings, orr_moving *out, orr_diag *diag);
// Frees all that a motion holds; it is zero then.
void orr_moving_free(orr_moving *v);
// Nodes (or rectangles) a step where nobody says: 2 Gauss-Legendre nodes at 50 Hz and more, 3 below and on
// the livelier motion of a log.
int orr_moving_order(const orr_moving *v, orr_quadrature quadrature, double rate_hz);
// Trajectory of unit k < n_units.
const orr_trajectory *orr_moving_unit(const orr_moving *v, size_t k);

#endif
