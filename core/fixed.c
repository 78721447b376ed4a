// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fixed.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

size_t orr_fixed(double v, int decimals, char buf[ORR_FIXED_TEXT])
{
    static const double power[16] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    double scaled = v * power[decimals];
    if (!(fabs(scaled) < 9e15)) return (size_t)snprintf(buf, ORR_FIXED_TEXT, "%.*f", decimals, v);
    int64_t n = (int64_t)nearbyint(scaled);
    uint64_t u = n < 0 ? (uint64_t)-n : (uint64_t)n;
    char digits[24];
    int k = 0;
    do {
        digits[k++] = (char)('0' + u % 10);
        u /= 10;
    } while (u > 0 || k <= decimals);
    char *p = buf;
    if (n < 0) *p++ = '-';
    while (k > decimals) *p++ = digits[--k];
    if (decimals > 0) *p++ = '.';
    while (k > 0) *p++ = digits[--k];
    *p = '\0';
    return (size_t)(p - buf);
}
