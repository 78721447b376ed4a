// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithms that carry attitude (and velocity) over a group of increments: rotation vectors with terms for coning and
// sculling, given by their coefficients, and functional iteration. Vibration studies compare them.
#ifndef ORR_INERTIAL_STUDY_ATTITUDE_METHOD_H
#define ORR_INERTIAL_STUDY_ATTITUDE_METHOD_H

#include "core/status.h"
#include "core/vec.h"

#define ORR_METHOD_MAX_SAMPLES 8

typedef enum orr_method_kind {
    // phi = sum_i d_i + sum_{i<j} pair_ij d_i x d_j over the group's increments d_1..d_N.
    ORR_METHOD_ROTATION_VECTOR,
    // The rate as the polynomial through the increments, q = q_0 + 1/2 integral of q w by Picard's iteration on
    // Chebyshev nodes until it stands still.
    ORR_METHOD_ITERATION,
} orr_method_kind;

typedef struct orr_attitude_method {
    char name[32];
    orr_method_kind kind;
    int samples; // of a group, N
    // Of d_i x d_j, i < j. Of an iteration, those of its second order: what it does to small vibrations.
    long double pair[ORR_METHOD_MAX_SAMPLES][ORR_METHOD_MAX_SAMPLES];
} orr_attitude_method;

// Names of the methods that are built in, in their order; NULL after the last: "1-step" .. "5-step" (coefficients that
// leave the least error for slow coning: Miller 1983; Lee, Yoon and others 1990; Ignagni 1996), "polynomial-3" .. "-5"
// (of the polynomial through the increments), "iteration-4" and "iteration-8" (Wu 2018).
const char *orr_attitude_method_name(size_t k);
// A built-in method by its name. ORR_E_ARG with the names.
orr_status orr_attitude_method_builtin(const char *name, orr_attitude_method *out, orr_diag *diag);
// A method of the user's.
//   Given:    name          for tables; 31 bytes at most
//             samples       N of a group, 1 to ORR_METHOD_MAX_SAMPLES
//             coefficient   [n] N - 1 of them multiply (k_1 d_1 + .. + k_{N-1} d_{N-1}) x d_N; N (N - 1) / 2 of them the
//                           pairs (1,2), (1,3) .. (1,N), (2,3) ..
//             n             how many
//   Returned: out           the method
//   Notes:    ORR_E_ARG with a sentence (another number of coefficients, one that is no number).
orr_status orr_attitude_method_make(const char *name, int samples, const double *coefficient, size_t n,
                                    orr_attitude_method *out, orr_diag *diag);

// sum_{i<j} pair_ij (j - i) over N^3 / 12, which is 1 of a method whose error of slow vibrations falls faster than that of
// one step; 0 of one step.
double orr_attitude_method_consistency(const orr_attitude_method *m);

// Error of the attitude of slow mean rotation that coning leaves, over the drift of (31), to second order in the
// amplitude: 1 - sin(wH)/(wH) - (8 / wH) sin^2(wh/2) sum pair_ij sin((j - i) wh), h the step between samples and H = N h.
// It is the error of mean velocity under sculling too, over that of one who leaves sculling out (Roscoe 2001).
//   Given:    m             method
//             ratio         f_v / f_m
//   Returned: (value)       0 of a perfect method, 1 of one that sees mean rates alone
double orr_attitude_method_response(const orr_attitude_method *m, double ratio);

#endif
