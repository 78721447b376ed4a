// SPDX-License-Identifier: GPL-3.0-or-later
// What vibration during alignment does to attitude and velocity algorithms: errors of mean heading under coning and of
// mean acceleration under sculling, over the ratio of the vibration's frequency to that of the readings (Bogdanov 2015,
// section 5).
#ifndef ORR_INERTIAL_STUDY_VIBRATION_H
#define ORR_INERTIAL_STUDY_VIBRATION_H

#include "inertial/motion/motion.h"
#include "inertial/study/attitude_method.h"

// A study: everything but the method and the frequency of the vibration.
typedef struct orr_vibration_study {
    double readings_hz; // f_m
    double product_hz;  // f_v beta^2, rad^2/s: the same at every frequency
    double duration_s;  // of a run; cut down to whole groups
    // Rest readings with the Earth's rate and gravity (section 5.1); without, the body vibrates in inertial axes.
    bool earth;
    double lat_rad;
    orr_angles attitude;
} orr_vibration_study;

// One method at one frequency.
typedef struct orr_vibration_error {
    double amplitude_rad; // beta = sqrt(product / f_v)
    double duration_s;    // that was run
    double drift_radps;   // of (31), clockwise about the cone's axis: +pi f_v beta^2
    double heading_rad;   // computed less true at the end, clockwise about the vertical
    double normalised; // error about the cone's axis over drift and time; heading's where the body is level
    double tilt_rad;   // what is left of the attitude's error without the heading's
} orr_vibration_error;

// Runs one method on exact increments of one vibration.
//   Given:    study         the study
//             method        the method
//             ratio         f_v / f_m, positive
//   Returned: out           its error
//   Notes:    In extended precision: errors are resolved to about 1e-14 of the drift of (31). ORR_E_ARG (an amplitude of
//             half a turn or more, a run shorter than a group).
//   Reference: Bogdanov 2015, eq. (28)-(31).
orr_status orr_vibration_error_of(const orr_vibration_study *study, const orr_attitude_method *method,
                                  double ratio, orr_vibration_error *out, orr_diag *diag);

// The velocity's counterpart: the body turns about axis 1 by beta sin wt while its axis 2 feels a force sin wt. The mean
// acceleration along axis 3 is force J_1(beta); what a method has of it less, over that, as the mean over the phases 0 and
// 90 deg (a single one also shows the end of the run).
//   Given:    study         the study; its Earth is not used
//             method        the method
//             ratio         f_v / f_m, positive
//   Returned: normalised    0 of a perfect method, 1 of one that sees mean forces alone
//   Notes:    ORR_E_ARG, as above.
//   Reference: Ignagni 1998; Roscoe 2001, J. Guidance 24, 205-212.
orr_status orr_sculling_error_of(const orr_vibration_study *study, const orr_attitude_method *method,
                                 double ratio, double *normalised, orr_diag *diag);

// A ratio where the errors of two methods are of equal size: below it one is better, above it the other.
typedef struct orr_vibration_crossing {
    size_t first, second; // methods
    double ratio;
    double normalised; // the size of both errors there
} orr_vibration_crossing;
// Crossings of two methods between the lowest and the highest ratio, by orr_attitude_method_response.
//   Given:    methods       [n] methods
//             low, high     ratios, 0 < low < high
//             most          room in `out`
//   Returned: out           crossings in ascending order of the ratio; the first `most`
//             (value)       how many
//   Notes:    Frequencies at which both methods are without error at once are no crossings.
size_t orr_vibration_crossings(const orr_attitude_method *methods, size_t n, double low, double high,
                               orr_vibration_crossing *out, size_t most);

#endif
