// SPDX-License-Identifier: MIT
// The loops for AVX2. The mixer makes 32 samples a turn as two vectors of 16. A vector's lanes are eight samples each; the chips of a
// lane are eight bytes from memory, picked by a byte shuffle whose index stands in the high byte of each word.
#include "src/generator/kernel/mix.h"

#if defined(__x86_64__)
#include <immintrin.h>
#include <string.h>

#include "src/generator/kernel/output_private.h"
#include "src/generator/kernel/phasor_private.h"

// Eight chips in each lane.
static inline __m256i eight(const int8_t *at)
{
    int64_t c;
    memcpy(&c, at, 8);
    return _mm256_set1_epi64x(c);
}

// Those of eight samples in the low lane, of eight others in the high one.
static inline __m256i two_lanes(const int8_t *chips, uint64_t low, uint64_t high)
{
    return _mm256_blend_epi32(eight(chips + (low >> ORR_GEN_CODE_BITS)),
                              eight(chips + (high >> ORR_GEN_CODE_BITS)), 0xf0);
}

// Words with the chip in the high byte. The low one is of no account to a sign, so that it is cleared for the other kinds alone.
static inline __m256i pick(orr_gen_chips kind, __m256i chips, __m256i part, __m256i steps)
{
    const __m256i index = _mm256_srli_epi16(_mm256_add_epi16(part, steps), 5);
    const __m256i picked = _mm256_shuffle_epi8(chips, index);
    return kind == ORR_GEN_SIGNS ? picked : _mm256_and_si256(picked, _mm256_set1_epi16((int16_t)0xff00));
}

static inline __m256i load(const int16_t *x) { return _mm256_loadu_si256((const __m256i *)(const void *)x); }

static inline __m256i pair(uint32_t x) { return _mm256_set1_epi32((int)x); }

// Adds a chip on the carrier to a sum.
static inline void add_to(orr_gen_chips kind, int16_t *sum, __m256i carrier, __m256i chip)
{
    const __m256i x =
        kind == ORR_GEN_LEVELS ? _mm256_mulhrs_epi16(carrier, chip) : _mm256_sign_epi16(carrier, chip);
    _mm256_storeu_si256((__m256i *)(void *)sum, _mm256_add_epi16(load(sum), x));
}

// Groups of a run: `kind` is a constant in each of its uses.
static inline __attribute__((always_inline)) void groups_of(const orr_gen_run *run, orr_gen_chips kind,
                                                            int16_t *re, int16_t *im)
{
    const orr_gen_carrier *c = run->carrier;
    const uint64_t step = run->code_step, group = ORR_GEN_GROUP * step;
    const int8_t *chips = run->chips;
    uint16_t w[8];
    uint64_t code = run->code + steps_of_eight(step, w);
    __m128i w8;
    memcpy(&w8, w, sizeof w8);
    const __m256i steps = _mm256_broadcastsi128_si256(w8);
    const __m256i low_word = _mm256_set1_epi16(0x0100), high_word = _mm256_set1_epi16(0x0908);
    // Of the phase what is less than a sub-chip, from the highest bit on. Lane by lane: samples 0, 16, 8, 24.
    enum { UP = 64 - ORR_GEN_CODE_BITS };
    __m256i phase =
        _mm256_slli_epi64(_mm256_set_epi64x((int64_t)(code + 24 * step), (int64_t)(code + 8 * step),
                                            (int64_t)(code + 16 * step), (int64_t)code),
                          UP);
    const __m256i turn = _mm256_set1_epi64x((int64_t)(group << UP));
    const __m256i sign = _mm256_set1_epi16((int16_t)run->sign);
    const __m256i r_re0 = _mm256_sign_epi16(load(c->re), sign),
                  r_re1 = _mm256_sign_epi16(load(c->re + 16), sign);
    const __m256i r_im0 = _mm256_sign_epi16(load(c->im), sign),
                  r_im1 = _mm256_sign_epi16(load(c->im + 16), sign);
    const size_t end = run->group + run->n;
    for (size_t g = run->group; g < end; g++) {
        const __m256i part = _mm256_srli_epi64(phase, 64 - 13);
        const __m256i c0 =
            pick(kind, two_lanes(chips, code, code + 8 * step), _mm256_shuffle_epi8(part, low_word), steps);
        const __m256i c1 = pick(kind, two_lanes(chips, code + 16 * step, code + 24 * step),
                                _mm256_shuffle_epi8(part, high_word), steps);
        const __m256i a = pair(c->group_re[g]), b = pair(c->group_im[g]);
        const __m256i re0 = _mm256_sub_epi16(_mm256_mulhrs_epi16(a, r_re0), _mm256_mulhrs_epi16(b, r_im0));
        const __m256i im0 = _mm256_add_epi16(_mm256_mulhrs_epi16(a, r_im0), _mm256_mulhrs_epi16(b, r_re0));
        const __m256i re1 = _mm256_sub_epi16(_mm256_mulhrs_epi16(a, r_re1), _mm256_mulhrs_epi16(b, r_im1));
        const __m256i im1 = _mm256_add_epi16(_mm256_mulhrs_epi16(a, r_im1), _mm256_mulhrs_epi16(b, r_re1));
        const size_t at = g * ORR_GEN_GROUP;
        add_to(kind, re + at, re0, c0);
        add_to(kind, im + at, im0, c0);
        add_to(kind, re + at + 16, re1, c1);
        add_to(kind, im + at + 16, im1, c1);
        phase = _mm256_add_epi64(phase, turn);
        code += group;
    }
}

void orr_gen_mix_avx2(const orr_gen_run *run, int16_t *re, int16_t *im)
{
    if (run->kind == ORR_GEN_SIGNS)
        groups_of(run, ORR_GEN_SIGNS, re, im);
    else if (run->kind == ORR_GEN_TERNARY)
        groups_of(run, ORR_GEN_TERNARY, re, im);
    else
        groups_of(run, ORR_GEN_LEVELS, re, im);
}

void orr_gen_carrier_avx2(uint64_t phase, uint64_t step, double amplitude, size_t groups, orr_gen_carrier *c)
{
    make_carrier(phase, step, amplitude, groups, c);
}

void orr_gen_add_avx2(bool first, const int16_t *group, size_t n, int32_t *sum)
{
    add_all(first, group, n, sum);
}

size_t orr_gen_output_write_avx2(const orr_gen_output *out, const orr_gen_sums *sums, int64_t first, size_t n,
                                 uint8_t *bytes)
{
    return write_all(out, sums, first, n, bytes);
}

#endif
