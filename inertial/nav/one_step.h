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

// Starts at t_s from inertial position and velocity and the attitude.
void orr_one_step_start(orr_one_step *s, orr_nav_frame frame, bool project_mid, double dt_s,
                        const orr_gravity *gravity, double t_s, orr_vec3 r_m, orr_vec3 v_mps, orr_quat q_bi);
void orr_one_step_advance(orr_one_step *s, orr_vec3 dtheta_rad, orr_vec3 dv_mps);
// Absolute velocity in inertial axes.
orr_vec3 orr_one_step_velocity(const orr_one_step *s);
// Holds the vertical channel: height and vertical velocity are taken from a reference (inertial position and
// velocity).
void orr_one_step_hold_vertical(orr_one_step *s, orr_vec3 reference_r_m, orr_vec3 reference_v_mps);

// Approach 1 on the truth of `imu` (r_m, q_be, mode set): fills dtheta, dv, the start state and, in a closed
// loop, carried_r_m. Bogdanov 2015, eq. (2), (10)-(14), (18). Errors: ORR_E_UNSUPPORTED near a pole in the
// geographic frame.
orr_status orr_one_step_generate(orr_imu *imu, const orr_gravity *gravity, orr_diag *diag);

#endif
