// SPDX-License-Identifier: MIT
#include "src/generator/kernel/kernel.h"

static const orr_gen_kernel plain = {"plain C", orr_gen_carrier_plain, orr_gen_mix_plain, orr_gen_add_plain,
                                     orr_gen_output_write};
#if defined(__x86_64__)
static const orr_gen_kernel avx2 = {"AVX2", orr_gen_carrier_avx2, orr_gen_mix_avx2, orr_gen_add_avx2,
                                    orr_gen_output_write_avx2};
#elif defined(__aarch64__)
// What is beside the mixer is vectorised by compilers as it stands: all processors of this kind have NEON.
static const orr_gen_kernel neon = {"NEON", orr_gen_carrier_plain, orr_gen_mix_neon, orr_gen_add_plain,
                                    orr_gen_output_write};
#endif

const orr_gen_kernel *orr_gen_kernel_at(size_t k)
{
    if (k == 0) return &plain;
#if defined(__x86_64__)
    if (k == 1 && __builtin_cpu_supports("avx2")) return &avx2;
#elif defined(__aarch64__)
    if (k == 1) return &neon;
#endif
    return NULL;
}

const orr_gen_kernel *orr_gen_kernel_best(void)
{
    const orr_gen_kernel *fastest = orr_gen_kernel_at(1);
    return fastest != NULL ? fastest : &plain;
}
