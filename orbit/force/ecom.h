// SPDX-License-Identifier: GPL-3.0-or-later
// The empirical model of radiation pressure that analysis centres use (ECOM: Beutler et al. 1994; its second
// edition: Arnold et al. 2015): nine coefficients a satellite in axes that follow the Sun.
#ifndef ORR_ORBIT_FORCE_ECOM_H
#define ORR_ORBIT_FORCE_ECOM_H

#include "core/vec.h"

// D points to the Sun, Y along the panels' axis, B completes them: for satellites that yaw to face the Sun Y is across D and the
// radius. Geostationary ones keep their panels' axis along the normal of the orbit; theirs is the normal's part across D, and
// presses 20 to 30 nm/s^2, because what panels that the Sun meets aslant throw back leaves the Sun's direction.
// u is the argument of latitude from the
// Sun's projection onto the orbit. In this order: D0, Y0, B0, B cos u, B sin u, D cos 2u, D sin 2u, D cos 4u,
// D sin 4u.
#define ORR_ECOM_TERMS 9

// What a prior knows of them, nm/s^2: D0 is that of the plain pressure on satellites of navigation.
#define ORR_ECOM_D0_NMPS2 (-100.0)
// Its sigmas for an orbit, by an inertial state.
const double *orr_ecom_sigma_nmps2(orr_vec3 r_m, orr_vec3 v_mps);

// Acceleration (m/s^2) of each coefficient of 1 nm/s^2 at 1 au, in the axes of r, v and the Sun. Terms of D
// fade with the sunlight in the Earth's penumbra and are nothing in the umbra.
void orr_ecom_basis(orr_vec3 r_m, orr_vec3 v_mps, orr_vec3 sun_m, orr_vec3 basis[ORR_ECOM_TERMS]);

#endif
