// SPDX-License-Identifier: GPL-3.0-or-later
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "src/service/text/message_text.h"

// Prints the columns of a record: their names, or its cells, blank where m is NULL. Lists are no columns but one
// that has at most one member.
typedef struct csv_row {
    bool names;
    const char *between;
    FILE *out;
} csv_row;

static void put(csv_row *row, const char *text)
{
    fprintf(row->out, "%s%s", row->between, text);
    row->between = ",";
}

// Digits that read back as the same number; a blank cell where there is none.
static void put_number(csv_row *row, const orr_field *f, const void *at, uint16_t k)
{
    char cell[32] = "";
    double v = at != NULL ? orr_field_number(f, at, k) * f->text_factor : (double)NAN;
    if (isfinite(v)) snprintf(cell, sizeof cell, "%.*g", f->kind == ORR_FIELD_F32 ? 9 : 17, v);
    put(row, cell);
}

// A text in quotes, so that a comma in it is none.
static void put_text(csv_row *row, const orr_wire_bytes *b)
{
    fputs(row->between, row->out);
    row->between = ",";
    if (b == NULL) return;
    putc('"', row->out);
    for (uint16_t i = 0; i < b->size; i++) {
        if (b->data[i] == '"') putc('"', row->out);
        putc(b->data[i] < ' ' ? ' ' : b->data[i], row->out);
    }
    putc('"', row->out);
}

static void put_hex(csv_row *row, const orr_wire_bytes *b)
{
    fputs(row->between, row->out);
    row->between = ",";
    for (uint16_t i = 0; b != NULL && i < b->size; i++) fprintf(row->out, "%02x", b->data[i]);
}

static void put_fields(csv_row *row, const orr_record *r, const void *m);

static void put_array(csv_row *row, const orr_field *f, const void *at)
{
    char name[80], buf[8];
    for (uint16_t k = 0; k < f->length; k++) {
        snprintf(name, sizeof name, "%s%s%s", f->stem, orr_message_axis(f, k, buf), f->suffix);
        if (row->names)
            put(row, name);
        else
            put_number(row, f, at, k);
    }
}

static void put_only_member(csv_row *row, const orr_field *f, const void *list)
{
    orr_message_room one;
    orr_wire_iter it = {0};
    bool there = list != NULL && f->next(list, &it, &one);
    put_fields(row, f->record, there ? &one : NULL);
}

static void put_field(csv_row *row, const orr_field *f, const void *at)
{
    char cell[ORR_MESSAGE_CELL];
    if (f->kind == ORR_FIELD_LIST) {
        if (f->record != NULL && f->limit == 1) put_only_member(row, f, at);
    } else if (f->kind == ORR_FIELD_STRUCT && !f->record->is_sat) {
        put_fields(row, f->record, at);
    } else if (f->length > 0) {
        put_array(row, f, at);
    } else if (row->names) {
        put(row, orr_message_name(f));
    } else if (f->kind == ORR_FIELD_STRING) {
        put_text(row, at);
    } else if (f->kind == ORR_FIELD_BYTES) {
        put_hex(row, at);
    } else if (f->kind == ORR_FIELD_F32 || f->kind == ORR_FIELD_F64) {
        put_number(row, f, at, 0);
    } else {
        put(row, at != NULL ? orr_message_text(f, at, false, cell) : "");
    }
}

// Behind an answer that is not OK the cells are blank.
static void put_fields(csv_row *row, const orr_record *r, const void *m)
{
    const void *from = m;
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        if (!f->in_text) continue;
        put_field(row, f, from != NULL && !row->names ? orr_message_member(f, from) : NULL);
        bool answers = f->show == ORR_SHOW_ANSWER || (f->kind == ORR_FIELD_STRUCT && f->record->spread);
        if (answers && m != NULL && orr_message_answer(r, m) != ORR_MSG_ANSWER_OK) from = NULL;
    }
}

// The instant of a message in front of the records of its list.
static void put_time(csv_row *row, const orr_record *r, const void *m)
{
    for (size_t i = 0; i < r->n; i++) {
        const orr_field *f = &r->field[i];
        const void *at = m != NULL ? orr_message_member(f, m) : NULL;
        if (f->kind == ORR_FIELD_STRUCT && f->record->spread) put_time(row, f->record, at);
        if (f->show == ORR_SHOW_TIME && strcmp(f->name, "t") == 0) put_field(row, f, at);
    }
}

static void put_row(bool names, const orr_record *r, const void *m, const orr_record *of, const void *one,
                    FILE *out)
{
    csv_row row = {names, "", out};
    if (of != NULL) put_time(&row, r, m);
    put_fields(&row, of != NULL ? of : r, of != NULL ? one : m);
    putc('\n', out);
}

void orr_message_values(const orr_record *r, const void *m, FILE *out)
{
    csv_row row = {false, "", out};
    put_fields(&row, r, m);
}

void orr_message_csv(const orr_record *r, const void *m, bool *headed, FILE *out)
{
    const orr_field *rows = orr_message_rows(r);
    if (!*headed) put_row(true, r, NULL, rows != NULL ? rows->record : NULL, NULL, out);
    *headed = true;
    if (rows == NULL) {
        put_row(false, r, m, NULL, NULL, out);
        return;
    }
    orr_message_room one;
    orr_wire_iter it = {0};
    while (rows->next(orr_message_member(rows, m), &it, &one)) put_row(false, r, m, rows->record, &one, out);
}
