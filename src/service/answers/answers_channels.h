// SPDX-License-Identifier: GPL-3.0-or-later
// Handler of POLL_CHANNELS, and what CAPS says of antennas, signals and transmitters.
#ifndef ORR_SERVICE_ANSWERS_CHANNELS_H
#define ORR_SERVICE_ANSWERS_CHANNELS_H

#include "proto/server.h"
#include "src/scenario/channel/live.h"
#include "src/service/live/ahead.h"
#include "src/service/live/vehicle.h"

// Room for one epoch of channels and for the lists of CAPS.
typedef struct orr_answers_channels_room {
    orr_channel_work *work;
    orr_ahead *ahead;        // NULL: blocks are made when they are asked for
    orr_live_channels *live; // NULL: antennas move as the scenario says
    orr_vehicle *vehicle;    // and the body, borrowed
    orr_block *block;
    orr_msg_sat_channel *channel;
    orr_msg_jammer jammer[ORR_MAX_JAMMERS];
    orr_msg_channel_terms *terms;
    orr_msg_antenna antenna[ORR_MSG_MAX_ANTENNAS];
    orr_msg_signal signal[ORR_MSG_MAX_SIGNALS];
    orr_msg_transmitter transmitter[ORR_MSG_MAX_SATELLITES];
} orr_answers_channels_room;

// Errors: ORR_E_LIMIT (more channels than a message lists), ORR_E_MEMORY. Free with orr_answers_channels_close.
orr_status orr_answers_channels_open(const orr_channels *c, orr_answers_channels_room *out, orr_diag *diag);
void orr_answers_channels_close(orr_answers_channels_room *room); // leaves *room empty
// Whether a POLL_CHANNELS is about blocks that will be asked for: they are made meanwhile.
void orr_answers_channels_expect(const orr_channels *c, orr_answers_channels_room *room,
                                 const orr_msg_poll_channels *poll);
// From here on antennas that ride on a body go along a live one, where there are samples of it. Errors: ORR_E_NODATA (no
// antenna rides), ORR_E_MEMORY.
orr_status orr_answers_channels_ride(const orr_channels *c, orr_vehicle *vehicle,
                                     orr_answers_channels_room *room, orr_diag *diag);
// Fills antennas, signals and transmitters of CAPS; nothing where c is NULL.
void orr_answers_channels_caps(const orr_channels *c, orr_answers_channels_room *room, orr_msg_caps *caps);

// Refuses a POLL_CHANNELS that cannot be answered: 0 or a code, with its sentence.
uint16_t orr_answers_begin_channels(void *user, const orr_msg_poll_channels *poll, orr_server_refusal *why);
// One epoch of the answer.
// Given:
//   user  the answers
//   poll  request
//   part  which epoch
// Returned:
//   w     frame
//   why   not used: what can be refused was refused at the begin
uint16_t orr_answers_channels(void *user, const orr_msg_poll_channels *poll, orr_server_part *part,
                              orr_wire_writer *w, orr_server_refusal *why);

#endif
