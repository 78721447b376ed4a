// SPDX-License-Identifier: GPL-3.0-or-later
// Phase wind-up as a pure function of time: whole turns are counted once, on a lattice, when a scenario is prepared.
#ifndef ORR_SCENARIO_CHANNEL_WINDUP_H
#define ORR_SCENARIO_CHANNEL_WINDUP_H

#include "src/scenario/antenna/antenna.h"
#include "src/scenario/channel/sun_track.h"
#include "src/scenario/source/source_orbit.h"

// Turns of one antenna and all satellites.
typedef struct orr_windup {
    orr_time from;
    size_t n_nodes, n_sats;
    float *turns; // [n_sats][n_nodes] every minute, of a dipole at the antenna's place along East and North
    double *heading; // [n_headings] every 0.1 s of a moving antenna, turns, continuous
    size_t n_headings;
    orr_time heading_from;
} orr_windup;

// Counts the turns over a span.
// Given:
//   orbits, a  satellites, and the antenna
//   antex      blocks of the satellites, for their laws of turning; NULL: nominal attitudes
//   span       when
//   sun        the Sun over the span
//   cancel     ends it; may be NULL
// Returned:
//   out        the turns; free with orr_windup_free
//   diag       ORR_E_MEMORY, ORR_E_INTERRUPTED
orr_status orr_windup_open(const orr_source_orbit *orbits, const orr_antenna *a, const orr_antex *antex,
                           orr_span span, const orr_sun_track *sun, const volatile int *cancel,
                           orr_windup *out, orr_diag *diag);
void orr_windup_free(orr_windup *w); // leaves *w empty

// Wind-up between satellite k and a dipole that lies along East and North at the antenna's place, cycles.
// Given:
//   w         counted turns
//   k         satellite, its place in orr_source_orbit_satellites
//   t         instant of reception
//   state     antenna
//   sat_m     satellite, ecef
//   attitude  rows are its body axes, ecef
// Reference: Wu et al. 1993, Manuscripta Geodaetica 18:91.
double orr_windup_still(const orr_windup *w, size_t k, orr_time t, const orr_antenna_state *state,
                        orr_vec3 sat_m, const orr_mat3 *attitude);
// What the antenna's own turn adds to it, cycles; 0 of a fixed antenna. The sum of both is to be added to the carrier's phase
// range.
// Given:
//   w          counted turns
//   t          instant of reception
//   state      antenna
//   u          unit vector from the antenna to the satellite, ecef
//   u_rate_ps  its rate
// Returned:
//   rate_hz    rate, exact
double orr_windup_turned(const orr_windup *w, orr_time t, const orr_antenna_state *state, orr_vec3 u,
                         orr_vec3 u_rate_ps, double *rate_hz);

#endif
