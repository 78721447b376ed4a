// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a fixed count of decimals, for tables of millions of rows: as printf's "%.*f", some ten times
// faster and without the locale.
#ifndef ORR_CORE_FIXED_H
#define ORR_CORE_FIXED_H

#include <stddef.h>

#define ORR_FIXED_TEXT 352 // room for any double and its NUL

// Writes v with 0 to 15 decimals, returns the length. Rounds to nearest of v * 10^decimals as a double has it
// (where that exceeds 2^53 printf's digits are written); a result of zero has no sign; "nan", "inf", "-inf"
// as printf.
size_t orr_fixed(double v, int decimals, char buf[ORR_FIXED_TEXT]);

#endif
