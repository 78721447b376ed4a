// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of POLL_ELEMENTS, a row of the table in answers.c.
#ifndef ORR_SERVICE_ANSWERS_ELEMENTS_H
#define ORR_SERVICE_ANSWERS_ELEMENTS_H

#include "proto/server.h"

uint16_t orr_answers_begin_elements(void *user, const orr_msg_poll_elements *poll, orr_server_refusal *why);
uint16_t orr_answers_elements(void *user, const orr_msg_poll_elements *poll, orr_server_part *part,
                              orr_wire_writer *w, orr_server_refusal *why);

#endif
