// SPDX-License-Identifier: MIT
// The frame around every message (docs/protocol.md): 16 bytes of header, payload, CRC-32 over both,
// little-endian.
//   0  magic "ORRY"   4  major u8   5  minor u8   6  type u16   8  sequence u32   12  payload length u32   16
//   payload
// The header keeps this shape in all versions to come, so that any two versions can tell each other what they
// are.
#ifndef ORR_PROTO_FRAME_H
#define ORR_PROTO_FRAME_H

#include "proto/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define ORR_FRAME_HEADER 16u
#define ORR_FRAME_OVERHEAD 20u // header and checksum

typedef struct orr_frame {
    uint8_t major, minor; // of the sender
    uint16_t type;
    uint32_t sequence;
    const uint8_t *payload; // borrowed from the bytes that were parsed
    uint32_t size;
} orr_frame;

// (I4, I5) Looks for one frame at the start of some bytes.
//   Given:    data, n       the n bytes that have come
//             max_payload   the longest payload that is taken
//   Returned: f             the frame, whose payload borrows the bytes
//             used          after OK its length; after MORE how many bytes are needed at least (so a buffer can
//                           be sized before they come)
//             (value)       ORR_WIRE_OK; ORR_WIRE_MORE; or ORR_WIRE_MAGIC, _VERSION, _LENGTH, _CRC: the stream is
//                           lost, and the header's fields are in *f except after ORR_WIRE_MAGIC
//   Notes:    a wrong magic, version or length is told from the header alone, without waiting for the rest.
orr_wire_status orr_frame_parse(const uint8_t *data, size_t n, uint32_t max_payload, orr_frame *f,
                                size_t *used);

// Writes the header with a length still open; *start is to be given to orr_frame_end. Everything between the two is
// payload.
void orr_frame_begin(orr_wire_writer *w, uint16_t type, uint32_t sequence, size_t *start);
// Sets the length and appends the checksum. The writer's status tells whether there was room.
void orr_frame_end(orr_wire_writer *w, size_t start);

#ifdef __cplusplus
}
#endif

#endif
