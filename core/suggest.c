// SPDX-License-Identifier: GPL-3.0-or-later
// "Did you mean": the nearest known word by edit distance.
#include "core/suggest.h"

#include <string.h>

enum { LONGEST = 40 };

// Damerau's distance in its restricted form: insertions, deletions, changes and swaps of neighbours cost 1.
static size_t distance(const char *a, const char *b)
{
    size_t na = strlen(a), nb = strlen(b);
    if (na > LONGEST || nb > LONGEST) return LONGEST;
    size_t d[LONGEST + 1][LONGEST + 1];
    for (size_t i = 0; i <= na; i++) d[i][0] = i;
    for (size_t j = 0; j <= nb; j++) d[0][j] = j;
    for (size_t i = 1; i <= na; i++) {
        for (size_t j = 1; j <= nb; j++) {
            size_t best = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            if (d[i - 1][j] + 1 < best) best = d[i - 1][j] + 1;
            if (d[i][j - 1] + 1 < best) best = d[i][j - 1] + 1;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && d[i - 2][j - 2] + 1 < best)
                best = d[i - 2][j - 2] + 1;
            d[i][j] = best;
        }
    }
    return d[na][nb];
}

const char *orr_suggest_nearest(const char *word, const char *const *candidate, size_t n)
{
    size_t len = strlen(word), best = len / 3 + 1; // a third of the letters may be wrong
    const char *found = NULL;
    for (size_t i = 0; i < n; i++) {
        size_t d = distance(word, candidate[i]);
        // A beginning that only one reading fits is meant too ("stat" for "states").
        if (len >= 3 && strncmp(word, candidate[i], len) == 0) d = 1;
        if (d < best || (d == best && found == NULL)) {
            best = d;
            found = candidate[i];
        }
    }
    return found;
}
