// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams of one connection: its channel, the keys of its TLS session, and streams that go as datagrams to its client's address.
#ifndef ORR_SERVICE_SERVE_DATAGRAM_LANE_H
#define ORR_SERVICE_SERVE_DATAGRAM_LANE_H

#include "proto/server.h"
#include "src/service/live/way.h"
#include "src/service/net/datagrams.h"
#include "src/service/net/link.h"

// Zero-initialise but for the first two.
typedef struct orr_datagram_lane {
    orr_datagrams *all; // NULL: there are none here
    const orr_link *link;
    uint32_t channel; // of what the client sends; 0: it has none
} orr_datagram_lane;

// OPEN_DATAGRAMS.
// Given:
//   l     the connection's
//   may   whether its client may send motion
//   room  of the keys that *told borrows
// Returned:
//   told  the answer
//   why   the sentence of a refusal
// Returns 0 or an ORR_MSG_ERROR_CODE.
uint16_t orr_datagram_lane_open(orr_datagram_lane *l, bool may, orr_seal_keys *room, orr_msg_datagrams *told,
                                orr_server_refusal *why);
// The way of a stream by datagrams.
// Given:
//   l       the connection's
//   port    of the client's address
//   stream  number that the frames bear
// Returned:
//   out      the way
//   channel  that its datagrams name
//   why      the sentence of a refusal
// Returns 0 or an ORR_MSG_ERROR_CODE.
uint16_t orr_datagram_lane_way(const orr_datagram_lane *l, uint16_t port, uint32_t stream, orr_way **out,
                               uint32_t *channel, orr_server_refusal *why);
// What the client may do has changed.
void orr_datagram_lane_permit(const orr_datagram_lane *l, bool may);
// Ends its channel.
void orr_datagram_lane_close(orr_datagram_lane *l);

#endif
