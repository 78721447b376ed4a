// SPDX-License-Identifier: GPL-3.0-or-later
// Payloads of frames on their way from the thread that makes them to those who send them: counted, so that streams which ask for
// the same have one copy, and kept for the next ones, so that a stream at its ease allocates nothing.
#ifndef ORR_SERVICE_LIVE_BLOCKS_H
#define ORR_SERVICE_LIVE_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct orr_payload {
    uint16_t type; // of the message
    unsigned owners;
    size_t size, capacity;
    struct orr_payload *next; // among those that are free
    uint8_t data[];
} orr_payload;

// Zero-initialise. Its owner sees to it that one thread at a time uses it.
typedef struct orr_payloads {
    orr_payload *free;
    size_t n_free;
} orr_payloads;

// A copy of a payload with one owner; NULL: out of memory.
orr_payload *orr_payload_new(orr_payloads *p, uint16_t type, const uint8_t *data, size_t size);
// One owner less; without any it is kept for the next.
void orr_payload_drop(orr_payloads *p, orr_payload *b);
// Frees those that are kept.
void orr_payloads_free(orr_payloads *p);

#endif
