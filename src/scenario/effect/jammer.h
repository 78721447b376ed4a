// SPDX-License-Identifier: GPL-3.0-or-later
// Jammers as geometry and power at an antenna: for conducted tests, in which a generator makes the waveform. A pure function of scenario
// and time.
#ifndef ORR_SCENARIO_EFFECT_JAMMER_H
#define ORR_SCENARIO_EFFECT_JAMMER_H

#include "src/scenario/antenna/antenna.h"

typedef struct orr_jammers orr_jammers;
// Prepares the section; *out NULL without it. ORR_E_MEMORY. Free with orr_jammers_close.
orr_status orr_jammers_open(const orr_scenario *s, orr_jammers **out, orr_diag *diag);
void orr_jammers_close(orr_jammers *j); // NULL is allowed

typedef struct orr_jammer {
    uint16_t number;       // place in the scenario's list
    const char *waveform;  // borrowed
    double az_rad, el_rad; // above the ellipsoid's horizon
    double range_m, range_rate_mps;
    double carrier_hz, doppler_hz; // as it is sent; by which it arrives higher
    double power_dbw;              // received by 0 dBi, free space between
} orr_jammer;

// The jammers that send at t, as an antenna in `at` receives them; j NULL: none. Their number.
size_t orr_jammers_at(const orr_jammers *j, const orr_antenna_state *at, orr_time t,
                      orr_jammer out[ORR_MAX_JAMMERS]);

#endif
