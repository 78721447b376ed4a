// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver's loops make of a signal and its echoes: the code delay, phase and amplitude at which an early-minus-late
// discriminator stands still. In closed form of the code's autocorrelation, without noise, dynamics or filters.
#ifndef ORR_SCENARIO_OBSERVABLES_CORRELATOR_H
#define ORR_SCENARIO_OBSERVABLES_CORRELATOR_H

#include "core/signal.h"

#define ORR_CORRELATOR_RAYS 8

// A ray: the signal itself, or an echo of it.
typedef struct orr_correlator_ray {
    double amplitude, delay_m, phase_cycles; // the phase range, of the carrier: larger is later
} orr_correlator_ray;

// Autocorrelation of a signal's code over an offset in chips: a triangle for BPSK and QPSK, that of BOC(1,1) with 1/11 of BOC(6,1) for
// CBOC, TMBOC and QMBOC, whose documents share the power of all components out so.
double orr_correlation(const orr_signal *s, double chips);

// Where the loops stand.
// Given:
//   s        signal
//   spacing  between early and late, chips
//   ray, n   the signal first, then its echoes, at most ORR_CORRELATOR_RAYS
// Returned:
//   code_m        against the first ray's delay
//   phase_cycles  against its phase, within half a cycle
//   gain          amplitude against that of the first ray alone
// Notes: of |early|^2 - |late|^2 the rising zero nearest to the first ray.
// Reference: van Nee 1993; Braasch 2017 (Springer Handbook of GNSS, 15.3).
void orr_correlator(const orr_signal *s, double spacing, const orr_correlator_ray *ray, size_t n,
                    double *code_m, double *phase_cycles, double *gain);

#endif
