// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and tunnels: which rays do not arrive. A pure function of scenario, time and place.
#ifndef ORR_SCENARIO_EFFECT_OBSTACLE_H
#define ORR_SCENARIO_EFFECT_OBSTACLE_H

#include "src/scenario/antenna/antenna.h"

typedef struct orr_obstacles orr_obstacles;
// Prepares the section; *out NULL without it. ORR_E_MEMORY. Free with orr_obstacles_close.
orr_status orr_obstacles_open(const orr_scenario *s, orr_obstacles **out, orr_diag *diag);
void orr_obstacles_close(orr_obstacles *o); // NULL is allowed

// Whether an antenna in `at` receives nothing at all, being in a tunnel; o NULL: no.
bool orr_obstacles_tunnel(const orr_obstacles *o, const orr_antenna_state *at, orr_time as_of);
// Whether a wall stands between an antenna and what lies in the direction u (unit vector, ecef); o NULL: no.
bool orr_obstacles_wall(const orr_obstacles *o, const orr_antenna_state *at, orr_vec3 u);
// Whether a tunnel begins or ends by its time in after < t <= until.
bool orr_obstacles_change(const orr_obstacles *o, orr_time after, orr_time until);
// Whether all that do so in [from, to) do it on a multiple of length_ns.
bool orr_obstacles_allow(const orr_obstacles *o, orr_time from, orr_time to, int64_t length_ns);

#endif
