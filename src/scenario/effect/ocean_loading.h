// SPDX-License-Identifier: GPL-3.0-or-later
// What the weight of the ocean's tides does to the ground below an antenna.
#ifndef ORR_SCENARIO_EFFECT_OCEAN_LOADING_H
#define ORR_SCENARIO_EFFECT_OCEAN_LOADING_H

#include "core/time.h"
#include "core/vec.h"
#include "ingest/tables/blq.h"

enum { ORR_TIDES = 342 };

// Up, West and South of each constituent: m, factors of the cosine and the sine of its argument.
typedef struct orr_ocean_loading {
    double cosine_m[ORR_TIDES][3], sine_m[ORR_TIDES][3];
} orr_ocean_loading;

// Spreads a station's eleven constituents over 342.
// Given:
//   blq   the station's loading
// Returned:
//   out   the constituents
//   diag  ORR_E_MEMORY
// Notes: what a constituent does, over its amplitude in the tide's potential, is a smooth function of its frequency: natural cubics
// through the four of half a day, the four of a day and the three of long periods; held beyond the outermost.
// Reference: IERS Conventions 2010, 7.1.2; Agnew's HARDISP
orr_status orr_ocean_loading_of(const orr_blq *blq, orr_ocean_loading *out, orr_diag *diag);

// Displacement at an instant: East, North and Up, m.
orr_vec3 orr_ocean_loading_m(const orr_ocean_loading *o, orr_time t);

#endif
