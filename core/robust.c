// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robust.h"

#include <assert.h>
#include <gsl/gsl_statistics_double.h>

double orr_order_statistic(double *x, size_t n, size_t k)
{
    assert(k < n);
    return gsl_stats_select(x, 1, n, k);
}

double orr_median(double *x, size_t n)
{
    assert(n > 0);
    return gsl_stats_median(x, 1, n);
}

double orr_upper_median(double *x, size_t n) { return orr_order_statistic(x, n, n / 2); }
