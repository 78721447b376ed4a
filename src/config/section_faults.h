// SPDX-License-Identifier: GPL-3.0-or-later
// Section `faults`: what goes wrong at given times, a list for each kind.
#ifndef ORR_CONFIG_SECTION_FAULTS_H
#define ORR_CONFIG_SECTION_FAULTS_H

#include "src/config/schema.h"

// Whom a fault concerns, and when: the first member of every fault.
typedef struct orr_fault_when {
    orr_sat_set sats;
    bool has_to;
    orr_time from, to; // from <= t < to; without has_to to the end of the scenario
} orr_fault_when;

// A step at the begin, then a ramp until `hold`, its last value until the end.
typedef struct orr_fault_profile {
    orr_fault_when when;
    orr_text_list signals; // of those that may be limited to some; none: all
    double step, rate;     // in the kind's unit, and per second
    bool has_hold;
    orr_time hold;
} orr_fault_profile;

typedef struct orr_fault_noise {
    orr_fault_when when;
    orr_real_list sigma_m, time_s; // one or two Gauss-Markov processes that are added
} orr_fault_noise;

typedef struct orr_fault_sine {
    orr_fault_when when;
    double amplitude_m, period_s, phase_deg;
} orr_fault_sine;

#define ORR_FAULT_ORBITS(X)                                                                                  \
    X(ORR_FAULT_ORBIT_TRUE, "orbit", "the satellite is elsewhere, its message does not know")                \
    X(ORR_FAULT_ORBIT_MESSAGE, "message", "its message tells another orbit than the one that it keeps")
typedef enum orr_fault_orbit_of { ORR_FAULT_ORBITS(ORR_CHOICE_VALUE) } orr_fault_orbit_of;

typedef struct orr_fault_orbit {
    orr_fault_when when;
    int wrong; // orr_fault_orbit_of
    double radial_m, along_m, cross_m;
} orr_fault_orbit;

typedef struct orr_fault_bits {
    orr_fault_when when;
    bool has_piece;
    int64_t piece;     // number of the subframe, string, word or message type; without has_piece every one
    char *message;     // "LNAV", "CNAV", ...; NULL: every one
    orr_real_list bit; // the first and the last that are inverted, from 1; one alone is both
} orr_fault_bits;

#define ORR_FAULT_LIST(T)                                                                                    \
    struct {                                                                                                 \
        size_t n;                                                                                            \
        T *item;                                                                                             \
    }
typedef struct orr_scenario_faults {
    int64_t seed;
    ORR_FAULT_LIST(orr_fault_profile) range;
    ORR_FAULT_LIST(orr_fault_profile) clock;
    ORR_FAULT_LIST(orr_fault_profile) divergence;
    ORR_FAULT_LIST(orr_fault_profile) power;
    ORR_FAULT_LIST(orr_fault_noise) noise;
    ORR_FAULT_LIST(orr_fault_sine) sine;
    ORR_FAULT_LIST(orr_fault_orbit) orbit;
    ORR_FAULT_LIST(orr_fault_when) off;
    ORR_FAULT_LIST(orr_fault_when) unhealthy;
    ORR_FAULT_LIST(orr_fault_when) stale;
    ORR_FAULT_LIST(orr_fault_bits) bits;
} orr_scenario_faults;

extern const orr_schema orr_section_faults;

#endif
