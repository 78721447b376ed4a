// SPDX-License-Identifier: GPL-3.0-or-later
// The satellite receiver among the auxiliary outputs, in a file of its own.
#ifndef ORR_INERTIAL_STUDY_AUXILIARY_PRIVATE_H
#define ORR_INERTIAL_STUDY_AUXILIARY_PRIVATE_H

#include "inertial/study/auxiliary.h"

typedef struct orr_aux_receiver_state {
    double walking[ORR_AUX_SATELLITES]; // of each number's range
    bool known[ORR_AUX_SATELLITES];
    double at_s[ORR_AUX_SATELLITES]; // when that was
} orr_aux_receiver_state;

// Position and velocity of a sample by weighted least squares of the satellites' errors.
//   Given:    plan          receiver and sky
//             m             true motion
//             k             number of the sample, for draws
//             state         of the ranges' processes
//   Returned: out           satellites, position, velocity, their errors and covariances
//             state         as it goes on
void orr_aux_receive(const orr_aux_plan *plan, const orr_motion *m, uint64_t k, orr_aux_receiver_state *state,
                     orr_aux_sample *out);

#endif
