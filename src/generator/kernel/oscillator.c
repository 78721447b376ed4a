// SPDX-License-Identifier: MIT
#include "src/generator/kernel/oscillator.h"

#include <math.h>

#define NS_PER_S 1000000000
#define SPEED_OF_LIGHT 299792458.0
#define CHIP ((int64_t)1 << ORR_GEN_CODE_BITS)

int64_t orr_gen_first_sample(int64_t t_ns, uint32_t rate_hz)
{
    int64_t s = t_ns / NS_PER_S, ns = t_ns % NS_PER_S;
    if (ns < 0) s--, ns += NS_PER_S;
    const int64_t rate = (int64_t)rate_hz;
    return s * rate + (ns * rate + NS_PER_S - 1) / NS_PER_S; // ns * rate is below 4.3e18
}

// Seconds from the block's begin to a sample: exact but for one rounding.
static double since_block(const orr_gen_cubics *c, const orr_gen_tuning *t, int64_t sample)
{
    int64_t s = c->block_ns / NS_PER_S, ns = c->block_ns % NS_PER_S;
    if (ns < 0) s--, ns += NS_PER_S;
    const int64_t rest = sample - s * (int64_t)t->rate_hz; // samples since the block's whole second
    return ((double)rest * 1e9 - (double)ns * (double)t->rate_hz) / (1e9 * (double)t->rate_hz);
}

static double cubic(const double c[4], double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

// What of a cubic is beyond its first coefficient.
static double beyond(const double c[4], double s) { return s * (c[1] + s * (c[2] + s * c[3])); }

// The fraction of `cycles` as a word. Casts of the negative wrap as they should.
static uint64_t turns(double cycles)
{
    const double whole = floor(cycles);
    return (uint64_t)((cycles - whole) * 0x1p64 < 0x1p64 ? (cycles - whole) * 0x1p64 : 0.0);
}

// phase = offset * t - phase range. Of offset * t the whole seconds are whole cycles; the rest is rational.
static uint64_t carrier_word(const orr_gen_cubics *c, const orr_gen_tuning *t, int64_t sample, double s)
{
    const int64_t rate = (int64_t)t->rate_hz;
    int64_t in_second = sample % rate;
    if (in_second < 0) in_second += rate;
    int64_t product = (t->offset_hz % rate) * in_second % rate; // rate is below 2^32 and so are the factors
    if (product < 0) product += rate;
    const uint64_t intermediate = turns((double)product / (double)rate);
    return intermediate - turns(cubic(c->carrier_cycles, s));
}

// Satellite's time at a sample as whole second and sub-chips since.
static uint64_t code_word(const orr_gen_cubics *c, const orr_gen_tuning *t, double s, int64_t *second)
{
    int64_t whole = c->transmit_ns / NS_PER_S, ns = c->transmit_ns % NS_PER_S;
    if (ns < 0) whole--, ns += NS_PER_S;
    // Sub-chips at the block's begin: those of whole nanoseconds by integers.
    const uint64_t scaled = (uint64_t)ns * t->chips_per_s; // below 1.3e16
    const double chips = (double)(scaled % NS_PER_S) / 1e9 +
                         c->transmit_rest_ns * 1e-9 * (double)t->chips_per_s +
                         (s - beyond(c->code_m, s) / SPEED_OF_LIGHT) * (double)t->chips_per_s;
    const double floor_chips = floor(chips);
    int64_t word = (int64_t)(scaled / NS_PER_S) +
                   (int64_t)floor_chips; // whole sub-chips, which may be those of another second
    while (word < 0) whole--, word += t->chips_per_s;
    while (word >= (int64_t)t->chips_per_s) whole++, word -= t->chips_per_s;
    *second = whole;
    return (uint64_t)(word * CHIP + (int64_t)((chips - floor_chips) * (double)CHIP));
}

void orr_gen_oscillators(const orr_gen_cubics *cubics, const orr_gen_tuning *tuning, int64_t first,
                         uint32_t n, orr_gen_oscillator *o)
{
    const double s0 = since_block(cubics, tuning, first), s1 = since_block(cubics, tuning, first + n);
    const double length = (double)n / (double)tuning->rate_hz;
    o->carrier = carrier_word(cubics, tuning, first, s0);
    o->code = code_word(cubics, tuning, s0, &o->code_s);
    // Steps: the chord, less what the sample clock itself makes.
    const double phase_rate =
        (beyond(cubics->carrier_cycles, s1) - beyond(cubics->carrier_cycles, s0)) / length; // cycles a second
    const double cycles = ((double)tuning->offset_hz - phase_rate) / (double)tuning->rate_hz;
    o->carrier_step = turns(cycles);
    const double stretch =
        (beyond(cubics->code_m, s1) - beyond(cubics->code_m, s0)) / length / SPEED_OF_LIGHT;
    o->code_step =
        (uint64_t)((1.0 - stretch) * (double)tuning->chips_per_s / (double)tuning->rate_hz * (double)CHIP +
                   0.5);
}
