// SPDX-License-Identifier: GPL-3.0-or-later
// Land-mobile reception in two states: in view the direct ray with scattered ones (Rice), in shadow scattered ones alone (Rayleigh),
// whose power is lognormal from stretch to stretch. A pure function of scenario and time.
#ifndef ORR_SCENARIO_EFFECT_LAND_MOBILE_H
#define ORR_SCENARIO_EFFECT_LAND_MOBILE_H

#include "core/sat.h"
#include "src/config/scenario.h"
#include "src/scenario/source/source.h"

typedef struct orr_land_mobile orr_land_mobile;
// Prepares the section; *out NULL without it.
// Given:
//   s     scenario
//   sat   [n] satellites; their places in this list stand for them below
//   n     how many
//   span  time of the channels
// Returned:
//   out   free with orr_land_mobile_close
//   diag  why it failed
// Errors: ORR_E_LIMIT (more than five million changes of state), ORR_E_MEMORY.
orr_status orr_land_mobile_open(const orr_scenario *s, const orr_sat *sat, size_t n, orr_span span,
                                orr_land_mobile **out, orr_diag *diag);
void orr_land_mobile_close(orr_land_mobile *x); // NULL is allowed

typedef struct orr_land_mobile_now {
    bool shadow;
    double power_db, phase_cycles,
        phase_rate_hz; // against the direct ray; phase: by which the carrier is advanced
} orr_land_mobile_now;
// What becomes of a satellite's carrier; all zero where no row names it.
// Given:
//   x           the section
//   place       satellite
//   t           instant
//   as_of       whose state there is, as orr_faults_at
//   carrier_hz  of the signal
// Reference: Lutz et al. 1991, IEEE Trans. Veh. Techn. 40 (2), eqs. (2) to (8); the waves' directions are even over the circle (Clarke).
orr_land_mobile_now orr_land_mobile_at(const orr_land_mobile *x, size_t place, orr_time t, orr_time as_of,
                                       double carrier_hz);
// Whether any state changes in after < t <= until; x NULL: no.
bool orr_land_mobile_change(const orr_land_mobile *x, orr_time after, orr_time until);
// Longest block that follows it, ns: states change on multiples of 20 ms, and waves beat; INT64_MAX without it.
int64_t orr_land_mobile_block_ns(const orr_land_mobile *x);

#endif
