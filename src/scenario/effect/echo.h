// SPDX-License-Identifier: GPL-3.0-or-later
// Echoes of a signal: by the ground and by reflectors, each a channel of its own. A pure function of scenario and time.
#ifndef ORR_SCENARIO_EFFECT_ECHO_H
#define ORR_SCENARIO_EFFECT_ECHO_H

#include "src/scenario/antenna/antenna.h"

typedef struct orr_echoes orr_echoes;

// Prepares the section `multipath`; *out NULL where it has no echoes.
// Given:
//   s     scenario
//   span  time of the channels
// Returned:
//   out   free with orr_echoes_close
//   diag  why it failed, with the key's line
// Errors: ORR_E_FORMAT (a delay that would become negative, a reflector that is never there), ORR_E_MEMORY.
orr_status orr_echoes_open(const orr_scenario *s, orr_span span, orr_echoes **out, orr_diag *diag);
void orr_echoes_close(orr_echoes *e); // NULL is allowed
// How many a signal can have; 0 for NULL.
size_t orr_echoes_max(const orr_echoes *e);

// A signal that arrives.
typedef struct orr_echo_ray {
    orr_time t, as_of; // as of orr_faults_at
    orr_sat sat;
    double carrier_hz;
    const orr_antenna_state *at;
    orr_vec3 u, u_rate_ps; // from the antenna to the satellite, ecef; its rate
} orr_echo_ray;

typedef struct orr_echo {
    uint16_t number; // from 1; the same reflector's all the time
    double delay_m, delay_mps;
    double phase_cycles, phase_rate_hz; // by which the reflection retards the carrier besides
    double power_db;                    // against the signal
} orr_echo;

// Echoes of a signal. e NULL: none.
// Given:
//   e    echoes
//   ray  signal
// Returned:
//   out  those that are there, by number
// Returns how many.
size_t orr_echoes_at(const orr_echoes *e, const orr_echo_ray *ray, orr_echo out[ORR_MAX_ECHOES]);

// Whether any reflector appears or goes in after < t <= until.
bool orr_echoes_change(const orr_echoes *e, orr_time after, orr_time until);
// Whether blocks of this length follow the echoes of an antenna in [from, to), as orr_faults_allow.
// Given:
//   e          echoes; NULL: none
//   antenna    that receives them
//   from, to   stretch of time
//   length_ns  of the blocks
//   error_m    what cubics may err
bool orr_echoes_allow(const orr_echoes *e, const orr_antenna *antenna, orr_time from, orr_time to,
                      int64_t length_ns, double error_m);

#endif
