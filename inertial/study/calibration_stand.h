// SPDX-License-Identifier: GPL-3.0-or-later
// A unit on a turntable with one axis: what its gyros and accelerometers feel through cycles of turning, each accelerometer
// at a place of its own (Bogdanov 2015, section 4). Readings with their truth, for anybody's calibration.
#ifndef ORR_INERTIAL_STUDY_CALIBRATION_STAND_H
#define ORR_INERTIAL_STUDY_CALIBRATION_STAND_H

#include "inertial/readings/imu.h"

// The stand's rate goes linearly to rate_radps within duration_s from what it was; 0 at the begin of a cycle.
typedef struct orr_stand_segment {
    double duration_s, rate_radps;
} orr_stand_segment;

typedef struct orr_stand_profile {
    size_t n;
    const orr_stand_segment *segment; // [n] borrowed
    // Ripple of the drive: the rate is that of the segments times 1 + ripple sin(ripple_per_turn theta), theta their angle.
    double ripple, ripple_per_turn; // no ripple: 0
} orr_stand_profile;

// One mounting of the unit and a run of the stand.
typedef struct orr_stand_cycle {
    orr_mat3 order;        // I^(k): the unit's axes from the stand's as they are meant to be, a rotation
    orr_vec3 mounting_rad; // alpha^(k), the error of that, body axes (22)
    double start_rad;      // chi at the begin
    orr_vec3 outer_m;      // the unit's point from the stand's axis, body axes
    orr_stand_profile profile;
} orr_stand_cycle;

typedef struct orr_stand_setup {
    orr_geodetic place;                // of a point of the axis
    double azimuth_rad, elevation_rad; // of the stand's axis 2: clockwise from North, and above the horizon
    const orr_gravity *gravity;        // NULL: normal gravity; borrowed
    // As the source has it, for comparison. Mounting: E + hat(alpha) (22), which is no rotation. Forces: (27) with the
    // stand's rate alone and one gravity for all, so that cross terms with the Earth's rate are lost.
    bool literal_mounting, literal_forces;
} orr_stand_setup;

// The stand as it is asked: made once by orr_stand_prepare.
typedef struct orr_stand {
    orr_stand_setup setup;
    orr_vec3 place_m;    // ecef
    orr_mat3 A_xe, C_tx; // enu from ecef; the stand's axes (chi = 0) from enu
    orr_vec3 u_radps;    // the Earth's rate, enu
    orr_vec3 rest_mps2;  // specific force of rest at the axis, enu: (0, 0, +g) and what the vertical is off
    orr_mat3
        gradient_ps2; // change of that with place, of gravitation alone: rest(dr) = rest - gradient dr, enu
} orr_stand;

// ORR_E_ARG: an elevation beyond 90 deg, a place inside the Earth.
orr_status orr_stand_prepare(const orr_stand_setup *setup, orr_stand *out, orr_diag *diag);
// Checks a cycle: an order that is no rotation, no segments, durations that are not positive, a ripple of a whole rate or more,
// mounting errors of half a right angle or more. ORR_E_ARG with a sentence.
orr_status orr_stand_cycle_check(const orr_stand_cycle *c, orr_diag *diag);
// Length of a profile, s.
double orr_stand_duration(const orr_stand_profile *p);

// The stand's angle relative to its begin, its rate and acceleration.
//   Given:    p             profile
//             t_s           time; beyond the end the last rate goes on
//   Returned: angle_rad, rate_radps, acceleration_radps2
void orr_stand_turn(const orr_stand_profile *p, double t_s, double *angle_rad, double *rate_radps,
                    double *acceleration_radps2);

// What the sensors of a unit feel in a while, as integrals.
typedef struct orr_stand_increment {
    orr_vec3 dtheta_rad; // (23)-(26)
    orr_vec3 rest_mps;   // of the force of rest at the axis
    // Of what an arm adds to it: the accelerometer of axis i at r_i (from the axis, body axes) has
    // dv_i = rest_i + sum_j arm[i][j] r_i[j] (27).
    orr_mat3 arm_ps;
} orr_stand_increment;
// Integrals from one time to another.
//   Given:    stand, cycle  where and how
//             from_s, to_s  times of the cycle
//   Returned: (value)       the integrals, to rounding: pieces are cut at the profile's bends and kept below 0.2 rad, which
//                       costs an arm 1e-12 of it (0.4 rad: 2e-9)
//   Reference: Bogdanov 2015, eq. (21)-(27).
orr_stand_increment orr_stand_integrate(const orr_stand *stand, const orr_stand_cycle *cycle, double from_s,
                                        double to_s);
// The increment of the accelerometer of an axis (0, 1, 2) at its arm from the stand's axis, body axes.
double orr_stand_force(const orr_stand_increment *a, int axis, orr_vec3 arm_m);

// The motion of the unit's point at t_s, with exact rotations.
void orr_stand_motion(const orr_stand *stand, const orr_stand_cycle *cycle, double t_s, orr_motion *out);

// Readings of a cycle with their truth.
//   Given:    stand, cycle  where and how
//             inner_m       [3] the accelerometers' places from the unit's point, body axes; NULL: all at it
//             t0, rate_hz   of the readings; bends of the profile have to be at their edges
//   Returned: out           readings; the truth is that of the unit's point. Free with orr_imu_free
//   Notes:    ORR_E_ARG, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_stand_readings(const orr_stand *stand, const orr_stand_cycle *cycle, const orr_vec3 *inner_m,
                              orr_time t0, double rate_hz, orr_imu *out, orr_diag *diag);

#endif
