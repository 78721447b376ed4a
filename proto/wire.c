// SPDX-License-Identifier: MIT
#include "proto/wire.h"

const char *orr_wire_status_text(orr_wire_status s)
{
    switch (s) {
    case ORR_WIRE_OK:
        return "no error";
    case ORR_WIRE_MORE:
        return "the frame is not complete";
    case ORR_WIRE_SHORT:
        return "the payload ends inside a field";
    case ORR_WIRE_LIMIT:
        return "a length or count in the payload is above its limit";
    case ORR_WIRE_SPACE:
        return "the message does not fit into the buffer";
    case ORR_WIRE_MAGIC:
        return "the bytes are no frame of this protocol (wrong magic)";
    case ORR_WIRE_VERSION:
        return "the frame is of another major version";
    case ORR_WIRE_LENGTH:
        return "the payload length is above the limit";
    case ORR_WIRE_CRC:
        return "the checksum does not match";
    case ORR_WIRE_IO:
        return "reading or writing failed";
    case ORR_WIRE_CLOSED:
        return "the peer closed the connection";
    case ORR_WIRE_UNEXPECTED:
        return "the peer sent a frame that does not answer the request";
    case ORR_WIRE_REFUSED:
        return "the peer refused the request";
    }
    return "unknown status";
}

char *orr_wire_text_copy(orr_wire_bytes b, char *buf, size_t n)
{
    size_t m = b.size < n ? b.size : n - 1;
    if (m > 0) memcpy(buf, b.data, m);
    buf[m] = '\0';
    return buf;
}

void orr_wire_put_raw(orr_wire_writer *w, const uint8_t *data, size_t n)
{
    uint8_t *p = orr_wire_room(w, n);
    if (p != NULL && n > 0) memcpy(p, data, n);
}

void orr_wire_put_bytes(orr_wire_writer *w, orr_wire_bytes b, uint16_t max)
{
    if (w->status == ORR_WIRE_OK && b.size > max) w->status = ORR_WIRE_LIMIT;
    uint8_t *p = orr_wire_room(w, 2);
    if (p == NULL) return;
    orr_wire_store_u16(p, b.size);
    orr_wire_put_raw(w, b.data, b.size);
}

orr_wire_bytes orr_wire_get_bytes(orr_wire_reader *r, uint16_t max)
{
    orr_wire_bytes b = {NULL, 0};
    const uint8_t *p = orr_wire_take(r, 2);
    if (p == NULL) return b;
    uint16_t n = orr_wire_load_u16(p);
    if (n > max) {
        r->status = ORR_WIRE_LIMIT;
        return b;
    }
    p = orr_wire_take(r, n);
    if (p == NULL) return b;
    b.data = p;
    b.size = n;
    return b;
}
