// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that orrery poll's JSON objects are made of: one object an epoch and line (docs/protocol.md).
#ifndef ORR_CLI_SERVICE_POLL_JSON_H
#define ORR_CLI_SERVICE_POLL_JSON_H

#include <stdint.h>

#include "proto/gen/messages.h"
#include "src/cli/frame/json.h"

json_t *orr_poll_json_vector(const double *v, int n);
json_t *orr_poll_json_sat(orr_msg_sat_id id); // "G05"
// Names of the bits that are set, by the generated name function of a bit set.
json_t *orr_poll_json_bits(uint32_t bits, const char *(*name)(unsigned bit));
// Prints it on a line of stdout and frees it.
void orr_poll_json_print(json_t *j);

// "G05"; '?' for a system that is no letter.
const char *orr_poll_sat_name(orr_msg_sat_id id, char buf[8]);
// An answer in words.
const char *orr_poll_answer_words(uint8_t answer);

#endif
