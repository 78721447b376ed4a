// SPDX-License-Identifier: GPL-3.0-or-later
// The connection to a service: proto's client over a TCP or Unix socket. Answers depend on the question alone, so that a
// connection that was lost is made again and the question is asked again; nothing else has to be remembered.
#ifndef ORR_GENERATOR_FEED_LINK_H
#define ORR_GENERATOR_FEED_LINK_H

#include "proto/client.h"
#include "src/generator/feed/fault.h"

#define ORR_GEN_NAME 65

// A signal as CAPS names it.
typedef struct orr_gen_signal_info {
    uint16_t number;
    char system, name[17];
    double carrier_hz, channel_hz, chips_per_s;
} orr_gen_signal_info;

// What of CAPS the generator uses, kept.
typedef struct orr_gen_service {
    char title[129];
    orr_msg_leap_seconds leap;
    size_t n_signals, n_antennas;
    orr_gen_signal_info signal[ORR_MSG_MAX_SIGNALS];
    char antenna[ORR_MSG_MAX_ANTENNAS][ORR_GEN_NAME];
    orr_msg_span channels, navdata; // of POLL_CHANNELS and POLL_NAVDATA
    bool has_channels, has_navdata;
} orr_gen_service;

typedef struct orr_gen_link orr_gen_link;

// Connects and says HELLO.
//
// Given:
//    url         tcp://HOST:PORT or unix:PATH
//    patience_s  how long it is tried to connect, now and whenever the connection is lost
//    log         called with a sentence when the connection is lost and when it is back; may be NULL
//    user        of log
// Returned:
//    link        to be closed
//    service     what CAPS says
//    fault       why it failed
bool orr_gen_link_open(const char *url, double patience_s, void (*log)(void *user, const char *text),
                       void *user, orr_gen_link **link, orr_gen_service *service, orr_gen_fault *fault);
// Closes the connection and frees it; NULL may be closed.
void orr_gen_link_close(orr_gen_link *link);

// The client to ask with. What it returns other than ORR_WIRE_OK goes to orr_gen_link_again.
orr_client *orr_gen_link_client(orr_gen_link *link);

// After a call of the client failed: true where the connection has been made again and the question is to be asked again,
// false with a sentence where the service refuses, answers another protocol, or does not come back within the patience.
// `doing` names the question.
bool orr_gen_link_again(orr_gen_link *link, orr_wire_status status, const char *doing, orr_gen_fault *fault);

#endif
