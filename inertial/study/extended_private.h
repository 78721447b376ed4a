// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and quaternions of long double, for studies whose results fall below what a double resolves: errors of
// attitude algorithms are told down to 1e-13 of a drift that is itself some microradians. Conventions of core/vec.h.
#ifndef ORR_INERTIAL_STUDY_EXTENDED_PRIVATE_H
#define ORR_INERTIAL_STUDY_EXTENDED_PRIVATE_H

#include <math.h>

#include "core/vec.h"

typedef struct orr_xvec {
    long double x, y, z;
} orr_xvec;
typedef struct orr_xquat {
    long double w, x, y, z;
} orr_xquat;

#define ORR_PI_X 3.14159265358979323846264338327950288L

// a + b
static inline orr_xvec orr_xvec_add(orr_xvec a, orr_xvec b)
{
    return (orr_xvec){a.x + b.x, a.y + b.y, a.z + b.z};
}
// a + k b
static inline orr_xvec orr_xvec_axpy(long double k, orr_xvec b, orr_xvec a)
{
    return (orr_xvec){a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}
// a x b
static inline orr_xvec orr_xvec_cross(orr_xvec a, orr_xvec b)
{
    return (orr_xvec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Hamilton's product a b.
static inline orr_xquat orr_xquat_mul(orr_xquat a, orr_xquat b)
{
    return (orr_xquat){
        a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
// The conjugate, which is the inverse of a unit quaternion.
static inline orr_xquat orr_xquat_conj(orr_xquat a) { return (orr_xquat){a.w, -a.x, -a.y, -a.z}; }
// a / |a|
static inline orr_xquat orr_xquat_unit(orr_xquat a)
{
    const long double n = sqrtl(a.w * a.w + a.x * a.x + a.y * a.y + a.z * a.z);
    return (orr_xquat){a.w / n, a.x / n, a.y / n, a.z / n};
}
// Of the rotation vector g; a series where the angle is small.
static inline orr_xquat orr_xquat_from_rotvec(orr_xvec g)
{
    const long double n2 = g.x * g.x + g.y * g.y + g.z * g.z, n = sqrtl(n2);
    const long double s =
        n2 < 1e-6L ? 0.5L - n2 / 48 + n2 * n2 / 3840 - n2 * n2 * n2 / 645120 : sinl(n / 2) / n;
    return (orr_xquat){cosl(n / 2), s * g.x, s * g.y, s * g.z};
}
// The components in the older frame of a vector given in the newer one: transpose of the matrix of q, times v.
static inline orr_xvec orr_xquat_back(orr_xquat q, orr_xvec v)
{
    const orr_xquat p = orr_xquat_mul(orr_xquat_mul(q, (orr_xquat){0, v.x, v.y, v.z}), orr_xquat_conj(q));
    return (orr_xvec){p.x, p.y, p.z};
}

#endif
