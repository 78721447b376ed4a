// SPDX-License-Identifier: GPL-3.0-or-later
// Velocity from equally spaced positions, to judge velocities of a product by the truth's own positions.
//
// Positions (ecef) of a window of +-1 h (or 8 steps, whichever is longer) are turned into axes that
// coincide with ecef at the wanted epoch and do not rotate; what they have beyond a two-body orbit through
// that epoch is fitted by a polynomial, least squares, and the sum's derivative, turned into ecef (v - u x
// r), is the velocity. Least squares rather than interpolation, because SP3's rounding to 1 mm makes 3e-6
// m/s of a derivative interpolated at 5 min and below 5e-7 of this one. Truncation is below 1e-7 m/s, but
// 2e-6 at the perigee of e = 0.16 from positions 15 min apart. Near a file's ends the window is one-sided
// and rounding costs some 1e-5 m/s; within an hour of an edge of shadow the truth is no polynomial to
// better than some 1e-6 m/s.
#ifndef ORR_ORBIT_JUDGE_VELOCITY_FILTER_H
#define ORR_ORBIT_JUDGE_VELOCITY_FILTER_H

#include "core/status.h"
#include "core/vec.h"

typedef struct orr_velocity_filter {
    double step_s;
    size_t half, n; // the window has n = 2 half + 1 epochs
    double *weight; // [at][k]: derivative at epoch `at` of the window from position k, 1/s
    double *c, *s;  // cosine and sine of u k step, k = 0 .. n - 1
} orr_velocity_filter;

// step_s: 1 to 900 s. Errors: ORR_E_ARG, ORR_E_MEMORY, ORR_E_NUMERIC.
orr_status orr_velocity_filter_init(double step_s, orr_velocity_filter *f, orr_diag *diag);
// Frees what orr_velocity_filter_init allocated.
void orr_velocity_filter_free(orr_velocity_filter *f);
// Velocity at one of equally spaced positions.
// Given:
//   f        filter of that spacing
//   pos_m    [n] positions, ecef, m; NAN where there is none
//   n        how many
//   at       index of the wanted one
// Returned:
//   vel_mps  velocity, ecef, m/s, from the complete window that is centred best about it
//   gain_ps  what independent errors of the positions are multiplied by, 1/s; may be NULL
// Returns false where no complete window holds it.
bool orr_velocity_filter_at(const orr_velocity_filter *f, const orr_vec3 *pos_m, size_t n, size_t at,
                            orr_vec3 *vel_mps, double *gain_ps);

#endif
