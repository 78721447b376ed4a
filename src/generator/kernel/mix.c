// SPDX-License-Identifier: MIT
// The mixer in plain C, which is what the others are measured by.
#include "src/generator/kernel/mix.h"

#include "src/generator/kernel/phasor_private.h"

void orr_gen_carrier_plain(uint64_t phase, uint64_t step, double amplitude, size_t groups, orr_gen_carrier *c)
{
    make_carrier(phase, step, amplitude, groups, c);
}

void orr_gen_add_plain(bool first, const int16_t *group, size_t n, int32_t *sum)
{
    add_all(first, group, n, sum);
}

// a * b / 2^15, rounded, as pmulhrsw and vqrdmulh do it.
static inline int16_t times(int16_t a, int16_t b) { return (int16_t)((a * b + 0x4000) >> 15); }

// Chips of one group: of eight samples the phase of the first is truncated to 1/8192 sub-chip and the steps are rounded, so that in the mean the code is
// neither early nor late.
static inline void group_chips(const orr_gen_run *run, uint64_t code, const uint16_t steps[8],
                               int16_t *restrict chip)
{
    for (size_t k = 0; k < ORR_GEN_GROUP; k += 8) {
        const int8_t *at = run->chips + (code >> ORR_GEN_CODE_BITS);
        const uint16_t part = (uint16_t)(code >> (ORR_GEN_CODE_BITS - 13) & 0x1fff);
        for (size_t i = 0; i < 8; i++) chip[k + i] = at[(uint16_t)(part + steps[i]) >> 13];
        code += 8 * run->code_step;
    }
}

// The rotations of a run, by its sign.
typedef struct rotations {
    int16_t re[ORR_GEN_GROUP], im[ORR_GEN_GROUP];
} rotations;

static rotations rotations_of(const orr_gen_run *run)
{
    rotations r;
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) r.re[k] = (int16_t)(run->sign * run->carrier->re[k]);
    for (size_t k = 0; k < ORR_GEN_GROUP; k++) r.im[k] = (int16_t)(run->sign * run->carrier->im[k]);
    return r;
}

// The carrier of a group: the phasor turned by each rotation.
static inline void group_carrier(const rotations *r, int16_t p_re, int16_t p_im, int16_t *restrict re,
                                 int16_t *restrict im)
{
    for (size_t k = 0; k < ORR_GEN_GROUP; k++)
        re[k] = (int16_t)(times(p_re, r->re[k]) - times(p_im, r->im[k]));
    for (size_t k = 0; k < ORR_GEN_GROUP; k++)
        im[k] = (int16_t)(times(p_re, r->im[k]) + times(p_im, r->re[k]));
}

// Chips on it.
static inline void group_code(orr_gen_chips kind, const int16_t *restrict chip, int16_t *restrict x)
{
    if (kind == ORR_GEN_LEVELS)
        for (size_t k = 0; k < ORR_GEN_GROUP; k++) x[k] = times((int16_t)(chip[k] * 256), x[k]);
    else
        for (size_t k = 0; k < ORR_GEN_GROUP; k++) x[k] = (int16_t)(chip[k] * x[k]);
}

void orr_gen_mix_plain(const orr_gen_run *run, int16_t *re, int16_t *im)
{
    int16_t chip[ORR_GEN_GROUP], s_re[ORR_GEN_GROUP], s_im[ORR_GEN_GROUP];
    uint16_t steps[8];
    const uint64_t ahead = steps_of_eight(run->code_step, steps);
    const rotations r = rotations_of(run);
    const orr_gen_carrier *c = run->carrier;
    uint64_t code = run->code + ahead;
    for (size_t g = run->group; g < run->group + run->n; g++) {
        const size_t at = g * ORR_GEN_GROUP;
        group_chips(run, code, steps, chip);
        group_carrier(&r, (int16_t)c->group_re[g], (int16_t)c->group_im[g], s_re, s_im);
        group_code(run->kind, chip, s_re);
        group_code(run->kind, chip, s_im);
        for (size_t k = 0; k < ORR_GEN_GROUP; k++) re[at + k] = (int16_t)(re[at + k] + s_re[k]);
        for (size_t k = 0; k < ORR_GEN_GROUP; k++) im[at + k] = (int16_t)(im[at + k] + s_im[k]);
        code += ORR_GEN_GROUP * run->code_step;
    }
}
