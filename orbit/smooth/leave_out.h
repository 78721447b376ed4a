// SPDX-License-Identifier: GPL-3.0-or-later
// What a smoothed track tells of each of its nodes and steps by itself, from both sides and without a second
// run: how far a node is from the orbit through all OTHERS (Baarda's data snooping), and what orbit would
// go on from an instant if it were free to begin anew there (de Jong and Penzer 1998, Diagnosing shocks in
// time series). Room-internal.
#ifndef ORR_ORBIT_SMOOTH_LEAVE_OUT_H
#define ORR_ORBIT_SMOOTH_LEAVE_OUT_H

#include "orbit/smooth/track.h"

// A node against the orbit without it: its distance, and the normalised square of that, over 3.
typedef struct orr_left_out {
    double length_m, d2;
} orr_left_out;

// Distance of a node of instant `at` from the smoothed orbit, as it would be without the node where it was used.
// Zero where all others do not tell an orbit.
orr_left_out orr_leave_node_out(const orr_track_context *c, const orr_instant *at, const orr_node *node,
                                bool used);

// What an instant's position and velocity change by if they may, and how much less the normalised squares of all
// nodes are then.
typedef struct orr_fresh_start {
    bool told; // the orbits before and after it are known
    double gain;
    orr_vec3 r_m, v_mps;
} orr_fresh_start;

// Given:
//   predicted  state of an instant after the range's first one, before its nodes
//   smoothed   the same, smoothed
//   u          the smoother's adjoint there
//   nx         states that are used
// Returned:
//   value      told is false where the orbit before the instant, or after it, is not known
orr_fresh_start orr_fresh_start_at(const orr_gauss *predicted, const orr_gauss *smoothed,
                                   const double u[ORR_NX], int nx);

#endif
