// SPDX-License-Identifier: GPL-3.0-or-later
// Linear error equations tested the right way: their solution along a true trajectory against the direct difference between that
// trajectory and a navigator on readings with errors, in the quantities that each formulation propagates.
#ifndef ORR_INERTIAL_STUDY_ERROR_STUDY_H
#define ORR_INERTIAL_STUDY_ERROR_STUDY_H

#include "inertial/nav/navigator.h"
#include "inertial/study/error_equations.h"

typedef enum orr_error_method { ORR_ERROR_EULER, ORR_ERROR_MIDPOINT, ORR_ERROR_RUNGE_KUTTA } orr_error_method;

// A flight, its readings and what is wrong with them.
typedef struct orr_error_flight {
    const orr_trajectory *tr;
    const orr_gravity *gravity;
    const orr_imu *imu;                              // ideal and measured increments, truth at every reading
    orr_vec3 position_m, velocity_mps, attitude_rad; // errors at the start, as phi has them, East, North, Up
    bool hold_vertical;                              // height and vertical velocity are the true ones
    bool round;                                      // gradient of a round Earth in the equations
    size_t every;                                    // readings from one comparison to the next
} orr_error_flight;

// How many comparisons a flight has: at readings 0, every, 2 every, ...
size_t orr_error_comparisons(const orr_error_flight *f);

// The solution of linear equations.
//   Given:    f         the flight; all of its errors, at size 1
//             model     formulation
//             method    of integration
//             step      readings a step; divides f->every
//   Returned: out       [orr_error_comparisons(f)] errors
//   Notes:    Errors of sensors are steady within a step, at their mean. ORR_E_ARG (step), ORR_E_UNSUPPORTED within 1 km of a pole.
orr_status orr_error_solve(const orr_error_flight *f, orr_error_model model, orr_error_method method,
                           size_t step, orr_error_state *out, orr_diag *diag);

// The direct difference: the reference navigator on readings with so much of the errors, from a start with so much of its errors.
//   Given:    f         the flight
//             size      factor of all errors
//   Returned: out       [ORR_ERROR_MODELS][orr_error_comparisons(f)] errors in the quantities of each formulation
//   Notes:    Those of orr_navigate; ORR_E_ARG where a group of readings does not end at a comparison; ORR_E_MEMORY.
orr_status orr_error_differ(const orr_error_flight *f, double size,
                            orr_error_state *const out[ORR_ERROR_MODELS], orr_diag *diag);

// How long a solution stands for the difference: seconds until the deviation is above a tenth of the greatest norm so far, of position,
// velocity and attitude apart. The whole time where it never is.
typedef struct orr_error_hold {
    double position_s, velocity_s, attitude_s;
    double position, velocity, attitude; // greatest deviation over the greatest norm
} orr_error_hold;
// Compares a solution with a difference.
//   Given:    f         the flight
//             model     formulation of the solution
//             linear    [orr_error_comparisons(f)] its solution at size 1
//             size      factor of it
//             of        formulation of the difference; another one than `model` is the usual mistake
//             direct    [orr_error_comparisons(f)] the difference
//   Returned: out       times
void orr_error_compare(const orr_error_flight *f, orr_error_model model, const orr_error_state *linear,
                       double size, orr_error_model of, const orr_error_state *direct, orr_error_hold *out);

#endif
