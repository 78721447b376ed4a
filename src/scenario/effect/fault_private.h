// SPDX-License-Identifier: GPL-3.0-or-later
// Faults among their parts: as they are kept (fault.c), listed and checked (fault_list.c), and their noise (fault_noise.c).
#ifndef ORR_SCENARIO_EFFECT_FAULT_PRIVATE_H
#define ORR_SCENARIO_EFFECT_FAULT_PRIVATE_H

#include "src/scenario/effect/fault.h"
#include "src/scenario/effect/series.h"

typedef enum fault_kind {
    FAULT_RANGE,
    FAULT_CLOCK,
    FAULT_DIVERGENCE,
    FAULT_POWER,
    FAULT_NOISE,
    FAULT_SINE,
    FAULT_ORBIT,
    FAULT_OFF,
    FAULT_UNHEALTHY,
    FAULT_STALE,
    FAULT_BITS,
    FAULT_KINDS,
} fault_kind;

typedef struct fault_item {
    fault_kind kind;
    size_t index; // in its kind's list
    orr_sat_set sats;
    uint64_t signals;
    orr_time from, to, hold;
    double step, rate;                   // of profiles
    double amplitude_m, w_radps, at_rad; // of sines
    int wrong;                           // orr_fault_orbit_of
    orr_vec3 orbit_m;
    const orr_fault_noise *noise; // while they are prepared
} fault_item;

// A fault of one satellite.
typedef struct fault_use {
    size_t place, item;
    orr_series series[2];
    size_t n_series;
} fault_use;

struct orr_faults {
    size_t n_items;
    fault_item *item;
    size_t n_sats;
    size_t *first; // [n_sats + 1] uses of a satellite: use[first[place]] to use[first[place + 1]]
    size_t n_uses;
    fault_use *use;
    size_t n_events;
    orr_time *event; // ascending
};

// All faults of the scenario into f->item, each by itself checked. Errors: those of orr_faults_open.
orr_status faults_list(const orr_scenario *s, orr_span span, orr_faults *f, orr_diag *diag);
// Refuses what contradicts itself.
// Given:
//   s             scenario
//   satellite, n  as orr_faults_open
//   f             faults that are listed
// Returned:
//   diag          what contradicts what
orr_status faults_contradict(const orr_scenario *s, const orr_fault_satellite *satellite, size_t n,
                             const orr_faults *f, orr_diag *diag);

// Makes a satellite's noise.
// Given:
//   item   fault of noise
//   seed   of the scenario
//   sat    satellite
//   spare  nodes that may still be made
// Returned:
//   spare  less those that were
//   use    its series
// Errors: ORR_E_LIMIT, ORR_E_MEMORY.
orr_status fault_noise_make(const fault_item *item, int64_t seed, orr_sat sat, size_t *spare, fault_use *use);

#endif
