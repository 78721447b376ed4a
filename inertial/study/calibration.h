// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration on a stand as least squares: which parameters of the sensors a plan of cycles shows, and how well; and their
// estimate from measured readings, as a check of data sets that others calibrate by.
#ifndef ORR_INERTIAL_STUDY_CALIBRATION_H
#define ORR_INERTIAL_STUDY_CALIBRATION_H

#include "inertial/study/calibration_stand.h"

// What the sensors add to the ideal: measured = M ideal + bias. The axes of the body are those that the accelerometers fix:
// their matrix has nothing above the diagonal.
typedef struct orr_calibration_truth {
    double accel_bias_mps2[3], gyro_bias_radps[3];
    orr_mat3 accel, gyro; // M
    orr_vec3 inner_m[3];  // places of the accelerometers from the unit's point
} orr_calibration_truth;

// Brings sensors whose accelerometers' matrix is any other to these axes: M_a = T R with T lower triangular and R a rotation,
// the axes of the body turned by R.
//   Given:    truth         in any axes
//   Returned: truth         in the accelerometers' own
//             turned        R: those axes from the former ones
//   Notes:    ORR_E_NUMERIC where two accelerometers look the same way.
orr_status orr_calibration_own_axes(orr_calibration_truth *truth, orr_mat3 *turned, orr_diag *diag);

#define ORR_CALIBRATION_SENSORS 21
#define ORR_CALIBRATION_MOST_CYCLES 24

typedef struct orr_calibration_plan {
    const orr_stand *stand;
    size_t n_cycles;
    const orr_stand_cycle
        *cycle;     // [n_cycles] with the true mounting, start angle and offset, which are not used but
                    // by orr_calibration_true_values
    double block_s; // readings are summed over so long
    // Inner arms as unknowns: six, those of the second and third accelerometer from the first, where the offset of each cycle
    // is unknown too (all nine cannot be told from it); nine with offsets_known.
    bool arms, offsets_known;
    // Where offsets are unknown: the known part of the first accelerometer's place along the body's axis that is nearest to the
    // stand's. It acts through the gradient of gravity alone, 3e-7 g a metre, and a ruler knows it well enough.
    double along_m[ORR_CALIBRATION_MOST_CYCLES];
    double gyro_white_radps_s, accel_white_mps2_s; // weights: N of the noises, per sqrt(s)
} orr_calibration_plan;

// Names of the parameters in their order, units with them: "accelerometer bias x", "m/s2". The first 21 are of the sensors
// (biases, scale factors and three misalignments of the accelerometers; biases and the nine of the matrix of the gyros), then 6 or
// 9 of arms. NULL beyond.
const char *orr_calibration_name(const orr_calibration_plan *plan, size_t k, const char **unit);
// How large unknown k usually is, in its unit: 1 mg, 1 %, 10 mrad, 2 deg/h, 10 cm, and of mounting 0.1 rad and 10 cm.
double orr_calibration_size(size_t k);
// How many of them: 21, 27 or 30.
size_t orr_calibration_parameters(const orr_calibration_plan *plan);
// The same with what is solved along: for each cycle two angles of mounting and the start angle (the third angle of mounting
// is one with it), and where offsets are unknown two parts of the offset across the axis.
size_t orr_calibration_unknowns(const orr_calibration_plan *plan);

// Sums of measured readings over blocks.
typedef struct orr_calibration_data {
    size_t n;              // blocks of all cycles
    size_t *cycle;         // [n]
    double *from_s, *to_s; // [n]
    orr_vec3 *dtheta_rad, *dv_mps;
} orr_calibration_data;
// Sums the readings of all cycles.
//   Given:    plan          blocks
//             imu           [n_cycles] readings
//             measured      those with errors, else ideal ones
//   Returned: out           free with orr_calibration_data_free
//   Notes:    ORR_E_ARG (no readings with errors, too few), ORR_E_MEMORY.
orr_status orr_calibration_sum(const orr_calibration_plan *plan, const orr_imu *imu, bool measured,
                               orr_calibration_data *out, orr_diag *diag);
// Frees all; zero may be freed.
void orr_calibration_data_free(orr_calibration_data *d);

