// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes that a receiver's port has put out, appended one message after the other.
#ifndef ORR_SCENARIO_RECEIVER_BYTES_H
#define ORR_SCENARIO_RECEIVER_BYTES_H

#include <stdlib.h>
#include <string.h>

#include "core/status.h"

// Zero-initialise; free(data) in the end.
typedef struct orr_port_bytes {
    uint8_t *data;
    size_t n, room;
    bool lost; // there was no memory for some
} orr_port_bytes;

// Appends n bytes; without memory none, and `lost` is set.
static inline void orr_port_bytes_add(orr_port_bytes *b, const void *data, size_t n)
{
    if (n == 0) return;
    if (b->room - b->n < n) {
        const size_t room = 2 * (b->n + n);
        uint8_t *grown = realloc(b->data, room);
        if (grown == NULL) {
            b->lost = true;
            return;
        }
        b->data = grown, b->room = room;
    }
    memcpy(b->data + b->n, data, n);
    b->n += n;
}

// ORR_E_MEMORY where some were lost.
static inline orr_status orr_port_bytes_status(const orr_port_bytes *b, orr_diag *diag)
{
    return b->lost ? orr_diag_set(diag, ORR_E_MEMORY, "out of memory") : ORR_OK;
}

#endif
