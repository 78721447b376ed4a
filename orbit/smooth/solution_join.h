// SPDX-License-Identifier: GPL-3.0-or-later
// Two solutions that overlap made one: the earlier before, the later after, and over some hours from one to the other.
#ifndef ORR_ORBIT_SMOOTH_SOLUTION_JOIN_H
#define ORR_ORBIT_SMOOTH_SOLUTION_JOIN_H

#include "core/status.h"
#include "orbit/smooth/solution.h"

// Joins two solutions about an instant.
// Given:
//   a, b      the earlier and the later; both cover `middle` and half_s to either side of it
//   middle    where they have equal weight, and where clocks, nodes and events go over from one to the other
//   half_s    half the time of going over, s
// Returned:
//   out       the joined solution; a and b are as they were. Free with orr_orbit_solution_free whatever this returned
//   diag      ORR_E_MEMORY
// Notes:
//   1. Within middle -+ half_s the orbit is a + w (b - a), w = s^3 (10 - 15 s + 6 s^2): position, velocity and acceleration
//      go over without a step, and velocity and acceleration are the derivatives of position.
//   2. A satellite that has a break there (a manoeuvre, a gap) goes over in the shorter stretch that both have unbroken; where
//      there is none, its orbit ends and begins anew at `middle`.
//   3. UT1 of b is shifted to that of a at `middle`: orbits tell its rate alone, and every solution starts it anew.
orr_status orr_orbit_solution_join(const orr_orbit_solution *a, const orr_orbit_solution *b, orr_time middle,
                                   double half_s, orr_orbit_solution *out, orr_diag *diag);

#endif
