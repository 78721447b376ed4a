// SPDX-License-Identifier: GPL-3.0-or-later
// The Kepler model of navigation messages as a position with its partial derivatives, for fits: orr_broadcast_eval tells
// what a receiver computes, this tells how that moves with each parameter. Private to the room.
#ifndef ORR_ORBIT_NAVDATA_KEPLER_MODEL_H
#define ORR_ORBIT_NAVDATA_KEPLER_MODEL_H

#include "ingest/rinex/rinex_nav.h"

// The parameters in the order of the derivatives. In near-circular orbits perigee, and with it omega and M0
// apart from their sum, is not defined; e cos omega, e sin omega and omega + M0 always are.
enum {
    ORR_KEPLER_SQRT_A,
    ORR_KEPLER_EX,     // e cos omega
    ORR_KEPLER_EY,     // e sin omega
    ORR_KEPLER_LAMBDA, // omega + M0
    ORR_KEPLER_I0,
    ORR_KEPLER_OMEGA0,
    ORR_KEPLER_OMEGA_DOT,
    ORR_KEPLER_DELTA_N,
    ORR_KEPLER_IDOT,
    ORR_KEPLER_CRC,
    ORR_KEPLER_CRS,
    ORR_KEPLER_CUC,
    ORR_KEPLER_CUS,
    ORR_KEPLER_CIC,
    ORR_KEPLER_CIS,
    ORR_KEPLER_A_DOT, // of CNAV and its kin alone
    ORR_KEPLER_N_DOT, // rate of delta n
    ORR_KEPLER_N
};

// What a system's document prescribes to compute with.
typedef struct orr_kepler_axes {
    double gm;         // m^3/s^2
    double earth_rate; // rad/s: the node's longitude is counted from the week's begin
    double turn;       // rad/s: of the axes of the positions against inertial ones; 0 in those of D2
} orr_kepler_axes;
// The axes of a message; D2's are ecef of toe, which do not turn, tilted by -5 deg (orr_kepler_tilted).
orr_kepler_axes orr_kepler_axes_of(orr_sat sat, uint8_t message);
// An ecef position tk_s after toe in the axes in which D2 has its elements (BDS-SIS-ICD-B1I 3.0, table 5-12).
orr_vec3 orr_kepler_tilted(const orr_kepler_axes *x, double tk_s, orr_vec3 pos_m);

// Position tk_s after toe, m, by IS-GPS-200N tables 20-IV and 30-II, the same as orr_broadcast_eval's to rounding, for
// 0 <= e < 1. d[j] is the derivative with respect to parameter j (metres per its SI unit); d may be NULL.
orr_vec3 orr_kepler_position(const orr_kepler_axes *x, const orr_nav_kepler *k, double tk_s,
                             orr_vec3 d[ORR_KEPLER_N]);

// Derivatives with respect to e, omega and M0 in the places of EX, EY and LAMBDA: what is transmitted.
void orr_kepler_by_elements(const orr_nav_kepler *k, orr_vec3 d[ORR_KEPLER_N]);

// Secular rates that the Earth's flattening causes.
// Given:
//   a_m, e, i_rad    semi-major axis, eccentricity, inclination
// Returned:
//   omega_dot_radps  rate of the node
//   delta_n_radps    rate of the mean argument of latitude beyond sqrt(mu/a^3) (the model keeps omega constant)
// Notes: fits start from these and stay near them where their window does not determine the rates.
// Reference: Kaula 1966, 3.74.
void orr_kepler_secular(double a_m, double e, double i_rad, double *omega_dot_radps, double *delta_n_radps);

#endif
