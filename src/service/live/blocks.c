// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/service/live/blocks.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_KEPT = 1024, GRAIN = 4096, LARGEST_KEPT = 256 << 10 };

orr_payload *orr_payload_new(orr_payloads *p, uint16_t type, const uint8_t *data, size_t size)
{
    orr_payload *b = p->free;
    if (b != NULL) {
        p->free = b->next;
        p->n_free--;
    }
    if (b == NULL || b->capacity < size) {
        const size_t capacity = (size + GRAIN - 1) / GRAIN * GRAIN;
        free(b);
        b = malloc(sizeof *b + capacity);
        if (b == NULL) return NULL;
        b->capacity = capacity;
    }
    b->type = type;
    b->owners = 1;
    b->size = size;
    b->next = NULL;
    memcpy(b->data, data, size);
    return b;
}

void orr_payload_drop(orr_payloads *p, orr_payload *b)
{
    if (--b->owners > 0) return;
    if (p->n_free >= MOST_KEPT || b->capacity > LARGEST_KEPT) {
        free(b);
        return;
    }
    b->next = p->free;
    p->free = b;
    p->n_free++;
}

void orr_payloads_free(orr_payloads *p)
{
    while (p->free != NULL) {
        orr_payload *next = p->free->next;
        free(p->free);
        p->free = next;
    }
    p->n_free = 0;
}
