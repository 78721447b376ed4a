// SPDX-License-Identifier: GPL-3.0-or-later
// The moving part of a scenario as the file states it: its trajectory, units, gravity and inertial readings.
#ifndef ORR_CONFIG_MOTION_H
#define ORR_CONFIG_MOTION_H

#include "src/config/schema.h"

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

#endif
