// SPDX-License-Identifier: GPL-3.0-or-later
// What the weight of the ocean's tides does to the ground below an antenna.
#ifndef ORR_SCENARIO_EFFECT_OCEAN_LOADING_H
#define ORR_SCENARIO_EFFECT_OCEAN_LOADING_H

#include "core/time.h"
#include "core/vec.h"
#include "ingest/tables/blq.h"

// Displacement, East, North and Up, m.
// Given:
//   blq  the station's loading
//   t    instant
// Notes: the eleven constituents with their nodal factors. What the IERS' HARDISP takes from 342 of them departs from this by up to
// half a millimetre (measured on its published case of Onsala).
// Reference: IERS Conventions 2010, 7.1.2, eq. (7.15); nodal factors: Doodson 1928 as Pugh 1987, table 4:3, lists them.
orr_vec3 orr_ocean_loading_m(const orr_blq *blq, orr_time t);

#endif
