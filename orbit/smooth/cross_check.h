// SPDX-License-Identifier: GPL-3.0-or-later
// A second look at an arc's verdicts, from both sides. The innovation of a node tells how far it is from what
// the nodes before it predict; where these are half an hour apart or more, that is metres, and an error of
// one metre is taken in and the good nodes after it blamed. How far a node is from the orbit through all
// OTHERS is known a hundred times better (Baarda's data snooping). Room-internal.
#ifndef ORR_ORBIT_SMOOTH_CROSS_CHECK_H
#define ORR_ORBIT_SMOOTH_CROSS_CHECK_H

#include "orbit/smooth/segmentation.h"

// One arc, filtered and smoothed: rejects nodes that are far from the orbit through the others, the worst
// first, takes back rejected ones that agree with it, and filters and smooths again. arc (of nodes that are
// used) may become longer or shorter within lowest..highest, instants that belong to no other arc. An arc in
// which the orbit goes over from one file to another, or of few nodes, is left as it is. ORR_E_MEMORY,
// ORR_E_NUMERIC.
orr_status orr_snoop_arc(const orr_track_context *c, const orr_node *list, orr_verdict *verdict, orr_track *t,
                         size_t lowest, size_t highest, orr_arc_range *arc);

#endif
