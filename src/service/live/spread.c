// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/spread.h"

#include <math.h>
#include <stdlib.h>

static const double LEAST_NS = 1000, BINS_AN_OCTAVE = 8;

static size_t bin_of(int64_t ns)
{
    const double size = fabs((double)ns);
    if (size < LEAST_NS) return ORR_SPREAD_SIDE;
    const double k = fmin(floor(log2(size / LEAST_NS) * BINS_AN_OCTAVE), ORR_SPREAD_SIDE - 1);
    return ns > 0 ? ORR_SPREAD_SIDE + 1 + (size_t)k : ORR_SPREAD_SIDE - 1 - (size_t)k;
}

// The middle of a bin.
static int64_t middle_ns(size_t bin)
{
    if (bin == ORR_SPREAD_SIDE) return 0;
    const bool late = bin > ORR_SPREAD_SIDE;
    const double k = (double)(late ? bin - ORR_SPREAD_SIDE - 1 : ORR_SPREAD_SIDE - 1 - bin) + 0.5;
    const int64_t ns = llround(LEAST_NS * exp2(k / BINS_AN_OCTAVE));
    return late ? ns : -ns;
}

void orr_spread_add(orr_spread *s, int64_t ns)
{
    if (s->n == 0 || ns < s->min_ns) s->min_ns = ns;
    if (s->n == 0 || ns > s->max_ns) s->max_ns = ns;
    s->last_ns = ns;
    s->n++;
    s->bin[bin_of(ns)]++;
}

static int64_t percentile_ns(const orr_spread *s, uint64_t percent)
{
    const uint64_t wanted = s->n * percent / 100;
    uint64_t below = 0;
    for (size_t k = 0; k < sizeof s->bin / sizeof s->bin[0]; k++) {
        below += s->bin[k];
        if (below > wanted) { // within what was seen
            const int64_t m = middle_ns(k);
            return m < s->min_ns ? s->min_ns : m > s->max_ns ? s->max_ns : m;
        }
    }
    return s->max_ns;
}

orr_msg_motion_spread orr_spread_told(const orr_spread *s)
{
    if (s->n == 0) return (orr_msg_motion_spread){0, 0, 0, 0, 0};
    return (orr_msg_motion_spread){s->min_ns, s->max_ns, s->last_ns, percentile_ns(s, 50),
                                   percentile_ns(s, 99)};
}
