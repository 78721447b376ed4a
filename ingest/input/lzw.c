// SPDX-License-Identifier: GPL-3.0-or-later
// The Unix compress (.Z) stage: Welch 1984, "A Technique for High-Performance Data Compression", with the
// variable code width of compress 4.x. Layout: 1f 9d, a byte (low five bits: widest code, bit 7: block mode,
// i.e. code 256 empties the table), then codes, low bits first, in groups of eight; a new width starts a new
// group, so the rest of the old group is dead. There is no length and no check sum.
#include <stdlib.h>
#include <string.h>

#include "ingest/input/stage.h"

enum { MIN_WIDTH = 9, MAX_WIDTH = 16, TABLE = 1 << MAX_WIDTH, CLEAR = 256, OUT = 2 * TABLE };

typedef struct lzw_stage {
    orr_stage stage;
    bool has_header, block_mode, at_end;
    int max_width, width;
    unsigned in_group; // codes read since the width was set
    unsigned n_codes;  // next code to be defined
    int previous;      // code read last, -1 at the start and after CLEAR
    uint64_t bits;     // n_bits of them, low first
    int n_bits;
    size_t in_at, in_n;
    size_t out_at, out_n;
    uint16_t prefix[TABLE];
    uint16_t length[TABLE]; // of the code's text less one; at most TABLE - 257
    uint8_t suffix[TABLE];
    uint8_t in[65536], out[OUT];
} lzw_stage;

static orr_status refill(lzw_stage *l, orr_diag *diag)
{
    l->in_at = l->in_n = 0;
    return orr_stage_read(l->stage.below, l->in, sizeof l->in, &l->in_n, diag);
}

// *code is -1 at the end of the input.
static orr_status next_code(lzw_stage *l, int *code, orr_diag *diag)
{
    while (l->n_bits < l->width) {
        if (l->in_at == l->in_n) {
            orr_status st = refill(l, diag);
            if (st != ORR_OK) return st;
            if (l->in_n == 0) {
                *code = -1;
                return ORR_OK;
            }
        }
        l->bits |= (uint64_t)l->in[l->in_at++] << l->n_bits;
        l->n_bits += 8;
    }
    *code = (int)(l->bits & ((UINT64_C(1) << l->width) - 1));
    l->bits >>= l->width;
    l->n_bits -= l->width;
    l->in_group++;
    return ORR_OK;
}

static orr_status set_width(lzw_stage *l, int width, orr_diag *diag)
{
    int code = 0;
    while (l->in_group % 8 != 0 && code >= 0) {
        orr_status st = next_code(l, &code, diag);
        if (st != ORR_OK) return st;
    }
    if (code < 0) l->n_bits = 0; // a file may end in the dead part of a group
    l->in_group = 0;
    l->width = width;
    return ORR_OK;
}

static orr_status read_header(lzw_stage *l, orr_diag *diag)
{
    uint8_t head[3];
    size_t n = 0, got = 0;
    do {
        orr_status st = orr_stage_read(l->stage.below, head + n, sizeof head - n, &got, diag);
        if (st != ORR_OK) return st;
        n += got;
    } while (got > 0 && n < sizeof head);
    int max_width = head[2] & 0x1f;
    if (n < sizeof head || max_width < MIN_WIDTH || max_width > MAX_WIDTH || (head[2] & 0x60) != 0)
        return orr_diag_at(diag, ORR_E_FORMAT, l->stage.name, 0, 0,
                           "starts like a .Z file, but its third byte is not one that compress writes");
    l->has_header = true;
    l->block_mode = (head[2] & 0x80) != 0;
    l->max_width = max_width == 9 ? 10 : max_width; // compress -b 9 goes on to ten bits all the same
    l->width = MIN_WIDTH;
    l->n_codes = l->block_mode ? CLEAR + 1 : CLEAR;
    l->previous = -1;
    return ORR_OK;
}

