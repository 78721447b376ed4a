// SPDX-License-Identifier: GPL-3.0-or-later
// Channels: for each antenna, satellite and signal what arrives at an instant of reception. Code and carrier are sums of terms,
// each on its own on request. A pure function of (scenario, time): nothing depends on who asked before.
#ifndef ORR_SCENARIO_CHANNEL_CHANNEL_H
#define ORR_SCENARIO_CHANNEL_CHANNEL_H

#include "core/signal.h"
#include "src/scenario/antenna/antenna.h"
#include "src/scenario/effect/jammer.h"
#include "src/scenario/effect/replay.h"
#include "src/scenario/source/source_iono.h"
#include "src/scenario/source/source_orbit.h"
#include "src/scenario/source/source_tables.h"
#include "src/scenario/troposphere/troposphere.h"

typedef enum orr_term {
#define ORR_TERM(NAME, name, code, carrier, meaning) ORR_TERM_##NAME,
#include "src/scenario/channel/terms.def"
#undef ORR_TERM
    ORR_N_TERMS
} orr_term;

// A term's name, its factors in code and carrier, and what it means.
typedef struct orr_term_row {
    const char *name, *meaning;
    double code, carrier;
} orr_term_row;
extern const orr_term_row orr_term_rows[ORR_N_TERMS];

enum {                                // orr_channel.flags
    ORR_CHANNEL_UNHEALTHY = 1u << 0,  // by the scenario: not to be used
    ORR_CHANNEL_ECLIPSE = 1u << 1,    // the satellite is in shadow
    ORR_CHANNEL_FAST_TURN = 1u << 2,  // near noon or midnight its true attitude departs from the nominal one
    ORR_CHANNEL_NO_ANTENNA = 1u << 3, // ANTEX was given and does not know the satellite
    ORR_CHANNEL_NO_DELAY = 1u << 4,   // biases were given and do not tell this signal's delay
    ORR_CHANNEL_ZERO_CLOCK = 1u << 5, // a hole of the clock, by channel.clock_holes
    ORR_CHANNEL_NOMINAL_FREQUENCY = 1u << 6, // GLONASS: the channel is the nominal one of the slot
    ORR_CHANNEL_FAULT = 1u << 7,             // the scenario's faults befall it
};

#define ORR_CHANNEL_SPOOFED 256
// What arrives of one signal. Rates are derivatives by the instant of reception.
typedef struct orr_channel {
    orr_sat sat;
    uint16_t signal; // place in orr_signals
    uint16_t
        echo; // 0: the signal itself, else which echo of it, or ORR_CHANNEL_SPOOFED times which spoofer (from 1)
    uint32_t flags;
    double az_rad, el_rad; // of the satellite above the ellipsoid's horizon, geometric
    double term_m[ORR_N_TERMS], rate_mps[ORR_N_TERMS];
    double code_m, code_rate_mps; // pseudorange of a receiver with a perfect clock
    int64_t carrier_cycles;       // whole cycles of the carrier's phase range, and
    double carrier_fraction;      // the rest, [0, 1)
    double carrier_rate_hz;       // cycles a second: minus the Doppler frequency
    double carrier_hz;
    orr_time
        transmit_ns; // reading of the satellite's clock at emission (GPS scale), t - code/c: whole ns, and
    double transmit_fraction_ns; // the rest, [0, 1)
    double power_dbw;            // received by 0 dBi
} orr_channel;

// Noise density of a receiver, dBW/Hz: that of 290 K (-204) and a noise figure of 1.5 dB.
#define ORR_N0_DBWHZ (-202.5)

typedef struct orr_channels orr_channels;

// Prepares the channels of a scenario. *out NULL where no signals are sent.
// Given:
//   s         scenario
//   orbits    satellites, borrowed; NULL: none
//   iono      delays, borrowed; NULL: none
//   motion    what moves, borrowed; NULL: nothing
//   tables    antennas, biases and records, borrowed
//   replay    recorded day whose signals the first antenna receives, borrowed; NULL: none
//   cancel    ends it; may be NULL
// Returned:
//   warnings  what was left out or taken from a neighbour, and why
//   out       the channels; free with orr_channels_close
//   diag      why it failed
// Errors: those of orr_antenna_open; ORR_E_NODATA (none of the satellites sends one of the signals).
orr_status orr_channels_open(const orr_scenario *s, const orr_source_orbit *orbits,
                             const orr_source_iono *iono, const orr_source_motion *motion,
                             const orr_source_tables *tables, const orr_replay *replay,
                             const volatile int *cancel, orr_warnings *warnings, orr_channels **out,
                             orr_diag *diag);
