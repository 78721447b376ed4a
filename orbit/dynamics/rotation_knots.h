// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections of the Earth's rotation as a curve through knots: pole and UT1 at the borders of windows, cubic
// between (slopes of a parabola through three knots, as core/astro's series has them). Room-internal.
#ifndef ORR_ORBIT_DYNAMICS_ROTATION_KNOTS_H
#define ORR_ORBIT_DYNAMICS_ROTATION_KNOTS_H

#include "core/astro.h"

enum {
    ORR_KNOT_VALUES = 3, // xp, yp (mas), UT1 (ms)
    ORR_KNOT_REACH = 4,  // knots that an instant depends on: window - 1 .. window + 2
    ORR_KNOT_LOCAL = ORR_KNOT_VALUES * ORR_KNOT_REACH,
};

typedef struct orr_rotation_knots {
    orr_time origin;
    size_t n; // windows + 1
    const double *t_s;
    double (*value)[ORR_KNOT_VALUES];
    // To be carried on beyond what was measured: n is 3, and in the place of knots stand value, rate (a day) and
    // the rate's change (a day squared) at t_s[1], for the whole of t_s[0] to t_s[2].
    bool polynomial;
} orr_rotation_knots;

// Weights of the knots window - 1 .. window + 2 in the curve at t_s; zero for knots that are not there.
void orr_knot_weights(const orr_rotation_knots *k, size_t window, double t_s, double weight[ORR_KNOT_REACH]);
// The window that t_s lies in; the first or last one beyond the ends.
size_t orr_knot_window(const orr_rotation_knots *k, double t_s);
// The curve at t_s and its derivative (a day).
void orr_knot_value(const orr_rotation_knots *k, double t_s, double value[ORR_KNOT_VALUES],
                    double per_day[ORR_KNOT_VALUES]);

// Entries of the series that orr_knot_series makes.
size_t orr_knot_series_length(const orr_rotation_knots *k);
// Start (a series, or NULL: what is known without measurements, by the run's table of leap seconds, with the zonal tides)
// plus corrections, every three hours, into out, which has room for orr_knot_series_length entries. leap NULL: built-in.
void orr_knot_series(const orr_rotation_knots *k, const orr_eop_series *start, const orr_leap_table *leap,
                     orr_eop_series *out);

// How a direction fixed to the Earth (ecef) moves in ecef by 1 mas of xp, of yp, by 1 ms of UT1: columns of
// d(R' p) = R' times them.
void orr_knot_partials(orr_vec3 ecef_m, orr_vec3 by[ORR_KNOT_VALUES]);

#endif
