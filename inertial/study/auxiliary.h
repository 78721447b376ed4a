// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside inertial units on a body: barometer, magnetometer, odometer, two antennas, a satellite receiver, each with bias and
// noise on the true motion.
#ifndef ORR_INERTIAL_STUDY_AUXILIARY_H
#define ORR_INERTIAL_STUDY_AUXILIARY_H

#include "core/earth.h"
#include "inertial/motion/trajectory.h"

// Error of one output: a constant, one that the seed draws, a Gauss-Markov process and white noise, all in the output's unit.
typedef struct orr_aux_error {
    double bias, bias_sigma;
    double walking, correlation_s; // standard deviation and time of the process; 0: none
    double white;                  // standard deviation of a sample
} orr_aux_error;

typedef struct orr_aux_barometer {
    orr_aux_error height_m;
    double
        scale; // relative error of heights above the ellipsoid: air warmer than the standard's by 288 K times it
    double lag_s; // of the pressure in its tube; 0: none
} orr_aux_barometer;

typedef struct orr_aux_magnetometer {
    const orr_magnetic *model; // NULL: the dipole
    orr_vec3 hard_nt;          // field of the body's own iron, body axes
    orr_mat3 soft;             // what its iron makes of the Earth's field: 1 + this
    orr_aux_error axis_nt;     // of each axis
} orr_aux_magnetometer;

typedef struct orr_aux_odometer {
    orr_vec3 arm_m;   // of the wheel, body axes; it measures forward
    double scale;     // relative
    double quantum_m; // of its pulses, the residue carried on; 0: none
    orr_aux_error speed_mps;
} orr_aux_odometer;

typedef struct orr_aux_antennas {
    orr_vec3 baseline_m; // from the first antenna to the second, body axes
    double across_m,
        up_m; // standard deviations of their relative position, horizontal (each axis) and vertical
    orr_aux_error heading_rad; // beside that: of the baseline's direction in the body
} orr_aux_antennas;

typedef struct orr_aux_receiver {
    orr_vec3 arm_m;  // of the antenna, body axes
    double mask_rad; // satellites above this elevation are seen
    double range_m,
        rate_mps; // white standard deviations in the zenith, of range and range rate; elsewhere over the sine of the elevation
    double range_walking_m, range_correlation_s; // and of a Gauss-Markov process of each satellite's range
} orr_aux_receiver;

enum { ORR_AUX_SATELLITES = 96 };
// Where satellites are at an instant: fills at most ORR_AUX_SATELLITES places (ecef) and numbers that stay with each, returns how many.
typedef size_t (*orr_aux_sky)(void *user, orr_time t, orr_vec3 *r_m, int *number);
// 24 satellites, Galileo's nominal constellation (Walker 24/3/1, a = 29600 km, i = 56 degrees), for who has no orbits at hand. user is not used.
size_t orr_aux_nominal_sky(void *user, orr_time t, orr_vec3 *r_m, int *number);

typedef struct orr_aux_plan {
    const orr_trajectory *tr;
    double begin_s, duration_s, rate_hz;
    uint64_t seed;
    const orr_aux_barometer *barometer; // each NULL where it is not there
    const orr_aux_magnetometer *magnetometer;
    const orr_aux_odometer *odometer;
    const orr_aux_antennas *antennas;
    const orr_aux_receiver *receiver;
    orr_aux_sky sky;
    void *sky_user;
} orr_aux_plan;

// All at one instant, with the truth of each. What is not there is NAN.
typedef struct orr_aux_sample {
    double t_s;
    double height_m, true_height_m, pressure_hpa; // above the ellipsoid; pressure by the standard atmosphere
    orr_vec3 field_nt, true_field_nt;             // body axes
    double speed_mps, distance_m, true_speed_mps; // forward; sum of pulses since the begin
    double heading_rad, pitch_rad, heading_sigma_rad, true_heading_rad, true_pitch_rad; // of the baseline
    size_t satellites;                                 // seen; fewer than 4: no position
    orr_vec3 position_m, velocity_mps;                 // ecef, of the antenna
    orr_vec3 position_error_m, velocity_error_mps;     // East, North, Up
    orr_mat3 position_covariance, velocity_covariance; // East, North, Up
} orr_aux_sample;

// Samples at begin_s + k / rate_hz, in order.
//   Given:    plan          what there is
//             sample        called with `user` for each; other than ORR_OK ends the run and is returned
//             user          for `sample`
//   Returned: diag          why it failed; may be NULL
//   Notes:    ORR_E_ARG (rate, negative variances, correlation times of zero, a baseline of none), ORR_E_RANGE (outside the trajectory).
//   Reference: ISO 2533 (standard atmosphere); Kaplan and Hegarty 2017, 11.2 (geometry's covariance).
orr_status orr_auxiliary(const orr_aux_plan *plan, orr_status (*sample)(void *user, const orr_aux_sample *s),
                         void *user, orr_diag *diag);

// Pressure at a (geometric) height by the standard atmosphere below 11 km, hPa.
double orr_aux_pressure_hpa(double height_m);

#endif
