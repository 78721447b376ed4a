// SPDX-License-Identifier: GPL-3.0-or-later
// The way of light from a satellite to an antenna: light time, the Earth's rotation meanwhile, the range and its rate.
#ifndef ORR_SCENARIO_CHANNEL_LIGHT_H
#define ORR_SCENARIO_CHANNEL_LIGHT_H

#include "orbit/ephemeris/ephemeris.h"

typedef struct orr_light {
    double tau_s;   // from emission to reception
    double range_m; // between the antenna and the satellite's centre of mass, in inertial space
    double range_rate_mps;
    double distance_m; // of range: between both points in the Earth's axes, without its rotation
    double distance_rate_mps;
    orr_vec3 u;             // unit vector from the antenna to the satellite, ecef at reception
    orr_vec3 sat_m;         // the satellite at emission, turned into the Earth's axes at reception
    orr_vec3 sat_v_mps;     // its inertial velocity in these axes
    orr_sat_state emission; // as the product has it at emission, in the axes of then
} orr_light;

// Solves |r_A(t) - R3(w tau) r_S(t - tau)| = c tau from tau = |r_A - r_S(t)| / c, so that nothing is remembered from epoch to
// epoch.
// Given:
//   e          orbits
//   t          instant of reception
//   reception  the satellite at t, as the product has it
//   r_m        antenna at t, ecef
//   v_mps      its velocity, ecef
// Returned:
//   out        range, its rate, and where the satellite was
// Errors: as orr_ephemeris_eval, at emission.
// Notes: three steps leave 1e-16 s. The rate is exact: with s the satellite in the axes of reception, R v_S its velocity in them
// and w the Earth's rate, (u.(R v_S - v_A)) / (1 + u.(R v_S + w x s) / c).
orr_status orr_light_from(const orr_ephemeris *e, orr_time t, const orr_sat_state *reception, orr_vec3 r_m,
                          orr_vec3 v_mps, orr_light *out);

// The relativistic delay of the signal in the Earth's field, m: 2 GM/c^2 ln((r_S + r_A + rho) / (r_S + r_A - rho))
// (IERS Conventions 2010, eq. (11.17), gamma = 1).
double orr_light_shapiro_m(orr_vec3 antenna_m, orr_vec3 sat_m, double range_m);

#endif
