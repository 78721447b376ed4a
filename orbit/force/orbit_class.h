// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of orbits, as users of navigation satellites tell them apart.
#ifndef ORR_ORBIT_FORCE_ORBIT_CLASS_H
#define ORR_ORBIT_FORCE_ORBIT_CLASS_H

#include "core/vec.h"
#include "orbit/force/gravity_field.h"

typedef enum orr_orbit_class { // geosynchronous ones inclined by more or by less than 15 deg, and the rest
    ORR_ORBIT_MEO,
    ORR_ORBIT_IGSO,
    ORR_ORBIT_GEO,
    ORR_ORBIT_CLASSES // how many; "any" where a class is asked for
} orr_orbit_class;

// By one state: position in ecef and the inertial velocity in its axes (v + u x r).
static inline orr_orbit_class orr_orbit_class_of(orr_vec3 r, orr_vec3 v_inertial)
{
    const double a = 1 / (2 / orr_vec3_norm(r) - orr_vec3_dot(v_inertial, v_inertial) / ORR_EGM96_GM);
    if (!(a > 4e7)) return ORR_ORBIT_MEO;
    const orr_vec3 normal = orr_vec3_unit(orr_vec3_cross(r, v_inertial));
    return normal.z > cos(15 * ORR_RAD_PER_DEG) ? ORR_ORBIT_GEO : ORR_ORBIT_IGSO;
}

#endif