void orr_channels_close(orr_channels *c); // NULL is allowed

// How many antennas there are; 0 for NULL.
size_t orr_channels_antennas(const orr_channels *c);
// One of them, borrowed; NULL where there are not so many.
const orr_antenna *orr_channels_antenna(const orr_channels *c, size_t antenna);
// Signals that are sent: bit k stands for the k-th of orr_signals.
uint64_t orr_channels_signals(const orr_channels *c);
// GLONASS' frequency channel of a satellite that sends; false for others.
bool orr_channels_frequency_channel(const orr_channels *c, orr_sat sat, int *channel);
// A satellite that sends.
typedef struct orr_transmitter {
    orr_sat sat;
    int frequency_channel; // GLONASS; 0 for others
    bool unhealthy;
    const char *svn, *block; // as ANTEX or satellites.metadata names them, borrowed; "" without
} orr_transmitter;
// The k-th of them, in the orbits' order; false where there are not so many.
bool orr_channels_transmitter(const orr_channels *c, size_t k, orr_transmitter *out);
// Whether an antenna sees a satellite.
// Given:
//   c        channels
//   antenna  which, from 0
//   at       the antenna at an instant
//   sat_m    centre of mass of the satellite then, ecef
bool orr_channels_sees(const orr_channels *c, size_t antenna, const orr_antenna_state *at, orr_vec3 sat_m);
// A fault of a satellite, by the section `faults`.
typedef struct orr_channel_fault {
    orr_sat sat;
    size_t number; // which of the scenario's faults, from 0
    orr_time from, to;
} orr_channel_fault;
// The k-th of them; false where there are not so many.
bool orr_channels_fault(const orr_channels *c, size_t k, orr_channel_fault *out);
// Stretch of time in which channels can be: of the orbits, less the flight of light, the ionosphere, and of the motion.
orr_span orr_channels_span(const orr_channels *c);
// The part of it in which an antenna is there: its trajectory's. `from` is after `to` where there is none.
orr_span orr_channels_antenna_span(const orr_channels *c, size_t antenna);
// How many channels an antenna can have at once: satellites times their signals, with their echoes.
size_t orr_channels_max(const orr_channels *c);
// Jammers that an antenna in `at` receives at t (jammers); their number.
size_t orr_channels_jammers(const orr_channels *c, const orr_antenna_state *at, orr_time t,
                            orr_jammer out[ORR_MAX_JAMMERS]);
// Time error of an antenna's receiver at its own reading t, s, and its rate: what observations have and channels do not
// (clocks.receiver, replay).
double orr_channels_oscillator(const orr_channels *c, size_t antenna, orr_time t, double *rate);
// Of that error what carriers do not follow: steps of whole milliseconds of a recorded receiver.
double orr_channels_held_s(const orr_channels *c, orr_time t);
// The neutral atmosphere over a place, as the channels of an antenna have it, with what a recorded day tells of it.
orr_troposphere_site orr_channels_troposphere(const orr_channels *c, size_t antenna, orr_geodetic place,
                                              orr_time t);
// Spacing between early and late of the correlator that observes a signal, chips (multipath.spacing).
double orr_channels_spacing(const orr_channels *c, size_t signal);

// What evaluations find and keep for the next: curves of slow terms and of satellites over some seconds. Everything in it is a
// function of scenario and time, so that an answer never depends on who asked before, of whatever workspace. One thread at a
// time may use one; any number of them may use the same channels.
typedef struct orr_channel_work orr_channel_work;
// Errors: ORR_E_MEMORY. Close it before the channels.
orr_status orr_channel_work_open(const orr_channels *c, orr_channel_work **out, orr_diag *diag);
void orr_channel_work_close(orr_channel_work *work); // NULL is allowed

// All channels of an antenna at t, by satellite, signal and echo, those that the antenna does not see left out.
// Given:
//   c        channels
//   antenna  which, from 0
//   work     workspace of these channels
//   t        instant of reception
//   signals  those that are wanted, as orr_channels_signals; others are left out
// Returned:
//   out      [at most orr_channels_max] channels
//   n        how many
// Answers: ORR_ANSWER_OK; ORR_ANSWER_OUTSIDE_SPAN or ORR_ANSWER_NOT_SERVED (no such antenna), then *n is 0.
orr_answer orr_channels_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                           uint64_t signals, orr_channel *out, size_t *n);

#endif
