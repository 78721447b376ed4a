// SPDX-License-Identifier: MIT
// The ground of the wire: bytes in and out of a caller's buffer, little-endian, every access checked against
// its end. C99 and libc alone, no allocation, so that a generator's firmware can embed it. The codec in
// proto/gen is made on this.
#ifndef ORR_PROTO_WIRE_H
#define ORR_PROTO_WIRE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum orr_wire_status {
    ORR_WIRE_OK = 0,
    ORR_WIRE_MORE,       // the frame is not complete yet
    ORR_WIRE_SHORT,      // a payload or record ends inside a field
    ORR_WIRE_LIMIT,      // a length or count above the limit of the message table
    ORR_WIRE_SPACE,      // the caller's buffer is too small
    ORR_WIRE_MAGIC,      // these bytes are no frame
    ORR_WIRE_VERSION,    // a frame of another major version
    ORR_WIRE_LENGTH,     // payload length above the limit
    ORR_WIRE_CRC,        // checksum does not match
    ORR_WIRE_IO,         // the caller's read or write failed
    ORR_WIRE_CLOSED,     // the peer closed the connection
    ORR_WIRE_UNEXPECTED, // a well-formed frame that does not answer what was asked
    ORR_WIRE_REFUSED,    // the peer answered with ERROR
} orr_wire_status;

// A short sentence, never NULL.
const char *orr_wire_status_text(orr_wire_status s);

// Writes into data[0..capacity). The first failure sticks: later writes do nothing.
typedef struct orr_wire_writer {
    uint8_t *data;
    size_t size, capacity;
    orr_wire_status status;
} orr_wire_writer;

// Reads data[0..size). The first failure sticks: later reads do nothing.
typedef struct orr_wire_reader {
    const uint8_t *data;
    size_t size, at;
    orr_wire_status status;
} orr_wire_reader;

// Borrowed bytes of a string or blob: not NUL-terminated.
typedef struct orr_wire_bytes {
    const uint8_t *data;
    uint16_t size;
} orr_wire_bytes;

// Records of a list as they came: `stride` bytes each, or 0 where each stands behind its own u16 size.
// Borrowed.
typedef struct orr_wire_records {
    const uint8_t *data;
    size_t size;
    uint16_t stride;
} orr_wire_records;

// Position in a list of records; zero-initialise.
typedef struct orr_wire_iter {
    uint16_t index;
    size_t at;
} orr_wire_iter;

// The bytes of a NUL-terminated text, borrowed; NULL is the empty text. Cut at 65535.
static inline orr_wire_bytes orr_wire_text(const char *text)
{
    orr_wire_bytes b = {(const uint8_t *)text, 0};
    size_t n = text != NULL ? strlen(text) : 0;
    b.size = n > UINT16_MAX ? UINT16_MAX : (uint16_t)n;
    return b;
}

// Copies a string into buf[0..n) with a NUL, cut if need be (n > 0); returns buf.
char *orr_wire_text_copy(orr_wire_bytes b, char *buf, size_t n);

// (I2) Room for n bytes at the writer's end, already counted; NULL (and the writer's status) where there is none.
static inline uint8_t *orr_wire_room(orr_wire_writer *w, size_t n)
{
    if (w->status != ORR_WIRE_OK) return NULL;
    if (n > w->capacity - w->size) {
        w->status = ORR_WIRE_SPACE;
        return NULL;
    }
    w->size += n;
    return w->data + (w->size - n);
}

// (I1) The next n bytes of the reader, already passed; NULL (and the reader's status) where there are fewer.
static inline const uint8_t *orr_wire_take(orr_wire_reader *r, size_t n)
{
    if (r->status != ORR_WIRE_OK) return NULL;
    if (n > r->size - r->at) {
        r->status = ORR_WIRE_SHORT;
        return NULL;
    }
    r->at += n;
    return r->data + (r->at - n);
}

