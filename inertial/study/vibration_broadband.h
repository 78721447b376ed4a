// SPDX-License-Identifier: GPL-3.0-or-later
// Vibration with a spectrum instead of a single tone: what attitude algorithms drift by on the power spectral density of a
// user's table, by the response of each method and by runs on made vibration of that density.
#ifndef ORR_INERTIAL_STUDY_VIBRATION_BROADBAND_H
#define ORR_INERTIAL_STUDY_VIBRATION_BROADBAND_H

#include "inertial/study/attitude_method.h"

// One-sided densities at ascending frequencies, joined by straight lines in logarithms, 0 outside.
typedef struct orr_vibration_psd {
    size_t n;                   // 2 at least
    const double *frequency_hz; // [n] positive, ascending
    const double *rate;         // [n] of the rate about each of axes 1 and 2, (rad/s)^2/Hz
    double
        coherence; // part of the vibration of axis 2 that follows axis 1 by a quarter of a period, -1 to 1: 1 is a cone
} orr_vibration_psd;

// Checks a table. ORR_E_ARG with a sentence (too few, not ascending, negative densities, coherence).
orr_status orr_vibration_psd_check(const orr_vibration_psd *p, orr_diag *diag);
// The density at a frequency.
double orr_vibration_psd_at(const orr_vibration_psd *p, double frequency_hz);

// What one drifts by who sees mean rates alone, rad/s, clockwise: coherence times the integral of S(f) / (2 pi f), the sum
// of (31) over the spectrum.
double orr_vibration_psd_drift(const orr_vibration_psd *p);
// What a method drifts by at readings of readings_hz: the same integral with its response; rad/s, clockwise.
double orr_vibration_psd_error(const orr_vibration_psd *p, const orr_attitude_method *m, double readings_hz);

// The same by a run on a vibration that has this density: tones of random phases, exact rate, integrated over each reading.
//   Given:    p             density
//             m             [n_methods]
//             n_methods     how many; at most 32
//             readings_hz   f_m
//             duration_s    of the run
//             seed          of the phases
//   Returned: drift_radps   [n_methods] mean heading error, clockwise, rad/s
//   Notes:    A run shows its drift with the scatter of a run: see the tests. ORR_E_ARG, ORR_E_LIMIT, ORR_E_MEMORY.
orr_status orr_vibration_psd_run(const orr_vibration_psd *p, const orr_attitude_method *m, size_t n_methods,
                                 double readings_hz, double duration_s, uint64_t seed, double *drift_radps,
                                 orr_diag *diag);

#endif
