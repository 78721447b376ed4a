// SPDX-License-Identifier: MIT
#include "src/generator/kernel/periods.h"

#include <string.h>

// Sub-chips of a group in which a period ends: those of a group, and what a load of the last eight samples reads.
#define JOINED (2 * ORR_GEN_CHIPS_BEYOND)

// The period at `code` with so many groups still to be played, of which it takes what it has.
static orr_gen_period period_of(const orr_gen_code_at *c, int64_t number, uint64_t code, size_t groups)
{
    const uint64_t end = (code + groups * ORR_GEN_GROUP * c->code_step) >> ORR_GEN_CODE_BITS;
    const size_t to = end < c->chips ? (size_t)end + 1 : c->chips;
    return c->period(c->user, number, (size_t)(code >> ORR_GEN_CODE_BITS), to);
}

// The last `left` chips of a period from `at` on, and behind them the first of the next, turned where the signs differ.
static void join(const int8_t *at, size_t left, const orr_gen_period *next, bool turned, int8_t chips[JOINED])
{
    memcpy(chips, at, ORR_GEN_CHIPS_BEYOND);
    for (size_t k = 0; k < ORR_GEN_CHIPS_BEYOND; k++)
        chips[left + k] = (int8_t)(turned ? -next->chips[k] : next->chips[k]);
}

void orr_gen_periods_mix(orr_gen_mixer *mix, const orr_gen_carrier *carrier, const orr_gen_code_at *code,
                         size_t groups, int16_t *re, int16_t *im)
{
    const uint64_t length = (uint64_t)code->chips << ORR_GEN_CODE_BITS;
    const uint64_t in_group = ORR_GEN_GROUP * code->code_step;
    orr_gen_run run = {
        .carrier = carrier, .code = code->code, .code_step = code->code_step, .kind = code->kind};
    int64_t number = code->number;
    orr_gen_period period = period_of(code, number, run.code, groups);
    for (;;) {
        const uint64_t whole = (length - run.code) / in_group;
        run.n = whole < groups - run.group ? (size_t)whole : groups - run.group;
        run.chips = period.chips;
        run.sign = period.sign;
        if (run.n > 0) mix(&run, re, im);
        run.group += run.n;
        run.code += run.n * in_group;
        if (run.group == groups) return;
        // A group of two periods.
        const size_t at = (size_t)(run.code >> ORR_GEN_CODE_BITS);
        const orr_gen_period next = period_of(code, ++number, 0, groups - run.group);
        int8_t joined[JOINED];
        join(period.chips + at, code->chips - at, &next, next.sign != period.sign, joined);
        const orr_gen_run border = {.carrier = carrier,
                                    .group = run.group++,
                                    .n = 1,
                                    .sign = period.sign,
                                    .chips = joined,
                                    .code = run.code & (((uint64_t)1 << ORR_GEN_CODE_BITS) - 1),
                                    .code_step = code->code_step,
                                    .kind = code->kind};
        mix(&border, re, im);
        run.code = run.code + in_group - length;
        period = next;
        if (run.group == groups) return;
    }
}
