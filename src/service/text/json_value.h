// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that values as JSON are made of. What is not known is null; no key goes missing for it.
#ifndef ORR_SERVICE_TEXT_JSON_VALUE_H
#define ORR_SERVICE_TEXT_JSON_VALUE_H

#include <jansson.h>

#include "core/sat.h"
#include "core/time.h"

json_t *orr_json_number(double v); // null for NAN and infinities
// A whole number.
json_t *orr_json_count(size_t n);
json_t *orr_json_text(const char *text); // null for NULL; other bytes than UTF-8 become '?'
json_t *orr_json_time(orr_time t);       // ISO 8601, GPS time; null for ORR_TIME_NONE
json_t *orr_json_sat(orr_sat sat);       // "G05"

#endif
