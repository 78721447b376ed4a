// SPDX-License-Identifier: GPL-3.0-or-later
// Mutations that know what files of records look like (RINEX and its relatives): lines doubled, dropped, exchanged and cut, and fields of a
// line, by columns or by words, replaced by what such fields hold. A line's other bytes and the label in columns 61 to 80 stay as they are,
// so that a reader gets as far as the field.
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "fuzz/mutate.h"

static uint64_t state;
static size_t below(size_t n) // splitmix64
{
    uint64_t z = (state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return n == 0 ? 0 : (size_t)((z ^ (z >> 31)) % n);
}

typedef struct span {
    size_t at, n; // a line, with its end
} span;

static span line_of(const uint8_t *p, size_t n, size_t at)
{
    size_t from = at, to = at;
    while (from > 0 && p[from - 1] != '\n') from--;
    while (to < n && p[to] != '\n') to++;
    return (span){from, (to < n ? to + 1 : to) - from};
}

static size_t drop(uint8_t *p, size_t n, span s)
{
    memmove(p + s.at, p + s.at + s.n, n - s.at - s.n);
    return n - s.n;
}

// Puts bytes in at a place, if there is room.
static size_t put(uint8_t *p, size_t n, size_t most, size_t at, const void *what, size_t size)
{
    if (size > most - n) return n;
    memmove(p + at + size, p + at, n - at);
    memcpy(p + at, what, size);
    return n + size;
}

// A field of a line, of words or of fixed columns, takes another text, of the same width where it is of columns.
static size_t refill(uint8_t *p, size_t n, size_t most, span line)
{
    static const char *const fill[] = {"0",
                                       "-1",
                                       "1e300",
                                       "-1.5D+99",
                                       "NaN",
                                       "99999999",
                                       "2147483648",
                                       "18446744073709551616",
                                       " ",
                                       "G01",
                                       "R27",
                                       "E36",
                                       "C63",
                                       "J10",
                                       "I14",
                                       "S59",
                                       "X99",
                                       "G00",
                                       "> EPH G01 LNAV",
                                       "> ION",
                                       "2025",
                                       "12 31 23 59 60",
                                       "1980 1 6",
                                       "2038 01",
                                       "0.000000",
                                       "1",
                                       "999",
                                       "3",
                                       "4",
                                       "5",
                                       "6",
                                       "C1C L1C",
                                       "END OF HEADER"};
    static const uint8_t widths[] = {1, 2, 3, 4, 6, 9, 12, 14, 16, 19, 20};
    const char *text = fill[below(sizeof fill / sizeof fill[0])];
    size_t length = strlen(text);
    if (line.n < 2) return n;
    size_t at = line.at + below(line.n - 1);
    if (below(2) == 0) { // columns
        const size_t width = widths[below(sizeof widths)];
        at = line.at + (at - line.at) / width * width;
        if (at + width > line.at + line.n - 1) return n;
        memset(p + at, ' ', width);
        memcpy(p + at + (width - (length < width ? length : width)), text, length < width ? length : width);
        return n;
    }
    size_t to = at;
    while (at > line.at && p[at - 1] != ' ' && p[at - 1] != ',') at--;
    while (to < line.at + line.n && p[to] != ' ' && p[to] != ',' && p[to] != '\n') to++;
    n = drop(p, n, (span){at, to - at});
    return put(p, n, most, at, text, length);
}

static size_t once(uint8_t *p, size_t n, size_t most)
{
    uint8_t copy[400];
    if (n == 0) return 0;
    const span line = line_of(p, n, below(n)), other = line_of(p, n, below(n));
    switch (below(8)) {
    case 0:
        return line.n < n ? drop(p, n, line) : n;
    case 1: // doubled, somewhere
        if (line.n > sizeof copy) return n;
        memcpy(copy, p + line.at, line.n);
        return put(p, n, most, other.at, copy, line.n);
    case 2: // cut before its end
        if (line.n < 3) return n;
        const size_t keep = below(line.n - 1);
        return drop(p, n, (span){line.at + keep, line.n - 1 - keep});
    case 3: // a digit
        for (size_t k = line.at + below(line.n); k < line.at + line.n; k++)
            if (p[k] >= '0' && p[k] <= '9') {
                p[k] = (uint8_t)('0' + below(10));
                break;
            }
        return n;
    default:
        return refill(p, n, most, line);
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t n, size_t most, unsigned seed)
{
    state = seed;
    if (below(3) == 0) return LLVMFuzzerMutate(data, n, most);
    for (size_t k = 1 + below(4); k > 0; k--) n = once(data, n, most);
    return n;
}
