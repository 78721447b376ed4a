// SPDX-License-Identifier: GPL-3.0-or-later
// The cubics of a block evaluated, as a generator does.
#ifndef ORR_TESTS_BLOCK_AT_H
#define ORR_TESTS_BLOCK_AT_H

#include <math.h>

#include "src/scenario/channel/block.h"

static inline double block_cubic(const double c[4], double s)
{
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}
// Code s seconds after the block's begin, m.
static inline double block_code_m(const orr_block *b, double s) { return block_cubic(b->code, s); }
// Carrier then: whole cycles, and the rest in [0, 1).
static inline void block_carrier(const orr_block *b, double s, int64_t *cycles, double *fraction)
{
    const double x = block_cubic(b->carrier, s), whole = floor(x);
    *cycles = b->carrier_cycles + (int64_t)whole;
    *fraction = x - whole;
}

#endif
