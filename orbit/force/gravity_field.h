// SPDX-License-Identifier: GPL-3.0-or-later
// Gravitation of the Earth at a point of ecef, for orbit integration: central term and harmonics of EGM96, or of a model
// of the user's, which may have more of them.
#ifndef ORR_ORBIT_FORCE_GRAVITY_FIELD_H
#define ORR_ORBIT_FORCE_GRAVITY_FIELD_H

#include "core/earth.h"
#include "core/status.h"
#include "core/vec.h"

#define ORR_GRAVITY_MAX_DEGREE 21

typedef struct orr_gravity_field {
    int degree, order;
    double c[ORR_GRAVITY_MAX_DEGREE + 1][ORR_GRAVITY_MAX_DEGREE + 1]; // unnormalised
    double s[ORR_GRAVITY_MAX_DEGREE + 1][ORR_GRAVITY_MAX_DEGREE + 1];
    // factors of the recursion in degree, (2n - 1)/(n - m) and (n + m - 1)/(n - m)
    double first[ORR_GRAVITY_MAX_DEGREE + 2][ORR_GRAVITY_MAX_DEGREE + 2];
    double second[ORR_GRAVITY_MAX_DEGREE + 2][ORR_GRAVITY_MAX_DEGREE + 2];
    // Summed instead of all that, where the field has harmonics at all; borrowed. NULL: none. Tides and gradients are still
    // those of the above.
    const orr_gravity_model *model;
} orr_gravity_field;

// degree 0 (or 1): the central term alone; zonal_only keeps order 0 (degree 2 then is "J2 only").
// ORR_E_ARG outside 0..ORR_GRAVITY_MAX_DEGREE.
orr_status orr_gravity_field_init(orr_gravity_field *f, int degree, bool zonal_only, orr_diag *diag);
// The highest degree that is summed.
int orr_gravity_field_degree(const orr_gravity_field *f);
// Gravitation (no centrifugal part) at r (ecef, m), m/s^2 in ecef axes.
orr_vec3 orr_gravity_field_gravitation(const orr_gravity_field *f, orr_vec3 r_m);
// The same with changes of the (unnormalised) coefficients of degree 2: C20, C21, S21, C22, S22. The field's
// degree is 2 at least.
orr_vec3 orr_gravity_field_with_tide(const orr_gravity_field *f, const double tide[5], orr_vec3 r_m);

#endif
