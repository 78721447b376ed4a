// SPDX-License-Identifier: GPL-3.0-or-later
// What each kernel that this processor can run makes of the same random runs, in one number each: they must be the same, here and on
// every other kind of processor. It needs libc and libm alone, so that it is built for others as it is (other_processor).
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "src/generator/kernel/kernel.h"
#include "src/generator/kernel/oscillator.h"

enum { TRIALS = 450, PERIOD = 1023 };

static uint64_t next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return *seed ^ *seed >> 29;
}

// FNV-1a.
static uint64_t digest(uint64_t d, const void *data, size_t size)
{
    const uint8_t *byte = data;
    for (size_t k = 0; k < size; k++) d = (d ^ byte[k]) * 0x100000001b3u;
    return d;
}

// Words in an order that is no processor's own.
static uint64_t digest_words(uint64_t d, const int32_t *x, size_t n)
{
    for (size_t k = 0; k < n; k++) d = (d ^ (uint32_t)x[k]) * 0x100000001b3u;
    return d;
}

static void fill(orr_gen_chips kind, uint64_t *seed, int8_t *chips, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const int x = (int)(next(seed) >> 40);
        chips[k] = (int8_t)(kind == ORR_GEN_SIGNS     ? x % 2 * 2 - 1
                            : kind == ORR_GEN_TERNARY ? x % 3 - 1
                                                      : x % 255 - 127);
    }
}

// A run of any place, length, code and kind of chips.
static orr_gen_run run_of(int trial, uint64_t *seed, const int8_t *chips, const orr_gen_carrier *c)
{
    const double ratio = 0.02 + (ORR_GEN_CHIPS_IN_SAMPLE - 0.02) * (double)(next(seed) >> 11) * 0x1p-53;
    orr_gen_run run = {.carrier = c, .chips = chips, .kind = (orr_gen_chips)(trial % 3)};
    run.sign = next(seed) >> 40 & 1 ? 1 : -1;
    run.code = next(seed) >> 26;
    run.code_step = (uint64_t)(ratio * 0x1p39);
    run.group = (next(seed) >> 40) % ORR_GEN_GROUPS;
    run.n = 1 + (next(seed) >> 40) % (ORR_GEN_GROUPS - run.group);
    const size_t most = (size_t)((PERIOD - 3) / (ratio * ORR_GEN_GROUP)); // within a period
    if (run.n > most) run.n = most;
    return run;
}

static uint64_t made_by(const orr_gen_kernel *kernel, const orr_gen_noise *noise)
{
    static int8_t chips[PERIOD + ORR_GEN_CHIPS_BEYOND];
    static int16_t re[ORR_GEN_PIECE], im[ORR_GEN_PIECE];
    static int32_t sum_re[ORR_GEN_PIECE], sum_im[ORR_GEN_PIECE];
    static uint8_t bytes[8 * ORR_GEN_PIECE];
    uint64_t seed = 1, d = 0xcbf29ce484222325u;
    memset(sum_re, 0, sizeof sum_re);
    memset(sum_im, 0, sizeof sum_im);
    for (int trial = 0; trial < TRIALS; trial++) {
        orr_gen_carrier c;
        const uint64_t phase = next(&seed), step = next(&seed);
        const double amplitude = (double)(next(&seed) % (ORR_GEN_AMPLITUDE + 1));
        memset(re, 0, sizeof re);
        memset(im, 0, sizeof im);
        kernel->carrier(phase, step, amplitude, ORR_GEN_GROUPS, &c);
        fill((orr_gen_chips)(trial % 3), &seed, chips, sizeof chips);
        const orr_gen_run run = run_of(trial, &seed, chips, &c);
        kernel->mix(&run, re, im);
        kernel->add(trial % 7 == 0, re, ORR_GEN_PIECE, sum_re);
        kernel->add(trial % 7 == 0, im, ORR_GEN_PIECE, sum_im);
        const size_t n = 1 + (next(&seed) >> 40) % ORR_GEN_PIECE;
        d = digest_words(digest_words(d, sum_re, ORR_GEN_PIECE), sum_im, ORR_GEN_PIECE);
        if (trial % 10 > 0) continue;
        const orr_gen_output out = {.format = (orr_gen_format)(trial / 10 % 4),
                                    .gain = 0.01,
                                    .sigma = trial % 20 > 0 ? 20 : 0,
                                    .noise = noise,
                                    .seed = (uint64_t)trial};
        const bool alone = trial % 30 == 0;
        const orr_gen_sums sums = {re, im, alone ? NULL : sum_re, alone ? NULL : sum_im, 1e9};
        const size_t clipped = kernel->write(&out, &sums, trial, n, bytes);
        d = digest(d ^ clipped, bytes, orr_gen_output_size(out.format, n));
    }
    return d;
}

int main(void)
{
    static orr_gen_noise noise;
    orr_gen_noise_init(&noise);
    uint64_t first = 0;
    bool same = true;
    for (size_t k = 0; orr_gen_kernel_at(k) != NULL; k++) {
        const uint64_t d = made_by(orr_gen_kernel_at(k), &noise);
        printf("%016" PRIx64 " %s\n", d, orr_gen_kernel_at(k)->name);
        if (k == 0) first = d;
        same = same && d == first;
    }
    if (!same) printf("kernels differ\n");
    return same ? 0 : 1;
}
