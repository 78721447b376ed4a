// SPDX-License-Identifier: GPL-3.0-or-later
// Filter and smoother over a range of a track's instants, with the verdicts on its nodes as they are. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_FILTER_RANGE_H
#define ORR_ORBIT_SMOOTH_FILTER_RANGE_H

#include "orbit/smooth/leave_out.h"

// Where a file begins its orbit may be elsewhere by centimetres: in the filter's units, of which a node's coordinate is
// worth one millimetre and really a quarter of it.
#define ORR_FILE_STEP_R_M 0.1
#define ORR_FILE_STEP_V_MPS 2e-5
// Where a centre joins half-day arcs at noon its velocity has a step of micrometres a second, likewise in the filter's units.
#define ORR_NOON_STEP_MPS 1e-5
// What a satellite that was pushed may have changed by: about as free as at an arc's start.
#define ORR_ANEW_R_M 100.0
#define ORR_ANEW_V_MPS 1.0

typedef struct orr_verdict { // one per node
    bool rejected;
    // Of the first node of an instant: the orbit there is another than the one before, as after a push
    bool begins_anew;
    // Where another file begins and goes on elsewhere: how far from what the one before predicts
    double jump_m;
    // Of an end node that is used though it is far from the orbit through all others: how far. Which of the two is right nothing
    // tells, and sigma holds it.
    double doubt_m;
} orr_verdict;

// The filter without tests.
// Given:
//   c            context
//   list         nodes of the satellite
//   verdict      of each node: rejected ones are left out, and where one begins anew the state is free
//   t            the track, linearised
//   first, last  instants, both inclusive; the state is diffuse before the first
// Returned:
//   t            filtered states, and with each instant the squares of its innovations
void orr_filter_range(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t, size_t first, size_t last);
// The same for the squares alone: states stay as they are.
// Given:
//   c, list, verdict, first, last  as of orr_filter_range
// Returned:
//   t            with each instant the squares of its innovations
void orr_filter_sums(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                     orr_track *t, size_t first, size_t last);
// The smoother back over a range that was filtered.
// Given:
//   c, verdict   as they were when it was filtered
//   t            filtered states
//   first, last  the range, both inclusive
// Returned:
//   t            smoothed states in the place of the filtered ones, and the adjoint
//   fresh        [t->n], of the instants after the first: what would go on from there; NULL: not asked for
// Errors: ORR_E_NUMERIC.
orr_status orr_smooth_range(const orr_track_context *c, const orr_verdict *verdict, orr_track *t,
                            size_t first, size_t last, orr_fresh_start *fresh);

#endif
