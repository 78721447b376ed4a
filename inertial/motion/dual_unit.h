// SPDX-License-Identifier: GPL-3.0-or-later
// A second unit on the same body: its motion follows from the first's by a lever arm and a fixed turn of axes
// (Bogdanov 2015, section 2.4). Gravity is then felt at its own place, which matters: 309 m after an hour
// otherwise.
#ifndef ORR_INERTIAL_MOTION_DUAL_UNIT_H
#define ORR_INERTIAL_MOTION_DUAL_UNIT_H

#include "inertial/motion/trajectory.h"

typedef struct orr_mounting {
    orr_vec3 arm_m; // from the first unit, in its body axes (right, forward, up)
    orr_mat3 C_21;  // axes of the second unit from those of the first
} orr_mounting;

// The trajectory of the second unit. `first` is borrowed and has to outlive it. Errors: ORR_E_ARG (no
// rotation, arm longer than 1 km), ORR_E_MEMORY.
orr_status orr_trajectory_mounted(const orr_trajectory *first, const orr_mounting *mounting,
                                  orr_trajectory *out, orr_diag *diag);

#endif
