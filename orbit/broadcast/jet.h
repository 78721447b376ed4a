// SPDX-License-Identifier: GPL-3.0-or-later
// A number with its first and second derivative by time, so that a formula written once gives position,
// velocity and acceleration exactly. Room-internal.
#ifndef ORR_ORBIT_BROADCAST_JET_H
#define ORR_ORBIT_BROADCAST_JET_H

#include <math.h>

typedef struct orr_jet {
    double v, d, dd;
} orr_jet;

// Given:
//   v, d, dd  value, first and second derivative by time
// Returned: the number.
static inline orr_jet orr_jet_make(double v, double d, double dd) { return (orr_jet){v, d, dd}; }
// a + b.
static inline orr_jet orr_jet_add(orr_jet a, orr_jet b)
{
    return (orr_jet){a.v + b.v, a.d + b.d, a.dd + b.dd};
}
// a - b.
static inline orr_jet orr_jet_sub(orr_jet a, orr_jet b)
{
    return (orr_jet){a.v - b.v, a.d - b.d, a.dd - b.dd};
}
// k a.
static inline orr_jet orr_jet_scale(double k, orr_jet a) { return (orr_jet){k * a.v, k * a.d, k * a.dd}; }
// a b, by the product rule.
static inline orr_jet orr_jet_mul(orr_jet a, orr_jet b)
{
    return (orr_jet){a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}
// f(a) with f' and f'' at a.v.
static inline orr_jet orr_jet_chain(orr_jet a, double f, double df, double ddf)
{
    return (orr_jet){f, df * a.d, ddf * a.d * a.d + df * a.dd};
}
// sin a; a in rad.
static inline orr_jet orr_jet_sin(orr_jet a) { return orr_jet_chain(a, sin(a.v), cos(a.v), -sin(a.v)); }
// cos a; a in rad.
static inline orr_jet orr_jet_cos(orr_jet a) { return orr_jet_chain(a, cos(a.v), -sin(a.v), -cos(a.v)); }

#endif
