// SPDX-License-Identifier: GPL-3.0-or-later
// Kepler elements: from position and velocity, from three positions as the source does it, and back.
#ifndef ORR_ORBIT_FORCE_KEPLER_H
#define ORR_ORBIT_FORCE_KEPLER_H

#include "core/status.h"
#include "core/vec.h"

// Angles in [0, 2 pi), i in [0, pi]. u = argp + true anomaly is what near-circular orbits should be read by:
// argp and m are ill-defined as e goes to 0, u is not. In an equatorial orbit raan is 0 by convention, in a
// circular one argp is 0.
typedef struct orr_kepler {
    double a_m, e, i_rad, raan_rad, argp_rad, m_rad, u_rad;
} orr_kepler;

// Radial, along-track and cross-track axes as the columns of a matrix to the axes of r and v, which do not turn.
orr_mat3 orr_orbit_axes(orr_vec3 r_m, orr_vec3 v_mps);
// Osculating elements of (r, v) in any inertial axes; i and raan refer to those axes' equator (see
// orbit/elements/elements.h for the choice). ORR_E_NUMERIC for rectilinear, parabolic or hyperbolic motion.
orr_status orr_kepler_from_state(orr_vec3 r_m, orr_vec3 v_mps, double gm, orr_kepler *out);
// The inverse: position and velocity (m, m/s; axes of the elements) of elements with 0 <= e < 1; u_rad is not read.
void orr_kepler_to_state(const orr_kepler *k, double gm, orr_vec3 *r_m, orr_vec3 *v_mps);

// Elements at the middle one of three positions.
// Given:
//   r1_m, r2_m, r3_m  positions in inertial axes, one after the other within half a revolution, m
//   gm                m^3/s^2
// Returned:
//   out               elements
// Errors: ORR_E_NUMERIC when the positions do not span a plane, or are not one after the other within half a revolution.
// Notes: the plane goes through r1 and r3, r2 is projected onto it (the source's regularisation), then the standard
// formulas follow. Limits, measured on real orbits: the plane is good (i to 3.5e-6 deg at +-5 min), but two-body motion is
// assumed, so a is off by 1.8 to 2.3 km whatever the spacing (J2), e and argp accordingly; a centimetre of noise at +-5 min
// makes hundreds of metres in a. Elements from (r, v) of the smoothed orbit have none of these errors.
// Reference: Bogdanov 2015, section 6; Gibbs' problem.
orr_status orr_kepler_from_positions(orr_vec3 r1_m, orr_vec3 r2_m, orr_vec3 r3_m, double gm, orr_kepler *out);

// Eccentric anomaly of mean anomaly m, 0 <= e < 1, to rounding.
double orr_kepler_solve(double m_rad, double e);
// True anomaly of it, in (-pi, pi].
double orr_kepler_true_anomaly(double m_rad, double e);
// An angle in [0, 2 pi).
double orr_kepler_turn(double angle_rad);

#endif
