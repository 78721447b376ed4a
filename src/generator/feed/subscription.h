// SPDX-License-Identifier: GPL-3.0-or-later
// A stream of the service's answers: subscribed to once, then taken as they come. Several share a connection, and whoever waits for his own
// hands the others theirs. A stream lives as long as its connection: after a lost one it is subscribed to again.
#ifndef ORR_GENERATOR_FEED_SUBSCRIPTION_H
#define ORR_GENERATOR_FEED_SUBSCRIPTION_H

#include "src/generator/feed/link.h"

typedef struct orr_gen_subscription orr_gen_subscription;
struct orr_gen_subscription {
    orr_gen_link *link;
    uint16_t request, answer;                     // ORR_MSG_TYPE_* of the request and of its answers
    bool (*keep)(void *user, const orr_frame *f); // takes an answer; false where it cannot be used
    void *user;                                   // of keep
    // Where it is; zero at first.
    uint32_t stream;            // its number on the connection
    bool ended, bad;            // the stream has; a frame of it could not be kept
    char end[201];              // and why it has
    orr_gen_subscription *next; // of the same connection
};

// Whether it is on the connection, has not ended, and all frames of it could be kept.
bool orr_gen_subscribed(const orr_gen_subscription *s);

// Asks for the stream, at no clock's pace.
//
// Given:
//    s       which
//    poll    payload of the request, as encoded
//    credit  how many answers may be on the way
// The function returns ORR_WIRE_OK; anything else goes to orr_gen_link_again, but what orr_gen_no_streams tells.
orr_wire_status orr_gen_subscribe(orr_gen_subscription *s, const orr_wire_writer *poll, uint32_t credit);

// Whether the service refused a SUBSCRIBE because it knows no streams: it is polled then.
bool orr_gen_no_streams(const orr_gen_subscription *s, orr_wire_status status);

// Lets as many answers come as were used up.
orr_wire_status orr_gen_subscription_credit(orr_gen_subscription *s, size_t answers);

// Waits for one frame of any stream of the connection, which its subscription keeps.
orr_wire_status orr_gen_subscription_wait(orr_gen_subscription *s);

#endif