// One byte.
static inline void orr_wire_store_u8(uint8_t *p, uint8_t v) { p[0] = v; }
// Two bytes, the lowest first.
static inline void orr_wire_store_u16(uint8_t *p, uint16_t v)
{
    p[0] = (uint8_t)(v & 0xff);
    p[1] = (uint8_t)(v >> 8);
}
// Four bytes, the lowest first.
static inline void orr_wire_store_u32(uint8_t *p, uint32_t v)
{
    p[0] = (uint8_t)(v & 0xff);
    p[1] = (uint8_t)((v >> 8) & 0xff);
    p[2] = (uint8_t)((v >> 16) & 0xff);
    p[3] = (uint8_t)(v >> 24);
}
// Eight bytes, the lowest first.
static inline void orr_wire_store_u64(uint8_t *p, uint64_t v)
{
    p[0] = (uint8_t)(v & 0xff);
    p[1] = (uint8_t)((v >> 8) & 0xff);
    p[2] = (uint8_t)((v >> 16) & 0xff);
    p[3] = (uint8_t)((v >> 24) & 0xff);
    p[4] = (uint8_t)((v >> 32) & 0xff);
    p[5] = (uint8_t)((v >> 40) & 0xff);
    p[6] = (uint8_t)((v >> 48) & 0xff);
    p[7] = (uint8_t)(v >> 56);
}
// The byte at p.
static inline uint8_t orr_wire_load_u8(const uint8_t *p) { return p[0]; }
// The two bytes at p.
static inline uint16_t orr_wire_load_u16(const uint8_t *p)
{
    return (uint16_t)(p[0] | (uint16_t)(p[1] << 8));
}
// The four bytes at p.
static inline uint32_t orr_wire_load_u32(const uint8_t *p)
{
    return (uint32_t)p[0] | ((uint32_t)p[1] << 8) | ((uint32_t)p[2] << 16) | ((uint32_t)p[3] << 24);
}
// The eight bytes at p.
static inline uint64_t orr_wire_load_u64(const uint8_t *p)
{
    return (uint64_t)p[0] | ((uint64_t)p[1] << 8) | ((uint64_t)p[2] << 16) | ((uint64_t)p[3] << 24) |
           ((uint64_t)p[4] << 32) | ((uint64_t)p[5] << 40) | ((uint64_t)p[6] << 48) | ((uint64_t)p[7] << 56);
}
// Signed values travel as two's complement.
static inline void orr_wire_store_i8(uint8_t *p, int8_t v) { orr_wire_store_u8(p, (uint8_t)v); }
// Two bytes.
static inline void orr_wire_store_i16(uint8_t *p, int16_t v) { orr_wire_store_u16(p, (uint16_t)v); }
// Four bytes.
static inline void orr_wire_store_i32(uint8_t *p, int32_t v) { orr_wire_store_u32(p, (uint32_t)v); }
// Eight bytes.
static inline void orr_wire_store_i64(uint8_t *p, int64_t v) { orr_wire_store_u64(p, (uint64_t)v); }
// The signed byte at p.
static inline int8_t orr_wire_load_i8(const uint8_t *p)
{
    int8_t v;
    memcpy(&v, p, sizeof v);
    return v;
}
// The signed two bytes at p.
static inline int16_t orr_wire_load_i16(const uint8_t *p)
{
    uint16_t u = orr_wire_load_u16(p);
    int16_t v;
    memcpy(&v, &u, sizeof v);
    return v;
}
// The signed four bytes at p.
static inline int32_t orr_wire_load_i32(const uint8_t *p)
{
    uint32_t u = orr_wire_load_u32(p);
    int32_t v;
    memcpy(&v, &u, sizeof v);
    return v;
}
// The signed eight bytes at p.
static inline int64_t orr_wire_load_i64(const uint8_t *p)
{
    uint64_t u = orr_wire_load_u64(p);
    int64_t v;
    memcpy(&v, &u, sizeof v);
    return v;
}
// An IEEE 754 float. Any NAN becomes the one quiet NAN, so that equal answers are equal bytes.
static inline void orr_wire_store_f32(uint8_t *p, float v)
{
    uint32_t u;
    memcpy(&u, &v, sizeof u);
    if ((u & UINT32_C(0x7fffffff)) > UINT32_C(0x7f800000)) u = UINT32_C(0x7fc00000);
    orr_wire_store_u32(p, u);
}
// An IEEE 754 double, likewise.
static inline void orr_wire_store_f64(uint8_t *p, double v)
{
    uint64_t u;
    memcpy(&u, &v, sizeof u);
    if ((u & UINT64_C(0x7fffffffffffffff)) > UINT64_C(0x7ff0000000000000)) u = UINT64_C(0x7ff8000000000000);
    orr_wire_store_u64(p, u);
}
// The IEEE 754 float at p.
static inline float orr_wire_load_f32(const uint8_t *p)
{
    uint32_t u = orr_wire_load_u32(p);
    float v;
    memcpy(&v, &u, sizeof v);
    return v;
}
// The IEEE 754 double at p.
static inline double orr_wire_load_f64(const uint8_t *p)
{
    uint64_t u = orr_wire_load_u64(p);
    double v;
    memcpy(&v, &u, sizeof v);
    return v;
}

// (I3) u16 length and the bytes; above `max` the status is ORR_WIRE_LIMIT, on either side.
void orr_wire_put_bytes(orr_wire_writer *w, orr_wire_bytes b, uint16_t max);
// The same on reading: the bytes are borrowed, empty after a failure.
orr_wire_bytes orr_wire_get_bytes(orr_wire_reader *r, uint16_t max);
// Records already in wire form, as they are.
void orr_wire_put_raw(orr_wire_writer *w, const uint8_t *data, size_t n);

#ifdef __cplusplus
}
#endif

#endif
