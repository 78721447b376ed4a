// SPDX-License-Identifier: GPL-3.0-or-later
// Mutations that a target may have of its own, with libFuzzer's names: in the preset `fuzz` libFuzzer calls them, elsewhere replay.c does.
#ifndef ORR_TESTS_FUZZ_MUTATE_H
#define ORR_TESTS_FUZZ_MUTATE_H

#include <stddef.h>
#include <stdint.h>

// Changes bytes in place.
//   Given:    data, n   the bytes, with room for `most`
//             most      how many there may be afterwards
//             seed      the same one makes the same change
//   Returned: data      the changed bytes, as many as the function returns
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t n, size_t most, unsigned seed);
// A change by bytes alone, likewise.
size_t LLVMFuzzerMutate(uint8_t *data, size_t n, size_t most);

#endif
