// SPDX-License-Identifier: GPL-3.0-or-later
// Terms of a channel that change slowly: what they are at an instant, at a place (slow.c), and as cubics on a lattice of scenario
// time (slow_cell.c), whose error is tested in every cell.
#ifndef ORR_SCENARIO_CHANNEL_SLOW_H
#define ORR_SCENARIO_CHANNEL_SLOW_H

#include "src/scenario/channel/channels_private.h"

enum {                  // what a satellite has, shared by its signals
    SLOW_FLIGHT,        // light time, s: an estimate
    SLOW_SHAPIRO,       // m
    SLOW_HYDROSTATIC,   // m
    SLOW_WET,           // m
    SLOW_CONTENT,       // slant TEC, TECU
    SLOW_DISTURBANCE,   // beside it, TECU
    SLOW_CONTENT_FIELD, // slant TEC times the magnetic field along the signal's way at the shell, TECU T
    SLOW_APPROACH,      // -u.v / c, v inertial
    SLOW_S4,            // of scintillation, at 1575.42 MHz
    SLOW_SIGMA_PHI,     // rad, likewise
    SLOW_SOLID_TIDE,    // m
    SLOW_POLE_TIDE,     // m
    SLOW_OCEAN_LOADING, // m
    SLOW_TURNS,         // wind-up of a dipole along East and North, cycles
    SLOW_SHARED,
};
enum {                      // and each signal, SLOW_OF of them apart
    SLOW_SATELLITE_ANTENNA, // m
    SLOW_RECEIVER_ANTENNA,  // m; of a fixed antenna
    SLOW_POWER,             // dBW
    SLOW_OF,
};
enum { SLOW_MOST = (SLOW_SHARED + CHANNEL_MAX_SENT * SLOW_OF + 3) / 4 * 4 }; // whole vectors of 4
// Place of one of a signal's values; j counts the satellite's signals.
static inline size_t slow_of(size_t j, int what) { return SLOW_SHARED + j * SLOW_OF + (size_t)what; }
// How many values a satellite with so many signals has.
static inline size_t slow_count(size_t n_sent) { return SLOW_SHARED + n_sent * SLOW_OF; }

enum { SLOW_SLOPES = SLOW_DISTURBANCE - SLOW_HYDROSTATIC + 1 }; // delays that change by the metre

// Values at an instant of reception at a place, and what delays change by when the antenna stands a metre beside it.
typedef struct slow_values {
    bool ok;        // false: no arc or no ionosphere
    uint32_t flags; // FAST_TURN, NO_ANTENNA
    double v[SLOW_MOST];
    orr_vec3 per_m[SLOW_SLOPES]; // of SLOW_HYDROSTATIC and the next, where they are asked for
} slow_values;

// The values of some satellites.
// Given:
//   c, antenna  channels, and which antenna
//   work        workspace
//   t           instant of reception
//   at          the antenna then, or one near it
//   slopes      whether per_m is wanted
//   place       [n] satellites, their places in c->satellite
//   n           at most SLOW_BATCH
// Returned:
//   out         [n] values
enum { SLOW_BATCH = 64 };
void slow_at(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
             const orr_antenna_state *at, bool slopes, const uint16_t *place, size_t n, slow_values *out);

// Values and rates of one satellite at an instant.
typedef struct slow_now {
    bool ok;
    uint32_t flags;
    double v[SLOW_MOST], r[SLOW_MOST]; // r: by second of reception
} slow_now;

// Makes sure that the workspace has cells that hold t for some satellites: as slow_at, n without a limit.
// Given:
//   c, antenna, work  as slow_at
//   t                 instant of reception
//   at                the antenna then
//   place, n          satellites
void slow_prepare(const orr_channels *c, size_t antenna, orr_channel_work *work, orr_time t,
                  const orr_antenna_state *at, const uint16_t *place, size_t n);
// Values and rates of a prepared satellite; not ok where it has no channel. Given: as slow_prepare. Returned: out.
// A function of (scenario, t, at).
void slow_of_satellite(const orr_channels *c, size_t antenna, const orr_channel_work *work, orr_time t,
                       const orr_antenna_state *at, uint16_t place, slow_now *out);

// [n] cells without content, and [n] nodes: for a workspace; free with free. NULL: out of memory.
struct slow_cell *slow_cells_open(size_t n);
void slow_cells_forget(struct slow_cell *cell, size_t n); // leaves them without content
struct slow_node *slow_nodes_open(size_t n);

#endif
