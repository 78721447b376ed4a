// SPDX-License-Identifier: GPL-3.0-or-later
// What went wrong, as a sentence for the person who runs the program.
#ifndef ORR_GENERATOR_FEED_FAULT_H
#define ORR_GENERATOR_FEED_FAULT_H

#include <stdbool.h>

typedef struct orr_gen_fault {
    char text[600];
} orr_gen_fault;

// Writes the sentence and returns false, so that a routine can return by it.
__attribute__((format(printf, 2, 3))) bool orr_gen_fail(orr_gen_fault *fault, const char *format, ...);

#endif
