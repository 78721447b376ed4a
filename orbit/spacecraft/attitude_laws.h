// SPDX-License-Identifier: GPL-3.0-or-later
// How satellites of a block turn about noon and midnight, where nominal yaw steering asks for more than they can.
#ifndef ORR_ORBIT_SPACECRAFT_ATTITUDE_LAWS_H
#define ORR_ORBIT_SPACECRAFT_ATTITUDE_LAWS_H

#include "orbit/spacecraft/attitude.h"

typedef enum orr_attitude_law {
    ORR_LAW_NOMINAL, // as orr_attitude_nominal, flagged where it is too fast
    ORR_LAW_RATE,    // GPS IIR: 0.20 deg/s at most, at noon and midnight (Kouba 2009, GPS Solut. 13:1)
    ORR_LAW_IIF, // noon: 0.11 deg/s at most; shadow: an even turn from entry to exit (Dilssner 2010, Inside GNSS 6)
    ORR_LAW_GLONASS_M, // 0.25 deg/s: noon: centred on it; shadow: from entry until the exit's yaw is reached (Dilssner et al.
                       // 2011, Adv. Space Res. 47:160)
    ORR_LAW_GALILEO_IOV, // an auxiliary direction of the Sun (European GNSS Service Centre, Galileo satellite metadata, 3.1)
    ORR_LAW_GALILEO_FOC, // a cosine in time within 10 deg of the Sun's line for |beta| < 4.1 deg (the same); its period is twice
    // the passage, so that it ends on the nominal yaw (there: 5656 s, which is that for beta 0)
    ORR_LAW_BEIDOU_3, // beta held above 2.8 deg near noon and midnight (Dilssner 2017; Xia et al. 2019, Remote Sens. 11:175)
    ORR_LAW_IIA, // GPS II, IIA: noon: 0.12 deg/s at most (mean of the satellites); shadow: 0.12 deg/s to the positive side, which
    // the yaw bias of 0.5 deg prefers, from entry to exit, then back to nominal the short way (Kouba 2009)
    ORR_LAW_III, // GPS III: as Galileo IOV, within 15 and 5.8 deg (Montenbruck et al. 2026: 1.9 to 3.5 deg RMS from the
                 // quaternions of JPL)
    ORR_LAW_BEIDOU_2, // orbit-normal while |beta| < 4 deg where the satellite last crossed 90 deg from midnight, steered else; of
    // MEO and IGSO (Montenbruck et al. 2015, Adv. Space Res. 56:1015; Guo and Zhao 2014, GPS Solut. 18:447)
    ORR_LAW_QZS_1, // the same with 20 deg (Montenbruck et al. 2015; Cabinet Office, QZS-1 satellite information)
} orr_attitude_law;

// The law of a satellite's block by the type that ANTEX gives ("BLOCK IIF", "GLONASS-M", "GALILEO-2"); nominal for all others
// and for NULL.
orr_attitude_law orr_attitude_law_of(const orr_antex_antenna *antenna);

// The attitude by a law: yaw_rad, body and fast_turn (false: it is followed) are the law's, the rest is as orr_attitude_nominal
// gives it. A function of the instant alone: when a turn began follows from beta and the mean motion, for a round orbit and a
// Sun that stands still meanwhile; what beta was hours ago, which decides between two ways of flying, from the Sun's way along the
// ecliptic. From one way to the other it takes 0.1 deg/s, of which nothing is published.
// Given:
//   law               of the block
//   t                 instant
//   r_m               satellite, in ecef or any axes whose z is the Earth's
//   v_inertial_mps    its inertial velocity in them
//   sun_m             the Sun
// Returned:
//   out               attitude
// Errors: as orr_attitude_nominal.
orr_status orr_attitude_by_law(orr_attitude_law law, orr_time t, orr_vec3 r_m, orr_vec3 v_inertial_mps,
                               orr_vec3 sun_m, orr_attitude *out);

#endif
