// SPDX-License-Identifier: MIT
// The loops that take the time, for each kind of processor; which of them a processor can run is found out when it runs them. All
// give the same bits.
#ifndef ORR_GENERATOR_KERNEL_KERNEL_H
#define ORR_GENERATOR_KERNEL_KERNEL_H

#include "src/generator/kernel/mix.h"
#include "src/generator/kernel/output.h"

typedef struct orr_gen_kernel {
    const char *name;
    orr_gen_carrier_maker *carrier;
    orr_gen_mixer *mix;
    orr_gen_adder *add;
    orr_gen_output_writer *write;
} orr_gen_kernel;

// The k-th that this processor can run, from plain C (0) to the fastest; NULL beyond it.
const orr_gen_kernel *orr_gen_kernel_at(size_t k);
// The fastest.
const orr_gen_kernel *orr_gen_kernel_best(void);

#endif
