// SPDX-License-Identifier: GPL-3.0-or-later
// What the fits of Kepler elements, of GLONASS and of almanacs share: the window of positions, where they start from, and
// the two steps of each: linear least squares, and the nearest point of the lattice.
#ifndef ORR_ORBIT_NAVDATA_NAVFIT_PRIVATE_H
#define ORR_ORBIT_NAVDATA_NAVFIT_PRIVATE_H

#include "orbit/navdata/field.h"
#include "orbit/navdata/lattice.h"
#include "orbit/navdata/navfit.h"

#define ORR_NAVFIT_POSITIONS 128
#define ORR_NAVFIT_ROWS (3 * ORR_NAVFIT_POSITIONS + ORR_LATTICE_MAX)

typedef struct orr_navfit_window {
    size_t n;
    orr_time t[ORR_NAVFIT_POSITIONS];
    orr_vec3 pos[ORR_NAVFIT_POSITIONS];
} orr_navfit_window;

// Checks a window.
// Given:
//   t0               reference time
//   from, to         window
//   least_s, most_s  its allowed length
// Returned:
//   diag             the sentence
// Errors: ORR_E_ARG for another length, or for a t0 that is further outside the window than the window is long.
orr_status orr_navfit_check_window(orr_time t0, orr_time from, orr_time to, double least_s, double most_s,
                                   orr_diag *diag);
// A record of which nothing is known but this; toc is toe.
// Given:
//   sat, kind, message  whose, and what it is
//   toe, week           reference time, and its week of the system
orr_nav_eph orr_navfit_blank(orr_sat sat, orr_nav_kind kind, uint8_t message, orr_time toe, int32_t week);
// Collects the positions of a window.
// Given:
//   from, to      window
//   step_s        longest step; at least 24 intervals are taken, at most ORR_NAVFIT_POSITIONS positions
//   source, user  positions
// Returned:
//   w             positions that the source has
//   diag          why it failed
// Errors: ORR_E_NODATA with fewer than 9 positions.
orr_status orr_navfit_gather(orr_time from, orr_time to, double step_s, orr_navfit_source source, void *user,
                             orr_navfit_window *w, orr_diag *diag);
// Position and velocity in the middle of a window, where a fit starts.
// Given:
//   w           positions
//   t0          instant at which the axes coincide with ecef
//   earth_rate  the axes turn by -earth_rate against ecef, rad/s; 0: ecef
// Returned:
//   r, v        state, m and m/s: the derivative of the polynomial through the five positions closest together
// Returns the index of the position.
size_t orr_navfit_middle(const orr_navfit_window *w, orr_time t0, double earth_rate, orr_vec3 *r,
                         orr_vec3 *v);

// The Sun in ecef, m, to 0.01 deg (The Astronomical Almanac, low-precision formulas): for what asks for it hundreds of times.
orr_vec3 orr_navfit_rough_sun(orr_time t);

// The product's clock over a window as a line about t0.
#define ORR_NAVFIT_CLOCKS 25
typedef struct orr_navfit_line {
    int n;
    double dt_s[ORR_NAVFIT_CLOCKS], value[ORR_NAVFIT_CLOCKS]; // since t0; s
    double mean_dt_s, mean, slope;
} orr_navfit_line;
// The product's clock over a window as a straight line about t0.
// Given:
//   e, sat      product and satellite
//   t0          reference time
//   from, to    window
//   relativity  include the periodic relativity, as GLONASS' parameters have to
// Returned:
//   line        values and their line
//   diag        why it failed
// Errors: ORR_E_NODATA with fewer than two values.
orr_status orr_navfit_clock_line(const orr_ephemeris *e, orr_sat sat, orr_time t0, orr_time from, orr_time to,
                                 bool relativity, orr_navfit_line *line, orr_diag *diag);
// What is left of the values after value + slope dt.
double orr_navfit_line_rms(const orr_navfit_line *line, double value, double slope);

// orr_broadcast_eval of the record against the window.
orr_status orr_navfit_judge(const orr_nav_eph *e, const orr_navfit_window *w, double *rms_m, double *max_m);

#endif
