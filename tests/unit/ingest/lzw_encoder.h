// SPDX-License-Identifier: GPL-3.0-or-later
// A plain encoder of Unix compress data, so that tests can make .Z files of any code width, with and without
// block mode.
#ifndef ORR_TESTS_LZW_ENCODER_H
#define ORR_TESTS_LZW_ENCODER_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct lzw_writer {
    uint8_t *out;
    size_t bits, capacity; // in bits; capacity in bytes
    size_t group_start;    // bit where the present group of eight codes began
} lzw_writer;

static inline void lzw_put(lzw_writer *w, unsigned code, int width)
{
    for (int i = 0; i < width; i++, w->bits++)
        if ((code >> i & 1) != 0 && w->bits / 8 < w->capacity)
            w->out[w->bits / 8] |= (uint8_t)(1u << w->bits % 8);
}

// A change of width leaves the rest of a group of eight codes unused.
static inline void lzw_end_group(lzw_writer *w, int width)
{
    size_t group = (size_t)width * 8;
    while ((w->bits - w->group_start) % group != 0) w->bits++;
    w->group_start = w->bits;
}

// Encodes n bytes; clear_every > 0 empties the table (block mode only) after so many codes. Returns malloc'ed
// bytes.
static inline uint8_t *lzw_encode(const uint8_t *data, size_t n, int max_width, bool block_mode,
                                  unsigned clear_every, size_t *out_n)
{
    lzw_writer w = {.capacity = 64 + 9 * n};
    w.out = calloc(w.capacity, 1);
    uint16_t(*child)[256] = calloc(65536, sizeof *child); // code and next byte -> code, 0 for none
    uint16_t **defined = malloc(65536 * sizeof *defined); // where each code stands in child, to clear it
    if (w.out == NULL || child == NULL || defined == NULL) abort();
    w.out[0] = 0x1f;
    w.out[1] = 0x9d;
    w.out[2] = (uint8_t)(max_width | (block_mode ? 0x80 : 0));
    w.bits = w.group_start = 24;
    unsigned first = block_mode ? 257 : 256, next = first, since = 0;
    int width = 9;
    size_t at = 0;
    while (at < n) {
        unsigned code = data[at++];
        while (at < n && child[code][data[at]] != 0) code = child[code][data[at++]];
        lzw_put(&w, code, width);
        if (at == n) break;
        bool grown = next < 1u << max_width;
        if (grown) {
            defined[next] = &child[code][data[at]];
            *defined[next] = (uint16_t)next;
            next++;
        }
        // The reader defines a code one step later than the writer.
        if (grown && next - 1 > (1u << width) - 1 && width < max_width) {
            lzw_end_group(&w, width);
            width++;
        }
        if (clear_every > 0 && ++since == clear_every) {
            since = 0;
            lzw_put(&w, 256, width);
            lzw_end_group(&w, width);
            width = 9;
            while (next > first) *defined[--next] = 0;
        }
    }
    free(defined);
    free(child);
    *out_n = (w.bits + 7) / 8;
    return w.out;
}

#endif
