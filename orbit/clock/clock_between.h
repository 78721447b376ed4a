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
// Beside a node its own white noise is known, further away that of another instant.
#define ORR_CLOCK_WHITE_REACH 0.125

// One interval between nodes.
typedef struct orr_clock_interval {
    double length_s;
    double clock_s, rate_sps;             // the line, from the first node on
    double bend_first_sps, bend_last_sps; // what the rate at the nodes is beyond the line's
} orr_clock_interval;

// The clock and its rate a part of the way (0 to 1) into an interval: C1 where both sides of a node have one rate there.
static inline void orr_clock_interval_at(const orr_clock_interval *c, double part, double *clock_s,
                                         double *rate_sps)
{
    const double room = ORR_CLOCK_ROUNDED, from_last = 1 - part;
    *clock_s = c->clock_s + c->rate_sps * (part * c->length_s);
    *rate_sps = c->rate_sps;
    if (part < room) {
        const double u = part / room;
        *clock_s += c->bend_first_sps * (room * c->length_s) * (u * (1 - u) * (1 - u));
        *rate_sps += c->bend_first_sps * ((1 - u) * (1 - 3 * u));
    } else if (from_last < room) {
        const double u = from_last / room;
        *clock_s -= c->bend_last_sps * (room * c->length_s) * (u * (1 - u) * (1 - u));
        *rate_sps += c->bend_last_sps * ((1 - u) * (1 - 3 * u));
    }
}

// Variance of what the clock is off the line between two nodes, a part of the way into an interval of length_s:
// a random walk held at both ends wanders by q h p (1 - p), one whose frequency wanders by q h^3 p^2 (1 - p)^2 / 3 (the
// square of the Green function of a string held at both ends); white noise of both nodes and of the instant itself.
// The shared noise of all clocks of the product is in it.
static inline double orr_clock_between_s2(const orr_clock_noise *n, double length_s, double part)
{
    const double q = 1 - part, near = part < q ? part : q, u = near / ORR_CLOCK_WHITE_REACH;
    const double apart = u < 1 ? u * u * (3 - 2 * u) : 1;
    return apart * n->white_s2 * (1 + part * part + q * q) + n->wfm_s2ps * length_s * part * q +
           n->rwfm_s2ps3 * length_s * length_s * length_s * part * part * q * q / 3;
}

// How the clocks of a product wander between their nodes.
// Given:
//   clocks     clocks; jumps are flagged
//   max_gap_s  neighbours are nodes up to so far apart
// Returned:
//   noise      [clocks->n] of each, for orr_clock_between_s2; all NAN where nothing tells it
// Errors: ORR_E_MEMORY.
// Notes: from second differences of one and two of a satellite's usual steps, which a constant rate has no part in (the
// Allan variance under another name), after steps and ramps of the reference are taken away. A satellite with fewer than
// five of them has the median of its system's.
orr_status orr_clock_between_noise(const orr_clock_table *clocks, double max_gap_s, orr_clock_noise *noise);

#endif
