// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials through values and derivatives at both ends of an interval.
#ifndef ORR_CORE_HERMITE_H
#define ORR_CORE_HERMITE_H

// Cubic over T seconds through value v0 and rate r0 at its begin, value v0 + rise and rate r1 at its end: c[0] + c[1] s + ...
static inline void orr_hermite_cubic(double v0, double rise, double r0, double r1, double T, double c[4])
{
    const double slope = rise / T;
    c[0] = v0;
    c[1] = r0;
    c[2] = (3 * slope - 2 * r0 - r1) / T;
    c[3] = (r0 + r1 - 2 * slope) / (T * T);
}

// Quintic likewise, through second derivatives a0 and a1 too.
static inline void orr_hermite_quintic(const double v[2], const double r[2], const double a[2], double T,
                                       double c[6])
{
    const double A = (v[1] - v[0] - T * (r[0] + T * a[0] / 2)) / (T * T * T);
    const double B = (r[1] - r[0] - T * a[0]) / (T * T), C = (a[1] - a[0]) / T;
    c[0] = v[0];
    c[1] = r[0];
    c[2] = a[0] / 2;
    c[3] = 10 * A - 4 * B + C / 2;
    c[4] = (-15 * A + 7 * B - C) / T;
    c[5] = (6 * A - 3 * B + C / 2) / (T * T);
}

// The cubic at s, and its rate.
static inline double orr_cubic_at(const double c[4], double s)
{
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}
static inline double orr_cubic_rate(const double c[4], double s)
{
    return c[1] + s * (2 * c[2] + s * 3 * c[3]);
}

#endif
