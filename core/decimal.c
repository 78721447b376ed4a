// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimal.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/cursor.h"

// Powers of ten that a double holds exactly.
static const double exact_power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

double orr_decimal_scale(uint64_t mantissa, int exp10)
{
    // Both operands are exact, so the one operation rounds once (Clinger 1990, "How to read floating point
    // numbers accurately", section 3).
    if (mantissa <= UINT64_C(1) << 53 && exp10 >= -22 && exp10 <= 22)
        return exp10 < 0 ? (double)mantissa / exact_power[-exp10] : (double)mantissa * exact_power[exp10];
    char text[48];
    int n = snprintf(text, sizeof text, "%" PRIu64, mantissa);
    return orr_decimal_long(text, (size_t)n, exp10);
}

double orr_decimal_long(const char *digits, size_t n, int exp10)
{
    // Digits and exponent without a point: there is nothing here a locale could read differently.
    char text[160];
    memcpy(text, digits, n);
    snprintf(text + n, sizeof text - n, "e%d", exp10);
    return strtod(text, NULL);
}

orr_field orr_view_real(orr_view v, double *out) { return orr_view_real_e(v, 0, out); }

orr_field orr_view_real_e(orr_view v, int power, double *out)
{
    const char *p = v.p, *end = v.p + v.n;
    while (p < end && (*p == ' ' || *p == '\t')) p++;
    if (p == end) return ORR_FIELD_BLANK;
    if (end - p > 128) return ORR_FIELD_BAD;
    bool minus = *p == '-';
    if (*p == '-' || *p == '+') p++;

    uint64_t m = 0;
    const char *first = p;
    while (p < end && (unsigned)(unsigned char)*p - '0' <= 9)
        m = m * 10 + ((unsigned)(unsigned char)*p++ - '0');
    size_t n_digits = (size_t)(p - first);
    int scale = power;
    if (p < end && *p == '.') {
        const char *fraction = ++p;
        while (p < end && (unsigned)(unsigned char)*p - '0' <= 9)
            m = m * 10 + ((unsigned)(unsigned char)*p++ - '0');
        scale -= (int)(p - fraction);
        n_digits += (size_t)(p - fraction);
    }
    if (n_digits == 0) return ORR_FIELD_BAD;
    const char *mantissa_end = p;

    if (p < end && (*p == 'D' || *p == 'd' || *p == 'E' || *p == 'e')) {
        p++;
        bool down = false;
        if (p < end && (*p == '-' || *p == '+' || *p == ' ')) down = *p++ == '-';
        int e = 0;
        const char *e_first = p;
        while (p < end && (unsigned)(unsigned char)*p - '0' <= 9) {
            if (e < 100000) e = e * 10 + (*p - '0');
            p++;
        }
        if (p == e_first) return ORR_FIELD_BAD;
        scale += down ? -e : e;
    }
    while (p < end && (*p == ' ' || *p == '\t')) p++;
    if (p != end) return ORR_FIELD_BAD;

    double x;
    if (n_digits <= 19) {
        x = orr_decimal_scale(m, scale);
    } else { // m may have overflowed: take the digits themselves
        char digits[128];
        size_t n = 0;
        for (const char *q = first; q < mantissa_end; q++)
            if (*q != '.') digits[n++] = *q;
        x = orr_decimal_long(digits, n, scale);
    }
    if (x > 1.7976931348623157e308) return ORR_FIELD_BAD;
    *out = minus ? -x : x;
    return ORR_FIELD_OK;
}
