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
// square of the Green function of a string held at both ends); white noise of both nodes and of the instant itself, as
// far as they are not one (orr_clock_white_correlation). What all clocks of a system do together is not in it.
static inline double orr_clock_between_s2(const orr_clock_noise *n, double length_s, double part)
{
    const double p = part, q = 1 - part, h = length_s;
    const double apart = 1 + p * p + q * q + 2 * p * q * orr_clock_white_correlation(h) -
                         2 * q * orr_clock_white_correlation(p * h) -
                         2 * p * orr_clock_white_correlation(q * h);
    return n->white_s2 * (apart > 0 ? apart : 0) + n->wfm_s2ps * h * p * q +
           n->rwfm_s2ps3 * h * h * h * p * p * q * q / 3;
}

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
