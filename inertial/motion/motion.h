// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a body at one instant: the value that every trajectory gives and that sensors, navigators'
// truth and the satellites' receiver all start from, so that they agree. Frames and signs: docs/inertial.md.
#ifndef ORR_INERTIAL_MOTION_MOTION_H
#define ORR_INERTIAL_MOTION_MOTION_H

#include "core/earth.h"
#include "core/vec.h"

typedef struct orr_motion {
    orr_vec3 r_m;    // ecef
    orr_vec3 v_mps;  // ecef axes, relative to the turning Earth
    orr_vec3 a_mps2; // second derivative of r_m in ecef axes
    orr_quat q_be; // body from ecef: orr_mat3_from_quat(q_be) maps ecef components to body's; body is right,
                   // forward, up
    orr_vec3 w_radps;     // rate of the body relative to ecef, body axes
    orr_vec3 wdot_radps2; // its derivative in body axes
} orr_motion;

// Heading clockwise from true North in [0, 2 pi); pitch, nose up; roll, right wing down. psi of the source is
// -heading.
typedef struct orr_angles {
    double heading_rad, pitch_rad, roll_rad;
} orr_angles;

// L = R2(roll) R1(pitch) R3(-heading): body from enu (Bogdanov 2015, 2.2).
orr_mat3 orr_body_from_enu(orr_angles a);
// Inverse of the above. Where the nose points straight up or down (|pitch| = 90 deg within rounding), roll is
// taken 0.
orr_angles orr_angles_from_body_enu(const orr_mat3 *L);
// Heading, pitch and roll of a motion, against the ellipsoid's East, North, Up at its place.
orr_angles orr_motion_angles(const orr_motion *m);
// Its heading in degrees as a table with so many decimals may show it: in [0, 360) after rounding too.
double orr_heading_shown_deg(double heading_rad, int decimals);

// Velocity relative to the Earth in East, North, Up at the body.
orr_vec3 orr_motion_velocity_enu(const orr_motion *m);
// Second derivative of the position in the inertial frame, resolved in ecef axes.
orr_vec3 orr_motion_absolute_acceleration(const orr_motion *m);
// What ideal sensors feel, body axes: the absolute (inertial) angular rate, rad/s, and the specific force
// f = a - gravitation, m/s^2 (Bogdanov 2015, eq. (15)). gravitation: ecef axes, without the centrifugal part.
void orr_motion_sense(const orr_motion *m, orr_vec3 gravitation_mps2, orr_vec3 *rate_radps,
                      orr_vec3 *force_mps2);

// Angular rate of a curve of quaternions p(t), which need not be of unit length.
//   Given:    p             [4] w x y z of body from ecef, times any positive factor that may vary in time
//             d1, d2        [4] its first and second derivative, 1/s and 1/s^2
//   Returned: unit          p / |p|
//             w_radps       rate of the body relative to ecef, body axes, rad/s
//             wdot_radps2   its derivative in body axes, rad/s^2
void orr_rates_from_quat(const double p[4], const double d1[4], const double d2[4], orr_quat *unit,
                         orr_vec3 *w_radps, orr_vec3 *wdot_radps2);

// Eotvos term 2 u v_E cos(lat) + v_E^2/(N + h) + v_N^2/(M + h), m/s^2, positive up: what motion over the
// turning Earth takes off the weight. *round_mps2 is its part without u, that of the Earth's roundness.
double orr_motion_eotvos(const orr_motion *m, double *round_mps2);

#endif
