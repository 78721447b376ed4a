// SPDX-License-Identifier: MIT
// Frames in datagrams: a head that numbers them, a seal behind them where one was agreed on, and what a receiver has had already. C99
// with libc alone; no allocation, no socket. The seal's arithmetic (HMAC-SHA-256) is the caller's.
//
// The bytes: `ORRD` (4), the channel that the server gave (4), the number of the datagram in it, from 1 (8), a frame, and with a seal its
// 32 bytes over all before them. All little-endian.
#ifndef ORR_PROTO_DATAGRAM_H
#define ORR_PROTO_DATAGRAM_H

#include "proto/frame.h"
#include "proto/gen/messages.h"

enum {
    ORR_DATAGRAM_HEAD = 16,
    ORR_DATAGRAM_SEAL = 32,
    ORR_DATAGRAM_MOST = 65507,  // bytes of UDP over IPv4
    ORR_DATAGRAM_WINDOW = 1024, // numbers behind the greatest that a datagram may still have
    ORR_DATAGRAM_FRAME = 65000, // payload of a frame that is sent in a datagram, at most
};
#define ORR_DATAGRAM_MAGIC "ORRD"

// Which numbers have come; zero-initialise. Numbers that are missing may still come: greatest - taken of them.
typedef struct orr_datagram_window {
    uint64_t greatest, taken, replayed;
    uint64_t seen[ORR_DATAGRAM_WINDOW / 64]; // a bit a number, modulo the window
} orr_datagram_window;

// A receiver's end of one channel.
typedef struct orr_datagram_reader {
    uint32_t channel;
    // Whether the 32 bytes behind the n bytes of data are their seal. NULL: the channel has none.
    bool (*holds)(void *user, const uint8_t *data, size_t n);
    void *user;
    orr_datagram_window window;
    uint64_t refused; // another channel, another seal, no frame
} orr_datagram_reader;

// Notes a number. False, and counted: it has come before, or lies so far back that nobody knows.
static inline bool orr_datagram_is_new(orr_datagram_window *w, uint64_t number)
{
    const uint64_t n = ORR_DATAGRAM_WINDOW, at = number % n, bit = (uint64_t)1 << (at % 64);
    if (number == 0 || (number <= w->greatest && w->greatest - number >= n) ||
        (number <= w->greatest && (w->seen[at / 64] & bit) != 0)) {
        w->replayed++;
        return false;
    }
    if (number > w->greatest) { // what comes into the window has not been seen
        const uint64_t gone = number - w->greatest < n ? number - w->greatest : n;
        for (uint64_t k = 0; k < gone; k++) {
            const uint64_t cleared = (number - k) % n;
            w->seen[cleared / 64] &= ~((uint64_t)1 << (cleared % 64));
        }
        w->greatest = number;
    }
    w->seen[at / 64] |= bit;
    w->taken++;
    return true;
}

// The channel that a datagram names; 0: it is none of ours.
static inline uint32_t orr_datagram_channel(const uint8_t *data, size_t n)
{
    return n >= ORR_DATAGRAM_HEAD && memcmp(data, ORR_DATAGRAM_MAGIC, 4) == 0 ? orr_wire_load_u32(data + 4)
                                                                              : 0;
}

// Writes the head of a datagram.
static inline void orr_datagram_head(uint8_t head[ORR_DATAGRAM_HEAD], uint32_t channel, uint64_t number)
{
    memcpy(head, ORR_DATAGRAM_MAGIC, 4);
    orr_wire_store_u32(head + 4, channel);
    orr_wire_store_u64(head + 8, number);
}

// Looks at one datagram.
// Given:
//   r     the receiver's end
//   data  the datagram
//   n     its bytes
// Returned:
//   f     its frame, which borrows the datagram
// True where it is of the channel, sealed as agreed, and new.
static inline bool orr_datagram_read(orr_datagram_reader *r, const uint8_t *data, size_t n, orr_frame *f)
{
    const size_t behind = r->holds != NULL ? ORR_DATAGRAM_SEAL : 0;
    size_t used;
    if (n < ORR_DATAGRAM_HEAD + behind || orr_datagram_channel(data, n) != r->channel ||
        (r->holds != NULL && !r->holds(r->user, data, n - behind)) ||
        orr_frame_parse(data + ORR_DATAGRAM_HEAD, n - ORR_DATAGRAM_HEAD - behind, ORR_DATAGRAM_FRAME, f,
                        &used) != ORR_WIRE_OK ||
        used != n - ORR_DATAGRAM_HEAD - behind) {
        r->refused++;
        return false;
    }
    return orr_datagram_is_new(&r->window, orr_wire_load_u64(data + 8));
}

#endif
