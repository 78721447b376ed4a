// SPDX-License-Identifier: GPL-3.0-or-later
// How a navigation satellite stands in space, and where its antenna is: nominal yaw steering and phase-centre
// offsets.
#ifndef ORR_ORBIT_SPACECRAFT_ATTITUDE_H
#define ORR_ORBIT_SPACECRAFT_ATTITUDE_H

#include "ingest/tables/antex.h"
#include "orbit/force/force.h"

typedef struct orr_attitude {
    orr_mat3 body; // ecef (or whatever axes r and the Sun were given in) to body: X towards the Sun's side, Y
                   // along the panels' axis, Z to the Earth's centre (IGS convention)
    double beta_rad;       // elevation of the Sun above the orbital plane
    double yaw_rad;        // from the along-track direction (of the inertial motion) to X, about Z
    double yaw_rate_radps; // of the nominal law
    bool fast_turn;  // near noon or midnight, where the nominal law asks for a turn that satellites cannot
                     // follow (below)
    double sunlight; // 1 in the Sun, 0 in umbra
} orr_attitude;

// The Sun's place in ecef, metres, with the Earth's rotation of a product (orr_ephemeris_eop), or, NULL, the
// secular pole and UT1 by the leap seconds: a second of UT1 turns it by 0.004 deg.
orr_vec3 orr_attitude_sun(orr_time t, const orr_eop_series *eop);

// Nominal yaw steering at r moving with v_inertial (velocity in the inertial sense resolved in the same axes:
// for ecef v + u x r) under a Sun at sun_m. Real satellites depart from it in eclipses and around noon and
// midnight: flagged; orr_attitude_by_law follows those of several blocks. They turn by 0.10 deg/s (GPS IIA; Kouba 2009) to 0.25 (GLONASS-M); the
// flag is set where the law's fastest turn, n / tan(beta), is above 0.10 deg/s, for the half hour before and
// after noon or midnight that 180 deg take then. ORR_E_NUMERIC where Sun, satellite and Earth stand in line.
orr_status orr_attitude_nominal(orr_vec3 r_m, orr_vec3 v_inertial_mps, orr_vec3 sun_m, orr_attitude *out);
// Orbit-normal mode: X along the track whatever the Sun does, yaw 0, never a fast turn. Geostationary
// satellites of BeiDou and QZSS fly so (Montenbruck et al. 2015, Adv. Space Res. 56:1015).
void orr_attitude_orbit_normal(orr_vec3 r_m, orr_vec3 v_inertial_mps, orr_vec3 sun_m, orr_attitude *out);

// Two carriers whose ionosphere-free combination a system's precise clocks belong to, as ANTEX names them.
// What GLONASS' channels have in common is the ratio of their carriers, 9/7, and no more is needed.
typedef struct orr_antenna_pair {
    char code1[4], code2[4]; // "G01", "G02"
    double f1_hz, f2_hz;
} orr_antenna_pair;
// GPS and QZSS L1/L2, GLONASS G1/G2, Galileo E1/E5a, BeiDou B1I/B3I, NavIC L5/S; NULL for other systems.
const orr_antenna_pair *orr_antenna_pair_of(char system);

// Offset of the phase centre from the centre of mass, in body axes.
// Given:
//   antenna   antenna of the satellite
//   code1     ANTEX frequency code, for example "G01"
//   f1_hz     its carrier, Hz
//   code2     second code for the ionosphere-free combination; NULL: the first alone
//   f2_hz     its carrier, Hz
// Returned:
//   offset_m  [3] X, Y, Z of orr_attitude.body, m
// Errors: ORR_E_NODATA where ANTEX has no such frequency.
orr_status orr_antenna_offset_body(const orr_antex_antenna *antenna, const char *code1, double f1_hz,
                                   const char *code2, double f2_hz, double offset_m[3]);
// The same of a satellite at t, for the pair of its system; ORR_E_NODATA where ANTEX has no such antenna.
orr_status orr_antenna_offset_of_sat(const orr_antex *antex, orr_sat sat, orr_time t, double offset_m[3]);
// The same in the axes in which the attitude was given.
// Given:
//   antenna         antenna of the satellite
//   attitude        attitude of the satellite
//   code1, f1_hz    ANTEX frequency code and carrier, Hz
//   code2, f2_hz    second ones for the ionosphere-free combination; NULL: the first alone
// Returned:
//   offset_m        offset, m
// Errors: ORR_E_NODATA where ANTEX has no such frequency.
orr_status orr_antenna_offset(const orr_antex_antenna *antenna, const orr_attitude *attitude,
                              const char *code1, double f1_hz, const char *code2, double f2_hz,
                              orr_vec3 *offset_m);

#endif
