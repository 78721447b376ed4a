// SPDX-License-Identifier: GPL-3.0-or-later
// A second look at an arc's verdicts, from both sides. The innovation of a node tells how far it is from what
// the nodes before it predict; where these are half an hour apart or more, that is metres, and an error of
// one metre is taken in and the good nodes after it are rejected. How far a node is from the orbit through all
// OTHERS is known a hundred times better (Baarda's w-test). Room-internal.
#ifndef ORR_ORBIT_SMOOTH_CROSS_CHECK_H
#define ORR_ORBIT_SMOOTH_CROSS_CHECK_H

#include "orbit/smooth/segmentation.h"

// One arc, filtered and smoothed: rejects nodes that are far from the orbit through the others, the worst first, takes
// back rejected ones that agree with it, and filters and smooths again.
// Given:
//   c, list          context and the satellite's nodes
//   verdict          of each node, from the filter
//   t                the track, filtered and smoothed over the arc
//   lowest, highest  instants that belong to no other arc
//   arc              first and last instant with a node that is used
// Returned:
//   verdict, t, arc  after the check; the arc may be longer or shorter within lowest..highest
// Errors: ORR_E_MEMORY, ORR_E_NUMERIC.
// Notes: an arc in which the orbit goes over from one file to another, or of few nodes, is left as it is.
orr_status orr_cross_check_arc(const orr_track_context *c, const orr_node *list, orr_verdict *verdict,
                               orr_track *t, size_t lowest, size_t highest, orr_arc_range *arc);

#endif
