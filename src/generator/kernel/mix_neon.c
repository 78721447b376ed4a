// SPDX-License-Identifier: MIT
// The mixer for NEON (aarch64): 32 samples a turn, eight at a time. Rounded products of 16 bits are what sqrdmulh makes; chips of
// eight samples are picked from eight bytes by a table lookup.
#include "src/generator/kernel/mix.h"

#if defined(__aarch64__)
#include <arm_neon.h>

#include "src/generator/kernel/phasor_private.h"

typedef struct eight_samples {
    int16x8_t re, im;
} eight_samples;

// The phasor turned by eight rotations, by the sign of the run.
static inline eight_samples carrier_of(const orr_gen_run *run, size_t k, int16x8_t a, int16x8_t b)
{
    const int16x8_t sign = vdupq_n_s16((int16_t)run->sign);
    const int16x8_t r_re = vmulq_s16(vld1q_s16(run->carrier->re + k), sign);
    const int16x8_t r_im = vmulq_s16(vld1q_s16(run->carrier->im + k), sign);
    return (eight_samples){vsubq_s16(vqrdmulhq_s16(a, r_re), vqrdmulhq_s16(b, r_im)),
                           vaddq_s16(vqrdmulhq_s16(a, r_im), vqrdmulhq_s16(b, r_re))};
}

// Their chips, as words.
static inline int16x8_t chips_of(const orr_gen_run *run, uint64_t code, uint16x8_t steps)
{
    const int8x8_t chips = vld1_s8(run->chips + (code >> ORR_GEN_CODE_BITS));
    const uint16_t part = (uint16_t)(code >> (ORR_GEN_CODE_BITS - 13) & 0x1fff);
    const uint16x8_t index = vshrq_n_u16(vaddq_u16(vdupq_n_u16(part), steps), 13);
    return vmovl_s8(vtbl1_s8(chips, vreinterpret_s8_u8(vmovn_u16(index))));
}

static inline int16x8_t times_chip(orr_gen_chips kind, int16x8_t x, int16x8_t chip)
{
    return kind == ORR_GEN_LEVELS ? vqrdmulhq_s16(vshlq_n_s16(chip, 8), x) : vmulq_s16(chip, x);
}

static inline void group(const orr_gen_run *run, uint64_t code, uint16x8_t steps, int16x8_t a, int16x8_t b,
                         int16_t *re, int16_t *im)
{
    for (size_t k = 0; k < ORR_GEN_GROUP; k += 8) {
        const eight_samples x = carrier_of(run, k, a, b);
        const int16x8_t chip = chips_of(run, code, steps);
        vst1q_s16(re + k, vaddq_s16(vld1q_s16(re + k), times_chip(run->kind, x.re, chip)));
        vst1q_s16(im + k, vaddq_s16(vld1q_s16(im + k), times_chip(run->kind, x.im, chip)));
        code += 8 * run->code_step;
    }
}

void orr_gen_mix_neon(const orr_gen_run *run, int16_t *re, int16_t *im)
{
    uint16_t w[8];
    const uint64_t ahead = steps_of_eight(run->code_step, w);
    const uint16x8_t steps = vld1q_u16(w);
    uint64_t code = run->code + ahead;
    for (size_t g = run->group; g < run->group + run->n; g++, code += ORR_GEN_GROUP * run->code_step)
        group(run, code, steps, vdupq_n_s16((int16_t)run->carrier->group_re[g]),
              vdupq_n_s16((int16_t)run->carrier->group_im[g]), re + g * ORR_GEN_GROUP,
              im + g * ORR_GEN_GROUP);
}

#endif
