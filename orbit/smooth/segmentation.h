// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes of a track are wrong, and where a push ends one orbit and begins the next: every node is judged
// against the orbit through all others, and every step by what a fresh start there would gain. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_SEGMENTATION_H
#define ORR_ORBIT_SMOOTH_SEGMENTATION_H

#include "orbit/smooth/filter_range.h"

// An arc: instants of the track between its first and last node, both inclusive.
typedef struct orr_arc_range {
    size_t first, last;
} orr_arc_range;

typedef struct orr_segmentation {
    size_t n_arcs;
    orr_arc_range *arc;   // ascending
    orr_verdict *verdict; // per node of the list
} orr_segmentation;

// Judges the nodes: those that are far from the orbit through all others, in units of what is usual for the satellite,
// are rejected; where a push explains more at less cost, one arc ends and the next one begins.
// Given:
//   c            context; options->detect switches the tests off
//   list, n      nodes of the satellite
//   node_step_s  usual distance of nodes, s
//   t            the track, linearised
// Returned:
//   t            predicted, filtered and smoothed states of the arcs
//   out          arcs, and a verdict on each node; free with orr_segmentation_free
// Errors: ORR_E_MEMORY, ORR_E_NODATA (no usable node), ORR_E_NUMERIC.
orr_status orr_segment_track(const orr_track_context *c, const orr_node *list, size_t n, double node_step_s,
                             orr_track *t, orr_segmentation *out);
// Frees arcs and verdicts; a zeroed one is allowed.
void orr_segmentation_free(orr_segmentation *s);

#endif
