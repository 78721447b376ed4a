// SPDX-License-Identifier: GPL-3.0-or-later
// The channels by which clients send datagrams, each given to one connection and ended with it: who may use it, what seals it, and what has
// come. All functions may be called from any thread.
#ifndef ORR_SERVICE_NET_DATAGRAMS_H
#define ORR_SERVICE_NET_DATAGRAMS_H

#include <stdbool.h>

#include "proto/datagram.h"
#include "src/service/net/seal.h"

typedef struct orr_datagrams orr_datagrams;

typedef enum orr_datagram_verdict {
    ORR_DATAGRAM_TAKEN,
    ORR_DATAGRAM_REPLAYED,    // it had come before, or nobody knows any more
    ORR_DATAGRAM_REFUSED,     // no channel of that number, another seal, from elsewhere, no frame
    ORR_DATAGRAM_NOT_ALLOWED, // whose client may not send motion
} orr_datagram_verdict;

// What has become of a channel's datagrams.
typedef struct orr_datagram_counts {
    uint64_t taken, replayed, refused;
} orr_datagram_counts;

// An empty table; NULL: out of memory.
orr_datagrams *orr_datagrams_open(void);
void orr_datagrams_close(orr_datagrams *d); // NULL is allowed
// The port where datagrams are taken; 0 at first: nowhere.
void orr_datagrams_listen(orr_datagrams *d, uint16_t port);
// That port.
uint16_t orr_datagrams_port(orr_datagrams *d);
// A number that no channel had before.
uint32_t orr_datagrams_number(orr_datagrams *d);
// Gives a channel to a client.
// Given:
//   d     the table
//   key   of its seal; NULL: it has none, and its datagrams come from this machine
//   may   whether it may send motion
// Returns its number; 0: out of memory.
uint32_t orr_datagrams_admit(orr_datagrams *d, const uint8_t *key, bool may);
// What its client may do has changed.
void orr_datagrams_permit(orr_datagrams *d, uint32_t channel, bool may);
// Ends a channel; 0 is none.
void orr_datagrams_leave(orr_datagrams *d, uint32_t channel);
// What has come of a channel.
orr_datagram_counts orr_datagrams_count(orr_datagrams *d, uint32_t channel);
// Looks at a datagram.
// Given:
//   d       the table
//   data    the datagram, of n bytes
//   local   whether it comes from this machine
// Returned:
//   f       its frame, which borrows the datagram
orr_datagram_verdict orr_datagrams_take(orr_datagrams *d, const uint8_t *data, size_t n, bool local,
                                        orr_frame *f);

#endif
