// SPDX-License-Identifier: GPL-3.0-or-later
// What a signal generator needs of a satellite beside its state: how it stands in space and where its antenna
// is, what its clock lacks, whether its signals may be used, and what each of them is late by. What is not
// known is NAN or says so; nothing is made up.
#ifndef ORR_ORBIT_SPACECRAFT_SPACECRAFT_H
#define ORR_ORBIT_SPACECRAFT_SPACECRAFT_H

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/spacecraft/attitude.h"
#include "orbit/spacecraft/signal_delay.h"

typedef struct orr_spacecraft_sources {
    const orr_ephemeris *orbit;
    const orr_antex *antex;   // antennas, and blocks for their laws of turning; NULL: none
    const orr_bias_set *bias; // NULL: group delays by nav
    const orr_nav *nav;       // NULL: no health, and no group delays without bias
    uint32_t messages;        // of nav to insist on (orr_broadcast_choice.messages); 0: the usual ones
} orr_spacecraft_sources;

typedef enum orr_health { ORR_HEALTH_UNKNOWN, ORR_HEALTH_OK, ORR_HEALTH_BAD } orr_health;

typedef struct orr_spacecraft {
    orr_sat_state state;
    bool has_attitude; // false where Sun, satellite and Earth stand in line
    bool orbit_normal; // geostationary satellites of BeiDou and QZSS; all others steer by the Sun
    orr_attitude attitude;
    // Phase centre of the system's ionosphere-free pair from the centre of mass, in body axes and in ecef;
    // NAN where ANTEX does not tell.
    double antenna_body_m[3];
    orr_vec3 antenna_ecef_m;
    double relativity_s; // -2 r.v / c^2, to be added to state.clock_s
    orr_health health;   // by the broadcast record nearest in time, whatever it says
} orr_spacecraft;

// Attitude, antenna, relativity and health of a satellite beside its state.
// Given:
//   src    what is known: orbit, antennas, biases, broadcast records
//   sat    satellite
//   t      instant
//   sun_m  orr_attitude_sun(t, eop), the same for all satellites, m
// Returned:
//   out    all of it; what is not known is NAN or says so
// Errors: as orr_ephemeris_eval.
orr_status orr_spacecraft_at(const orr_spacecraft_sources *src, orr_sat sat, orr_time t, orr_vec3 sun_m,
                             orr_spacecraft *out);

// Group delay of a signal against the product's clock (orbit/spacecraft/signal_delay.h).
// Given:
//   src      what is known
//   sat      satellite
//   signal   RINEX 3 code without the leading letter
//   t        instant
// Returned:
//   delay_s  delay, s
// Errors: ORR_E_NODATA, ORR_E_ARG.
// Notes: from biases where there are any, else from the broadcast record, and where that says nothing of the signal from
// another message of the satellite (CNAV's ISCs beside LNAV), unless messages are insisted on; never from biases and
// records both, because their datums differ by nanoseconds.
orr_status orr_spacecraft_delay(const orr_spacecraft_sources *src, orr_sat sat, const char *signal,
                                orr_time t, double *delay_s);

#endif
