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

// A message as a table on stdout; `frame` is what positions refer to. False without memory.
bool orr_message_table(const orr_record *r, const void *m, const char *frame);

// Prints a message to stdout.
// Given:
//   info    kind of the message
//   m       the message, of info->record
//   format  table, JSON or CSV
//   frame   what positions refer to, for the head of a table
//   headed  whether the names of CSV's columns have been printed
// Returned:
//   headed  true once they have
//   (value)  false without memory for it
bool orr_message_show(const orr_message_info *info, const void *m, orr_show_format format, const char *frame,
                      bool *headed);

#endif
