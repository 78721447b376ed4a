// SPDX-License-Identifier: GPL-3.0-or-later
// What bends an orbit: gravitation of Earth, Sun and Moon, and radiation pressure with the Earth's shadow:
// plain, or all that is known of an orbit to a nanometre per second squared.
#ifndef ORR_ORBIT_FORCE_FORCE_H
#define ORR_ORBIT_FORCE_FORCE_H

#include "orbit/force/ecom.h"
#include "orbit/force/gravity_field.h"
#include "orbit/force/shadow.h"
#include "orbit/force/sky.h"

typedef struct orr_force {
    orr_gravity_field earth;
    bool sun_moon;
    double srp_mps2; // along Sun-satellite at 1 au; 0 for none
    // All that is known: also the tides of the solid Earth (where the sky tells them), relativity
    // (Schwarzschild), the Earth's own radiation, and the nine coefficients of ECOM in the place of the plain
    // pressure.
    bool precise;
    double ecom_nmps2[ORR_ECOM_TERMS];
} orr_force;

// Acceleration in integration axes, m/s^2, of a satellite at r (same axes, m).
orr_vec3 orr_force_acceleration(const orr_force *f, const orr_sky_point *p, orr_vec3 r_m);
// The same for either kind of force; v_mps matters to a precise one alone.
orr_vec3 orr_force_of_state(const orr_force *f, const orr_sky_point *p, orr_vec3 r_m, orr_vec3 v_mps);

// (34): gradient of the central field, 3 mu/r^5 r r' - mu/r^3 E.
orr_mat3 orr_force_central_gradient(orr_vec3 r_m);
// The same with the Earth's flattening about the given axis (a unit vector, axes of r): 1e-5 of it is
// missing.
orr_mat3 orr_force_gradient(const orr_force *f, orr_vec3 axis, orr_vec3 r_m);

#endif
