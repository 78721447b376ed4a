// SPDX-License-Identifier: GPL-3.0-or-later
#include "orbit/navdata/rtcm_frame.h"

#include <string.h>

#include "core/crc.h"

#define PREAMBLE 0xd3
#define HEAD 3

void orr_rtcm_begin(orr_rtcm_frame *f) { memset(f, 0, sizeof *f); }

void orr_rtcm_put(orr_rtcm_frame *f, int n, uint64_t value)
{
    if (f->full || f->bits + (size_t)n > 8 * ORR_RTCM_CONTENT) {
        f->full = true;
        return;
    }
    for (int k = n - 1; k >= 0; k--, f->bits++)
        if (value >> k & 1u) f->data[HEAD + f->bits / 8] |= (uint8_t)(0x80u >> f->bits % 8);
}

bool orr_rtcm_end(orr_rtcm_frame *f)
{
    if (f->full) return false;
    const size_t content = (f->bits + 7) / 8;
    f->data[0] = PREAMBLE;
    f->data[1] = (uint8_t)(content >> 8);
    f->data[2] = (uint8_t)content;
    const uint32_t crc = orr_crc24q(0, f->data, HEAD + content);
    for (size_t k = 0; k < 3; k++) f->data[HEAD + content + k] = (uint8_t)(crc >> (16 - 8 * k));
    f->n = HEAD + content + 3;
    return true;
}
