// SPDX-License-Identifier: GPL-3.0-or-later
// A satellite over a few seconds: its place as quintics, its clock and the clock's relativity as cubics, on a fixed lattice of
// scenario time. A tenth of what the product's own segments cost, and equal to them to their rounding.
#ifndef ORR_SCENARIO_CHANNEL_SATELLITE_CELL_H
#define ORR_SCENARIO_CHANNEL_SATELLITE_CELL_H

#include "orbit/ephemeris/ephemeris.h"

#define LATTICE_NS (10 * ORR_NS_PER_S)     // cells are as long as this, or halves of it
#define LATTICE_LEAST_NS (LATTICE_NS / 16) // but not shorter
// Begin of the lattice's cell that holds t.
static inline orr_time lattice_cell(orr_time t) { return t - orr_floor_mod(t, LATTICE_NS); }

typedef struct satellite_cell {
    orr_time from, to; // [from, to); the same: nothing is kept
    bool curves;       // else the product is asked each time
    uint32_t flags;    // of the product
    double x[6][4]; // coefficients of s^j, s the seconds since `from`: x, y, z [m], and c times the clock [m]
    double relativity[4];
} satellite_cell;

// The satellite at an instant, ecef axes of then.
typedef struct satellite_state {
    orr_vec3 pos_m, vel_mps;
    double clock_m, clock_rate_mps;           // c times the product's clock; 0 where it has none
    double relativity_m, relativity_rate_mps; // c times its periodic relativity, taken away: + 2 r.v / c
    uint32_t flags;                           // of the product
} satellite_state;

// The state `before_s` seconds before t.
// Given:
//   e         orbits
//   sat       satellite
//   cell      [2] what was found before, of this satellite alone; all zero at first
//   t         instant
//   before_s  seconds before it, 0 or more
// Returned:
//   cell      likewise
//   out       the state
// Returns false where it has no arc. A function of (product, t - before_s): what `cell` holds changes no digit.
bool satellite_at(const orr_ephemeris *e, orr_sat sat, satellite_cell cell[2], orr_time t, double before_s,
                  satellite_state *out);

#endif
