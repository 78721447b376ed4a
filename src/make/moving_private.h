// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a motion, each in its own file; moving.c puts them together.
#ifndef ORR_MAKE_MOVING_PRIVATE_H
#define ORR_MAKE_MOVING_PRIVATE_H

#include "src/make/moving.h"

// A flight by survey, waypoints or phases, laid over the terrain's waves where there are some.
//   Given:    m         the scenario's trajectory
//             start     its begin
//   Returned: warnings  a duration that is longer than the plan; may be NULL
//             out       the trajectory
//             diag      why it failed
orr_status moving_make_plan(const orr_scenario_trajectory *m, orr_time start, orr_warnings *warnings,
                            orr_trajectory *out, orr_diag *diag);
// A trajectory in closed form, from `start` on.
orr_status moving_make_analytic(const orr_scenario_trajectory *m, orr_time start, orr_trajectory *out,
                                orr_diag *diag);
// A trajectory through logs.
//   Given:    m         the scenario's trajectory
//             fallback  its begin where neither scenario nor log tells a date
//   Returned: warnings  of the logs' reader, and what is assumed; may be NULL
//             out       trajectory, report, tie of clocks; the logs are in its inputs
//             diag      why it failed
orr_status moving_make_telemetry(const orr_scenario_trajectory *m, orr_time fallback, orr_warnings *warnings,
                                 orr_moving *out, orr_diag *diag);
// The orbit of a satellite of a product, or of elements.
//   Given:    m      the scenario's trajectory
//             start  begin of elements
//   Returned: out    the trajectory; the product is in its inputs
//             diag   why it failed: a satellite that the product has not, or not for so long; elements that are no orbit
orr_status moving_make_orbit(const orr_scenario_trajectory *m, orr_time start, orr_moving *out,
                             orr_diag *diag);
// Gravity on the trajectory that `out` has; C moves disturbances with a transferred flight (NULL: there is none).
orr_status moving_make_gravity(const orr_scenario_gravity *g, const orr_mat3 *C, orr_moving *out,
                               orr_diag *diag);

#endif
