// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic terms of elements over weeks and years: the spectrum by least squares, which needs no even spacing and bridges days that are missing.
#ifndef ORR_ORBIT_ELEMENTS_LINES_H
#define ORR_ORBIT_ELEMENTS_LINES_H

#include "core/status.h"

// One period in a series, beside a cubic trend.
// Given:
//   t          [n] instants, any unit of time, in any order
//   y          [n] values
//   n          how many; at least 6
//   period     in the unit of t
//   windowed   values weigh by Hann's window over the span, so that a strong line leaks less into its neighbours; periods beyond a third of
//              the span are then not to be told from the trend
// Returned:
//   amplitude  of a cosine of that period, of whatever phase, in the unit of y
//   explained  what it explains: the amplitude of a wave over whole turns that has as much of the mean square as is less left over
//              with the period than with the trend alone. Where a trend can stand for much of the wave (periods of half the span
//              and more) the amplitude alone grows with the period, and this has its peak at the line; may be NULL
//   diag       why there is none; may be NULL
// Errors: ORR_E_ARG (too few, or no period), ORR_E_NUMERIC (the series cannot tell the period from the trend).
// Reference: Lomb 1976, with the trend among the unknowns; its normal equations are those of least squares. Zechmeister and Kuerster 2009,
// eq. (4), for what is explained.
orr_status orr_line_amplitude(const double *t, const double *y, size_t n, double period, bool windowed,
                              double *amplitude, double *explained, orr_diag *diag);

#endif
