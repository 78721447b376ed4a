// SPDX-License-Identifier: GPL-3.0-or-later
// A-priori states at the nodes, variant B: from the sparse positions alone (Bogdanov 2015, section 6, stage
// 1). Room-internal.
#ifndef ORR_ORBIT_SMOOTH_PRIOR_H
#define ORR_ORBIT_SMOOTH_PRIOR_H

#include "orbit/smooth/track.h"

// Position: the node's. Velocity: derivative of the polynomial through up to ten nearest nodes of the same
// unbroken stretch, in integration axes; where fewer than three stand together, that of a circular orbit
// towards the nearest other node. Good to 1e-5 m/s inside 15-minute nodes, to some m/s in hourly ones: the
// passes of the smoother do the rest.
// Given:
//   c            context
//   list, n      nodes of the satellite
//   node_step_s  usual distance of nodes, s
// Returned:
//   reference    per node; invalid where nothing else lies within half a revolution
void orr_prior_sparse(const orr_track_context *c, const orr_node *list, size_t n, double node_step_s,
                      orr_reference *reference);

// Variant A: position and velocity of the broadcast orbit, where the navigation file has a record; the rest
// as of orr_prior_sparse.
// Given:
//   c            context with broadcast ephemerides in its options
//   sat          the satellite
//   list, n      its nodes
//   node_step_s  usual distance of nodes, s
// Returned:
//   reference    per node
//   value        how many nodes have a broadcast state
size_t orr_prior_broadcast(const orr_track_context *c, orr_sat sat, const orr_node *list, size_t n,
                           double node_step_s, orr_reference *reference);

#endif
