// SPDX-License-Identifier: GPL-3.0-or-later
// Handler of POLL_EVENTS, a row of the table in answers.c.
#ifndef ORR_SERVICE_ANSWERS_EVENTS_H
#define ORR_SERVICE_ANSWERS_EVENTS_H

#include "proto/server.h"

// Whether a POLL_EVENTS can be answered: 0, or a code of the protocol with a sentence in *why.
uint16_t orr_answers_begin_events(void *user, const orr_msg_poll_events *poll, orr_server_refusal *why);
// Writes one frame of events, or pieces of it until the turn is over.
// Given:
//   user  an orr_answers
//   poll  the request
//   part  which interval, and which pieces of it are done
// Returned:
//   part  `more` where pieces are left
//   w     the payload so far
//   why   the sentence of a code
// Returns 0, or a code of the protocol: LIMIT where an interval has more events than a message lists.
uint16_t orr_answers_events(void *user, const orr_msg_poll_events *poll, orr_server_part *part,
                            orr_wire_writer *w, orr_server_refusal *why);

#endif
