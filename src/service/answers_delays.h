// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of POLL_DELAYS, a row of the table in answers.c.
#ifndef ORR_SERVICE_ANSWERS_DELAYS_H
#define ORR_SERVICE_ANSWERS_DELAYS_H

#include "proto/server.h"

uint16_t orr_answers_begin_delays(void *user, const orr_msg_poll_delays *poll, orr_server_refusal *why);
uint16_t orr_answers_delays(void *user, const orr_msg_poll_delays *poll, orr_server_part *part,
                            orr_wire_writer *w, orr_server_refusal *why);

#endif
