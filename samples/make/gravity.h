// SPDX-License-Identifier: GPL-3.0-or-later
// The Earth's gravitation for the made truth: spherical harmonics by normalised Legendre functions, a
// different road from the program's own (Cartesian recursions), of higher degree than the smoother's.
#ifndef ORR_SAMPLES_GRAVITY_H
#define ORR_SAMPLES_GRAVITY_H

#include "core/vec.h"

#define ORR_SAMPLE_DEGREE 16
#define ORR_SAMPLE_N_COEFFICIENTS 150

typedef struct orr_sample_coefficient {
    int n, m;
    double c, s;
} orr_sample_coefficient;
extern const orr_sample_coefficient ORR_SAMPLE_EGM96[ORR_SAMPLE_N_COEFFICIENTS];

typedef struct orr_sample_gravity {
    int degree;
    double c[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 1], s[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 1];
    // factors of the recursions of P(n, m) and of its derivative
    double a[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 1], b[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 1];
    double d[ORR_SAMPLE_DEGREE + 1][ORR_SAMPLE_DEGREE + 1];
} orr_sample_gravity;

void orr_sample_gravity_init(orr_sample_gravity *g, int degree);
// Gravitation at r (ecef, m), m/s^2, ecef axes. Not at the poles.
orr_vec3 orr_sample_gravitation(const orr_sample_gravity *g, orr_vec3 r_m);

#endif
