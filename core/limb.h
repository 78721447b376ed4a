// SPDX-License-Identifier: GPL-3.0-or-later
// What the Earth hides: lines of sight against the ellipsoid (WGS 84), raised by a height.
#ifndef ORR_CORE_LIMB_H
#define ORR_CORE_LIMB_H

#include <stdbool.h>

#include "core/vec.h"

// Where space begins for what is modelled: above it there is no troposphere, and lines that pass below it are hidden, because what
// the air does to a ray that grazes it (bending, spreading) is not computed.
#define ORR_SPACE_HEIGHT_M 100e3

// Whether a place (ecef) is higher than ORR_SPACE_HEIGHT_M; right to 10 m.
bool orr_limb_in_space(orr_vec3 r_m);
// Whether the straight line from a place to another passes below a height above the ellipsoid between them. The surface of that
// height is taken as an ellipsoid with axes longer by it, which is right to 10 m at 100 km. Places that are themselves below it
// see nothing below their own level.
bool orr_limb_hides(orr_vec3 r_m, orr_vec3 target_m, double height_m);

#endif
