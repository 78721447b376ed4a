// SPDX-License-Identifier: MIT
// The mixer for AVX2: 32 samples a turn as two vectors of 16. A vector's lanes are eight samples each; the chips of a lane
// are eight bytes from memory, picked by a byte shuffle whose index stands in the high byte of each word.
#include "src/generator/kernel/mix.h"

#include "src/generator/kernel/phasor_private.h"

#if defined(__x86_64__) && defined(__AVX2__)
#include <immintrin.h>
#include <string.h>

// Samples 0-7 of the lane pair in the low lane's low half, 16-23 in its high half; 8-15 and 24-31 in the high lane.
static inline __m256i load_chips(const int8_t *chips, uint64_t code, uint64_t step)
{
    int64_t c[4];
    for (unsigned k = 0; k < 4; k++) memcpy(&c[k], chips + ((code + 8 * k * step) >> ORR_GEN_CODE_BITS), 8);
    return _mm256_set_epi64x(c[3], c[1], c[2], c[0]);
}

// Words with the chip in the high byte and 0 in the low one.
static inline __m256i pick(__m256i chips, __m256i part, __m256i steps, __m256i half)
{
    const __m256i index = _mm256_srli_epi16(_mm256_add_epi16(part, steps), 5);
    const __m256i high = _mm256_and_si256(index, _mm256_set1_epi16(0x0700));
    return _mm256_shuffle_epi8(
        chips, _mm256_or_si256(high, half)); // half: 0x80 in the low byte, 8 or 0 in the high one
}

static inline void add_to(int16_t *sum, __m256i x)
{
    __m256i *const at = (__m256i *)(void *)sum;
    _mm256_storeu_si256(at, _mm256_add_epi16(_mm256_loadu_si256(at), x));
}

static inline __m256i load(const int16_t *x) { return _mm256_loadu_si256((const __m256i *)(const void *)x); }

static inline __m256i pair(int16_t x) { return _mm256_set1_epi16(x); }

// Whole groups of a run: `levels` is a constant in each of its uses.
static inline __attribute__((always_inline)) void groups_of(const orr_gen_run *run, size_t from, size_t to,
                                                            bool levels, const int16_t *p_re,
                                                            const int16_t *p_im, int16_t *re, int16_t *im)
{
    const uint64_t step = run->code_step;
    uint64_t code = run->code + from * ORR_GEN_GROUP * step;
    uint16_t w[8];
    for (unsigned i = 0; i < 8; i++)
        w[i] = (uint16_t)((i * step + ((uint64_t)1 << (ORR_GEN_CODE_BITS - 14))) >> (ORR_GEN_CODE_BITS - 13));
    __m128i w8;
    memcpy(&w8, w, sizeof w8);
    const __m256i steps = _mm256_broadcastsi128_si256(w8);
    const __m256i first_half = _mm256_set1_epi16(0x0080), second_half = _mm256_set1_epi16(0x0880);
    const __m256i low_word = _mm256_set1_epi16(0x0100), high_word = _mm256_set1_epi16(0x0908);
    const __m256i mask = _mm256_set1_epi64x(0x1fff);
    // Lane by lane: samples 0, 16, 8, 24.
    __m256i phase = _mm256_set_epi64x((int64_t)(code + 24 * step), (int64_t)(code + 8 * step),
                                      (int64_t)(code + 16 * step), (int64_t)code);
    const __m256i turn = _mm256_set1_epi64x((int64_t)(ORR_GEN_GROUP * step));
    const __m256i r_re0 = load(run->rotation->re), r_re1 = load(run->rotation->re + 16);
    const __m256i r_im0 = load(run->rotation->im), r_im1 = load(run->rotation->im + 16);
    for (size_t g = from; g < to; g++) {
        const __m256i chips = load_chips(run->chips, code, step);
        const __m256i part = _mm256_and_si256(_mm256_srli_epi64(phase, ORR_GEN_CODE_BITS - 13), mask);
        const __m256i c0 = pick(chips, _mm256_shuffle_epi8(part, low_word), steps, first_half);
        const __m256i c1 = pick(chips, _mm256_shuffle_epi8(part, high_word), steps, second_half);
        const __m256i a = pair(p_re[g]), b = pair(p_im[g]);
        const __m256i re0 = _mm256_sub_epi16(_mm256_mulhrs_epi16(a, r_re0), _mm256_mulhrs_epi16(b, r_im0));
        const __m256i im0 = _mm256_add_epi16(_mm256_mulhrs_epi16(a, r_im0), _mm256_mulhrs_epi16(b, r_re0));
        const __m256i re1 = _mm256_sub_epi16(_mm256_mulhrs_epi16(a, r_re1), _mm256_mulhrs_epi16(b, r_im1));
        const __m256i im1 = _mm256_add_epi16(_mm256_mulhrs_epi16(a, r_im1), _mm256_mulhrs_epi16(b, r_re1));
        int16_t *const out_re = re + (g - from) * ORR_GEN_GROUP, *const out_im =
                                                                     im + (g - from) * ORR_GEN_GROUP;
        if (levels) {
            add_to(out_re, _mm256_mulhrs_epi16(re0, c0));
            add_to(out_im, _mm256_mulhrs_epi16(im0, c0));
            add_to(out_re + 16, _mm256_mulhrs_epi16(re1, c1));
            add_to(out_im + 16, _mm256_mulhrs_epi16(im1, c1));
        } else {
            add_to(out_re, _mm256_sign_epi16(re0, c0));
            add_to(out_im, _mm256_sign_epi16(im0, c0));
            add_to(out_re + 16, _mm256_sign_epi16(re1, c1));
            add_to(out_im + 16, _mm256_sign_epi16(im1, c1));
        }
        phase = _mm256_add_epi64(phase, turn);
        code += ORR_GEN_GROUP * step;
    }
}

void orr_gen_mix_avx2(const orr_gen_run *run, int16_t *re, int16_t *im)
{
    int16_t p_re[GROUPS], p_im[GROUPS];
    const size_t groups = run_phasors(run, p_re, p_im), whole = run->n / ORR_GEN_GROUP;
    if (run->levels)
        groups_of(run, 0, whole, true, p_re, p_im, re, im);
    else
        groups_of(run, 0, whole, false, p_re, p_im, re, im);
    if (groups == whole) return;
    int16_t s_re[ORR_GEN_GROUP] = {0},
            s_im[ORR_GEN_GROUP] = {0}; // the last samples, which are no whole group
    if (run->levels)
        groups_of(run, whole, groups, true, p_re, p_im, s_re, s_im);
    else
        groups_of(run, whole, groups, false, p_re, p_im, s_re, s_im);
    const size_t at = whole * ORR_GEN_GROUP;
    for (size_t k = 0; at + k < run->n; k++) {
        re[at + k] = (int16_t)(re[at + k] + s_re[k]);
        im[at + k] = (int16_t)(im[at + k] + s_im[k]);
    }
}

#else

void orr_gen_mix_avx2(const orr_gen_run *run, int16_t *re, int16_t *im) { orr_gen_mix_plain(run, re, im); }

#endif
