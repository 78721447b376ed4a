// SPDX-License-Identifier: GPL-3.0-or-later
// A line or parabola, with or without a half-day harmonic, fitted to a clock's nodes; and how each value that
// it gives depends on the nodes. Room-internal.
#ifndef ORR_ORBIT_CLOCK_CLOCK_CURVE_H
#define ORR_ORBIT_CLOCK_CLOCK_CURVE_H

#include "core/status.h"

enum { ORR_CLOCK_TERMS = 5 };

typedef struct orr_clock_curve {
    int degree;    // 1 or 2
    bool harmonic; // cos and sin of ORR_CLOCK_HARMONIC_S
    int n_terms;
    double inverse[ORR_CLOCK_TERMS * ORR_CLOCK_TERMS]; // of the normal matrix, [n_terms][n_terms]
    double x[ORR_CLOCK_TERMS];                         // the fitted terms, s
} orr_clock_curve;

// Fits the curve to a clock's nodes by least squares.
// Given:
//   degree    1 (line) or 2 (parabola)
//   harmonic  with cosine and sine of half a sidereal day
//   days      [n] instants of the nodes, days from an origin of the caller's
//   clock_s   [n] clocks, s
//   weight    [n] weights of the nodes; they act as their squares
//   n         how many nodes
// Returned:
//   out       the curve and the inverse of its normal matrix
// Errors: ORR_E_NUMERIC where the nodes do not tell the terms.
orr_status orr_clock_curve_fit(int degree, bool harmonic, const double *days, const double *clock_s,
                               const double *weight, size_t n, orr_clock_curve *out);
// The clock at `days`, s.
double orr_clock_curve_at(const orr_clock_curve *c, double days);
// Its derivative at `days`, s a day.
double orr_clock_curve_rate_per_day(const orr_clock_curve *c, double days);
// How the value at `at_days` changes with the node at `days` of weight `weight`.
double orr_clock_curve_gain(const orr_clock_curve *c, double at_days, double days, double weight);

#endif
