// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/force/ecom.h"

#include "orbit/force/orbit_class.h"
#include "orbit/force/shadow.h"

// Whether the panels' axis is along the orbit's normal.
static bool keeps_normal(orr_vec3 r, orr_vec3 v) { return orr_orbit_class_of(r, v) == ORR_ORBIT_GEO; }

const double *orr_ecom_sigma_nmps2(orr_vec3 r, orr_vec3 v)
{
    static const double facing[ORR_ECOM_TERMS] = {30, 3, 3, 5, 5, 5, 5, 3, 3},
                        normal[ORR_ECOM_TERMS] = {30, 30, 3, 5, 5, 5, 5, 3, 3};
    return keeps_normal(r, v) ? normal : facing;
}

void orr_ecom_basis(orr_vec3 r, orr_vec3 v, orr_vec3 sun, orr_vec3 basis[ORR_ECOM_TERMS])
{
    const orr_vec3 radial = orr_vec3_unit(r), cross = orr_vec3_unit(orr_vec3_cross(r, v));
    orr_vec3 d = orr_vec3_sub(sun, r);
    const double distance = orr_vec3_norm(d), au = ORR_AU_M / distance;
    d = orr_vec3_scale(1.0 / distance, d);
    const orr_vec3 axis =
        keeps_normal(r, v) ? orr_vec3_axpy(-orr_vec3_dot(d, cross), d, cross) : orr_vec3_cross(radial, d);
    const orr_vec3 y = orr_vec3_unit(axis), b = orr_vec3_cross(d, y);
    const orr_vec3 zero = orr_vec3_unit(orr_vec3_axpy(-orr_vec3_dot(d, cross), cross, d)); // u counts from it
    const double c = orr_vec3_dot(radial, zero), s = orr_vec3_dot(radial, orr_vec3_cross(cross, zero));
    const double c2 = c * c - s * s, s2 = 2 * s * c, c4 = c2 * c2 - s2 * s2, s4 = 2 * s2 * c2;
    const double unit = 1e-9 * au * au, lit = unit * orr_force_sunlight_fast(r, sun);
    basis[0] = orr_vec3_scale(lit, d);
    basis[1] = orr_vec3_scale(unit, y);
    basis[2] = orr_vec3_scale(unit, b);
    basis[3] = orr_vec3_scale(unit * c, b);
    basis[4] = orr_vec3_scale(unit * s, b);
    basis[5] = orr_vec3_scale(lit * c2, d);
    basis[6] = orr_vec3_scale(lit * s2, d);
    basis[7] = orr_vec3_scale(lit * c4, d);
    basis[8] = orr_vec3_scale(lit * s4, d);
}
