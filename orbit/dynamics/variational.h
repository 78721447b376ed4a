// SPDX-License-Identifier: GPL-3.0-or-later
// How an orbit answers to small changes: the variational equations d_eta' = d_V, d_V' = G d_eta + B p over
// one step, for changes of the state, of an empirical acceleration in given axes, and of the coefficients of
// ECOM.
#ifndef ORR_ORBIT_DYNAMICS_VARIATIONAL_H
#define ORR_ORBIT_DYNAMICS_VARIATIONAL_H

#include "orbit/force/force.h"
#include "orbit/force/kepler.h"

enum {                     // columns of the partial derivatives
    ORR_PARTIAL_STATE = 0, // position and velocity at the step's begin
    ORR_PARTIAL_F0 = 6,    // empirical acceleration, m/s^2, in its axes
    ORR_PARTIAL_ECOM = 9,  // nm/s^2
    ORR_PARTIALS = 18,
};

// A step of the trajectory: states at its two ends, integration axes.
typedef struct orr_orbit_step {
    double t_s, h_s;
    orr_vec3 r0_m, v0_mps, r1_m, v1_mps;
} orr_orbit_step;

// Middle of a step by Hermite's cubic: metres off over 450 s of a GNSS satellite.
void orr_orbit_step_middle(const orr_orbit_step *s, orr_vec3 *r_m, orr_vec3 *v_mps);

// Partial derivatives of the state at the step's end by one classical Runge-Kutta step with the gradient (central and
// flattening) at begin, middle and end: over 150 s of a GNSS satellite they err by 4e-11 of the deviation, and by 1e-8
// over 450 s.
// Given:
//   force    the force; without its precise part the columns of ECOM are zero
//   sky      of the step
//   s        the step
//   axes     of the empirical acceleration at begin, middle and end; NULL: its columns are zero
// Returned:
//   partial  rows position then velocity, columns ORR_PARTIAL_*
void orr_variational_step(const orr_force *force, const orr_sky *sky, const orr_orbit_step *s,
                          const orr_mat3 axes[3], double partial[6][ORR_PARTIALS]);

#endif
