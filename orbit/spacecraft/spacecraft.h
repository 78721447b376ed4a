// SPDX-License-Identifier: GPL-3.0-or-later
// What a signal generator needs of a satellite beside its state: how it stands in space and where its antenna
// is, what its clock lacks, whether its signals may be used, and what each of them is late by. What is not
// known is NAN or says so; nothing is made up.
#ifndef ORR_ORBIT_SPACECRAFT_SPACECRAFT_H
#define ORR_ORBIT_SPACECRAFT_SPACECRAFT_H

#include "orbit/ephemeris/ephemeris.h"
#include "orbit/spacecraft/attitude.h"
#include "orbit/spacecraft/signal_delay.h"

typedef struct orr_extras_sources {
    const orr_ephemeris *orbit;
    const orr_antex *antex;   // NULL: no antennas
    const orr_bias_set *bias; // NULL: group delays by nav
    const orr_nav *nav;       // NULL: no health, and no group delays without bias
} orr_extras_sources;

typedef enum orr_health { ORR_HEALTH_UNKNOWN, ORR_HEALTH_OK, ORR_HEALTH_BAD } orr_health;

typedef struct orr_extras {
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
} orr_extras;

// sun_m: orr_attitude_sun(t), which is the same for all satellites. ORR_OK, or what orr_ephemeris_eval says.
orr_status orr_extras_at(const orr_extras_sources *src, orr_sat sat, orr_time t, orr_vec3 sun_m,
                         orr_extras *out);

// Group delay of a signal against the product's clock (orbit/spacecraft/signal_delay.h). By biases where
// there are any, else by the broadcast record; never from both, because their datums lie nanoseconds apart.
// ORR_E_NODATA, ORR_E_ARG.
orr_status orr_extras_delay(const orr_extras_sources *src, orr_sat sat, const char *signal, orr_time t,
                            double *delay_s);

#endif
