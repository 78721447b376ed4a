// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdlib.h>

#include "src/service/text/json_value.h"
#include "src/service/text/message_text.h"

static bool is_floating(orr_field_kind kind) { return kind == ORR_FIELD_F32 || kind == ORR_FIELD_F64; }

static json_t *json_of_bytes(const orr_wire_bytes *b)
{
    static const char digit[] = "0123456789abcdef";
    char *hex = malloc(2 * (size_t)b->size + 1);
    if (hex == NULL) return NULL;
    for (size_t i = 0; i < b->size; i++) {
        hex[2 * i] = digit[b->data[i] >> 4];
        hex[2 * i + 1] = digit[b->data[i] & 15];
    }
    hex[2 * (size_t)b->size] = '\0';
    json_t *j = json_string(hex);
    free(hex);
    return j;
}

static json_t *json_of_text(const orr_wire_bytes *b)
{
    char text[513];
    return orr_json_text(orr_wire_text_copy(*b, text, sizeof text));
}

static json_t *json_of_bits(const orr_field *f, uint64_t bits)
{
    json_t *a = json_array();
    for (size_t i = 0; i < f->n_words; i++)
        if ((bits & f->word[i].value) != 0) json_array_append_new(a, json_string(f->word[i].name));
    return a;
}

static json_t *json_of_scalar(const orr_field *f, const void *at)
{
    char cell[ORR_MESSAGE_CELL];
    if (is_floating(f->kind)) return orr_json_number(orr_field_number(f, at, 0) * f->text_factor);
    if (f->show == ORR_SHOW_BITS) return json_of_bits(f, orr_field_bits(f, at));
    if (f->show == ORR_SHOW_TIME) return orr_json_time(orr_field_integer(f, at));
    if (f->show == ORR_SHOW_NUMBER) return json_integer(orr_field_integer(f, at));
    return json_string(orr_message_text(f, at, false, cell));
}

// How many numbers of an array mean something: one for each member of the message's list that it goes with.
static uint16_t meant(const orr_field *f, const orr_record *top, const void *message)
{
    const orr_field *list = f->per != NULL ? orr_record_field(top, f->per) : NULL;
    if (list == NULL) return f->length;
    uint16_t n = 0;
    double v;
    orr_wire_iter it = {0};
    while (n < f->length && list->next(orr_message_member(list, message), &it, &v)) n++;
    return n;
}

static void add_fields(json_t *j, const orr_record *r, const void *m, const orr_record *top,
                       const void *message);

static json_t *json_of_record(const orr_record *r, const void *m, const orr_record *top, const void *message)
{
    json_t *j = json_object();
    add_fields(j, r, m, top, message);
    return j;
}

// A list is an array; one that has at most one member is that member, or nothing.
static void add_list(json_t *j, const orr_field *f, const void *list, const orr_record *top,
                     const void *message)
{
    json_t *a = json_array();
    orr_wire_iter it = {0};
    if (f->record == NULL) {
        double v; // smaller kinds fit into its room
        while (f->next(list, &it, &v)) json_array_append_new(a, orr_json_number(orr_field_number(f, &v, 0)));
    } else {
        orr_message_room one;
        while (f->next(list, &it, &one))
            json_array_append_new(a, json_of_record(f->record, &one, top, message));
    }
    if (f->limit > 1 || f->record == NULL) {
        json_object_set_new(j, f->text_name, a);
        return;
    }
    if (json_array_size(a) > 0) json_object_set(j, f->text_name, json_array_get(a, 0));
    json_decref(a);
}

static void add_field(json_t *j, const orr_field *f, const void *at, const orr_record *top,
                      const void *message)
{
    char cell[ORR_MESSAGE_CELL];
    if (f->kind == ORR_FIELD_LIST) {
        add_list(j, f, at, top, message);
    } else if (f->kind == ORR_FIELD_STRUCT && f->record->is_sat) {
        json_object_set_new(j, f->text_name, json_string(orr_message_text(f, at, false, cell)));
    } else if (f->kind == ORR_FIELD_STRUCT && f->record->spread) {
        add_fields(j, f->record, at, top, message);
    } else if (f->kind == ORR_FIELD_STRUCT) {
        json_object_set_new(j, f->text_name, json_of_record(f->record, at, top, message));
    } else if (f->kind == ORR_FIELD_STRING) {
        json_object_set_new(j, f->text_name, json_of_text(at));
    } else if (f->kind == ORR_FIELD_BYTES) {
        json_object_set_new(j, f->text_name, json_of_bytes(at));
    } else if (f->length > 0) {
        json_t *a = json_array();
        for (uint16_t k = 0; k < meant(f, top, message); k++)
            json_array_append_new(a, orr_json_number(orr_field_number(f, at, k) * f->text_factor));
        json_object_set_new(j, f->text_name, a);
    } else {
        json_object_set_new(j, orr_message_name(f), json_of_scalar(f, at));
    }
}

// Behind an answer that is not OK there are no numbers; a message keeps its lists, which tell that they are empty.
static void add_fields(json_t *j, const orr_record *r, const void *m, const orr_record *top,
                       const void *message)
{
    bool none = false;
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        const void *at = orr_message_member(f, m);
        if (!f->in_text || (none && !(r == top && f->kind == ORR_FIELD_LIST))) continue;
        add_field(j, f, at, top, message);
        if (f->show == ORR_SHOW_ANSWER || (f->kind == ORR_FIELD_STRUCT && f->record->spread))
            none = orr_message_answer(r, m) != ORR_MSG_ANSWER_OK;
    }
}

bool orr_message_json(const orr_record *r, const void *m, FILE *out)
{
    json_t *j = json_of_record(r, m, r, m);
    const bool done = j != NULL && json_dumpf(j, out, JSON_COMPACT | JSON_REAL_PRECISION(17)) == 0;
    if (done) putc('\n', out);
    json_decref(j);
    return done;
}
