// SPDX-License-Identifier: GPL-3.0-or-later
// The moving part of a scenario: its trajectory, units, gravity and inertial readings, as sections of the
// file and as what they become. One trajectory serves readings, truth and the satellites' receiver.
#ifndef ORR_SCENARIO_MOTION_H
#define ORR_SCENARIO_MOTION_H

#include "core/log.h"
#include "inertial/dual_unit.h"
#include "inertial/imu.h"
#include "inertial/telemetry_fit.h"
#include "src/scenario/schema.h"

typedef enum orr_motion_kind {
    ORR_MOTION_NONE,
    ORR_MOTION_SURVEY,
    ORR_MOTION_WAYPOINTS,
    ORR_MOTION_TELEMETRY,
    ORR_MOTION_ANALYTIC,
} orr_motion_kind;

typedef struct orr_scenario_spectrum {
    double rms, low_hz, high_hz, slope;
} orr_scenario_spectrum;
typedef struct orr_scenario_waypoint {
    double lat_deg, lon_deg, height_m, speed_mps;
} orr_scenario_waypoint;
typedef struct orr_scenario_log {
    char *file, *columns;
} orr_scenario_log;
typedef struct orr_scenario_term {
    int kind; // straight, circle, eight, sine
    double east, north, up, radius_m, period_s, azimuth_deg, along_m, across_m, heading_deg, pitch_deg,
        roll_deg, phase_deg;
    bool counter_clockwise;
} orr_scenario_term;
typedef struct orr_scenario_unit {
    char *name;
    double right_m, forward_m, up_m, heading_deg, pitch_deg, roll_deg;
} orr_scenario_unit;
typedef struct orr_scenario_mass {
    double lat_deg, lon_deg, height_m, gm_m3ps2;
} orr_scenario_mass;

typedef struct orr_scenario_motion {
    int kind; // orr_motion_kind
    orr_time start;
    int64_t duration_ns;
    double lat_deg, lon_deg, height_m, azimuth_deg, length_m, spacing_m, tie_spacing_m; // of the survey
    int64_t lines, tie_lines;
    int side;
    struct {
        size_t n;
        orr_scenario_waypoint *item;
    } waypoints;
    double speed_mps, bank_deg, turn_radius_m, climb_mps, lead_m, smoothing_s, pitch_deg, knots_s;
    int64_t seed;
    orr_scenario_spectrum turbulence, heading, pitch, roll;
    struct {
        size_t n;
        orr_scenario_log *item;
    } logs;
    int degree; // 3 or 5 as choice
    double position_per_knot, attitude_per_knot;
    int64_t max_gap_ns;
    double body_heading_deg, body_pitch_deg, body_roll_deg;
    bool follow_course;
    struct {
        size_t n;
        orr_scenario_term *item;
    } terms;
    bool transfer;
    double to_lat_deg, to_lon_deg, to_azimuth_deg;
    struct {
        size_t n;
        orr_scenario_unit *item;
    } units;
    // gravity
    char *model, *model_folder, *gravity_file;
    double profile_lat_deg, profile_lon_deg, profile_azimuth_deg;
    orr_real_list profile_distance_m, profile_mgal;
    struct {
        size_t n;
        orr_scenario_mass *item;
    } masses;
    // imu
    double rate_hz;
    int approach, frame, projection, loop, quadrature;
    int64_t order;
} orr_scenario_motion;

#define ORR_MOTION_MAX_UNITS 16

// A scenario's motion, prepared. Unit 0 is the body's own reference; unit k is units.item[k - 1].
typedef struct orr_moving {
    orr_trajectory trajectory;                 // of unit 0
    size_t n_units;                            // 1 and those named
    orr_trajectory unit[ORR_MOTION_MAX_UNITS]; // unit[0] is not used
    orr_gravity *gravity;                      // NULL: normal gravity
    orr_gravity_model *model;
    orr_imu_mode mode;
    double rate_hz;
    bool from_telemetry;
    orr_fit_report report; // of telemetry
} orr_moving;

// Prepares; fallback_start is the start where the scenario has none. Errors: those of readers and makers,
// with files and lines. Free with orr_moving_free.
orr_status orr_moving_open(const orr_scenario_motion *m, orr_time fallback_start, orr_warnings *warnings,
                           orr_moving *out, orr_diag *diag);
void orr_moving_free(orr_moving *v);
// Nodes (or rectangles) a step where nobody says: 2 Gauss-Legendre nodes at 50 Hz and more, 3 below and on
// the livelier motion of a log.
int orr_moving_order(const orr_moving *v, orr_quadrature quadrature, double rate_hz);
// Trajectory of unit k < n_units.
const orr_trajectory *orr_moving_unit(const orr_moving *v, size_t k);

#endif
