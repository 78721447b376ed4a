// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics that a few outliers do not move. Each puts x[] into another order; values must not be NAN, n
// at least 1.
#ifndef ORR_CORE_ROBUST_H
#define ORR_CORE_ROBUST_H

#include <stddef.h>

// The standard deviation of normal noise over the median of its absolute values: 1 / (sqrt(2) erfinv(1/2)).
#define ORR_SIGMA_PER_MAD 1.4826

// x_(k), k from 0: the value that would stand at x[k] if x[n] were sorted ascending.
double orr_order_statistic(double *x, size_t n, size_t k);
// The middle value; of an even number the mean of the two in the middle.
double orr_median(double *x, size_t n);
// The middle value; of an even number the greater of the two: a value that occurs, as intervals of time
// need it.
double orr_upper_median(double *x, size_t n);

#endif
