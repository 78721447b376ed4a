// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal digits to double, correctly rounded and without the locale: the numeric core of the text cursor.
#ifndef ORR_CORE_DECIMAL_H
#define ORR_CORE_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// mantissa * 10^exp10, correctly rounded; HUGE_VAL past the range of double.
double orr_decimal_scale(uint64_t mantissa, int exp10);

#endif
