// SPDX-License-Identifier: GPL-3.0-or-later
// A trajectory from recorded telemetry (Bogdanov 2015, section 1.7): find faults, leave them out and say so,
// smooth by least-squares B-splines.
#ifndef ORR_INERTIAL_MOTION_TELEMETRY_FIT_H
#define ORR_INERTIAL_MOTION_TELEMETRY_FIT_H

#include "inertial/motion/trajectory.h"

// Rows as recorded, in any order of time, places and angles each on their own clock readings (the same
// clock). Borrowed.
typedef struct orr_telemetry_log {
    size_t n_position;
    const double *position_t_s;
    const orr_geodetic *position;
    const int64_t *position_row; // line in the file, for the report
    size_t n_attitude;           // 0: heading along the motion, pitch by the climb, roll of coordinated turns
    const double *attitude_t_s;
    const double *heading_rad, *pitch_rad, *roll_rad; // NAN: not known, taken 0 (heading: from the motion)
    const int64_t *attitude_row;
} orr_telemetry_log;

typedef struct orr_fit_options {
    int degree;               // 3 (the source's) or 5
    double position_per_knot; // p of the source: samples per knot; 0: enough for a knot a second
    double attitude_per_knot; // 0: enough for a knot every 0.2 s
    double max_gap_s;         // longer gaps split the log; the longest segment is used
    double grid_s;            // knots and the begin are multiples of it, so that samples of an IMU meet them
    double jump_m, jump_rad;  // a sample farther than this and than 8 robust sigmas from the fit is no motion
} orr_fit_options;
orr_fit_options orr_fit_options_default(void); // cubic, automatic, 10 s, 0.01 s, 3 m, 8 deg

typedef enum orr_fault {
    ORR_FAULT_REPEATED, // the row before, again
    ORR_FAULT_CLOCK,    // its time does not ascend with the others'
    ORR_FAULT_FROZEN,   // values stood still while the body moved on
    ORR_FAULT_JUMP,     // far off the motion around it
    ORR_FAULT_OUTSIDE,  // in a part of the log that was not used
    ORR_FAULT_NOT_FINITE,
    ORR_FAULTS,
} orr_fault;
const char *orr_fault_name(orr_fault f); // "repeated", "clock", ...

typedef struct orr_excluded_row {
    bool attitude;
    orr_fault fault;
    int64_t row;
    double t_s;
} orr_excluded_row;

typedef struct orr_telemetry_gap {
    bool attitude;
    double from_s, to_s; // on the log's clock
} orr_telemetry_gap;

typedef struct orr_fit_report {
    size_t positions, attitudes; // rows there were
    size_t positions_used, attitudes_used;
    size_t count[2][ORR_FAULTS]; // [attitude?][fault]
    size_t n_excluded;
    orr_excluded_row *excluded;
    size_t n_gaps; // gaps over 3 usual intervals
    orr_telemetry_gap *gap;
    size_t wraps; // steps of heading or roll through 180 or 360 deg, nothing wrong with them
    double position_interval_s, attitude_interval_s; // usual
    double position_knot_s, attitude_knot_s;
    double from_s, to_s; // on the log's clock: what the trajectory covers
    orr_spline_residuals residuals;
    bool attitude_from_motion;
} orr_fit_report;
// Frees the lists of a report; an empty one is allowed.
void orr_fit_report_free(orr_fit_report *r);

// Smooth motion through a log.
//   Given:    log_t0        instant of the log's second 0
//             log           its rows, in any order of time
//             options       degree and knots of the splines, limits of gaps and jumps
//   Returned: out           the trajectory; its second 0 is from_s of the report on the log's clock. Free with
//                           orr_trajectory_free
//             report        what was used and what was left out; free with orr_fit_report_free
//   Notes:    ORR_E_NODATA (too few rows, no time common to places and angles), ORR_E_ARG, ORR_E_NUMERIC,
//             ORR_E_MEMORY; then there is nothing to free.
//   Reference: Bogdanov 2015, section 1.7, eq. (5)-(9), (16), (17).
orr_status orr_trajectory_from_telemetry(orr_time log_t0, const orr_telemetry_log *log,
                                         const orr_fit_options *options, orr_trajectory *out,
                                         orr_fit_report *report, orr_diag *diag);

#endif
