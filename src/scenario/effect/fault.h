// SPDX-License-Identifier: GPL-3.0-or-later
// Faults at given times, with their truth: what the section `faults` adds to channels. A pure function of scenario and time.
#ifndef ORR_SCENARIO_EFFECT_FAULT_H
#define ORR_SCENARIO_EFFECT_FAULT_H

#include "core/vec.h"
#include "src/config/scenario.h"
#include "src/scenario/source/source.h"

typedef struct orr_faults orr_faults;

// A satellite as the channels know it.
typedef struct orr_fault_satellite {
    orr_sat sat;
    bool sends;
} orr_fault_satellite;

// Prepares the faults; *out NULL where the scenario has none.
// Given:
//   s          scenario
//   satellite  [n] satellites; a satellite's place in this list stands for it below
//   n          how many
//   span       time of the channels
// Returned:
//   out        the faults; free with orr_faults_close
//   diag       why it failed, with the key's line
// Errors: ORR_E_FORMAT (times that are not in order or not on milliseconds, faults that contradict each other or are never
// seen), ORR_E_LIMIT (noise of more than 2e7 nodes), ORR_E_MEMORY.
orr_status orr_faults_open(const orr_scenario *s, const orr_fault_satellite *satellite, size_t n,
                           orr_span span, orr_faults **out, orr_diag *diag);
void orr_faults_close(orr_faults *f); // NULL is allowed

// What faults a signal has at an instant.
typedef struct orr_fault_now {
    bool any, unhealthy;
    double range_m, range_mps;           // of code and carrier
    double noise_m, noise_mps;           // likewise: noise and sines
    double clock_m, clock_mps;           // likewise: minus c times the clock's
    double divergence_m, divergence_mps; // of the code alone
    double power_db;
    orr_vec3 orbit_m; // radial, along, cross
} orr_fault_now;

// Faults of a signal.
// Given:
//   f       faults; NULL: none
//   place   satellite
//   signal  place in orr_signals
//   t       instant of reception
//   as_of   which faults there are: those of this instant. A block's end takes its begin, so that what begins there belongs to the
//           next block
// Returned:
//   out     what they add up to
void orr_faults_at(const orr_faults *f, size_t place, size_t signal, orr_time t, orr_time as_of,
                   orr_fault_now *out);
// One fault of one satellite: when it begins and is over.
typedef struct orr_fault_time {
    size_t place, number; // satellite; which fault of the scenario, from 0
    orr_time from, to;
} orr_fault_time;
// The k-th of them; false where there are not so many, or no faults at all.
bool orr_faults_time(const orr_faults *f, size_t k, orr_fault_time *out);
// Whether the satellite is off.
bool orr_faults_off(const orr_faults *f, size_t place, orr_time as_of);
// Whether any fault begins, holds or ends in after < t <= until.
bool orr_faults_change(const orr_faults *f, orr_time after, orr_time until);
// Whether blocks of this length, on multiples of it, follow the faults in [from, to): all that begins, holds or ends then is at an
// edge, and cubics err by less than error_m.
// Given:
//   f          faults; NULL: none
//   from, to   stretch of time
//   length_ns  of the blocks
//   error_m    what cubics may err
bool orr_faults_allow(const orr_faults *f, orr_time from, orr_time to, int64_t length_ns, double error_m);

#endif
