// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials through values and derivatives at both ends of an interval.
#ifndef ORR_CORE_HERMITE_H
#define ORR_CORE_HERMITE_H

// Cubic through values and rates at both ends.
//   Given:    v0, r0  value and rate at the begin
//             rise    how much larger the value is at the end
//             r1      the rate there
//             T       length of the interval (s); the rates are in the value's unit a second
//   Returned: c       coefficients, so that the value at s seconds from the begin is c[0] + c[1] s + c[2] s^2 + c[3] s^3
static inline void orr_hermite_cubic(double v0, double rise, double r0, double r1, double T, double c[4])
{
    const double slope = rise / T;
    c[0] = v0;
    c[1] = r0;
    c[2] = (3 * slope - 2 * r0 - r1) / T;
    c[3] = (r0 + r1 - 2 * slope) / (T * T);
}

// Quintic through values, rates and second derivatives at both ends.
//   Given:    v, r, a  value, rate and second derivative at the begin and at the end
//             T        length of the interval (s); the derivatives are over seconds
//   Returned: c        coefficients, c[0] + ... + c[5] s^5 at s seconds from the begin
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

// The cubic at s seconds from its begin.
static inline double orr_cubic_at(const double c[4], double s)
{
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}
// Its rate there.
static inline double orr_cubic_rate(const double c[4], double s)
{
    return c[1] + s * (2 * c[2] + s * 3 * c[3]);
}

#endif
