// SPDX-License-Identifier: GPL-3.0-or-later
// What CAPS tells of a scenario: which requests will be answered and over which span, and everything that a
// client would otherwise have to guess.
#ifndef ORR_SERVICE_ANSWERS_CAPS_H
#define ORR_SERVICE_ANSWERS_CAPS_H

#include "proto/server.h"

// Fills CAPS, but for versions, limits and requests; `user` is an orr_answers.
void orr_answers_caps(void *user, orr_msg_caps *caps);
// Whether a kind of request will be answered, and over which span; `user` is an orr_answers.
bool orr_answers_served(void *user, uint16_t request, orr_msg_span *span);

#endif
