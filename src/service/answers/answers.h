// SPDX-License-Identifier: GPL-3.0-or-later
// What the service answers with: the handler table of proto filled from a scenario's engine. A new kind of
// request is a pair of functions here and a row in the table.
#ifndef ORR_SERVICE_ANSWERS_H
#define ORR_SERVICE_ANSWERS_H

#include "proto/server.h"
#include "src/scenario/engine/engine.h"
#include "src/service/live/vehicle.h"

typedef struct orr_answers orr_answers;

// Makes the handler table of an engine, which must outlive it. ORR_E_LIMIT if it has more satellites than a message can
// list; ORR_E_MEMORY. Free with orr_answers_close.
orr_status orr_answers_open(const orr_engine *engine, orr_answers **out, orr_diag *diag);
// The handler table, borrowed.
const orr_server *orr_answers_server(const orr_answers *a);
// From here on antennas that ride on a body go along a live one; as orr_answers_channels_ride. The vehicle must outlive it.
orr_status orr_answers_ride(orr_answers *a, orr_vehicle *vehicle, orr_diag *diag);
// From here on blocks of channels are prepared ahead, by a thread of its own (live/ahead.h). Nothing where no signals are sent. Errors:
// ORR_E_MEMORY.
orr_status orr_answers_look_ahead(orr_answers *a, orr_diag *diag);
// A stream's first block is at the request's instant: orr_streams_options.expect, with the answers as user.
void orr_answers_expect(void *user, uint16_t type, const orr_msg_any *request);
// Frees it; NULL may be closed.
void orr_answers_close(orr_answers *a);

// A satellite as the wire names it.
orr_msg_sat_id orr_answers_sat_id(orr_sat sat);

// Of the handlers: the engine behind `user`.
const orr_engine *orr_answers_engine(const void *user);

#endif
