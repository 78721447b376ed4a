// SPDX-License-Identifier: GPL-3.0-or-later
// The null test: navigating on ideal readings from the start state alone must return the trajectory
// (Bogdanov 2015, section 2.5). What is left tells how well generator and navigator suit each other.
#ifndef ORR_INERTIAL_NAV_NULL_TEST_H
#define ORR_INERTIAL_NAV_NULL_TEST_H

#include "inertial/nav/navigator.h"

typedef struct orr_null_report {
    double duration_s;
    size_t compared; // edges where truth was there to compare with
    double max_3d_m, max_horizontal_m, max_vertical_m, final_3d_m;
    double max_xi1_m; // along axis 1 of the inertial frame, as the source's Figs 1-2
    double max_velocity_mps, max_attitude_rad;
    bool replayed;      // readings of a closed loop, navigated by the navigator they were matched to
    bool bit_identical; // then: every position has the very bits that the generator carried
} orr_null_report;

// Difference (navigated - true) at one instant.
typedef struct orr_null_point {
    double t_s;
    orr_vec3 dr_m, dv_mps; // inertial axes
    double horizontal_m, vertical_m;
    double attitude_rad; // angle between the two attitudes
} orr_null_point;

// Navigates and compares with the truth beside the readings.
//   Given:    imu           readings with their truth
//             nav           which navigator; its gravity is that of the readings
//             point         called with `user` at every compared edge; may be NULL. Other than ORR_OK ends the
//                           test and is returned
//             user          for `point`
//   Returned: out           largest and last differences
//   Notes:    Errors: those of orr_navigate.
//   Reference: Bogdanov 2015, section 2.5.
orr_status orr_null_test(const orr_imu *imu, const orr_navigator *nav,
                         orr_status (*point)(void *user, const orr_null_point *p), void *user,
                         orr_null_report *out, orr_diag *diag);

#endif
