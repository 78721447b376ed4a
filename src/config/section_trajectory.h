// SPDX-License-Identifier: GPL-3.0-or-later
// Section `trajectory`: where the body goes.
#ifndef ORR_CONFIG_SECTION_TRAJECTORY_H
#define ORR_CONFIG_SECTION_TRAJECTORY_H

#include "src/config/schema.h"

#define ORR_MOTION_KINDS(X)                                                                                  \
    X(ORR_MOTION_SURVEY, "survey", "a flight along parallel lines, and tie lines across")                    \
    X(ORR_MOTION_WAYPOINTS, "waypoints", "a flight from place to place")                                     \
    X(ORR_MOTION_PHASES, "phases", "a sequence: rest, taxi, take-off, climb, survey, landing and others")    \
    X(ORR_MOTION_TELEMETRY, "telemetry", "a smooth motion through the log of a flight")                      \
    X(ORR_MOTION_ANALYTIC, "analytic", "rest, or a sum of motions in closed form")                           \
    X(ORR_MOTION_ORBIT, "orbit", "a receiver in space: a satellite of an orbit product, or elements")
#define ORR_SURVEY_SIDES(X)                                                                                  \
    X(ORR_SURVEY_RIGHT, "right", "to the right of the first line's direction")                               \
    X(ORR_SURVEY_LEFT, "left", "to the left of it")
#define ORR_FIT_DEGREES(X)                                                                                   \
    X(ORR_FIT_CUBIC, "3", "cubic")                                                                           \
    X(ORR_FIT_QUINTIC, "5", "quintic, with a smooth acceleration")
#define ORR_TERM_KINDS(X)                                                                                    \
    X(ORR_TERM_STRAIGHT, "straight", "constant velocity over the local map")                                 \
    X(ORR_TERM_CIRCLE, "circle", "a circle about the origin")                                                \
    X(ORR_TERM_EIGHT, "eight", "a figure of eight")                                                          \
    X(ORR_TERM_SINE, "sine", "oscillation of place and attitude")

#define ORR_PHASE_KINDS(X)                                                                                   \
    X(ORR_PHASE_WORD_REST, "rest", "stands still")                                                           \
    X(ORR_PHASE_WORD_STRAIGHT, "straight", "straight and level, at another speed if one is told")            \
    X(ORR_PHASE_WORD_TAXI, "taxi", "the same on the ground")                                                 \
    X(ORR_PHASE_WORD_TURN, "turn", "a level arc")                                                            \
    X(ORR_PHASE_WORD_TAKEOFF, "takeoff", "a ground run to a speed")                                          \
    X(ORR_PHASE_WORD_CLIMB, "climb", "straight on to a height, up or down")                                  \
    X(ORR_PHASE_WORD_TO, "to", "the shortest way to a place and a course there")                             \
    X(ORR_PHASE_WORD_SURVEY, "survey", "lines and tie lines")                                                \
    X(ORR_PHASE_WORD_LANDING, "landing", "a straight descent to the ground, and a ground run to rest")
#define ORR_TRANSFER_ATTITUDES(X)                                                                            \
    X(ORR_TRANSFER_LEVEL, "level", "roll and pitch stay as they were against the ellipsoid's vertical")      \
    X(ORR_TRANSFER_LITERAL, "literal",                                                                       \
      "turned with the places alone: they stay against the geocentric vertical, up to 0.19 deg off")

typedef enum orr_motion_kind {
    ORR_MOTION_NONE, // no section `trajectory`
    ORR_MOTION_KINDS(ORR_CHOICE_VALUE)
} orr_motion_kind;
typedef enum orr_survey_side { ORR_SURVEY_SIDES(ORR_CHOICE_VALUE) } orr_survey_side;
typedef enum orr_fit_degree { ORR_FIT_DEGREES(ORR_CHOICE_VALUE) } orr_fit_degree;
typedef enum orr_phase_word { ORR_PHASE_KINDS(ORR_CHOICE_VALUE) } orr_phase_word;
typedef enum orr_transfer_attitude { ORR_TRANSFER_ATTITUDES(ORR_CHOICE_VALUE) } orr_transfer_attitude;
typedef enum orr_term_kind { ORR_TERM_KINDS(ORR_CHOICE_VALUE) } orr_term_kind;

