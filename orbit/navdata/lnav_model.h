// SPDX-License-Identifier: GPL-3.0-or-later
// LNAV's Kepler model as a position with its partial derivatives, for fits: orr_broadcast_eval tells what a
// receiver computes, this tells how that moves with each parameter. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_LNAV_MODEL_H
#define ORR_ORBIT_NAVDATA_LNAV_MODEL_H

#include "ingest/rinex/rinex_nav.h"

// The parameters in the order of the derivatives. In near-circular orbits perigee, and with it omega and M0
// apart from their sum, is not defined; e cos omega, e sin omega and omega + M0 always are.
enum {
    ORR_LNAV_SQRT_A,
    ORR_LNAV_EX,     // e cos omega
    ORR_LNAV_EY,     // e sin omega
    ORR_LNAV_LAMBDA, // omega + M0
    ORR_LNAV_I0,
    ORR_LNAV_OMEGA0,
    ORR_LNAV_OMEGA_DOT,
    ORR_LNAV_DELTA_N,
    ORR_LNAV_IDOT,
    ORR_LNAV_CRC,
    ORR_LNAV_CRS,
    ORR_LNAV_CUC,
    ORR_LNAV_CUS,
    ORR_LNAV_CIC,
    ORR_LNAV_CIS,
    ORR_LNAV_N
};

// Position (ecef, m) tk_s after toe by IS-GPS-200N table 20-IV, the same as orr_broadcast_eval's to rounding,
// for 0 <= e < 1. d[j] is the derivative with respect to parameter j (metres per its SI unit); d may be NULL.
orr_vec3 orr_lnav_position(const orr_nav_kepler *k, double tk_s, orr_vec3 d[ORR_LNAV_N]);

// Derivatives with respect to e, omega and M0 in the places of EX, EY and LAMBDA: what is transmitted.
void orr_lnav_by_elements(const orr_nav_kepler *k, orr_vec3 d[ORR_LNAV_N]);

// Secular rates that the Earth's flattening causes.
// Given:
//   a_m, e, i_rad    semi-major axis, eccentricity, inclination
// Returned:
//   omega_dot_radps  rate of the node
//   delta_n_radps    rate of the mean argument of latitude beyond sqrt(mu/a^3) (the model keeps omega constant)
// Notes: fits start from these and stay near them where their window does not determine the rates.
// Reference: Kaula 1966, 3.74.
void orr_lnav_secular(double a_m, double e, double i_rad, double *omega_dot_radps, double *delta_n_radps);

#endif
