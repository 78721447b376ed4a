// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer alignment: a second unit is aligned on a moving base by the velocity of a first one that navigates (Bogdanov 2015, section 2.4). A Kalman
// filter on the difference of the two units' errors, which obeys psi's equations with the difference of the sensors' errors.
#ifndef ORR_INERTIAL_STUDY_TRANSFER_ALIGNMENT_H
#define ORR_INERTIAL_STUDY_TRANSFER_ALIGNMENT_H

#include "inertial/motion/dual_unit.h"
#include "inertial/readings/imu.h"
#include "inertial/sense/measured.h"

// What the filter is told of sensors: of both units together.
typedef struct orr_transfer_noise {
    double white;                  // N, of either triad
    double bias;                   // standard deviation of the constant bias
    double walking, correlation_s; // and of a Gauss-Markov process beside it; 0: none
} orr_transfer_noise;
// Of two units whose errors add. What else they have (scale factors, misalignments) the filter does not know.
//   Given:    first, second   errors of the same triad of both units
//   Returned: the sum of the variances; the correlation time is the second's
orr_transfer_noise orr_transfer_noise_of(const orr_triad_errors *first, const orr_triad_errors *second);

typedef struct orr_transfer_plan {
    orr_trajectory const *first_tr, *second_tr; // true motions
    const orr_imu *first, *second; // measured increments and truth at every reading, on the same edges
    const orr_gravity *gravity;    // NULL: normal gravity
    orr_mounting mounting;         // of the second unit, as it is known
    size_t interval;               // readings from one measurement to the next
    double
        velocity_noise_mps; // standard deviation of the first unit's velocity, as it is handed over, each axis
    orr_vec3 flexure_mps;   // of what bending adds to it, first unit's axes
    orr_vec3
        mounting_sigma_rad; // standard deviations of the second unit's attitude at the start against the first's, and
    double start_velocity_mps; // of its velocity; both are drawn
    orr_vec3
        first_attitude_rad; // standard deviations of the first unit's own attitude at the start, East, North, up
    orr_transfer_noise gyro, accel;
    uint64_t seed;
} orr_transfer_plan;

enum { ORR_TRANSFER_STATES = 18 };

// One measurement.
typedef struct orr_transfer_point {
    double t_s;
    orr_vec3 attitude_rad, velocity_mps; // errors that are left: second less first unit's, geographic axes
    orr_vec3 attitude_sigma_rad, velocity_sigma_mps; // what the filter says of them
    orr_vec3 residual; // of the velocity along the first unit's axes, in standard deviations
} orr_transfer_point;

typedef struct orr_transfer_result {
    size_t n;                       // measurements
    orr_transfer_point first, last; // before any measurement, and after the last
    double nees;                    // of attitude and velocity at the end: chi-square of 6
    double whiteness
        [3]; // autocorrelation of the residuals of each axis over one interval; 1 / sqrt(n) for white ones
    double residual_rms[3]; // 1 where the filter knows its noise
} orr_transfer_result;

// Aligns the second unit.
//   Given:    plan          both units
//             point         called with `user` at the start and after each measurement; may be NULL
//             user          for `point`
//   Returned: out           what came out
//   Notes:    The filter is fed back: after each measurement the second unit's attitude, velocity and biases are corrected, and its place is that
//             of the first and the arm. ORR_E_ARG (edges that differ, an interval that is none, negative variances), ORR_E_MEMORY, those of orr_navigate.
//   Reference: Bogdanov 2015, 2.4; Groves 2013, 15.1.
orr_status orr_transfer_align(const orr_transfer_plan *plan,
                              void (*point)(void *user, const orr_transfer_point *p), void *user,
                              orr_transfer_result *out, orr_diag *diag);

#endif
