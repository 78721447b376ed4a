// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol as JSON lines: a request is an object on a line, {"request": "POLL", "t": "2025-03-21T10:00:00", "satellites": ["G05"]},
// with the names of the message's fields; its answers are objects on lines as `orrery poll --format json` prints them.
#ifndef ORR_SERVICE_TEXT_JSON_LINE_H
#define ORR_SERVICE_TEXT_JSON_LINE_H

#include <stdio.h>

#include "src/service/text/ask.h"

enum { ORR_JSON_LINE_EPOCHS = 10000 }; // of one request

// Answers a line. What cannot be answered is {"error": class, "sentence": why}. Instants are numbers (ns) or texts; one that is missing is
// that of the scenario's clock; step and count are 0 and 1 where they are missing.
void orr_json_line(const orr_asked *a, const char *line, FILE *out);

#endif
