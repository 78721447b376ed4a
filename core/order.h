// SPDX-License-Identifier: GPL-3.0-or-later
// Orders for qsort that more than one file needs.
#ifndef ORR_CORE_ORDER_H
#define ORR_CORE_ORDER_H

// Doubles ascending; for medians and percentiles.
static inline int orr_by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif
