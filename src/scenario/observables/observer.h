// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver measures, epoch by epoch: code, phase, Doppler and C/N0 of every signal of an antenna, and how long each has been
// tracked. All formats of observations are written from it.
#ifndef ORR_SCENARIO_OBSERVABLES_OBSERVER_H
#define ORR_SCENARIO_OBSERVABLES_OBSERVER_H

#include "src/scenario/channel/channel.h"

// One signal at one epoch.
typedef struct orr_observation {
    orr_sat sat;
    uint16_t signal;             // place in orr_signals
    bool begins;                 // it was not there at the epoch before
    orr_time since;              // first epoch of the arc
    double code_m, phase_cycles; // with the receiver's clock error in both
    double doppler_hz, cn0_dbhz, carrier_hz;
    double code_sigma_m, phase_sigma_cycles; // of the noise; 0 without
    double az_rad, el_rad;
} orr_observation;

typedef struct orr_observed {
    orr_time t;
    size_t n;
    const orr_observation *item; // [n] by satellite and signal; valid until the next epoch
    double clock_s;              // the receiver's clock error
} orr_observed;

typedef struct orr_observer orr_observer;

// A receiver at an antenna. Its epochs are a function of the scenario, the seed and the epochs before (of arcs alone).
// Given:
//   c        channels, borrowed
//   antenna  which
//   noise    thermal noise, by C/N0
//   seed     of the noise
// Returned:
//   out      the observer; close with orr_observer_close
//   diag     ORR_E_MEMORY; ORR_E_ARG where there is no such antenna
// Notes: with noise, a delay lock of 1 Hz with half a chip between early and late, of 0.1 chip where chips come faster than
// 5 MHz, and a phase lock of 15 Hz (Kaplan and Hegarty 2017, eqs. (8.31), (8.96)): white, a pure function of seed and time.
orr_status orr_observer_open(const orr_channels *c, size_t antenna, bool noise, uint64_t seed,
                             orr_observer **out, orr_diag *diag);
void orr_observer_close(orr_observer *o); // NULL is allowed
// The observations at t, by the receiver's clock, later than the epoch before. ORR_E_RANGE outside of the channels' span.
orr_status orr_observer_at(orr_observer *o, orr_time t, orr_observed *out, orr_diag *diag);

#endif
