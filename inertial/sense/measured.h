// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of real sensors on ideal increments: biases and their drifts, noises, scale factors, axes that are not where
// they should be, places that are not one point, temperature, bandwidth, sampling, limits and quantisation. Seeded: the same
// seed gives the same bits.
#ifndef ORR_INERTIAL_SENSE_MEASURED_H
#define ORR_INERTIAL_SENSE_MEASURED_H

#include "inertial/readings/imu.h"
#include "inertial/sense/temperature.h"

#define ORR_ERRORS_MAX_PROCESSES 4

// Stationary, of this standard deviation (in the unit of the rate); correlation exp(-t / correlation_s).
typedef struct orr_gauss_markov {
    double sigma, correlation_s;
} orr_gauss_markov;

// Of three gyros (rates in rad/s) or accelerometers (m/s^2), each with draws of its own.
typedef struct orr_triad_errors {
    double bias[3];    // constant
    double bias_sigma; // of a constant that each seed draws: what differs from one switching-on to the next
    size_t n_processes;
    orr_gauss_markov process[ORR_ERRORS_MAX_PROCESSES]; // instability of the bias
    double white[3];              // N, rate times sqrt(s): angle or velocity random walk
    double walk[3];               // K, rate per sqrt(s): random walk of the bias
    double ramp[3];               // rate per second
    double scale[3], scale_sigma; // relative; and what each seed draws
    double asymmetry[3]; // relative, of the magnitude: scale + asymmetry above zero, scale - it below
    double quadratic[3], cubic[3]; // of the rate's square and cube
    double cross[3][3];    // axis i sees so much of k (radians; the diagonal is not used): mounting errors
                           // and axes that are not orthogonal
    double cross_sigma;    // what each seed draws for each of the six
    double by_force[3][3]; // gyros: axis i, per m/s^2 of specific force along k
    double by_force_squared[3]; // gyros: axis i, per (m/s^2)^2 of that along i
    // Bias per (m/s^2)^2 of the mean square of vibration along the axis: what readings show of it (the square's mean about
    // the mean, both over the last second), and what is too fast for them (orr_imu_errors.vibration_mps2).
    double rectification[3];
    double by_temperature[3], by_temperature_squared[3]; // bias per K off the reference, per K^2
    double by_temperature_rate[3];                       // bias per K/s
    double scale_by_temperature[3];                      // relative, per K
    double arm_m[3][3];  // accelerometers: place of that of axis i, body axes, m: the size effect
    double bandwidth_hz; // where the response is down by 3 dB; 0: no limit
    double damping;      // of that second-order response; 0 stands for sqrt(1/2)
    double limit;        // of the rate that comes out; 0: none
    double quantum;      // of the increments, what is left over carried to the next; 0: none
} orr_triad_errors;

typedef struct orr_imu_errors {
    orr_triad_errors gyro, accel;
    uint64_t seed;
    orr_temperature temperature;
    double vibration_mps2; // r.m.s. of the vibration that is too fast for the readings, along each axis
    double delay_s,
        jitter_s; // sampling is late by delay_s, give or take a standard deviation of jitter_s, of both
                  // triads alike
} orr_imu_errors;

typedef struct orr_errors_report {
    size_t saturated[2]; // steps in which a gyro, an accelerometer was at its limit
} orr_errors_report;

// Fills measured_dtheta_rad and measured_dv_mps of a run from its ideal increments.
//   Given:    errors        of both triads
//             imu           the run
//   Returned: imu           with what the sensors measure; a run that has that already gets it anew
//             report        what was cut off; may be NULL
//   Notes:    The rate of a step is its increment over its length. Order: places, mounting, scale and biases; bandwidth;
//             delay and jitter; noises; limits; quantisation. Noises are exact for their sums over steps: the
//             white one, the walk within a step, the Gauss-Markov processes at its ends with the mean between. ORR_E_ARG
//             with a sentence (negative variances, correlation times of zero, rates beyond the limit throughout), ORR_E_RANGE
//             (a temperature profile that does not cover the run), ORR_E_MEMORY.
//   Reference: IEEE Std 952-1997, annex C; IEEE Std 1293-1998 (accelerometers); Titterton and Weston 2004, 4.4, 6.4.
orr_status orr_imu_add_errors(const orr_imu_errors *errors, orr_imu *imu, orr_errors_report *report,
                              orr_diag *diag);

#endif
