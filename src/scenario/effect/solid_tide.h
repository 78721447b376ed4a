// SPDX-License-Identifier: GPL-3.0-or-later
// What Sun and Moon, and the wandering pole, do to the ground below an antenna.
#ifndef ORR_SCENARIO_EFFECT_SOLID_TIDE_H
#define ORR_SCENARIO_EFFECT_SOLID_TIDE_H

#include "core/astro.h"

// Displacement by the solid Earth's tide, ecef, m: the conventional "tide free" position plus this is where the ground is, the permanent
// part included.
// Given:
//   r_m      station, ecef
//   sun_m    the Sun, ecef
//   moon_m   the Moon, ecef
//   ut_h     hours of UT1's day; UTC does
//   century  Julian centuries of TT since J2000
// Notes: steps 1 and 2, nominal Love numbers with their dependence on latitude, frequency and phase.
// Reference: IERS Conventions 2010, 7.1.1, eqs. (7.5) to (7.13), tables 7.2, 7.3a and 7.3b.
orr_vec3 orr_solid_tide_m(orr_vec3 r_m, orr_vec3 sun_m, orr_vec3 moon_m, double ut_h, double century);

// Displacement by the pole tide, ecef, m.
// Given:
//   r_m      station, ecef
//   eop      the pole
//   secular  the pole that it wanders about (orr_eop_at without a series)
// Reference: IERS Conventions 2010, updated 2018, 7.1.4, eqs. (7.24) and (7.26).
orr_vec3 orr_pole_tide_m(orr_vec3 r_m, const orr_eop *eop, const orr_eop *secular);

#endif
