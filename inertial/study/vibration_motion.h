// SPDX-License-Identifier: GPL-3.0-or-later
// Conical vibration of a body that stands on the Earth: the motion itself, in closed form with its integrals, and as a
// trajectory that every other part of the program can ask.
#ifndef ORR_INERTIAL_STUDY_VIBRATION_MOTION_H
#define ORR_INERTIAL_STUDY_VIBRATION_MOTION_H

#include "inertial/motion/trajectory.h"

// A_zx = R3(-w (t - t0)) R1(beta) R3(w (t - t0)): the body's axis 3 moves round a cone (Bogdanov 2015, eq. (28)).
typedef struct orr_vibration {
    double frequency_hz;  // f_v, w = 2 pi f_v
    double amplitude_rad; // beta
    double start_s;       // t0 of the phase, in seconds of the trajectory
} orr_vibration;

// What an attitude algorithm drifts by that sees the mean rate alone, rad/s, counter-clockwise: -pi f_v beta^2; exactly
// w (cos beta - 1).
// Reference: Bogdanov 2015, eq. (30), (31).
double orr_vibration_drift(const orr_vibration *v);

// Body from its axes at rest, at t_s.
orr_quat orr_vibration_attitude(const orr_vibration *v, double t_s);
// The body's rate relative to its axes at rest, and the derivative of that.
//   Given:    v             vibration
//             t_s           time
//   Returned: rate_radps    body axes, rad/s
//             change_radps2 body axes, rad/s^2
//   Reference: Bogdanov 2015, eq. (29).
void orr_vibration_rate(const orr_vibration *v, double t_s, orr_vec3 *rate_radps, orr_vec3 *change_radps2);

// A body at rest on the Earth, vibrating.
//   Given:    t0              instant of its second 0
//             begin_s, end_s  time that it may be evaluated in
//             place           where it stands
//             attitude        of the axes at rest
//             v               vibration; amplitude within (-pi, pi), frequency not negative
//   Returned: out             the trajectory, without knots; free with orr_trajectory_free
//   Notes:    The unit is the cone's apex: its place does not move. ORR_E_ARG, ORR_E_MEMORY.
orr_status orr_trajectory_vibrating(orr_time t0, double begin_s, double end_s, orr_geodetic place,
                                    orr_angles attitude, const orr_vibration *v, orr_trajectory *out,
                                    orr_diag *diag);

#endif
