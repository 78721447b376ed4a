// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal digits eight at a time, for the readers of fixed-column formats whose files are large.
#ifndef ORR_CORE_DIGITS_H
#define ORR_CORE_DIGITS_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

// Eight characters as their distance to '0' by xor: 0..9 of a digit, 0x10 of a blank. The first is the lowest
// byte.
static inline uint64_t orr_digits_load(const char *s)
{
    uint64_t v;
    memcpy(&v, s, sizeof v);
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    v = __builtin_bswap64(v);
#endif
    return v ^ UINT64_C(0x3030303030303030);
}

static inline bool orr_digits_all(uint64_t d) // is every byte 0..9?
{
    return ((d | (d + UINT64_C(0x7676767676767676))) & UINT64_C(0x8080808080808080)) == 0;
}

// The number of eight digits, by pairs, fours, eights.
static inline uint32_t orr_digits_value(uint64_t d)
{
    d = d * 10 + (d >> 8);
    return (uint32_t)(((d & UINT64_C(0x000000ff000000ff)) * UINT64_C(0x000f424000000064) +
                       (d >> 16 & UINT64_C(0x000000ff000000ff)) * UINT64_C(0x0000271000000001)) >>
                      32);
}

#endif
