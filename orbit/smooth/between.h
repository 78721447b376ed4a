// SPDX-License-Identifier: GPL-3.0-or-later
// The smoothed orbit at every point of the grid, from what the smoother left at the instants. Room-internal.
#ifndef ORR_ORBIT_SMOOTH_BETWEEN_H
#define ORR_ORBIT_SMOOTH_BETWEEN_H

#include "orbit/smooth/track.h"

// The mean of the smoothed state at the grid points of one interval. Noise of the steps is what the instants' adjoint u
// tells (Bryson and Frazier).
// Given:
//   c, t  context and the track, filtered and smoothed
//   k     the interval from instant k to k + 1
// Returned:
//   x     deviations from the grid's states at points at[k].grid to at[k + 1].grid - 1, the first one in x[0]
//   b     working room, as many vectors as x
// Errors: ORR_E_NUMERIC.
orr_status orr_track_between(const orr_track_context *c, orr_track *t, size_t k, double (*x)[ORR_NX],
                             double (*b)[ORR_NW]);

#endif
