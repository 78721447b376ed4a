// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks of a solution beyond their last node. Room-internal.
#ifndef ORR_ORBIT_PREDICT_PREDICT_CLOCK_H
#define ORR_ORBIT_PREDICT_PREDICT_CLOCK_H

#include "orbit/smooth/solution.h"

// Appends predicted clock nodes, flagged, from the last one to `to` to satellites for which wanted[i] holds and whose
// clock goes on up to three hours before `end`. What all clocks of a system do together is taken away first and
// stays as it was at the last epoch.
// Given:
//   s       the solution
//   wanted  per satellite of it
//   end     where the positions end
//   to      how far
// Returned:
//   s       more clock nodes
//   n       satellites that have them
//   diag    ORR_E_MEMORY
orr_status orr_predict_clocks(orr_orbit_solution *s, const bool *wanted, orr_time end, orr_time to, size_t *n,
                              orr_diag *diag);

#endif
