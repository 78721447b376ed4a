// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a solution: a day that was smoothed together with the hours around it.
#ifndef ORR_ORBIT_SMOOTH_SOLUTION_CUT_H
#define ORR_ORBIT_SMOOTH_SOLUTION_CUT_H

#include "orbit/smooth/solution.h"

// Leaves of a solution what concerns [from, to]: whole segments that reach into it, clocks from the last node not after
// `from` to the first not before `to`, nodes within, events that overlap it. Satellites without an arc there are gone.
// What is left is as it was, to the bit.
void orr_orbit_solution_cut(orr_orbit_solution *s, orr_time from, orr_time to);

#endif
