// SPDX-License-Identifier: GPL-3.0-or-later
// The moving part of a scenario as true motion and inertial readings at any instant.
#ifndef ORR_SCENARIO_SOURCE_SOURCE_MOTION_H
#define ORR_SCENARIO_SOURCE_SOURCE_MOTION_H

#include "inertial/sense/sensors.h"
#include "src/config/scenario.h"
#include "src/make/moving.h"
#include "src/scenario/source/source.h"

typedef struct orr_source_motion orr_source_motion;

// True motion and gravity terms of a unit.
typedef struct orr_truth {
    orr_motion motion;
    orr_angles angles;
    orr_vec3 rate_radps, force_mps2; // absolute rate and specific force, body axes
    double disturbance_mgal, eotvos_mgal, vertical_mps2;
} orr_truth;

// How a unit is mounted on the body of unit 0.
typedef struct orr_unit {
    const char *name; // borrowed; "" where it has none
    orr_vec3 arm_m;   // from unit 0: right, forward, up
    orr_angles turn;  // of its axes against unit 0's
} orr_unit;

// Opens the moving part of a scenario.
// Given:
//   s               the scenario
//   fallback_start  where the trajectory begins if the scenario does not say when
// Returned:
//   warnings        of the readers; may be NULL
//   out             the source, NULL where the scenario has no trajectory; free with orr_source_motion_close
//   diag            why it failed; may be NULL
// Errors: those of orr_moving_open.
orr_status orr_source_motion_open(const orr_scenario *s, orr_time fallback_start, orr_warnings *warnings,
                                  orr_source_motion **out, orr_diag *diag);
// Frees it; NULL may be closed.
void orr_source_motion_close(orr_source_motion *m);

// The span of the trajectory; false without one.
bool orr_source_motion_span(const orr_source_motion *m, orr_span *out);
// The prepared motion; NULL without a trajectory.
const orr_moving *orr_source_motion_moving(const orr_source_motion *m);
// How many inertial units there are; 0 without a trajectory.
size_t orr_source_motion_units(const orr_source_motion *m);
// How a unit is mounted, as orr_engine_unit.
bool orr_source_motion_unit(const orr_source_motion *m, size_t unit, orr_unit *out);
// The scenario's rate of readings; 0 without a trajectory.
double orr_source_motion_rate_hz(const orr_source_motion *m);
// Whether readings are of approach 2.
bool orr_source_motion_physical(const orr_source_motion *m);

// Motion of the point of a unit at t: ORR_ANSWER_OK, _OUTSIDE_SPAN, or _NOT_SERVED (no such unit).
orr_answer orr_source_motion_at(const orr_source_motion *m, size_t unit, orr_time t, orr_motion *out);
// The point of a unit (ecef) at t, with answers as of orr_engine_truth.
orr_answer orr_source_motion_place(const orr_source_motion *m, size_t unit, orr_time t, orr_vec3 *out);
// Whether readings have the errors of the scenario's sensors.
bool orr_source_motion_measured(const orr_source_motion *m);
// Begins increments of a unit over an interval, as orr_engine_imu_begin.
// Given:
//   m     the source
//   unit  which
//   t0    begin of the interval
//   t1    its end, behind t0
// Returned:
//   sum   the increments so far; set with ORR_ANSWER_OK alone
orr_answer orr_source_motion_imu_begin(const orr_source_motion *m, size_t unit, orr_time t0, orr_time t1,
                                       orr_sensors_sum *sum);
// Adds pieces to the increments, as orr_engine_imu_add.
bool orr_source_motion_imu_add(const orr_source_motion *m, size_t unit, orr_sensors_sum *sum, long pieces);
// True motion and gravity of a unit, as orr_engine_truth.
orr_answer orr_source_motion_truth(const orr_source_motion *m, size_t unit, orr_time t, orr_truth *out);

#endif
