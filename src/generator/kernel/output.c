// SPDX-License-Identifier: MIT
#include "src/generator/kernel/output.h"

#include <math.h>

#include "src/generator/kernel/output_private.h"

// The normal distribution's value of a probability below one half: Abramowitz and Stegun 26.2.23, good to 4.5e-4, and
// Newton's method on erfc from there.
static double quantile(double p)
{
    const double t = sqrt(-2 * log(p));
    double x =
        (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))) - t;
    for (int k = 0; k < 3; k++) {
        const double miss = 0.5 * erfc(-x * 0.70710678118654752440) - p;
        x -= miss / (0.39894228040143267794 * exp(-0.5 * x * x));
    }
    return x;
}

void orr_gen_noise_init(orr_gen_noise *noise)
{
    for (size_t k = 0; k < 32768; k++) {
        const double x = TABLE_SIGMA * quantile(((double)k + 0.5) / 65536);
        const int16_t v = (int16_t)(x < -32767 ? -32767 : floor(x + 0.5));
        noise->value[k] = v;
        noise->value[65535 - k] = (int16_t)-v;
    }
}

size_t orr_gen_output_size(orr_gen_format format, size_t n)
{
    switch (format) {
    case ORR_GEN_I8:
        return 2 * n;
    case ORR_GEN_I16:
        return 4 * n;
    case ORR_GEN_I2:
        return n;
    default:
        return 8 * n;
    }
}

size_t orr_gen_output_pack(uint8_t *bytes, size_t n)
{
    for (size_t k = 0; k < n; k++)
        bytes[k / 2] = (uint8_t)(k % 2 == 0 ? bytes[k] : bytes[k / 2] | bytes[k] << 4);
    return (n + 1) / 2;
}

size_t orr_gen_output_write(const orr_gen_output *out, const orr_gen_sums *sums, int64_t first, size_t n,
                            uint8_t *bytes)
{
    return write_all(out, sums, first, n, bytes);
}
