// SPDX-License-Identifier: GPL-3.0-or-later
// Allan and Hadamard deviation of a sensor's readings, and the coefficients of its noises.
#ifndef ORR_INERTIAL_SENSE_ALLAN_H
#define ORR_INERTIAL_SENSE_ALLAN_H

#include "core/status.h"

#define ORR_ALLAN_MAX_POINTS 128

// One averaging time. Deviations are in the unit of the rate (increment per second).
typedef struct orr_allan_point {
    double tau_s;
    double deviation; // overlapping Allan
    double low, high; // 95 % interval of it, by chi-square with the equivalent degrees of freedom
    double freedom;   // those, of the noise that the slope shows there
    double
        hadamard; // overlapping Hadamard deviation, which a steady drift does not move; NAN: too few samples
} orr_allan_point;

typedef struct orr_allan {
    double duration_s;
    size_t n;
    orr_allan_point point[ORR_ALLAN_MAX_POINTS]; // ascending
} orr_allan;

// Deviations at ten averaging times a decade, from a sample up to a third of the run.
//   Given:    increment     [n] integrals of the rate over successive samples
//             n             9 at least
//             dt_s          length of a sample
//   Returned: out           the curve
//   Notes:    ORR_E_ARG, ORR_E_MEMORY.
//   Reference: Riley and Howe 2008, NIST SP 1065, 5.2.4, 5.2.10, 5.4.1 (degrees of freedom: Howe, Allan, Barnes 1981).
orr_status orr_allan_deviation(const double *increment, size_t n, double dt_s, orr_allan *out,
                               orr_diag *diag);

// Noises that a curve is made of.
typedef enum orr_allan_noise {
    ORR_ALLAN_QUANTISATION, // Q: sigma = sqrt(3) Q / tau
    ORR_ALLAN_WHITE,        // N: sigma = N / sqrt(tau), angle or velocity random walk
    ORR_ALLAN_INSTABILITY,  // B: sigma = sqrt(2 ln 2 / pi) B = 0.664 B, flicker
    ORR_ALLAN_RATE_WALK,    // K: sigma = K sqrt(tau / 3)
    ORR_ALLAN_RAMP,         // R: sigma = R tau / sqrt(2)
    ORR_ALLAN_NOISES,
} orr_allan_noise;
const char *orr_allan_noise_name(orr_allan_noise k); // "quantisation", ...

typedef struct orr_allan_coefficient {
    bool seen;               // it is above twice its standard deviation
    double value, low, high; // and its 95 % interval
} orr_allan_coefficient;

typedef struct orr_allan_fit {
    double longest_tau_s; // of the points that were fitted: a 200th of the run
    orr_allan_coefficient noise[ORR_ALLAN_NOISES];
    // A hump instead of a floor: a Gauss-Markov process of standard deviation and correlation time (its peak is
    // 0.618 sigma at 1.89 T). Where it describes the curve better than a floor, noise[INSTABILITY] is not seen.
    bool gauss_markov;
    double sigma;                                 // its interval is that of noise[INSTABILITY]
    double correlation_s;                         // T, and
    double correlation_low_s, correlation_high_s; // its 95 % interval
} orr_allan_fit;

// The coefficients, in units of rate and seconds, by weighted least squares on the Allan variance. Their intervals come
// from the scatter between ten parts of the run, so that correlation between points of the curve is in them.
//   Given:    increment, n, dt_s   as above; n 4000 at least
//   Returned: out                  coefficients
//   Notes:    ORR_E_ARG, ORR_E_NODATA (too short), ORR_E_MEMORY.
//   Reference: IEEE Std 952-1997, annex C.
orr_status orr_allan_coefficients(const double *increment, size_t n, double dt_s, orr_allan_fit *out,
                                  orr_diag *diag);

#endif
