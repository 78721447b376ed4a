// SPDX-License-Identifier: GPL-3.0-or-later
// Reports as JSON on stdout; the pieces that they are made of are src/service/text's.
#ifndef ORR_CLI_FRAME_JSON_H
#define ORR_CLI_FRAME_JSON_H

#include <jansson.h>

#include "src/cli/frame/cli.h"
#include "src/service/text/json_value.h"

// Both print j and a line's end on stdout and free j. flags are jansson's (JSON_INDENT, JSON_REAL_PRECISION).
bool orr_json_put(json_t *j, size_t flags);
int orr_json_print(const orr_cli *c, json_t *j, size_t flags); // an exit status, with its sentence

#endif
