// SPDX-License-Identifier: GPL-3.0-or-later
// Phase wind-up: a circularly polarised carrier counts the turns of its antennas. It is the same number of
// cycles on both carriers, so it does not cancel in metres: 0.513 TECU a turn for GPS L1/L2 (Wu et al. 1993).
#ifndef ORR_IONO_PHASE_WINDUP_H
#define ORR_IONO_PHASE_WINDUP_H

#include "core/vec.h"
#include "iono/field/pierce.h"

// Cycles to SUBTRACT from both measured carrier phases, continued from `before` (cycles of the epoch before;
// the nearest whole turn is taken; 0 to start). The satellite keeps nominal yaw (z to the Earth, y across the
// Sun), sun_m is the Sun's ecef position; the receiver's antenna stands still in enu.
double orr_windup_turns(const orr_iono_site *site, orr_vec3 sat_m, orr_vec3 sun_m, double before);
// The same for a satellite whose attitude is known.
// Given:
//   site          receiver; its antenna stands still in enu
//   sat_m         satellite, ecef
//   sat_x, sat_y  its body axes, unit vectors, ecef
//   before        cycles of the epoch before; 0 to start
// Returned: cycles to SUBTRACT from both measured carrier phases, the nearest whole turn to `before` taken.
// Reference: Wu et al. 1993, eqs. (23) and (24).
double orr_windup_axes(const orr_iono_site *site, orr_vec3 sat_m, orr_vec3 sat_x, orr_vec3 sat_y,
                       double before);

#endif
