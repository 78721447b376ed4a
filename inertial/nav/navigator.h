// SPDX-License-Identifier: GPL-3.0-or-later
// Strapdown navigation on a run of readings from its start state alone: the reference navigator that measures
// readings, the classical multi-sample ones and the source's one-step ones.
#ifndef ORR_INERTIAL_NAV_NAVIGATOR_H
#define ORR_INERTIAL_NAV_NAVIGATOR_H

#include "inertial/readings/imu.h"

typedef enum orr_navigator_kind {
    // Polynomials through a group of increments, integrated by Runge-Kutta of order 4 in inertial axes with
    // sub-steps and
    // compensated sums. Groups end at the trajectory's knots.
    ORR_NAVIGATOR_REFERENCE,
    // Rotation vector and velocity increment of a group with coning and sculling terms of the polynomial
    // through its
    // increments (Miller 1983; Savage 1998), then one step in inertial axes.
    ORR_NAVIGATOR_MULTI_SAMPLE,
    ORR_NAVIGATOR_ONE_STEP, // Bogdanov 2015, eq. (10)-(14), in `frame`
} orr_navigator_kind;

#define ORR_NAVIGATOR_MAX_SAMPLES 5

typedef struct orr_navigator {
    orr_navigator_kind kind;
    int samples;         // of a group: 1..5 (reference and multi-sample)
    int substeps;        // of the reference per sample; 0: as many as step and turn ask for
    orr_nav_frame frame; // one-step
    bool project_mid;    // one-step: f and gravitation with the matrices of mid-step (18), else of t_j
    bool
        hold_vertical; // height and vertical velocity from the truth beside the readings, wherever there is one
    const orr_gravity *gravity;
} orr_navigator;

typedef struct orr_nav_state {
    size_t edge; // of the readings
    double t_s;
    orr_vec3 r_m, v_mps; // inertial axes, absolute
    orr_mat3 A_bi;       // body from inertial
} orr_nav_state;

// Navigates on a run of readings from its start state.
//   Given:    imu           readings and start state
//             nav           which navigator
//             visit         called with `user` at the start and after every group or step, in order; if it
//                           returns other than ORR_OK, that ends the run and is returned
//             user          for `visit`
//   Returned: diag          a sentence on what went wrong
//   Notes:    ORR_E_ARG (samples), ORR_E_UNSUPPORTED (a vertical channel that cannot be held), ORR_E_NUMERIC
//             (the solution left the Earth's surroundings).
orr_status orr_navigate(const orr_imu *imu, const orr_navigator *nav,
                        orr_status (*visit)(void *user, const orr_nav_state *state), void *user,
                        orr_diag *diag);

// The reference navigator from a given state to edge `to` (at most imu->n); nav->samples is 1..5, checked by
// an assertion.
void orr_navigate_from(const orr_imu *imu, const orr_navigator *nav, orr_nav_state *state, size_t to);

// Number of samples in the group that starts at sample j: `wanted` at most, shorter where a knot of a cubic
// trajectory would come inside (a knot within a sample counts as the nearer edge), and the groups between two
// knots as equal as they can be.
size_t orr_navigator_group(const orr_imu *imu, size_t j, int wanted);

// coefficient[d][i]: the polynomial sum_d c_d x^d, x in [0, 1], whose integrals over the `n` equal parts are
// the increments I_i, is c_d = sum_i coefficient[d][i] I_i (per length of the whole group). n is 1..5.
void orr_increment_polynomial(int n,
                              double coefficient[ORR_NAVIGATOR_MAX_SAMPLES][ORR_NAVIGATOR_MAX_SAMPLES]);

#endif
