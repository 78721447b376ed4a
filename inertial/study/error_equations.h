// SPDX-License-Identifier: GPL-3.0-or-later
// Linear error equations of inertial navigation in three formulations, exact to first order on the ellipsoid and in any field
// of gravity, so that what separates them from the navigator itself is of second order alone (Bogdanov 2015, section 3).
//
// Errors are navigated minus true. D is geographic (East, North, Up) from ecef, C geographic from body; what the navigator
// has is marked '. A small turn a of axes or of a body takes a vector v into v + a x v. All vectors are resolved in the true
// geographic axes.
//
//   phi      position (longitude, latitude, height), velocity D'v' - Dv, each in its own axes, and the attitude against the
//            geographic axes, C'C^T = 1 + [phi x].
//   psi      the vectors D(r' - r) and D(v' - v), velocity relative to the Earth, and the attitude against the Earth,
//            psi = phi + theta, where theta turns the true geographic axes into the computed ones.
//   dynamic  the source's school: what the navigator knows in the axes of its own instruments. Position and absolute velocity as
//            components in the body's axes, A'r' - Ar and A'w' - Aw (A is body from inertial), are the dynamic parts; the
//            turn of the instruments' axes, beta = psi, adds the kinematic parts beta x r and beta x w to the full errors.
//            On a round Earth the dynamic parts do not feel the attitude at all.
#ifndef ORR_INERTIAL_STUDY_ERROR_EQUATIONS_H
#define ORR_INERTIAL_STUDY_ERROR_EQUATIONS_H

#include "inertial/gravity/gravity.h"

typedef enum orr_error_model {
    ORR_ERROR_PHI,
    ORR_ERROR_PSI,
    ORR_ERROR_DYNAMIC,
    ORR_ERROR_MODELS
} orr_error_model;

// What the three vectors are depends on the model. phi's position is longitude and latitude in radians, height in metres.
typedef struct orr_error_state {
    orr_vec3 position, velocity, attitude;
} orr_error_state;

// The true motion at an instant, as the equations need it.
typedef struct orr_error_point {
    double t_s, lat_rad, height_m, meridian_m, normal_m; // radii of curvature
    orr_mat3 D;                                          // geographic from ecef
    orr_mat3 C;                                          // geographic from body
    orr_vec3 r, v, w,
        f; // place from the Earth's centre, velocity relative to the Earth, absolute, specific force; geographic axes
    orr_vec3 earth, transport; // rates of the Earth, and of the geographic axes over it
    orr_vec3 gravity;          // plumb, with the centrifugal part
    orr_mat3 gradient;         // of gravitation, geographic axes
} orr_error_point;

// The point of a trajectory at t_s.
//   Given:    tr        the trajectory, evaluated at
//             gravity   field; NULL: normal gravity
//             t_s       seconds after its t0
//             round     the gradient of a round Earth, -g/R along the horizon and 2 g/R upwards, instead of the field's own
//   Returned: out       the point; not within 1 km of a pole
void orr_error_point_at(const orr_trajectory *tr, const orr_gravity *gravity, double t_s, bool round,
                        orr_error_point *out);

// Rates of change of the errors.
//   Given:    m         which formulation
//             p         the true motion
//             x         the errors
//             gyro_radps, accel_mps2   errors of the sensors, body axes
//   Returned: the derivative of x
//   Reference: Titterton and Weston 2004, 12.3 (phi); Benson 1975, IEEE Trans. AES-11, 447 (psi); Bogdanov 2015, section 3, and Golovan,
//              Parusnikov 2010 (dynamic and kinematic parts).
orr_error_state orr_error_rate(orr_error_model m, const orr_error_point *p, const orr_error_state *x,
                               orr_vec3 gyro_radps, orr_vec3 accel_mps2);

// The same errors in another formulation, exact to first order.
//   Given:    from, to  formulations
//             p         the true motion
//             x         errors in `from`
//   Returned: in `to`
orr_error_state orr_error_convert(orr_error_model from, orr_error_model to, const orr_error_point *p,
                                  const orr_error_state *x);

// Errors of height and vertical velocity taken out, as a navigator does that takes both from elsewhere.
orr_error_state orr_error_hold_vertical(orr_error_model m, const orr_error_point *p,
                                        const orr_error_state *x);

// phi's position in metres East, North, Up; of other models it is that already.
orr_vec3 orr_error_metres(orr_error_model m, const orr_error_point *p, const orr_error_state *x);

// The errors of a navigator against the truth, in the quantities of a model, without any linearisation.
//   Given:    m               which formulation
//             p               the true motion
//             r_m, w_mps      navigated inertial position and absolute velocity, inertial axes
//             A_bi            navigated attitude, body from inertial
//   Returned: the errors
orr_error_state orr_error_direct(orr_error_model m, const orr_error_point *p, orr_vec3 r_m, orr_vec3 w_mps,
                                 const orr_mat3 *A_bi);

// theta of a position error (longitude, latitude in radians): the turn of the computed geographic axes, geographic axes.
orr_vec3 orr_error_turn_of_axes(const orr_error_point *p, orr_vec3 phi_position);

#endif
