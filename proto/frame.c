// SPDX-License-Identifier: MIT
#include "proto/frame.h"

#include "proto/crc32.h"
#include "proto/gen/messages.h"

static const uint8_t magic[4] = {ORR_MSG_MAGIC_0, ORR_MSG_MAGIC_1, ORR_MSG_MAGIC_2, ORR_MSG_MAGIC_3};

orr_wire_status orr_frame_parse(const uint8_t *data, size_t n, uint32_t max_payload, orr_frame *f,
                                size_t *used)
{
    *used = ORR_FRAME_OVERHEAD;
    if (n > 0 && memcmp(data, magic, n < sizeof magic ? n : sizeof magic) != 0) return ORR_WIRE_MAGIC;
    if (n < ORR_FRAME_HEADER) return ORR_WIRE_MORE;
    f->major = orr_wire_load_u8(data + 4);
    f->minor = orr_wire_load_u8(data + 5);
    f->type = orr_wire_load_u16(data + 6);
    f->sequence = orr_wire_load_u32(data + 8);
    f->size = orr_wire_load_u32(data + 12);
    f->payload = data + ORR_FRAME_HEADER;
    if (f->major != ORR_MSG_MAJOR) return ORR_WIRE_VERSION;
    if (f->size > max_payload) return ORR_WIRE_LENGTH;
    *used = (size_t)ORR_FRAME_OVERHEAD + f->size;
    if (n < *used) return ORR_WIRE_MORE;
    size_t covered = *used - 4;
    if (orr_crc32(0, data, covered) != orr_wire_load_u32(data + covered)) return ORR_WIRE_CRC;
    return ORR_WIRE_OK;
}

void orr_frame_begin(orr_wire_writer *w, uint16_t type, uint32_t sequence, size_t *start)
{
    *start = w->size;
    uint8_t *p = orr_wire_room(w, ORR_FRAME_HEADER);
    if (p == NULL) return;
    memcpy(p, magic, sizeof magic);
    orr_wire_store_u8(p + 4, ORR_MSG_MAJOR);
    orr_wire_store_u8(p + 5, ORR_MSG_MINOR);
    orr_wire_store_u16(p + 6, type);
    orr_wire_store_u32(p + 8, sequence);
    orr_wire_store_u32(p + 12, 0);
}

void orr_frame_end(orr_wire_writer *w, size_t start)
{
    if (w->status != ORR_WIRE_OK) return;
    size_t payload = w->size - start - ORR_FRAME_HEADER;
    if (payload > ORR_MSG_MAX_PAYLOAD) {
        w->status = ORR_WIRE_LIMIT;
        return;
    }
    orr_wire_store_u32(w->data + start + 12, (uint32_t)payload);
    size_t covered = w->size - start;
    uint8_t *p = orr_wire_room(w, 4);
    if (p == NULL) return;
    orr_wire_store_u32(p, orr_crc32(0, w->data + start, covered));
}
