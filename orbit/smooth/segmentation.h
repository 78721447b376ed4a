// SPDX-License-Identifier: GPL-3.0-or-later
// The forward filter over a track, with its verdicts: which nodes are outliers, where a manoeuvre ends one
// arc and begins the next. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_SEGMENTATION_H
#define ORR_ORBIT_SMOOTH_SEGMENTATION_H

#include "orbit/smooth/track.h"

// Where a file begins its orbit may be elsewhere by centimetres: in the filter's units, of which a node's coordinate is
// worth one millimetre and really a quarter of it.
#define ORR_FILE_STEP_R_M 0.1
#define ORR_FILE_STEP_V_MPS 2e-5

typedef struct orr_verdict { // one per node
    bool rejected;
    // Where another file begins and goes on elsewhere: how far from what the one before predicts
    double jump_m;
} orr_verdict;

// An arc: instants of the track between its first and last node, both inclusive.
typedef struct orr_arc_range {
    size_t first, last;
} orr_arc_range;

typedef struct orr_segmentation {
    size_t n_arcs;
    orr_arc_range *arc;   // ascending
    orr_verdict *verdict; // per node of the list
} orr_segmentation;

// Runs the filter with tests of the innovations.
// Given:
//   c        context; options->detect switches the tests off
//   list, n  nodes of the satellite
//   t        the track, linearised
// Returned:
//   t        predicted and filtered states
//   out      arcs, and a verdict on each node; free with orr_segmentation_free
// Errors: ORR_E_MEMORY, ORR_E_NODATA (no usable node).
orr_status orr_segment_track(const orr_track_context *c, const orr_node *list, size_t n, orr_track *t,
                             orr_segmentation *out);
// Frees arcs and verdicts; a zeroed one is allowed.
void orr_segmentation_free(orr_segmentation *s);

// The filter without tests.
// Given:
//   c            context
//   list         nodes of the satellite
//   verdict      of each node: rejected ones are left out
//   t            the track, linearised
//   first, last  instants, both inclusive; the state is diffuse before the first
// Returned:
//   t            predicted and filtered states
void orr_filter_range(const orr_track_context *c, const orr_node *list, const orr_verdict *verdict,
                      orr_track *t, size_t first, size_t last);
// The smoother back over the same range. ORR_E_NUMERIC.
orr_status orr_smooth_range(const orr_track_context *c, orr_track *t, size_t first, size_t last);

#endif
