// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the sensors' errors, one idea a file: noises, the size effect, bandwidth, sampling.
#ifndef ORR_INERTIAL_SENSE_MEASURED_PRIVATE_H
#define ORR_INERTIAL_SENSE_MEASURED_PRIVATE_H

#include "core/rng.h"
#include "inertial/sense/measured.h"

// --- Noises of one sensor (sensor_noise.c) ---
typedef struct orr_sensor_noise {
    double white; // of a step's integral: N, and the walk about its chord
    double walk;  // of a step
    double ramp;
    size_t n_processes;
    double keep[ORR_ERRORS_MAX_PROCESSES], drive[ORR_ERRORS_MAX_PROCESSES]; // of a step
    double process[ORR_ERRORS_MAX_PROCESSES];                               // now
    double walked;
    double dt_s;
    uint64_t seed, stream; // and the one after it
    uint64_t drawn;        // normal numbers so far, a block at a time
    double draw[ORR_RNG_BLOCK];
} orr_sensor_noise;
// The state before step 0.
//   Given:    e             of the triad
//             axis          0 to 2
//             dt_s          length of a step
//             seed, stream  of the draws; the stream after it is used too
//   Returned: the state
orr_sensor_noise orr_sensor_noise_begin(const orr_triad_errors *e, int axis, double dt_s, uint64_t seed,
                                        uint64_t stream);
// Integral over step j, in order from 0 on.
double orr_sensor_noise_step(orr_sensor_noise *s, size_t j);

// --- Size effect (size_effect.c) ---
// Whether an arm is not zero.
bool orr_size_effect_any(const orr_triad_errors *accel);
// What the accelerometers' arms add to their increments of step j.
void orr_size_effect(const orr_triad_errors *accel, const orr_imu *imu, size_t j, double add[3]);

// --- Bandwidth (bandwidth.c) ---
typedef struct orr_bandwidth {
    bool on, begun;
    double step[3][4];   // of (integral, value, slope, input)
    double value, slope; // of the output
} orr_bandwidth;
// The filter of a triad's sensors for steps of dt_s; it begins settled on its first input.
orr_bandwidth orr_bandwidth_begin(const orr_triad_errors *e, double dt_s);
// Integral of the output over a step, by that of the input.
double orr_bandwidth_step(orr_bandwidth *b, double increment, double dt_s);

// --- Sampling (sampling.c) ---
// Increments between the instants of sampling instead of the edges.
//   Given:    errors        delay and jitter
//             stream        of the draws, one an edge
//             imu           a run, with measured increments between edges
//   Returned: imu           those between instants that are so much late
//   Notes:    ORR_E_MEMORY.
orr_status orr_sampling_shift(const orr_imu_errors *errors, uint64_t stream, orr_imu *imu, orr_diag *diag);

#endif