typedef struct orr_scenario_spectrum {
    double rms, low_hz, high_hz, slope; // rms 0: none
} orr_scenario_spectrum;

typedef struct orr_scenario_survey {
    double azimuth_deg, length_m, spacing_m, tie_spacing_m;
    int64_t lines, tie_lines;
    int side; // orr_survey_side
} orr_scenario_survey;

typedef struct orr_scenario_waypoint {
    double lat_deg, lon_deg, height_m, speed_mps;
} orr_scenario_waypoint;

typedef struct orr_scenario_phase {
    int kind; // orr_phase_word
    int64_t duration_ns;
    double length_m, speed_mps, angle_deg, radius_m, height_m, rate_mps, lat_deg, lon_deg, azimuth_deg;
    bool stop;
    orr_scenario_survey survey;
} orr_scenario_phase;

typedef struct orr_scenario_wave {
    double amplitude_m, wavelength_m, azimuth_deg, phase_deg;
} orr_scenario_wave;

typedef struct orr_scenario_log {
    char *file, *columns;
} orr_scenario_log;

typedef struct orr_scenario_fit {
    int degree; // orr_fit_degree
    double position_per_knot, attitude_per_knot;
    int64_t max_gap_ns;
} orr_scenario_fit;

typedef struct orr_scenario_term {
    int kind; // orr_term_kind
    double east, north, up, radius_m, period_s, azimuth_deg, along_m, across_m, heading_deg, pitch_deg,
        roll_deg, phase_deg;
    bool counter_clockwise;
} orr_scenario_term;

typedef struct orr_scenario_body {
    double heading_deg, pitch_deg, roll_deg;
    bool follow_course;
} orr_scenario_body;

typedef struct orr_scenario_transfer {
    double lat_deg, lon_deg, azimuth_deg;
    int attitude; // orr_transfer_attitude
} orr_scenario_transfer;

typedef struct orr_scenario_elements {
    double semimajor_axis_m, eccentricity, inclination_deg, node_deg, perigee_deg, mean_anomaly_deg;
} orr_scenario_elements;

typedef struct orr_scenario_trajectory {
    int kind; // orr_motion_kind
    bool has_start;
    orr_time start;
    int64_t duration_ns; // 0: the whole plan or log
    double lat_deg, lon_deg, height_m;
    orr_scenario_survey survey;
    struct {
        size_t n;
        orr_scenario_waypoint *item;
    } waypoints;
    struct {
        size_t n;
        orr_scenario_phase *item;
    } phases;
    double azimuth_deg; // phases: course at the begin
    double speed_mps, bank_deg, turn_radius_m, climb_mps, acceleration_mps2, lead_m, smoothing_s, pitch_deg,
        knots_s;
    orr_scenario_spectrum turbulence;
    struct orr_scenario_oscillation {
        orr_scenario_spectrum heading, pitch, roll;
    } oscillation;
    struct {
        size_t n;
        orr_scenario_wave *item;
    } drape;
    int64_t seed;
    struct {
        size_t n;
        orr_scenario_log *item;
    } logs;
    orr_scenario_fit fit;
    orr_scenario_body body;
    struct {
        size_t n;
        orr_scenario_term *item;
    } terms;
    char *product, *sat; // orbit: of a product, else elements
    bool has_elements;
    orr_scenario_elements elements;
    bool has_transfer;
    orr_scenario_transfer transfer;
} orr_scenario_trajectory;

extern const orr_schema orr_section_trajectory;

#define ORR_TRAJECTORY_MAX_WAYPOINTS 1000
#define ORR_TRAJECTORY_MAX_PHASES 200
#define ORR_TRAJECTORY_MAX_LOGS 2 // places and angles
#define ORR_TRAJECTORY_MAX_TERMS 16

#endif
