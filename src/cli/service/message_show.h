// SPDX-License-Identifier: GPL-3.0-or-later
// Any message as a table, as a JSON object on a line, or as CSV, by its field descriptors alone: a new kind of
// message is printed without a line of code. docs/protocol.md tells the rules.
#ifndef ORR_CLI_SERVICE_MESSAGE_SHOW_H
#define ORR_CLI_SERVICE_MESSAGE_SHOW_H

#include "proto/fields.h"

typedef enum orr_show_format {
    ORR_AS_TABLE,
    ORR_AS_JSON,
    ORR_AS_CSV,
} orr_show_format;

// Prints m (of info->record) to stdout. *headed: whether the names of CSV's columns have been printed; `frame`
// is what positions refer to, for the head of a table.
void orr_message_show(const orr_message_info *info, const void *m, orr_show_format format, const char *frame,
                      bool *headed);

#endif
