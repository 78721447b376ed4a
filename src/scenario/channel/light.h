// SPDX-License-Identifier: GPL-3.0-or-later
// The way of light from a satellite to an antenna: light time, the Earth's rotation meanwhile, the range and its rate.
#ifndef ORR_SCENARIO_CHANNEL_LIGHT_H
#define ORR_SCENARIO_CHANNEL_LIGHT_H

#include "core/vec.h"

typedef struct orr_light {
    double tau_s;   // from emission to reception
    double range_m; // between the antenna and the satellite's centre of mass, in inertial space
    double range_rate_mps;
    double distance_m; // of range: between both points in the Earth's axes, without its rotation
    double distance_rate_mps;
    orr_vec3 u;         // unit vector from the antenna to the satellite, ecef at reception
    orr_vec3 u_rate_ps; // its rate
    orr_vec3 sat_m;     // the satellite at emission, turned into the Earth's axes at reception
    orr_vec3 sat_v_mps; // its inertial velocity in these axes
} orr_light;

// Solves |r_A(t) - R3(w tau) r_S(t - tau)| = c tau from an estimate.
// Given:
//   tau_s     estimate of tau, to a microsecond: |r_A - r_S(t)| / c, so that nothing is remembered from epoch to epoch, or better
//   sat_m     satellite at t - tau_s, ecef of then
//   vel_mps   its velocity
//   r_m       antenna at t, ecef
//   v_mps     its velocity
// Returned:
//   out       range, its rate, and where the satellite was
// Notes: one step of Newton's method leaves the square of the estimate's error times 0.6 m/s^2: 3e-13 m of a microsecond. The rate
// is exact: with s the satellite in the axes of reception, R v_S its velocity in them and w the Earth's rate,
// (u.(R v_S - v_A)) / (1 + u.(R v_S + w x s) / c).
void orr_light_close(double tau_s, orr_vec3 sat_m, orr_vec3 vel_mps, orr_vec3 r_m, orr_vec3 v_mps,
                     orr_light *out);

// The relativistic delay of the signal in the Earth's field, m: 2 GM/c^2 ln((r_S + r_A + rho) / (r_S + r_A - rho))
// (IERS Conventions 2010, eq. (11.17), gamma = 1).
double orr_light_shapiro_m(orr_vec3 antenna_m, orr_vec3 sat_m, double range_m);

#endif
