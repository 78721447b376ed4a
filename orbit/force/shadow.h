// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's shadow on a satellite.
#ifndef ORR_ORBIT_FORCE_SHADOW_H
#define ORR_ORBIT_FORCE_SHADOW_H

#include "core/vec.h"

// Distance of the Sun's centre from the Earth's limb as seen from r, in radii of the Sun's disc, positive
// outside: below -1 is umbra, between -1 and 1 penumbra. Infinite on the day side.
double orr_force_limb_distance(orr_vec3 r_m, orr_vec3 sun_m);
// Part of the Sun's disc that the Earth leaves uncovered: 1 in sunlight, 0 in umbra. The Earth's limb is
// taken as a straight line over the disc (it is 50 times wider), which is exact to 1 % of the penumbra.
double orr_force_sunlight(orr_vec3 r_m, orr_vec3 sun_m);
// The same, without trigonometry where the satellite is well outside the shadow.
double orr_force_sunlight_fast(orr_vec3 r_m, orr_vec3 sun_m);

#endif
