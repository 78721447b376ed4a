// SPDX-License-Identifier: GPL-3.0-or-later
// Filters that crews of airborne gravimetry choose from: a Gaussian, a finite impulse response of 100 to 160 s, and a Kalman
// smoother with a model of gravity along the line.
#ifndef ORR_INERTIAL_GRAVIMETRY_GRAVITY_FILTER_H
#define ORR_INERTIAL_GRAVIMETRY_GRAVITY_FILTER_H

#include "core/status.h"

typedef enum orr_gravity_filter_kind {
    ORR_GRAVITY_GAUSSIAN, // of standard deviation length_s, cut at 4 of them
    ORR_GRAVITY_FIR,      // sinc under Hann's window over two periods of length_s, at which it passes half
    // Rauch, Tung and Striebel's smoother on heights: p' = v, v' = g, g a second-order Gauss-Markov process.
    ORR_GRAVITY_KALMAN,
} orr_gravity_filter_kind;

typedef struct orr_gravity_filter {
    orr_gravity_filter_kind kind;
    double
        length_s; // standard deviation; period; correlation time 1 / beta of gravity: sigma^2 (1 + beta t) e^(-beta t)
    double model_mgal; // Kalman: sigma of gravity along the line
    double place_m;    // Kalman: standard deviation of a height a sample
} orr_gravity_filter;

// The time at either end of a series within which the filter lacks data on one side: 3 standard deviations, one period, or
// two correlation times.
double orr_gravity_filter_edge_s(const orr_gravity_filter *f);

// Filters a series of means of vertical acceleration over steps.
//   Given:    f             filter
//             x             [n] mGal
//             n, step_s     how many, and their step
//   Returned: out           [n] mGal, not x; towards the ends weights are those of what is there
//   Notes:    ORR_E_ARG with a sentence (a length that is not positive, a series shorter than the filter), ORR_E_MEMORY.
//   Reference: Olesen 2003 (FIR and its ends); Rauch, Tung and Striebel 1965; Jordan 1972 (gravity models).
orr_status orr_gravity_filter_apply(const orr_gravity_filter *f, const double *x, size_t n, double step_s,
                                    double *out, orr_diag *diag);

#endif
