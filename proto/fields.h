// SPDX-License-Identifier: MIT
// Messages told field by field: name, kind, place in the C struct, unit, names of values, and how each is
// shown as text. Code that does the same with every message (a table, JSON lines, CSV) needs nothing else, and
// a new message is a row of these tables. Generated into proto/gen/fields.c; firmware does without.
#ifndef ORR_PROTO_FIELDS_H
#define ORR_PROTO_FIELDS_H

#include "proto/gen/messages.h"

typedef enum orr_field_kind {
    ORR_FIELD_U8,
    ORR_FIELD_U16,
    ORR_FIELD_U32,
    ORR_FIELD_U64,
    ORR_FIELD_I8,
    ORR_FIELD_I16,
    ORR_FIELD_I32,
    ORR_FIELD_I64,
    ORR_FIELD_F32,
    ORR_FIELD_F64,
    ORR_FIELD_STRING,
    ORR_FIELD_BYTES,
    ORR_FIELD_STRUCT,
    ORR_FIELD_LIST,
} orr_field_kind;

// What a scalar is beside a number.
typedef enum orr_field_show {
    ORR_SHOW_NUMBER,
    ORR_SHOW_CHAR,
    ORR_SHOW_HEX,
    ORR_SHOW_TIME,       // an instant
    ORR_SHOW_MESSAGE,    // a message type
    ORR_SHOW_PLACE,      // of an array: a place (ecef)
    ORR_SHOW_POLYNOMIAL, // of an array: coefficients, from that of power 0 on
    ORR_SHOW_ENUM,
    ORR_SHOW_BITS,
    ORR_SHOW_ANSWER, // an enum: without OK the numbers behind it are none
} orr_field_show;

// A value of an enum, or the mask of a bit.
typedef struct orr_field_word {
    uint64_t value;
    const char *name;  // as in the specification
    const char *words; // for people; empty: not worth a word
    bool counted;      // a record with this answer is counted in a table, not listed
} orr_field_word;

typedef struct orr_record orr_record;
typedef struct orr_field {
    const char *name, *unit, *doc;
    orr_field_kind kind;
    orr_field_kind element; // of a list of scalars
    orr_field_show show;
    uint16_t length;      // numbers of an array; 0: no array
    size_t offset, limit; // place in the C struct; of a string, blob or list: its most members
    const orr_field_word *word;
    size_t n_words;
    const orr_record *record;                                     // of a struct, or of the list of them
    bool (*next)(const void *list, orr_wire_iter *it, void *out); // of a list: as orr_msg_..._next
    const char *stem, *suffix; // of an array: name of a single number is stem, axis, suffix
    const char *per; // of an array: the list of the message that has one member for each of its numbers
    // JSON and CSV: whether it is there, its name, and what its numbers are multiplied by
    bool in_text;
    const char *text_name;
    double text_factor;
    // tables: likewise, with the unit and the decimals (negative: ten significant digits)
    bool in_table;
    const char *head, *table_unit;
    double table_factor;
    int digits;
} orr_field;

struct orr_record {
    const char *name;
    const orr_field *field;
    size_t n, size; // size: of the C struct
    bool spread;    // its fields are shown as those of the message that holds it
    bool is_sat;    // shown as one word, G05
};

typedef struct orr_message_info {
    const char *name;
    uint16_t type, answer; // of the message that answers; 0: none
    bool from_client;
    const orr_record *record;
    orr_wire_status (*encode)(const void *m, orr_wire_writer *w);
    orr_wire_status (*decode)(const uint8_t *payload, size_t size, void *m);
} orr_message_info;

// NULL for a type that the specification does not know.
const orr_message_info *orr_message_of(uint16_t type);
// The field of a record by name, NULL where there is none.
const orr_field *orr_record_field(const orr_record *r, const char *name);
// Number k of a scalar or array that stands at `at`, not multiplied by anything; of integers above 2^53 the
// nearest double.
double orr_field_number(const orr_field *f, const void *at, uint16_t k);
uint64_t orr_field_bits(const orr_field *f, const void *at);   // of an unsigned scalar
int64_t orr_field_integer(const orr_field *f, const void *at); // of any scalar that is no floating number

#endif
