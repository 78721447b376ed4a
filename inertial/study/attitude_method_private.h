// SPDX-License-Identifier: GPL-3.0-or-later
// A step of an attitude method over a group of increments, in extended precision.
#ifndef ORR_INERTIAL_STUDY_ATTITUDE_METHOD_PRIVATE_H
#define ORR_INERTIAL_STUDY_ATTITUDE_METHOD_PRIVATE_H

#include "inertial/study/attitude_method.h"
#include "inertial/study/extended_private.h"

#define ORR_METHOD_NODES 16 // of an iteration: Chebyshev's extrema over a group

// A method with what its steps need prepared.
typedef struct orr_method_plan {
    const orr_attitude_method *method;
    long double rate[ORR_METHOD_NODES][ORR_METHOD_MAX_SAMPLES]; // at node k, of a unit increment i, per group
    long double sum[ORR_METHOD_NODES][ORR_METHOD_NODES]; // integral up to node k of what is 1 at node i
} orr_method_plan;

// Prepares a method, which is borrowed.
void orr_method_prepare(const orr_attitude_method *method, orr_method_plan *plan);
// Carries attitude and velocity over one group.
//   Given:    plan          method
//             d             [N] increments of angle, body axes
//             dv            [N] increments of velocity, body axes; NULL: attitude alone
//             q             body from the axes of reference, before
//   Returned: q             after
//             dv_out        change of velocity in the axes of reference; NULL with dv
void orr_method_step(const orr_method_plan *plan, const orr_xvec *d, const orr_xvec *dv, orr_xquat *q,
                     orr_xvec *dv_out);

#endif