#define ORR_CALIBRATION_MOST 160 // unknowns

typedef struct orr_calibration_result {
    size_t n, sensors;                  // unknowns, and those of them that orr_calibration_name names
    double value[ORR_CALIBRATION_MOST]; // [n]
    double sigma[ORR_CALIBRATION_MOST]; // [n] by the plan's noises; infinite where the plan cannot see it
    double *covariance;                 // [n][n]
    double *factor;                     // R of the weighted problem at the solution
    // Observability: singular values of the problem, readings in their sigma and unknowns in the sizes of
    // orr_calibration_size.
    double condition;                     // largest over smallest
    size_t unseen;                        // how many combinations readings tell no better than that size
    bool seen[ORR_CALIBRATION_MOST];      // whether a parameter has no part in these
    size_t partner[ORR_CALIBRATION_MOST]; // with which other one it is correlated most
    double correlation[ORR_CALIBRATION_MOST];
    double residual_rms; // over their sigma
    int iterations;
} orr_calibration_result;
// Frees all; zero may be freed.
void orr_calibration_result_free(orr_calibration_result *r);

// Observability of a plan at given values, without readings. ORR_E_NUMERIC is none of its errors: what cannot be seen is told.
//   Given:    plan          the plan
//             value         [unknowns] where; NULL: perfect sensors, mounted as meant
//   Returned: out           everything but residuals; free with orr_calibration_result_free
//   Notes:    ORR_E_ARG, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_calibration_observe(const orr_calibration_plan *plan, const double *value,
                                   orr_calibration_result *out, orr_diag *diag);
// Least squares by Gauss and Newton.
//   Given:    plan          the plan
//             data          sums
//             start         [unknowns] values to begin with; NULL: perfect sensors, mounted as meant
//             most          iterations at most; 1 is one linear step from `start`
//   Returned: out           free with orr_calibration_result_free
//   Notes:    ORR_E_NUMERIC with the names of what a singular plan cannot see, or where it does not converge.
orr_status orr_calibration_solve(const orr_calibration_plan *plan, const orr_calibration_data *data,
                                 const double *start, int most, orr_calibration_result *out, orr_diag *diag);

// A plan about one solution, for many sets of noise: each is then one linear step from there.
typedef struct orr_calibration_linear {
    size_t rows;
    double *J, *y;                     // [rows][n] and [rows], over their sigma
    const orr_calibration_data *about; // borrowed
    orr_calibration_result at;
} orr_calibration_linear;
// Frees all; zero may be freed.
void orr_calibration_linear_free(orr_calibration_linear *l);
// Linearises about values.
//   Given:    plan          the plan
//             data          sums that the step starts from, kept by reference
//             value         [unknowns]
//   Returned: out           free with orr_calibration_linear_free
//   Notes:    those of orr_calibration_solve.
orr_status orr_calibration_linearise(const orr_calibration_plan *plan, const orr_calibration_data *data,
                                     const double *value, orr_calibration_linear *out, orr_diag *diag);
// One step on other sums of the same plan.
//   Given:    plan, l       as above
//             data          sums
//   Returned: value         [unknowns]
void orr_calibration_linear_step(const orr_calibration_plan *plan, const orr_calibration_linear *l,
                                 const orr_calibration_data *data, double *value);

// That part as it truly is.
double orr_calibration_along(const orr_stand_cycle *cycle, const orr_calibration_truth *truth);
// The unknowns as they truly are.
//   Given:    plan          whose cycles have the true mounting, in the axes of `truth`
//             truth         sensors in their accelerometers' own axes
//   Returned: value         [unknowns]
void orr_calibration_true_values(const orr_calibration_plan *plan, const orr_calibration_truth *truth,
                                 double *value);
// Normalised squared error of the first unknowns: e' P^-1 e, of mean k where the covariance is right.
//   Given:    r             whose covariance
//             value, truth  [k] found, and true
//             k             how many
//   Returned: nees          the number
//   Notes:    ORR_E_NUMERIC, ORR_E_MEMORY.
orr_status orr_calibration_nees(const orr_calibration_result *r, const double *value, const double *truth,
                                size_t k, double *nees, orr_diag *diag);

#endif
