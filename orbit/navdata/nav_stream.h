// SPDX-License-Identifier: GPL-3.0-or-later
// Which navigation message is sent on which signal: a stream is one sequence of bits. Some messages are sent on several
// signals in an order or at a rate of their own (I/NAV on E1 and E5b, CNAV on L2C and L5), and are several streams.
#ifndef ORR_ORBIT_NAVDATA_NAV_STREAM_H
#define ORR_ORBIT_NAVDATA_NAV_STREAM_H

#include "ingest/rinex/rinex_nav.h"

typedef struct orr_nav_stream {
    char system;
    uint8_t message;     // orr_nav_message
    const char *signals; // of core/signal.def, that carry these bits, divided by blanks: "L1OF L2OF"
} orr_nav_stream;

// All streams, by system; in each the legacy message first.
const orr_nav_stream *orr_nav_streams(size_t *n);
// Messages that a system's streams send, bit 1 << orr_nav_message each.
uint32_t orr_nav_streams_of(char system);

#endif
