// SPDX-License-Identifier: GPL-3.0-or-later
// A clock between two of its nodes: the line, which is the best that can be said of a random walk, rounded beside the
// nodes so that the rate has no steps; and how far the clock wanders from it.
#ifndef ORR_ORBIT_CLOCK_CLOCK_BETWEEN_H
#define ORR_ORBIT_CLOCK_CLOCK_BETWEEN_H

#include "core/status.h"
#include "orbit/clock/clock_noise.h"
#include "orbit/clock/clock_sources.h"

// Within this part of an interval beside each node the line is rounded. Measured with nodes withheld: curves that leave
// the line over the whole interval (monotone cubic, spline) cost old rubidium clocks 3 to 8 per cent of accuracy and gain
// nothing elsewhere; this one costs 0.3 per cent.
#define ORR_CLOCK_ROUNDED 0.25
// What is white noise from node to node is correlated over minutes: (1 + tau / 300 s)^-2, a covariance since it is
// convex. Old rubidium clocks between nodes of 5 min and of 15 min ask for about so much.
#define ORR_CLOCK_WHITE_S 300.0

// That correlation of two instants tau_s apart.
static inline double orr_clock_white_correlation(double tau_s)
{
    const double r = 1 / (1 + tau_s / ORR_CLOCK_WHITE_S);
    return r * r;
}

// One interval between nodes.
typedef struct orr_clock_interval {
    double length_s;
    double clock_s, rate_sps;             // the line, from the first node on
    double bend_first_sps, bend_last_sps; // what the rate at the nodes is beyond the line's
} orr_clock_interval;

// Several clocks side by side, as a vector unit takes them.
enum { ORR_CLOCK_LANES = 4 };
typedef double orr_clock_lanes __attribute__((vector_size(ORR_CLOCK_LANES * sizeof(double)), may_alias));
typedef int64_t orr_clock_mask __attribute__((vector_size(ORR_CLOCK_LANES * sizeof(int64_t)), may_alias));

typedef struct orr_clock_intervals {
    orr_clock_lanes length_s, clock_s, rate_sps, bend_first_sps, bend_last_sps;
} orr_clock_intervals;

typedef struct orr_clock_noises {
    orr_clock_lanes white_s2, wfm_s2ps, rwfm_s2ps3;
} orr_clock_noises;

// One clock: orr_clock_interval_at, orr_clock_between_s2.
#define NUMBER double
#define WHERE(condition, x) ((condition) ? (x) : 0)
#define INTERVAL orr_clock_interval
#define NOISE orr_clock_noise
#define INTERVAL_AT orr_clock_interval_at
#define BETWEEN_S2 orr_clock_between_s2
#include "orbit/clock/clock_formulas.h"
// Four: orr_clock_intervals_at, orr_clock_betweens_s2. The same bits.
#define NUMBER orr_clock_lanes
#define WHERE(mask, x) ((orr_clock_lanes)((mask) & (orr_clock_mask)(x)))
#define INTERVAL orr_clock_intervals
#define NOISE orr_clock_noises
#define INTERVAL_AT orr_clock_intervals_at
#define BETWEEN_S2 orr_clock_betweens_s2
#include "orbit/clock/clock_formulas.h"

// How the clocks of a product wander between their nodes.
// Given:
//   clocks     clocks; jumps are flagged
//   max_gap_s  neighbours are nodes up to so far apart
// Returned:
//   noise      [clocks->n] of each, for orr_clock_between_s2; all NAN where nothing tells it
// Errors: ORR_E_MEMORY.
// Notes: from second differences of one and two of a satellite's usual steps, which a constant rate has no part in (the
// Allan variance under another name), after what all clocks of the system do together is taken away: the reference clock's
// doing, which no receiver sees. Where fewer than five satellites tell that, its steps and ramps alone are. A satellite
// with fewer than five differences has the median of its system's.
orr_status orr_clock_between_noise(const orr_clock_table *clocks, double max_gap_s, orr_clock_noise *noise);

#endif
