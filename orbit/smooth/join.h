// SPDX-License-Identifier: GPL-3.0-or-later
// Where one file ends and the next one begins elsewhere, the filter admits a step; the product goes over from one orbit to
// the other within hours. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_JOIN_H
#define ORR_ORBIT_SMOOTH_JOIN_H

#include "orbit/smooth/segmentation.h"

// What is added to the smoothed orbit at a point of the grid so that it has no step.
typedef struct orr_join {
    orr_vec3 r_m, v_mps, a_mps2; // a: beyond what the force at the moved place gives
    bool between_files;          // neither file's own orbit
} orr_join;

// The step at an instant as the smoother sees it, its variance times u: position and velocity, integration axes.
void orr_join_step(const orr_instant *at, double step[6]);

// For every point of the track's grid, after filter and smoother. Each orbit goes on beyond the joint as the variational
// equations tell, and a polynomial with three continuous derivatives weighs one against the other. *out is NULL where
// there is no joint; else free it. ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_join_files(const orr_track_context *c, orr_track *t, orr_join **out);

#endif
