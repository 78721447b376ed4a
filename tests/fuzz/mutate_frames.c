// SPDX-License-Identifier: GPL-3.0-or-later
// Mutations that know what a stream of frames is: a frame's payload is changed and its length and checksum are made right again, frames are
// doubled, dropped, given other types and sequences. Only so do changed payloads get behind the checksum. The first byte is not the stream's.
#include <string.h>

#include "fuzz/mutate.h"
#include "proto/frame.h"
#include "proto/gen/messages.h"

enum { LARGEST = 1 << 16 };

// The frame that begins there, if one does; its length with header and checksum.
static size_t frame_at(const uint8_t *p, size_t n, orr_frame *f)
{
    size_t used = 0;
    return orr_frame_parse(p, n, LARGEST, f, &used) == ORR_WIRE_OK ? used : 0;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t n, size_t most, unsigned seed)
{
    static uint8_t payload[2 * LARGEST], made[2 * LARGEST + ORR_FRAME_OVERHEAD];
    size_t at = 1, frames = 0;
    orr_frame f;
    for (size_t used; at < n && (used = frame_at(data + at, n - at, &f)) > 0; at += used) frames++;
    if (frames == 0 || seed % 4 == 0) return LLVMFuzzerMutate(data, n, most);
    const size_t which = seed / 4 % frames;
    at = 1;
    for (size_t k = 0; k < which; k++) at += frame_at(data + at, n - at, &f);
    const size_t size = frame_at(data + at, n - at, &f), rest = n - at - size;
    uint16_t type = f.type;
    uint32_t sequence = f.sequence;
    size_t length = f.size;
    memcpy(payload, f.payload, length);
    const unsigned what = seed / 4096 % 8;
    if (what == 0) { // dropped
        memmove(data + at, data + at + size, rest);
        return n - size;
    }
    if (what == 1 && n + size <= most) { // doubled
        memmove(data + at + size, data + at, rest + size);
        return n + size;
    }
    if (what == 2)
        type = (uint16_t)(1 + seed / 32768 % 45); // a payload of another message's
    else if (what == 3)
        sequence = seed / 32768 % 7;
    else
        length = LLVMFuzzerMutate(payload, length, LARGEST);
    orr_wire_writer w = {made, 0, sizeof made, ORR_WIRE_OK};
    size_t start;
    orr_frame_begin(&w, type, sequence, &start);
    orr_wire_put_raw(&w, payload, length);
    orr_frame_end(&w, start);
    if (w.status != ORR_WIRE_OK || at + w.size + rest > most) return n;
    memmove(data + at + w.size, data + at + size, rest);
    memcpy(data + at, made, w.size);
    return at + w.size + rest;
}
