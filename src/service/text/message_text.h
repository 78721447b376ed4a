// SPDX-License-Identifier: GPL-3.0-or-later
// What the forms of a message as text share: its answer, its rows, its values that are words.
#ifndef ORR_SERVICE_TEXT_MESSAGE_TEXT_H
#define ORR_SERVICE_TEXT_MESSAGE_TEXT_H

#include <stddef.h>
#include <stdio.h>

#include "proto/fields.h"

// The answer in a message or record, ORR_MSG_ANSWER_OK where it has no such field.
uint8_t orr_message_answer(const orr_record *r, const void *m);
// How many have numbers: records of its list whose answer is OK; of a message without a list itself, 1 or 0.
uint64_t orr_message_numbers(const orr_record *r, const void *m);

#define ORR_MESSAGE_CELL 96
// Where a field of the record m stands.
static inline const void *orr_message_member(const orr_field *f, const void *m)
{
    return (const char *)m + f->offset;
}
// A field's name in text: an instant `t` is t_gps, as every command calls it.
const char *orr_message_name(const orr_field *f);
// The list of records that the rows of a table are; NULL where a message has none.
const orr_field *orr_message_rows(const orr_record *r);
// Room for one record of any list (test_json_line looks that it is enough).
typedef union orr_message_room {
    max_align_t align;
    unsigned char bytes[1024];
} orr_message_room;
// An enum's value, a bit set's names, a satellite, an instant, a letter or an integer as text; `words`: as for
// people, otherwise as the specification names it.
char *orr_message_text(const orr_field *f, const void *at, bool words, char cell[ORR_MESSAGE_CELL]);
// "x" of the first of three, "1" of the first of any other number.
const char *orr_message_axis(const orr_field *f, uint16_t k, char buf[8]);
// A message as one JSON object on a line of out; false where that failed.
bool orr_message_json(const orr_record *r, const void *m, FILE *out);
// A message as CSV on out, a row for each record of its list; *headed: whether the names of columns have been printed.
void orr_message_csv(const orr_record *r, const void *m, bool *headed, FILE *out);
// The values of one record, divided by commas, as CSV has them; lists are left out but those with one member.
void orr_message_values(const orr_record *r, const void *m, FILE *out);

#endif
