// SPDX-License-Identifier: MIT
// A ring of messages in memory that two processes share: one writes, any number read by sequence, and no reader holds the writer up.
// A reader that is slower than the ring is long loses messages, and is told how many. C99 with the atomics of gcc and clang; no
// allocation, no system call.
//
// The memory: 64 bytes of head (magic, how many slots, bytes of each), 64 bytes whose first 8 count the messages that were written, then
// the slots. A slot is 16 bytes (its stamp, 8 bytes; bytes of the payload, 4; type of the message, 2; 2 of 0), then the payload. While
// message n (from 0) is written its slot's stamp is 2n + 1, afterwards 2n + 2. All little-endian.
#ifndef ORR_PROTO_RING_H
#define ORR_PROTO_RING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { ORR_RING_COUNT_AT = 64, ORR_RING_SLOTS_AT = 128, ORR_RING_SLOT_HEAD = 16 };
#define ORR_RING_MAGIC "ORRYRNG1"

// One side's view of a ring.
typedef struct orr_ring {
    uint8_t *memory;
    uint32_t slots, stride; // stride: bytes of a slot, its head included
    uint64_t next;          // message that is written, or read, next
    uint64_t lost;          // of a reader: messages that it was too slow for
} orr_ring;

// Bytes of memory that a ring takes; `stride` is a multiple of 64.
static inline size_t orr_ring_size(uint32_t slots, uint32_t stride)
{
    return ORR_RING_SLOTS_AT + (size_t)slots * stride;
}

// A word of the ring, for atomics.
static inline uint64_t *orr_ring_word_(uint8_t *at) { return (uint64_t *)(void *)at; }
// The slot of message n.
static inline uint8_t *orr_ring_slot_(const orr_ring *r, uint64_t n)
{
    return r->memory + ORR_RING_SLOTS_AT + (size_t)(n % r->slots) * r->stride;
}

// The writer's: lays out a ring in zeroed memory of orr_ring_size bytes, aligned to 64.
static inline void orr_ring_make(orr_ring *r, void *memory, uint32_t slots, uint32_t stride)
{
    *r = (orr_ring){(uint8_t *)memory, slots, stride, 0, 0};
    memcpy(r->memory + 8, &slots, 4);
    memcpy(r->memory + 12, &stride, 4);
    memcpy(r->memory, ORR_RING_MAGIC, 8);
}

// The writer's: writes one message. False, and nothing, where it is larger than a slot.
// Whoever sees any word of it sees that its slot is being written, too: the words are released one by one, and taken likewise.
static inline bool orr_ring_write(orr_ring *r, uint16_t type, const uint8_t *data, size_t size)
{
    uint8_t *slot = orr_ring_slot_(r, r->next);
    if (size > r->stride - ORR_RING_SLOT_HEAD) return false;
    __atomic_store_n(orr_ring_word_(slot), 2 * r->next + 1, __ATOMIC_RELAXED);
    __atomic_store_n(orr_ring_word_(slot + 8), (uint64_t)size | (uint64_t)type << 32, __ATOMIC_RELEASE);
    uint64_t *to = orr_ring_word_(slot + ORR_RING_SLOT_HEAD), word;
    for (size_t k = 0; k < size / 8; k++) {
        memcpy(&word, data + 8 * k, 8);
        __atomic_store_n(&to[k], word, __ATOMIC_RELEASE);
    }
    word = 0;
    if (size % 8 != 0) {
        memcpy(&word, data + size / 8 * 8, size % 8);
        __atomic_store_n(&to[size / 8], word, __ATOMIC_RELEASE);
    }
    __atomic_store_n(orr_ring_word_(slot), 2 * r->next + 2, __ATOMIC_RELEASE);
    r->next++;
    __atomic_store_n(orr_ring_word_(r->memory + ORR_RING_COUNT_AT), r->next, __ATOMIC_RELEASE);
    return true;
}

// A reader's: takes up a ring of so many bytes, at its first message (r->next may be set to another). False: it is none.
static inline bool orr_ring_open(orr_ring *r, const void *memory, size_t bytes)
{
    uint32_t slots, stride;
    *r = (orr_ring){(uint8_t *)(uintptr_t)memory, 0, 0, 0, 0}; // never written to
    if (bytes < ORR_RING_SLOTS_AT || memcmp(memory, ORR_RING_MAGIC, 8) != 0) return false;
    memcpy(&slots, r->memory + 8, 4);
    memcpy(&stride, r->memory + 12, 4);
    if (slots == 0 || stride < 64 || stride % 64 != 0 || (bytes - ORR_RING_SLOTS_AT) / stride < slots)
        return false;
    r->slots = slots;
    r->stride = stride;
    return true;
}

// A reader's: copies the next message. False: it has not been written yet. What was lost before it is counted in r->lost.
// Given:
//   r         the ring
//   capacity  bytes of data; what does not fit is cut off
// Returned:
//   type      of the message
//   data      its payload
//   size      bytes of the payload, more than capacity where it was cut
static inline bool orr_ring_read(orr_ring *r, uint16_t *type, uint8_t *data, size_t capacity, size_t *size)
{
    for (int tries = 0; tries < 8; tries++) { // of a writer that means no good there might be no end
        uint8_t *slot = orr_ring_slot_(r, r->next);
        const uint64_t stamp = __atomic_load_n(orr_ring_word_(slot), __ATOMIC_ACQUIRE);
        if (stamp < 2 * r->next + 2) return false;
        if (stamp == 2 * r->next + 2) {
            const uint64_t head = __atomic_load_n(orr_ring_word_(slot + 8), __ATOMIC_ACQUIRE);
            size_t n = (uint32_t)head;
            if (n > r->stride - ORR_RING_SLOT_HEAD) n = r->stride - ORR_RING_SLOT_HEAD;
            const size_t most = n < capacity ? n : capacity;
            const uint64_t *from = orr_ring_word_(slot + ORR_RING_SLOT_HEAD);
            for (size_t k = 0; k < most / 8; k++) {
                const uint64_t word = __atomic_load_n(&from[k], __ATOMIC_ACQUIRE);
                memcpy(data + 8 * k, &word, 8);
            }
            if (most % 8 != 0) {
                const uint64_t word = __atomic_load_n(&from[most / 8], __ATOMIC_ACQUIRE);
                memcpy(data + most / 8 * 8, &word, most % 8);
            }
            if (__atomic_load_n(orr_ring_word_(slot), __ATOMIC_RELAXED) == stamp) {
                *type = (uint16_t)(head >> 32);
                *size = n;
                r->next++;
                return true;
            }
        }
        // The writer has come round: on to the oldest that is safe for a while, half a ring behind it.
        const uint64_t written =
            __atomic_load_n(orr_ring_word_(r->memory + ORR_RING_COUNT_AT), __ATOMIC_ACQUIRE);
        const uint64_t to = written > r->slots / 2 ? written - r->slots / 2 : 0;
        if (to <= r->next) return false; // its slot is being written over at this moment
        r->lost += to - r->next;
        r->next = to;
    }
    return false;
}

#endif
