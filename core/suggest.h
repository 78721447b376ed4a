// SPDX-License-Identifier: GPL-3.0-or-later
// "Did you mean": for words of the command line and keys of scenario files.
#ifndef ORR_CORE_SUGGEST_H
#define ORR_CORE_SUGGEST_H

#include <stddef.h>

// The candidate most like `word` if it is like enough to be meant, else NULL.
const char *orr_suggest_nearest(const char *word, const char *const *candidate, size_t n);

#endif
