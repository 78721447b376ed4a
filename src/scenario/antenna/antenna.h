// SPDX-License-Identifier: GPL-3.0-or-later
// Antennas of a scenario: where each is, how it moves and stands, and where its phase centres are.
#ifndef ORR_SCENARIO_ANTENNA_ANTENNA_H
#define ORR_SCENARIO_ANTENNA_ANTENNA_H

#include "core/earth.h"
#include "core/signal.h"
#include "ingest/tables/antex.h"
#include "src/config/scenario.h"
#include "src/scenario/source/source_motion.h"

// An antenna at an instant, ecef.
typedef struct orr_antenna_state {
    orr_vec3 r_m, v_mps; // antenna reference point
    orr_mat3 axes;       // rows: the antenna's East, North and Up, which on a body are right, forward, up
    orr_vec3 w_radps;    // rate at which they turn against the Earth, ecef
    orr_mat3 enu;        // rows: East, North, Up of the place
    orr_vec3
        enu_radps; // rate at which they turn while the antenna moves, ecef; of a sphere, which is right to 1 %
} orr_antenna_state;

typedef struct orr_antenna {
    char name[64];
    char type[21];                                      // "" where the scenario names none
    const orr_antex_antenna *antex;                     // NULL: the phase centre is the reference point
    const orr_antex_frequency *centre[ORR_MAX_SIGNALS]; // of each of orr_signals; NULL: none
    const orr_source_motion *motion;                    // NULL: fixed
    size_t unit;
    orr_vec3 arm_m; // on the body, from the unit: right, forward, up
    // Of a live body: the straight line that slow terms are computed along, instead of the scenario's motion; NULL: none.
    const struct orr_antenna_line *line;
    orr_antenna_state fixed; // of a fixed antenna
} orr_antenna;

// Prepares antenna k of the scenario; where the scenario has no antennas, its receiver as antenna 0.
// Given:
//   s         scenario
//   k         which antenna, from 0
//   motion    the scenario's motion, borrowed; NULL: nothing moves
//   station   place of the ionosphere's station (ecef), the last resort of a receiver; NULL: none
//   antex     antennas, borrowed; NULL: none
// Returned:
//   out       the antenna
//   warnings  a radome that ANTEX does not know
//   diag      why it failed
// Errors: ORR_E_NODATA (an antenna type that ANTEX lacks, a type without ANTEX, no receiver at all).
orr_status orr_antenna_open(const orr_scenario *s, size_t k, const orr_source_motion *motion,
                            const orr_vec3 *station, const orr_antex *antex, orr_antenna *out,
                            orr_warnings *warnings, orr_diag *diag);

// A straight line on which an antenna goes.
typedef struct orr_antenna_line {
    orr_time t;
    orr_antenna_state at; // then; its axes do not turn
} orr_antenna_line;

// An antenna that rides on a body, which moves as m says; without arm: m is that of the antenna's reference point.
void orr_antenna_ride(const orr_antenna *a, const orr_motion *m, bool arm, orr_antenna_state *out);
// Where an antenna stands that is carried along from `state`, at its velocity and with its axes: enu of the new place.
orr_antenna_state orr_antenna_carried(const orr_antenna_state *state, double s);

// Where the antenna is at t. ORR_ANSWER_OK, or ORR_ANSWER_OUTSIDE_SPAN of the trajectory.
orr_answer orr_antenna_at(const orr_antenna *a, orr_time t, orr_antenna_state *out);

// A direction in the antenna's own axes, with its rate.
typedef struct orr_antenna_direction {
    orr_vec3 own, own_rate_ps; // East, North, Up of the antenna
    double az_deg, zenith_deg, az_rate_dps, zenith_rate_dps;
} orr_antenna_direction;
// Given:
//   state      orr_antenna_at
//   u          unit vector from the antenna to the satellite, ecef
//   u_rate_ps  its rate
orr_antenna_direction orr_antenna_toward(const orr_antenna_state *state, orr_vec3 u, orr_vec3 u_rate_ps);

// What the antenna's phase centre adds to the range to a satellite, of code and carrier alike.
// Given:
//   a         antenna
//   d         direction of the satellite
//   signal    place in orr_signals
// Returned:
//   rate_mps  its rate
// Returns -offset.u + variation, m; 0 without a type.
// Notes: a frequency that ANTEX lacks is taken from the nearest one that it has, as analysis centres do.
// Reference: ANTEX 1.4, section "phase centre corrections": observed = geometric + correction.
double orr_antenna_range_m(const orr_antenna *a, const orr_antenna_direction *d, size_t signal,
                           double *rate_mps);

// The frequency of an ANTEX antenna for a signal: its own, else the nearest in frequency. NULL where it has none.
const orr_antex_frequency *orr_antenna_frequency(const orr_antex_antenna *a, const orr_signal *s,
                                                 double carrier_hz);

#endif
