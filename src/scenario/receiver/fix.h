// SPDX-License-Identifier: GPL-3.0-or-later
// The position that a receiver tells: the antenna's true one, with the dilutions of precision of what it observes.
#ifndef ORR_SCENARIO_RECEIVER_FIX_H
#define ORR_SCENARIO_RECEIVER_FIX_H

#include "core/earth.h"
#include "src/scenario/observables/observer.h"

typedef struct orr_fix {
    bool valid;                   // four satellites or more, not in a plane
    size_t n_sats;                // observed
    orr_geodetic g;               // of the antenna's reference point
    orr_vec3 v_mps;               // East, North, Up
    double speed_mps, course_rad; // over ground; course [0, 2 pi), 0 at rest
    double pdop, hdop, vdop;      // 99.99 without a fix
    double range_sigma_m;         // RMS of the codes' noise; 0 without
    double sigma_m[3];            // of East, North, Up, by that noise
} orr_fix;

// Where the antenna is at an epoch, as a receiver tells it.
// Given:
//   a     the antenna
//   o     its observations at the epoch
// Returned:
//   out   the fix: one clock for all systems, all satellites alike
//   diag  ORR_E_RANGE outside of the antenna's motion
orr_status orr_fix_of(const orr_antenna *a, const orr_observed *o, orr_fix *out, orr_diag *diag);

#endif
