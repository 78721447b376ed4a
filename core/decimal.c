// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimal.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/cursor.h"
#include "core/decimal_powers.h"

// Powers of ten that a double holds exactly.
static const double exact_power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// a * b as two words. C17 has no type of 128 bits.
static void multiply(uint64_t a, uint64_t b, uint64_t *high, uint64_t *low)
{
    uint64_t al = (uint32_t)a, ah = a >> 32, bl = (uint32_t)b, bh = b >> 32;
    uint64_t ll = al * bl, lh = al * bh, hl = ah * bl, hh = ah * bh;
    uint64_t middle = (ll >> 32) + (uint32_t)lh + (uint32_t)hl;
    *low = middle << 32 | (uint32_t)ll;
    *high = hh + (lh >> 32) + (hl >> 32) + (middle >> 32);
}

static int leading_zeros(uint64_t v) // of v != 0
{
    int n = 0;
    for (int step = 32; step > 0; step /= 2)
        if (v >> (64 - step) == 0) {
            v <<= step;
            n += step;
        }
    return n;
}

// Lemire 2021, "Number Parsing at a Gigabyte per Second", sections 5 to 8: the product of the mantissa with
// 128 bits of the power decides the rounding, but for rare cases in which it says so itself (false).
static bool scale_by_product(uint64_t mantissa, int exp10, double *out)
{
    if (exp10 < ORR_DECIMAL_POWER_MIN || exp10 > ORR_DECIMAL_POWER_MAX) return false;
    const uint64_t *power = five_to[exp10 - ORR_DECIMAL_POWER_MIN];
    int zeros = leading_zeros(mantissa);
    mantissa <<= zeros;
    uint64_t high, low;
    multiply(mantissa, power[0], &high, &low);
    if ((high & 0x1ff) == 0x1ff) { // the bits below those we keep are all ones: the next word may carry
        uint64_t more, rest;
        multiply(mantissa, power[1], &more, &rest);
        low += more;
        if (low < more) high++;
        if (low == UINT64_MAX) return false;
    }
    int upper = (int)(high >> 63), shift = upper + 9;
    uint64_t m = high >> shift; // 53 bits and one for rounding
    // floor(exp10 log2(10)) by a fraction that is exact for exponents of double.
    int log2 = (217706 * exp10 - (exp10 < 0 ? 65535 : 0)) / 65536;
    int e = log2 + 63 + upper - zeros + 1023;
    if (e <= 0 || e >= 2046) return false;
    // Half way between two numbers: to the even one. Only these powers can have exact halves.
    if (low <= 1 && exp10 >= -4 && exp10 <= 23 && (m & 3) == 1 && m << shift == high) m &= ~UINT64_C(1);
    m = (m + (m & 1)) >> 1;
    if (m >= UINT64_C(1) << 53) {
        m = UINT64_C(1) << 52;
        e++;
    }
    uint64_t bits = (uint64_t)e << 52 | (m & ((UINT64_C(1) << 52) - 1));
    memcpy(out, &bits, sizeof bits);
    return true;
}

// digits * 10^exp10, correctly rounded, for n digits (n <= 128, no sign, no point), for numbers whose mantissa has more than 19 of them.
static double decimal_long(const char *digits, size_t n, int exp10)
{
    // Digits and exponent without a point: there is nothing here a locale could read differently.
    char text[160];
    memcpy(text, digits, n);
    snprintf(text + n, sizeof text - n, "e%d", exp10);
    return strtod(text, NULL);
}

double orr_decimal_scale(uint64_t mantissa, int exp10)
{
    // Both operands are exact, so the one operation rounds once (Clinger 1990, "How to read floating point
    // numbers accurately", section 3).
    if (mantissa <= UINT64_C(1) << 53 && exp10 >= -22 && exp10 <= 22)
        return exp10 < 0 ? (double)mantissa / exact_power[-exp10] : (double)mantissa * exact_power[exp10];
    double x;
    if (mantissa == 0) return 0;
    if (scale_by_product(mantissa, exp10, &x)) return x;
    char text[48];
    int n = snprintf(text, sizeof text, "%" PRIu64, mantissa);
    return decimal_long(text, (size_t)n, exp10);
}

// Three digits, then blanks alone.
static bool bare_exponent(const char *p, const char *end)
{
    for (int i = 0; i < 3; i++)
        if ((unsigned)(unsigned char)p[i] - '0' > 9) return false;
    for (p += 3; p < end; p++)
        if (*p != ' ' && *p != '\t') return false;
    return true;
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
    const bool point = p < end && *p == '.';
    if (point) {
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
    } else if (point && end - p >= 4 && (*p == '-' || *p == '+') && bare_exponent(p + 1, end)) {
        // Fortran drops the letter where the exponent has three digits: 0.499063314674-269.
        const int e = 100 * (p[1] - '0') + 10 * (p[2] - '0') + (p[3] - '0');
        scale += *p == '-' ? -e : e;
        p += 4;
    }
    while (p < end && (*p == ' ' || *p == '\t')) p++;
    if (p != end) return ORR_FIELD_BAD;

    double x;
    if (n_digits <= 19) {
        x = orr_decimal_scale(m, scale);
    } else { // m may have overflowed: take the digits themselves
        char digits[128] = {0};
        size_t n = 0;
        for (const char *q = first; q < mantissa_end; q++)
            if (*q != '.') digits[n++] = *q;
        x = decimal_long(digits, n, scale);
    }
    if (x > 1.7976931348623157e308) return ORR_FIELD_BAD;
    *out = minus ? -x : x;
    return ORR_FIELD_OK;
}
