// SPDX-License-Identifier: GPL-3.0-or-later
// Slow changes of the Earth's gravitation, of degree 2: the solid Earth's tide, and the figure axis with the
// pole.
#ifndef ORR_ORBIT_FORCE_TIDES_H
#define ORR_ORBIT_FORCE_TIDES_H

#include "core/time.h"
#include "core/vec.h"

// Slow changes of the Earth's coefficients of degree 2.
// Given:
//   t               instant
//   sun_m, moon_m   places in ecef, m
//   xp_rad, yp_rad  pole
// Returned:
//   change          [5] changes of the unnormalised C20, C21, S21, C22, S22 of EGM96 (tide-free)
// Notes: the solid tide by Sun and Moon with Love numbers of an anelastic Earth (6.2.1, step 1, degree 2), the pole tide
// (6.4), the figure axis of the mean pole (6.1) and C20's change since 1986.
// Reference: IERS Conventions 2010, chapter 6.
void orr_tides_gravitation(orr_time t, orr_vec3 sun_m, orr_vec3 moon_m, double xp_rad, double yp_rad,
                           double change[5]);

#endif
