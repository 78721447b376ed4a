// SPDX-License-Identifier: GPL-3.0-or-later
// A request of the protocol asked from within, and its answer as a struct: by the handlers, or of the scenario's clock and motion.
#ifndef ORR_SERVICE_TEXT_ASK_H
#define ORR_SERVICE_TEXT_ASK_H

#include "core/leap.h"
#include "core/log.h"
#include "proto/server.h"
#include "src/config/access.h"
#include "src/service/live/streams.h"

struct orr_message_info; // proto/fields.h

// What answers. Its server is used by one thread.
typedef struct orr_asked {
    const orr_server *server;
    orr_streams *streams;       // NULL: no clock and no motion
    const orr_leap_table *leap; // NULL: the one built in
    unsigned may;               // orr_may: what else is asked is refused
    const orr_log *log;         // of what is told about clients; may be NULL
    uint32_t most_epochs;       // of one request as text; 0: ORR_JSON_LINE_EPOCHS
    uint8_t *room;              // ORR_MSG_LARGEST bytes, which answers borrow until the next
} orr_asked;

// Frame number k of the answer to a request.
// Given:
//   a        what answers
//   type     of the request
//   request  the request
//   k        0 unless it asks for epochs
// Returned:
//   answer   kind of the answer
//   m        the answer
//   why      the sentence of a refusal
// Returns 0 or an ORR_MSG_ERROR_CODE.
uint16_t orr_ask(const orr_asked *a, uint16_t type, const orr_msg_any *request, uint32_t k,
                 const struct orr_message_info **answer, orr_msg_any *m, orr_server_refusal *why);
// Where a request has its epochs; NULL where it has none.
orr_msg_epochs *orr_ask_epochs(uint16_t type, orr_msg_any *request);

#endif
