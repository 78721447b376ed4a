// SPDX-License-Identifier: GPL-3.0-or-later
// Numerical integration of one satellite's motion: Prince and Dormand's Runge-Kutta of order 8 (GSL's rk8pd),
// with steps bounded so that the truncation stays below a tenth of a micrometre an hour, parted at the borders of the
// penumbra, where the force has kinks.
#ifndef ORR_ORBIT_FORCE_INTEGRATE_H
#define ORR_ORBIT_FORCE_INTEGRATE_H

#include "orbit/force/force.h"

#define ORR_INTEGRATE_MAX_STEP_S 300.0
#define ORR_INTEGRATE_PENUMBRA_STEP_S 30.0
enum { ORR_INTEGRATE_BORDERS = 6 }; // of the penumbra that a step may meet

typedef struct orr_integrator orr_integrator; // one a thread

// Borrows force and sky, which must outlive it. ORR_E_MEMORY. Free with orr_integrator_free.
orr_status orr_integrator_init(const orr_force *force, const orr_sky *sky, orr_integrator **out,
                               orr_diag *diag);
// Frees an integrator; NULL is none.
void orr_integrator_free(orr_integrator *it);
// Goes on with another force (which must outlive it) and another longest step.
void orr_integrator_set(orr_integrator *it, const orr_force *force, double max_step_s);

// Moves a state along its orbit.
// Given:
//   it     integrator
//   t_s    time of the state, s since the sky's origin
//   h_s    by how much, s; either sign
// Given and returned:
//   r_m    position, integration axes, m
//   v_mps  velocity, m/s
// Errors: ORR_E_NUMERIC if the orbit becomes impossible (below 1000 km from the centre, or not finite).
orr_status orr_integrate(orr_integrator *it, double t_s, double h_s, orr_vec3 *r_m, orr_vec3 *v_mps);
// Where a step meets the borders of the penumbra, for callers that integrate something else beside.
// Given:
//   it      integrator; a force without sunlight has no borders
//   t_s     time of the state, s since the sky's origin
//   h_s     length of the step, s; either sign
//   r, v    state, integration axes, m and m/s
// Returned:
//   dt_s    ascending from t_s on (descending with a negative step), half a second from both ends at least
//   value   how many
size_t orr_integrate_borders(const orr_integrator *it, double t_s, double h_s, orr_vec3 r, orr_vec3 v,
                             double dt_s[ORR_INTEGRATE_BORDERS]);

#endif
