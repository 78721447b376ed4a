// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that reports as JSON are made of. What is not known is null; no key goes missing for it.
#ifndef ORR_CLI_FRAME_JSON_H
#define ORR_CLI_FRAME_JSON_H

#include <jansson.h>

#include "src/cli/frame/cli.h"

json_t *orr_json_number(double v); // null for NAN and infinities
// A whole number.
json_t *orr_json_count(size_t n);
json_t *orr_json_text(const char *text); // null for NULL; other bytes than UTF-8 become '?'
json_t *orr_json_time(orr_time t);       // ISO 8601, GPS time; null for ORR_TIME_NONE
json_t *orr_json_sat(orr_sat sat);       // "G05"

// Both print j and a line's end on stdout and free j. flags are jansson's (JSON_INDENT, JSON_REAL_PRECISION).
bool orr_json_put(json_t *j, size_t flags);
int orr_json_print(const orr_cli *c, json_t *j, size_t flags); // an exit status, with its sentence

#endif
