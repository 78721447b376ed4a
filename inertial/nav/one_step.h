// SPDX-License-Identifier: GPL-3.0-or-later
// The one-step navigator of the source, (10)-(14), in its three frames, and approach 1, which is the same
// step solved for the reading. Both live here because approach 1 in a closed loop carries this very state:
// replay is then bit-exact.
#ifndef ORR_INERTIAL_NAV_ONE_STEP_H
#define ORR_INERTIAL_NAV_ONE_STEP_H

#include "inertial/readings/imu.h"

// State in between steps. The velocity is absolute and belongs, as the source has it for stability, to the
// end of the last step; the position follows by r += v dt with that new velocity.
typedef struct orr_one_step {
    orr_nav_frame frame;
    bool project_mid;
    double dt_s;
    const orr_gravity *gravity;
    double t_s;       // since t0
    orr_vec3 r_m;     // inertial axes (in the geographic frame made from the two below)
    orr_vec3 r_low_m; // what r_m lost to rounding (compensated sum)
    orr_vec3 v_mps;   // in axes of `frame`
    orr_mat3 A_zi;    // body from inertial
    orr_mat3 A_xi;    // geographic from inertial (geographic frame only)
    double height_m;  // (geographic frame only)
} orr_one_step;

// Starts the stepper.
//   Given:    frame        the frame that the velocity is integrated in
//             project_mid  forces are projected with the attitude in the middle of the step, not at its start
//             dt_s         step
//             gravity      field; NULL: normal gravity. Borrowed.
//             t_s          time since t0 of the readings
//             r_m, v_mps   inertial position and absolute velocity, in inertial axes
//             q_bi         body from inertial axes
//   Returned: s            the state, at t_s
//   Reference: Bogdanov 2015, eq. (11)-(14).
void orr_one_step_start(orr_one_step *s, orr_nav_frame frame, bool project_mid, double dt_s,
                        const orr_gravity *gravity, double t_s, orr_vec3 r_m, orr_vec3 v_mps, orr_quat q_bi);
// One step by a reading: the increments of angle and of velocity over dt_s, body axes.
void orr_one_step_advance(orr_one_step *s, orr_vec3 dtheta_rad, orr_vec3 dv_mps);
// Absolute velocity in inertial axes.
orr_vec3 orr_one_step_velocity(const orr_one_step *s);
// Takes height and vertical velocity from a reference.
//   Given:    reference_r_m, reference_v_mps   inertial position and absolute velocity
//   Returned: r_m, v_mps                       likewise, moved along the ellipsoid's vertical alone
void orr_hold_vertical(orr_vec3 reference_r_m, orr_vec3 reference_v_mps, orr_vec3 *r_m, orr_vec3 *v_mps);
// Holds the vertical channel of a step's state on a reference, likewise.
void orr_one_step_hold_vertical(orr_one_step *s, orr_vec3 reference_r_m, orr_vec3 reference_v_mps);

// Approach 1 on the truth of `imu` (r_m, q_be, mode set): fills dtheta, dv, the start state and, in a closed
// loop, carried_r_m. Bogdanov 2015, eq. (2), (10)-(14), (18). Errors: ORR_E_UNSUPPORTED near a pole in the
// geographic frame.
orr_status orr_one_step_generate(orr_imu *imu, const orr_gravity *gravity, orr_diag *diag);

#endif
