// SPDX-License-Identifier: GPL-3.0-or-later
// Vector-valued B-splines on uniform knots, the representation behind every sampled trajectory. Fitted by
// banded least squares, kept as polynomials per knot interval because sensors ask for some million values
// with two derivatives.
#ifndef ORR_INERTIAL_MOTION_UNIFORM_SPLINE_H
#define ORR_INERTIAL_MOTION_UNIFORM_SPLINE_H

#include "core/status.h"

#define ORR_USPLINE_MAX_DIM 4
#define ORR_USPLINE_MAX_DEGREE 5
#define ORR_USPLINE_MAX_INTERVALS 20000000u

typedef struct orr_uspline {
    int degree; // 3 (C2) or 5 (C4)
    int dim;
    size_t n;                // knot intervals
    double origin_s, step_s; // interval i is [origin + i step, origin + (i + 1) step]
    double *poly;            // [n][degree + 1][dim]: powers of (t - interval's begin) / step
} orr_uspline;

// Least squares through m samples value[m][dim] at ascending times t_s[m] (all inside the knots), of weights
// weight[m] (NULL: all 1), plus `roughness` times the squared third differences of the coefficients: a small
// one (1e-9) fills gaps and the free ends smoothly and leaves well-observed stretches alone. The uniform
// knots and their least squares are the source's (Bogdanov 2015, eq. (5)-(9), (16), (17)); its basis is 3/2
// of the standard one, which changes coefficients and nothing else.
//   Given:    degree, dim   3 or 5; 1 to ORR_USPLINE_MAX_DIM components
//             origin_s      first knot
//             step_s        knot step, and
//             n_intervals   number of knot intervals
//             m             samples
//             t_s           [m] their times, ascending
//             value         [m][dim]
//             weight        [m]; NULL: all 1
//             roughness     factor of the squared third differences
//   Returned: out           the spline; free with orr_uspline_free
//   Notes:    ORR_E_ARG (degree, dim, times outside or descending), ORR_E_NUMERIC (singular), ORR_E_MEMORY,
//             ORR_E_LIMIT.
//   Reference: Bogdanov 2015, eq. (5)-(9), (16), (17).
orr_status orr_uspline_fit(int degree, int dim, double origin_s, double step_s, size_t n_intervals, size_t m,
                           const double *t_s, const double *value, const double *weight, double roughness,
                           orr_uspline *out, orr_diag *diag);
// Frees the polynomials; an empty spline is allowed.
void orr_uspline_free(orr_uspline *s);

// Value and derivatives of a spline.
//   Given:    s             the spline
//             t_s           time; outside the knots the polynomials of the end intervals continue
//   Returned: value         [dim]
//             d1, d2        [dim] first and second derivative, by s and s^2; may be NULL
void orr_uspline_eval(const orr_uspline *s, double t_s, double *value, double *d1, double *d2);

#endif
