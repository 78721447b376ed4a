// SPDX-License-Identifier: GPL-3.0-or-later
// A flight from a few words: waypoints, or survey lines with tie lines, flown at given speeds with
// coordinated turns, a climb limit, seeded turbulence and attitude oscillation.
#ifndef ORR_INERTIAL_MOTION_FLIGHT_PLAN_H
#define ORR_INERTIAL_MOTION_FLIGHT_PLAN_H

#include "inertial/motion/trajectory.h"

#define ORR_PLAN_MAX_WAYPOINTS 1000
#define ORR_PLAN_MAX_LINES 500

typedef struct orr_waypoint {
    orr_geodetic at;
    double speed_mps; // from here on; 0: as before
} orr_waypoint;

// Parallel lines flown in turn, forth and back, then tie lines across them.
typedef struct orr_survey {
    orr_geodetic start; // begin of the first line
    double azimuth_rad; // of the first line, clockwise from North
    double length_m;
    double spacing_m; // between lines
    int lines;
    bool to_left;         // the next line lies to the left of the first line's direction, else to the right
    int tie_lines;        // 0: none
    double tie_spacing_m; // between tie lines; the first is that far inside the lines' begin
} orr_survey;

// What a flight is a sequence of. It begins on the ground at rest if the first phase is a rest, a taxi or a take-off,
// else in the air at the plan's speed.
typedef enum orr_phase_kind {
    ORR_PHASE_REST,     // stands still
    ORR_PHASE_STRAIGHT, // straight and level, at another speed if one is told
    ORR_PHASE_TAXI,     // the same on the ground; stop: to rest at the end
    ORR_PHASE_TURN,     // level arc
    ORR_PHASE_TAKEOFF,  // ground run to a speed
    ORR_PHASE_CLIMB,    // straight on to a height, up or down
    ORR_PHASE_TO,       // the shortest way to a place and a course there
    ORR_PHASE_SURVEY,   // lines and tie lines
    ORR_PHASE_LANDING,  // straight descent to the ground and ground run to rest
} orr_phase_kind;
const char *orr_phase_name(orr_phase_kind kind); // "rest", "straight", ...

typedef struct orr_phase {
    orr_phase_kind kind;
    double duration_s; // rest; straight and taxi: instead of the length
    double length_m;   // straight, taxi
    double
        speed_mps; // straight, taxi, takeoff, landing; 0: as before (taxi from rest: 8; takeoff: the plan's)
    bool stop;     // taxi
    double angle_rad;   // turn; positive to the right
    double radius_m;    // turn; 0: of the plan's bank
    double height_m;    // climb, landing: above the ellipsoid
    double rate_mps;    // climb, landing: vertical speed; 0: the plan's limit
    orr_geodetic at;    // to, survey: latitude and longitude
    double azimuth_rad; // to: course at the place, clockwise from North
    orr_survey survey;  // without its start
} orr_phase;

#define ORR_PLAN_MAX_PHASES 200

// A random oscillation: power spectral density ~ f^slope within the band, scaled to the r.m.s.
typedef struct orr_spectrum {
    double rms; // 0: none
    double low_hz, high_hz;
    double slope; // 0: flat; -5/3: Kolmogorov's turbulence
} orr_spectrum;

typedef struct orr_flight_plan {
    size_t n_phases; // 0: waypoints or the survey
    const orr_phase *phase;
    orr_geodetic start; // of phases, and
    double course_rad;  // the course there, clockwise from North
    size_t n_waypoints; // 0: the survey
    const orr_waypoint *waypoint;
    orr_survey survey;
    double speed_mps;
    double bank_rad;          // of the turns; their radius is v^2 / (g tan bank)
    double turn_radius_m;     // if > 0, instead; the bank it needs must not pass bank_rad
    double climb_limit_mps;   // steepest climb and descent
    double acceleration_mps2; // greatest, along the way, where speeds change
    double lead_m;            // survey: straight flight before and after each line
    double smoothing_s; // time in which turns, climbs and speeds set in (standard deviation of the smoothing)
    double pitch_rad;   // of level flight
    orr_spectrum wind_mps; // velocity, each of East, North, Up
    orr_spectrum heading_rad, pitch_osc_rad, roll_rad;
    uint64_t seed;
    double duration_s;  // 0: the whole plan; else cut to it, or flown straight on to fill it
    double knot_step_s; // of the quintic spline laid through the plan
} orr_flight_plan;

typedef struct orr_flight_summary {
    double duration_s, length_m, turn_radius_m;
    size_t lines;
} orr_flight_summary;

// The flight of a plan.
//   Given:    t0            instant of its begin
//             plan          waypoints or a survey, and how they are flown
//   Returned: out           the trajectory from 0 s on, a quintic spline; free with orr_trajectory_free
//             summary       length, duration and turns of the plan; may be NULL
//   Notes:    Each error has a sentence: ORR_E_ARG (a turn too tight for its speed, legs shorter than their
//             turns, a climb too steep, a speed that changes too fast, phases that do not follow on each
//             other, latitude past a pole, a plan that reaches too far), ORR_E_LIMIT,
//             ORR_E_MEMORY.
orr_status orr_trajectory_flight_plan(orr_time t0, const orr_flight_plan *plan, orr_trajectory *out,
                                      orr_flight_summary *summary, orr_diag *diag);

#endif
