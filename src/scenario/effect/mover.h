// SPDX-License-Identifier: GPL-3.0-or-later
// A place that moves on a straight line: of reflectors, jammers and spoofers.
#ifndef ORR_SCENARIO_EFFECT_MOVER_H
#define ORR_SCENARIO_EFFECT_MOVER_H

#include "core/earth.h"
#include "src/config/schema.h"

typedef struct orr_mover {
    orr_vec3 r_m, v_mps; // at `from`, ecef
    orr_time from;
} orr_mover;

// By a scenario's position (latitude and longitude in degrees, height in metres) and velocity (East, North, Up; none: it stands).
orr_mover orr_mover_of(const orr_real_list *position, const orr_real_list *velocity_mps, orr_time from);
// Where it is at t.
static inline orr_vec3 orr_mover_at(const orr_mover *m, orr_time t)
{
    return orr_vec3_axpy(orr_time_diff_s(t, m->from), m->v_mps, m->r_m);
}

#endif
