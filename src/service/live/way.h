// SPDX-License-Identifier: GPL-3.0-or-later
// How the messages of a stream go to its client past the connection: one face for shared memory and datagrams. Who makes one embeds it as
// his first member.
#ifndef ORR_SERVICE_LIVE_WAY_H
#define ORR_SERVICE_LIVE_WAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct orr_way orr_way;
struct orr_way {
    int fd;     // descriptor that the client gets with SUBSCRIBED, borrowed; -1: none
    bool lossy; // what was put may not come: notices go by the connection too
    // Puts one message; called by the thread that makes the blocks, and never waits. False: it is too large for the way.
    bool (*put)(orr_way *w, uint16_t type, const uint8_t *data, size_t size);
    // Frees it.
    void (*close)(orr_way *w);
};

#endif
