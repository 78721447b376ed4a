// SPDX-License-Identifier: GPL-3.0-or-later
// Parity of LNAV words, as a receiver checks it (IS-GPS-200N 20.3.5.2, table 20-XIV).
#ifndef ORR_TESTS_LNAV_PARITY_H
#define ORR_TESTS_LNAV_PARITY_H

#include "orbit/navdata/lnav_bits.h"

// A receiver's check: each parity bit is the sum of the bits under its mask.
static inline bool lnav_parity_holds(const orr_lnav_subframe *s)
{
    static const uint32_t mask[6] = {0xbb1f3480u, 0x5d8f9a40u, 0xaec7cd00u,
                                     0x5763e680u, 0x6bb1f340u, 0x8b7a89c0u};
    uint32_t last = 0; // D29* D30* of the word before
    for (int w = 0; w < 10; w++) {
        uint32_t word = (last << 30) | s->word[w];
        if (word & 0x40000000u) word ^= 0x3fffffc0u;
        for (int p = 0; p < 6; p++)
            if ((uint32_t)__builtin_parity(word & mask[p]) != (s->word[w] >> (5 - p) & 1u)) return false;
        last = s->word[w] & 3u;
    }
    return true;
}

#endif