static orr_status damaged(const lzw_stage *l, orr_diag *diag)
{
    return orr_diag_at(diag, ORR_E_FORMAT, l->stage.name, 0, 0,
                       "damaged .Z data: a code was used before it was defined");
}

// Appends the text of one code to out[] and defines the next code.
static orr_status expand(lzw_stage *l, int code, orr_diag *diag)
{
    uint8_t *to = l->out + l->out_n;
    if (l->previous < 0) {
        if (code >= 256) return damaged(l, diag);
        *to = (uint8_t)code;
        l->out_n++;
        l->previous = code;
        return ORR_OK;
    }
    if ((unsigned)code > l->n_codes) return damaged(l, diag);
    bool itself =
        (unsigned)code == l->n_codes; // the code being defined: the previous text and its own first byte
    int walk = itself ? l->previous : code;
    size_t length = (walk < 256 ? 0 : (size_t)l->length[walk]) + 1;
    for (uint8_t *at = to + length; at > to + 1;) {
        *--at = l->suffix[walk];
        walk = l->prefix[walk];
    }
    *to = (uint8_t)walk;
    if (itself) to[length++] = *to;
    l->out_n += length;
    if (l->n_codes < (1u << l->max_width)) {
        l->prefix[l->n_codes] = (uint16_t)l->previous;
        l->suffix[l->n_codes] = *to;
        l->length[l->n_codes] = (uint16_t)((l->previous < 256 ? 0 : l->length[l->previous]) + 1);
        l->n_codes++;
    } else if (itself) {
        return damaged(l, diag);
    }
    l->previous = code;
    return ORR_OK;
}

static orr_status fill(lzw_stage *l, orr_diag *diag)
{
    l->out_at = l->out_n = 0;
    while (l->out_n < OUT - TABLE) {
        orr_status st = ORR_OK;
        if (l->n_codes > (1u << l->width) - 1 && l->width < l->max_width)
            st = set_width(l, l->width + 1, diag);
        if (st != ORR_OK) return st;
        int code = 0;
        st = next_code(l, &code, diag);
        if (st != ORR_OK) return st;
        if (code < 0) {
            // The last code is padded to a whole byte; more than that is a code that was cut.
            if (l->n_bits >= 8)
                return orr_diag_at(diag, ORR_E_FORMAT, l->stage.name, 0, 0,
                                   "the .Z data end inside a code: the file is cut (a broken download?)");
            l->at_end = true;
            return ORR_OK;
        }
        if (code == CLEAR && l->block_mode) {
            st = set_width(l, MIN_WIDTH, diag);
            l->n_codes = CLEAR + 1;
            l->previous = -1;
        } else {
            st = expand(l, code, diag);
        }
        if (st != ORR_OK) return st;
    }
    return ORR_OK;
}

static orr_status lzw_read(orr_stage *self, uint8_t *buf, size_t capacity, size_t *got, orr_diag *diag)
{
    lzw_stage *l = (lzw_stage *)self;
    *got = 0;
    if (!l->has_header) {
        orr_status st = read_header(l, diag);
        if (st != ORR_OK) return st;
    }
    if (l->out_at == l->out_n && !l->at_end) {
        orr_status st = fill(l, diag);
        if (st != ORR_OK) return st;
    }
    size_t n = l->out_n - l->out_at;
    if (n > capacity) n = capacity;
    memcpy(buf, l->out + l->out_at, n);
    l->out_at += n;
    *got = n;
    return ORR_OK;
}

static void lzw_close(orr_stage *self) { free(self); }

orr_status orr_stage_lzw(orr_stage *below, orr_stage **out, orr_diag *diag)
{
    lzw_stage *l = calloc(1, sizeof *l);
    if (l == NULL) return orr_diag_set(diag, ORR_E_MEMORY, "out of memory");
    l->stage = (orr_stage){.read = lzw_read, .close = lzw_close, .name = below->name, .below = below};
    *out = &l->stage;
    return ORR_OK;
}
